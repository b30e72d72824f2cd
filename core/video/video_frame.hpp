#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace abrazo {

/// A decoded picture of a video, upright (the file's rotation is applied, and its mirroring).
struct VideoFrame {
  int index = 0;      ///< from 0, in order of presentation
  double time_s = 0;  ///< presentation time in the file; the first picture's is 0
  int width = 0, height = 0;
  std::vector<std::uint8_t> rgb;  ///< 3 bytes a pixel, rows from the top, no padding
};
using VideoFramePtr = std::shared_ptr<const VideoFrame>;

/// Properties of a video file, measured from the times of all pictures, not only from its header.
struct VideoFacts {
  std::string file;
  int width = 0, height = 0;          ///< upright
  int rotation_deg = 0;               ///< applied rotation: 0, 90, 180, 270
  bool is_mirrored = false;           ///< left to right, before the rotation
  std::string codec;                  ///< "h264"
  std::vector<double> times_s;        ///< of every picture, ascending
  double rate_hz = 0;                 ///< of most pictures
  bool is_even = true;                ///< all intervals are equal (to half a millisecond)
  std::vector<std::string> warnings;  ///< wrong statements of the header

  int frames() const { return static_cast<int>(times_s.size()); }
  double duration_s() const;  ///< to the end of the last picture
  /// The picture shown at a time; the first before all, the last after all.
  int index_at(double time_s) const;
};

}  // namespace abrazo
