#include "core/library/store/takes_of_library.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <utility>

#include "core/library/takes/manifest.hpp"

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

template <typename Takes>
Error unknown_take(const std::string& name, const Takes& takes, const std::string& where) {
  std::vector<std::string> names;
  for (const auto& take : takes) names.push_back(take.name);
  return {fmt::format("has no take {}; there are {}", name, fmt::join(names, ", ")), where};
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

Result<std::vector<PairedTake>> takes_of_library(const MotionLibrary& library,
                                                 const std::vector<std::string>& names,
                                                 const std::string& where) {
  auto all = takes_of_library(library);
  if (!all) return all.error();
  std::vector<PairedTake> takes;
  for (const std::string& name : names) {
    const auto found = std::ranges::find(*all, name, &PairedTake::name);
    if (found == all->end()) return unknown_take(name, *all, where);
    takes.push_back(*found);
  }
  return takes;
}

Result<std::vector<PairedTake>> takes_of_manifest(const std::string& file,
                                                  const std::vector<std::string>& names,
                                                  std::vector<std::string>& warnings,
                                                  const Progress& progress) {
  const auto manifest = read_manifest(file);
  if (!manifest) return manifest.error();
  std::vector<const Manifest::Take*> wanted;
  for (const std::string& name : names) {
    const auto found = std::ranges::find(manifest->takes, name, &Manifest::Take::name);
    if (found == manifest->takes.end()) return unknown_take(name, manifest->takes, file);
    wanted.push_back(&*found);
  }
  warnings.insert(warnings.end(), manifest->warnings.begin(), manifest->warnings.end());
  std::vector<PairedTake> takes;
  for (std::size_t t = 0; t < wanted.size(); ++t) {
    const auto share = [&](std::size_t done) {
      return static_cast<double>(done) / static_cast<double>(wanted.size());
    };
    auto take = load_take(*wanted[t], warnings, part(progress, share(t), share(t + 1)));
    if (!take) return take.error();
    takes.push_back(std::move(*take));
  }
  return takes;
}

}  // namespace abrazo
