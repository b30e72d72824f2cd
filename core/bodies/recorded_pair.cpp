#include "core/bodies/recorded_pair.hpp"

#include <fmt/format.h>

namespace abrazo {

RecordedPair recorded_pair_of(const PairedTake& take) {
  int of_a = 0, of_b = 0;
  for (const RoleInterval& interval : take.roles) {
    if (interval.active == ActivePerformer::A) of_a += interval.end - interval.start;
    if (interval.active == ActivePerformer::B) of_b += interval.end - interval.start;
  }
  return of_b > of_a ? RecordedPair{take.name, take.b, take.a} : RecordedPair{take.name, take.a, take.b};
}

Result<RecordedPair> cut(const RecordedPair& pair, long long from, std::optional<long long> to) {
  const auto frames = static_cast<long long>(pair.active.poses.size());
  const long long end = to.value_or(frames);
  if (from < 0 || from >= end || end > frames)
    return Error{
        fmt::format("frames {} to {} are not in it: it has frames 0 to {}, of which the first and the "
                    "one behind the last are given",
                    from, end, frames),
        "take " + pair.name, Hint::ChooseFrames};
  RecordedPair part = pair;
  for (Clip* clip : {&part.active, &part.passive}) {
    clip->poses.erase(clip->poses.begin() + end, clip->poses.end());
    clip->poses.erase(clip->poses.begin(), clip->poses.begin() + from);
  }
  return part;
}

}  // namespace abrazo
