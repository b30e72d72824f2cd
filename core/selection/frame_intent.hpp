#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "core/library/store/normalization.hpp"

namespace abrazo {

class IntentModel;

/// What the selection `intent` made of one frame beside its candidates.
struct FrameIntent {
  std::shared_ptr<const IntentModel> model;  ///< null when Eq. 7 selected
  /// Of every block of the model: 255 exp(-excess of its best landing over the best of all / 3 cm).
  std::vector<std::uint8_t> belief;
  std::vector<float> moves;  ///< P(label | what the user did), of the model's labels; they sum to 1
  /// From the source to where it would fit the user best [source s]; 0 without a source.
  double lead_s = 0;
  /// Where the believed pairs that are like the source have their partners, seen from the user's root; the
  /// source's own without a belief.
  std::optional<RootFrame> partner_place;
  int continued = -1;  ///< the pair that would have gone on with the source; -1 when there is none
};

}  // namespace abrazo
