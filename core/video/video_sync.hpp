#pragma once

#include <string>
#include <vector>

#include "core/base/result.hpp"

namespace abrazo {

/// Two instants that are the same moment.
struct SyncPoint {
  double subject_s = 0;  ///< of the session or take
  double video_s = 0;    ///< of the video file

  bool operator==(const SyncPoint&) const = default;
};

/// How the time of a video goes with that of a session or take: offset by one point, offset and rate by two.
struct VideoSync {
  std::vector<SyncPoint> points;  ///< none, one or two, by subject_s; none = both begin together
  double rate = 1;                ///< video seconds per subject second with fewer than two points

  double video_time(double subject_s) const;
  double subject_time(double video_s) const;
  double effective_rate() const;
  bool operator==(const VideoSync&) const = default;
};

/// @return an Error where two points cannot be: the same instant, or time that goes backwards
Status check_sync(const VideoSync& sync);

}  // namespace abrazo
