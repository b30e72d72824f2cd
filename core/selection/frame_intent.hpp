#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "core/library/store/normalization.hpp"

namespace abrazo {

class IntentModel;

/// Results of the selection `intent` for one frame, in addition to the candidates.
struct FrameIntent {
  std::shared_ptr<const IntentModel> model;  ///< null if Eq. 7 selected
  /// Per block of the model: 255 exp(-(cost of its best landing - cost of the best landing of all) / 3 cm).
  std::vector<std::uint8_t> belief;
  std::vector<float> moves;  ///< P(label | user's motion), per label of the model; sums to 1
  /// Time from the source to its best fit to the user [source s]; 0 without a source.
  double lead_s = 0;
  /// Place of the partner relative to the user's root, in the believed pairs that resemble the source;
  /// without a belief that of the source.
  std::optional<RootFrame> partner_place;
  int continued = -1;  ///< the pair that would have continued the source; -1 if there is none
};

}  // namespace abrazo
