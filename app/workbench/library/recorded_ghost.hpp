#pragma once

#include "core/library/store/motion_library.hpp"

namespace abrazo::app {

/// Placement of shown pairs of a take: starting at the user, then as recorded.
class RecordedGhost {
 public:
  /// Places a pair at the user.
  void begin(const MotionLibrary& library, int pair, const RootFrame& user_root, bool user_is_passive);
  /// A pair of the same take with the transform of the first: its path and turns are those of the recording.
  PairPose at(const MotionLibrary& library, int pair) const;

 private:
  RootFrame m_recorded;  ///< of the first pair's active body, in its take
  RootFrame m_shown;     ///< the same as shown
};

}  // namespace abrazo::app
