#pragma once

#include <string>
#include <vector>

#include "core/video/video_frame.hpp"

namespace abrazo {

/// When the pictures of a file are shown, in the order they were decoded in, as the file says it.
struct PictureTimes {
  std::vector<double> stamps_ms;  ///< of the file's clock, not necessarily from 0
  double nominal_hz = 0;          ///< what the header says
  int promised = 0;               ///< number of pictures by the header; 0 where it says nothing

  /// The last pictures come out of a decoder after the last bytes went in, and OpenCV 4.6 then says 0 for
  /// their times: they are taken to follow at the usual interval. @return how many have the file's own time
  int mend_end();
  /// Times that do not go upwards say nothing; then the pictures are taken to follow at the nominal rate.
  bool are_usable() const;
};

/// Puts times, rate and evenness into the facts, and what is wrong with them among the warnings.
void add_times(VideoFacts& facts, const PictureTimes& times);

}  // namespace abrazo
