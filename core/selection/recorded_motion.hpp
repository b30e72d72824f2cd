#pragma once

#include <vector>

#include "core/library/store/motion_library.hpp"
#include "core/selection/history_kernel.hpp"

namespace abrazo {

/// The recorded motion around a pair, for comparison with a user: the leader's motion before it and the
/// partner after it. Refers to the library.
class RecordedMotion {
 public:
  explicit RecordedMotion(const MotionLibrary& library);

  /// The leader's motion up to this pair, in the format of MotionHistory::sample.
  void sample(int pair, HistoryKernel::Raw& raw) const;
  /// The partner `later_s` after the pair (or at the end of the recording), relative to the leader's root and
  /// heading at this pair; heights are above the floor.
  Pose partner_after(int pair, double later_s) const;

 private:
  Pose leader_in_world(int pair) const;

  const MotionLibrary& library_;
  std::vector<int> first_;  ///< per pair: the first pair of its stretch without a gap
};

/// The partner's root on the floor and heading at a pair, relative to the leader's root and heading.
RootFrame partner_place(const MotionLibrary& library, int pair);

}  // namespace abrazo
