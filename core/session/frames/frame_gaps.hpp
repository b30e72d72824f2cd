#pragma once

#include <cstdint>
#include <optional>

#include "core/session/frames/frame_snapshot.hpp"

namespace abrazo {

/// Frames that are this far apart have a gap between them: nothing was solved for a while, because packets
/// were lost, the input was held, or nothing was recorded between two takes. Lanes and lines end at a gap.
/// @param left_out_s  the time of frames between them that were solved and not read [s]
double gap_beyond_s(double left_out_s);

/// The time from one frame that was read to the next.
struct FrameInterval {
  double since_s = 0;        ///< 0 before the first frame
  double left_out_s = 0;     ///< of it, that of frames that were solved and not read
  bool is_adjacent = false;  ///< no frame lies between them

  bool is_gap() const { return since_s >= gap_beyond_s(left_out_s); }
};

/// Finds the gaps of a recording in its frames, all of them or evenly thinned.
class FrameGaps {
 public:
  /// Frames come in order.
  /// @param frames_each  how many frames one of them stands for at most, as in FrameHistory. More that are
  /// missing were not recorded
  FrameInterval next(const FrameSnapshot& frame, std::uint64_t frames_each);

 private:
  struct Last {
    std::uint64_t index = 0;
    double time_s = 0;
  };
  std::optional<Last> last_;
  double rate_hz_ = 0;  ///< of the input; 0 = not known yet
};

}  // namespace abrazo
