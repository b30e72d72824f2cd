#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace abrazo {

/// A decoded picture of a video, upright (the file's rotation is applied).
struct VideoFrame {
  int index = 0;      ///< from 0, in order of presentation
  double time_s = 0;  ///< presentation time in the file; the first picture's is 0
  int width = 0, height = 0;
  std::vector<std::uint8_t> rgb;  ///< 3 bytes a pixel, rows from the top, no padding
};
using VideoFramePtr = std::shared_ptr<const VideoFrame>;

/// What a video file is, measured by looking at all its pictures' times, not only at what its header says.
struct VideoFacts {
  std::string file;
  int width = 0, height = 0;          ///< upright
  int rotation_deg = 0;               ///< that was applied: 0, 90, 180, 270
  std::string codec;                  ///< "h264"
  std::vector<double> times_s;        ///< of every picture, ascending
  double rate_hz = 0;                 ///< of most pictures
  bool is_even = true;                ///< all intervals are alike (to half a millisecond)
  std::vector<std::string> warnings;  ///< what the file says wrongly of itself

  int frames() const { return static_cast<int>(times_s.size()); }
  double duration_s() const;  ///< to the end of the last picture
  /// The picture that is shown at a time; the first before, the last after.
  int index_at(double time_s) const;
};

}  // namespace abrazo
