#pragma once

#include <string>
#include <vector>

#include "core/base/result.hpp"

namespace abrazo {

/// A pair of times that are the same moment.
struct SyncPoint {
  double subject_s = 0;  ///< of the session or take
  double video_s = 0;    ///< of the video file

  bool operator==(const SyncPoint&) const = default;
};

/// Synchronisation of a video with a session or take: one point gives the offset, two give offset and rate.
struct VideoSync {
  std::vector<SyncPoint> points;  ///< none, one or two, by subject_s; none = both begin at the same time
  double rate = 1;                ///< video seconds per subject second with fewer than two points

  double video_time(double subject_s) const;
  double subject_time(double video_s) const;
  double effective_rate() const;
  bool operator==(const VideoSync&) const = default;
};

/// @return an Error for invalid points: the same instant, or reversed time
Status check_sync(const VideoSync& sync);

}  // namespace abrazo
