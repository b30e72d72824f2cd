#pragma once

#include <string>
#include <vector>

#include "core/video/video_frame.hpp"

namespace abrazo {

/// Presentation times of the pictures of a file, in decoding order.
struct PictureTimes {
  std::vector<double> stamps_ms;  ///< of the file's clock, not necessarily from 0
  double nominal_hz = 0;          ///< from the header
  int promised = 0;               ///< number of pictures by the header; 0 = unknown

  /// Repairs the times of the last pictures: they leave the decoder after the last bytes went in, and OpenCV
  /// 4.6 then reports time 0. They are placed at the usual interval. @return the number with original times
  int mend_end();
  /// Whether times ascend; otherwise the nominal rate is used.
  bool are_usable() const;
};

/// Sets times, rate and evenness of the facts, and adds warnings about them.
void add_times(VideoFacts& facts, const PictureTimes& times);

}  // namespace abrazo
