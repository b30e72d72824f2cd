#pragma once

#include <vector>

#include "core/bodies/pair_retargeting.hpp"

namespace abrazo {

struct LivePair {
  std::vector<PairPose> poses;
  int nearest_only = 0;  ///< frames that are only the nearest pose
};

/// A recorded pair as it is shown live on other bodies (ShownBodies): frame by frame without the future, for
/// a user of the active body who moves like the recorded performer, and a partner that is solved exactly as
/// recorded.
LivePair shown_live(const RecordedPair& recorded, const PairBodies& bodies, const PairCapsules& capsules);

}  // namespace abrazo
