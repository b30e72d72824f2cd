#pragma once

#include <vector>

#include "core/library/store/motion_library.hpp"
#include "core/selection/history_kernel.hpp"

namespace abrazo {

/// What was recorded around a pair, as it is compared with a user: the leader's motion before it and the
/// partner after it. Refers to the library.
class RecordedMotion {
 public:
  explicit RecordedMotion(const MotionLibrary& library);

  /// The leader's motion up to this pair, as MotionHistory::sample gives a user's.
  void sample(int pair, HistoryKernel::Raw& raw) const;
  /// The partner so much later - as far as it was recorded - seen from the leader's root and heading at this
  /// pair; heights are those above the floor.
  Pose partner_after(int pair, double later_s) const;

 private:
  Pose leader_in_world(int pair) const;

  const MotionLibrary& library_;
  std::vector<int> first_;  ///< per pair: the first of its stretch without a gap
};

}  // namespace abrazo
