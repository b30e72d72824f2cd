#include "core/video/video_sync.hpp"

#include <fmt/format.h>

namespace abrazo {

double VideoSync::effective_rate() const {
  if (points.size() < 2) return rate;
  return (points[1].video_s - points[0].video_s) / (points[1].subject_s - points[0].subject_s);
}

double VideoSync::video_time(double subject_s) const {
  if (points.empty()) return rate * subject_s;
  return points[0].video_s + effective_rate() * (subject_s - points[0].subject_s);
}

double VideoSync::subject_time(double video_s) const {
  if (points.empty()) return video_s / rate;
  return points[0].subject_s + (video_s - points[0].video_s) / effective_rate();
}

Status check_sync(const VideoSync& sync) {
  if (!(sync.rate > 0))
    return Error{fmt::format("the video's rate is {}; it has to be above 0", sync.rate), ""};
  if (sync.points.size() < 2) return Done{};
  const double subject_s = sync.points[1].subject_s - sync.points[0].subject_s;
  const double video_s = sync.points[1].video_s - sync.points[0].video_s;
  if (subject_s * video_s > 0) return Done{};
  return Error{fmt::format("the sync points are {:.3f} s apart in the recording and {:.3f} s in the video; "
                           "choose two different instants, the later one of both second",
                           subject_s, video_s),
               ""};
}

}  // namespace abrazo
