#include "core/evaluation/run/library_takes.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace abrazo {

namespace {

/// Frames [start, end) in those that are left when only every stride-th is kept.
template <typename Interval>
std::vector<Interval> thinned(std::vector<Interval> intervals, int stride) {
  for (Interval& interval : intervals) {
    interval.start = (interval.start + stride - 1) / stride;
    interval.end = (interval.end + stride - 1) / stride;
  }
  std::erase_if(intervals, [](const Interval& interval) { return interval.start >= interval.end; });
  return intervals;
}

PairedTake empty_take(const LibraryTake& about) {
  const int stride = std::max(1, about.frame_stride);
  PairedTake take;
  take.name = about.name;
  take.fps = about.fps / stride;
  take.roles = thinned(about.roles, stride);
  take.labels = thinned(about.labels, stride);
  const auto frames = static_cast<std::size_t>((about.frames + stride - 1) / stride);
  for (Clip* clip : {&take.a, &take.b}) {
    clip->name = about.name;
    clip->fps = take.fps;
    clip->poses.resize(frames);
  }
  return take;
}

/// A pair whose roles differ from those of its take: the library has both assignments, whatever the takes
/// say.
bool is_against_roles(const PairSource& source) {
  return source.annotated == (source.swapped ? ActivePerformer::A : ActivePerformer::B);
}

}  // namespace

Result<std::vector<PairedTake>> takes_of_library(const MotionLibrary& library) {
  std::vector<PairedTake> takes;
  std::vector<std::vector<bool>> there;
  for (const LibraryTake& about : library.takes()) {
    takes.push_back(empty_take(about));
    there.emplace_back(takes.back().a.poses.size(), false);
  }
  for (int pair = 0; pair < library.pair_count(); ++pair) {
    const PairSource& source = library.source(pair);
    const auto stride = static_cast<std::size_t>(std::max(1, library.takes()[source.take].frame_stride));
    PairedTake& take = takes[source.take];
    const std::size_t frame = source.frame / stride;
    Clip& active = source.swapped ? take.b : take.a;
    Clip& passive = source.swapped ? take.a : take.b;
    active.poses.at(frame) = to_world(library.pose(pair).topRows<joint_count>(), library.root(pair));
    passive.poses.at(frame) = to_world(library.pose(pair).bottomRows<joint_count>(), library.root(pair));
    there[source.take][frame] = true;
  }
  for (std::size_t t = 0; t < takes.size(); ++t)
    if (const auto gap = std::find(there[t].begin(), there[t].end(), false); gap != there[t].end())
      return Error{fmt::format("has no pair of frame {}; open the manifest that the library was built from",
                               (gap - there[t].begin()) * std::max(1, library.takes()[t].frame_stride)),
                   "take " + takes[t].name};
  return takes;
}

Result<EvaluationData> evaluation_data_of(std::shared_ptr<const MotionLibrary> library) {
  auto takes = takes_of_library(*library);
  if (!takes) return takes.error();
  EvaluationData data;
  data.name = library->name();
  data.takes = std::move(*takes);
  const auto& sources = library->columns().sources;
  data.both_roles = std::any_of(sources.begin(), sources.end(), is_against_roles);
  data.library = std::move(library);
  return data;
}

}  // namespace abrazo
