#pragma once

#include <cstdint>
#include <memory>
#include <vector>

namespace abrazo {

class IntentModel;

/// What the selection `filter` made of one frame beside its candidates.
struct FrameIntent {
  std::shared_ptr<const IntentModel> model;  ///< null when Eq. 7 selected
  /// Of every block of the model: 255 where the belief is strongest, 0 where there is none.
  std::vector<std::uint8_t> belief;
  std::vector<float> moves;  ///< P(label | what the user did), of the model's labels; they sum to 1
  int continued = -1;        ///< the pair that would have gone on with the source; -1 when there is none
};

}  // namespace abrazo
