#include "core/selection/recorded_motion.hpp"

#include <algorithm>
#include <cmath>

namespace abrazo {

RecordedMotion::RecordedMotion(const MotionLibrary& library)
    : library_(library), first_(static_cast<std::size_t>(library.pair_count())) {
  for (int pair = 0; pair < library.pair_count(); ++pair) {
    const bool continues = pair > 0 && library.later_pair(pair - 1, 1) == pair;
    first_[static_cast<std::size_t>(pair)] = continues ? first_[static_cast<std::size_t>(pair) - 1] : pair;
  }
}

Pose RecordedMotion::leader_in_world(int pair) const {
  return to_world(library_.pose(pair).topRows<joint_count>(), library_.root(pair));
}

void RecordedMotion::sample(int pair, HistoryKernel::Raw& raw) const {
  const double rate = library_.take_of(pair).pairs_per_second();
  const int oldest = first_[static_cast<std::size_t>(pair)];
  const RootFrame& root = library_.root(pair);
  for (std::size_t lag = 0; lag < HistoryKernel::lags_s.size(); ++lag) {
    // Rates come from files: frames that were not recorded are not counted.
    const double before = std::min<double>(HistoryKernel::lags_s[lag] * rate, pair - oldest);
    const int whole = static_cast<int>(before);
    const int later = std::max(oldest, pair - whole);
    const int earlier = std::max(oldest, later - 1);
    const double share = before - whole;
    Pose pose = leader_in_world(later);
    if (share > 1e-6 && earlier != later) pose += share * (leader_in_world(earlier) - pose);
    const Pose seen = to_normalized(pose, root);
    for (int joint = 0; joint < joint_count; ++joint)
      for (int axis = 0; axis < 3; ++axis)
        raw[lag * MotionHistory::coordinates + static_cast<std::size_t>(3 * joint + axis)] =
            static_cast<float>(seen(joint, axis));
  }
}

Pose RecordedMotion::partner_after(int pair, double later_s) const {
  const double ahead = std::round(later_s * library_.take_of(pair).pairs_per_second());
  int seen = pair;
  for (int steps = static_cast<int>(std::min<double>(ahead, library_.pair_count() - 1 - pair));
       steps > 0 && seen == pair; --steps)
    if (const int later = library_.later_pair(pair, steps); later >= 0) seen = later;
  RootFrame above_floor = library_.root(pair);
  above_floor.position.y() = 0;
  return to_normalized(to_world(library_.pose(seen).bottomRows<joint_count>(), library_.root(seen)),
                       above_floor);
}

RootFrame partner_place(const MotionLibrary& library, int pair) {
  RootFrame place = root_frame(library.pose(pair).bottomRows<joint_count>());
  place.position.y() = 0;
  return place;
}

}  // namespace abrazo
