#pragma once

#include "core/library/store/motion_library.hpp"

namespace abrazo::app {

/// Where recorded pairs of a take are shown: begun where the user is, then as they were recorded.
class RecordedGhost {
 public:
  /// Puts a pair where the user is.
  void begin(const MotionLibrary& library, int pair, const RootFrame& user_root, bool user_is_passive);
  /// A pair of the same take, moved like the first one: the way it walks and turns stays the recorded one.
  PairPose at(const MotionLibrary& library, int pair) const;

 private:
  RootFrame m_recorded;  ///< of the first pair's active body, in its take
  RootFrame m_shown;     ///< the same where it is shown
};

}  // namespace abrazo::app
