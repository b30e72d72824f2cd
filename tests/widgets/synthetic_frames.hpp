#pragma once

#include "core/session/frames/frame_snapshot.hpp"
#include "tests/support/libraries.hpp"

namespace abrazo::test {

/// A solved frame as the solver would freeze it: two people face to face, five candidates of
/// `two_take_library`, the first of them selected. The passive character sways with the index.
FrameSnapshotPtr synthetic_frame(std::uint64_t index, double time_s);

/// The same, selected by `intent`. The first candidate goes on with the source [m]: 0.100 partner, 0.060
/// leader, 0.030 move. The second would be 0.020 better, the margin is 0.030.
FrameSnapshotPtr frame_by_intent(std::uint64_t index, double time_s);

}  // namespace abrazo::test
