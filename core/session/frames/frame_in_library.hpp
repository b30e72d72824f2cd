#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/library/store/motion_library.hpp"
#include "core/session/frames/frame_snapshot.hpp"

namespace abrazo {

/// The pair of library `to` with the same take, frame and active performer as `pair` of library `from`; if
/// `to` has that frame only with the other performer active, that pair. -1 if it has neither.
int same_pair(const MotionLibrary& from, int pair, const MotionLibrary& to);
/// The same for a pair of a library that is not at hand. -1 also if it is not noted.
int same_pair(const NotedPairs& from, int pair, const MotionLibrary& to);

/// `same_pair` for many pairs of one library, quick where they follow each other. Both libraries outlive it.
class PairNumbers {
 public:
  PairNumbers(const MotionLibrary& from, const MotionLibrary& to);
  int operator()(int pair);
  /// Number in `to` of each take of `from`; -1 = it does not have it.
  const std::vector<int>& takes() const { return takes_; }

 private:
  const MotionLibrary& from_;
  const MotionLibrary& to_;
  std::vector<int> takes_;
  int apart_ = 0;  ///< number of the last pair in `to` less that in `from`
};

/// Whether the library has every pair that a frame and the solver's state before it name, under the same
/// numbers if its own library is not at hand. Guards against inconsistent files.
bool has_pairs_of(const MotionLibrary& library, const FrameSnapshot& frame);

/// The pair selected in a frame, numbered as in this library; unchanged if nothing is known of the frame's
/// library. -1 if nothing is selected, or the library does not have it.
int selected_pair(const FrameSnapshot& frame, const std::shared_ptr<const MotionLibrary>& library);

/// A frame with candidates numbered as in this library. The same object if they already are, or if nothing is
/// known of the frame's library (numbers out of range become -1). Candidates that are not in the library are
/// dropped; if the selected one is among them, nothing is selected, and the frame names its library as
/// absent.
FrameSnapshotPtr in_library(const FrameSnapshotPtr& frame,
                            const std::shared_ptr<const MotionLibrary>& library);

/// Why a frame of `in_library` has no source although it was solved with one: "Danced with library “salsa”,
/// which is not open". Empty if its library is not absent.
std::string absence_text(const FrameSnapshot& frame);

}  // namespace abrazo
