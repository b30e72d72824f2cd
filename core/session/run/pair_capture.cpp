#include "core/session/run/pair_capture.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace abrazo {

namespace {

std::string seconds(double s) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.1f s", s);
  return text.data();
}

/// The pose at a time within a track, straight between its two neighbours.
template <typename Track>
Pose pose_at(const Track& track, double time_s) {
  const auto after = std::lower_bound(track.begin(), track.end(), time_s,
                                      [](const auto& timed, double t) { return timed.time_s < t; });
  if (after == track.begin()) return track.front().pose;
  if (after == track.end()) return track.back().pose;
  const auto& before = *std::prev(after);
  const double share = (time_s - before.time_s) / (after->time_s - before.time_s);
  return (1 - share) * before.pose + share * after->pose;
}

/// That of the usual interval: a pose that got lost does not lower it.
template <typename Track>
double rate_of(const Track& track, double from_s, double to_s) {
  std::vector<double> intervals_s;
  for (std::size_t i = 1; i < track.size(); ++i)
    if (from_s <= track[i - 1].time_s && track[i].time_s <= to_s)
      intervals_s.push_back(track[i].time_s - track[i - 1].time_s);
  if (intervals_s.empty()) return 1;
  const auto median = intervals_s.begin() + static_cast<std::ptrdiff_t>(intervals_s.size() / 2);
  std::nth_element(intervals_s.begin(), median, intervals_s.end());
  return 1 / *median;
}

/// Where a performer was lost for too long; nothing when nowhere.
template <typename Track>
std::string gap_in(const Track& track, double from_s, double to_s) {
  for (std::size_t i = 1; i < track.size(); ++i) {
    const double begin = std::max(track[i - 1].time_s, from_s), end = std::min(track[i].time_s, to_s);
    if (end - begin > PairCapture::longest_gap_s)
      return "was lost for " + seconds(end - begin) + " after " + seconds(begin - from_s);
  }
  return {};
}

}  // namespace

void PairCapture::add(const ReceivedPose& pose) {
  const int which = pose.performer == names_[0] ? 0 : pose.performer == names_[1] ? 1 : -1;
  if (which < 0) return;
  const std::scoped_lock lock(mutex_);
  Track& track = tracks_[which];
  if (track.empty() || pose.pose.time_s > track.back().time_s)
    track.push_back({pose.pose.time_s, pose.pose.pose});
}

PairCapture::State PairCapture::state() const {
  const std::scoped_lock lock(mutex_);
  State state{tracks_[0].size(), tracks_[1].size(), 0};
  if (state.a == 0 || state.b == 0) return state;
  const double from_s = std::max(tracks_[0].front().time_s, tracks_[1].front().time_s);
  const double to_s = std::min(tracks_[0].back().time_s, tracks_[1].back().time_s);
  state.length_s = std::max(0.0, to_s - from_s);
  return state;
}

Result<PairedTake> PairCapture::take(const Wishes& wishes) const {
  const std::scoped_lock lock(mutex_);
  for (int which : {0, 1})
    if (tracks_[which].size() < 2) return Error{"was not seen; a pair needs both performers", names_[which]};
  const double from_s = std::max(tracks_[0].front().time_s, tracks_[1].front().time_s) + wishes.in_s;
  const double to_s = std::min(tracks_[0].back().time_s, tracks_[1].back().time_s) - wishes.out_s;
  if (to_s - from_s < shortest_s)
    return Error{"leaves " + seconds(std::max(0.0, to_s - from_s)) +
                     "; cut off less, or record longer: a take needs at least " + seconds(shortest_s),
                 wishes.name};
  for (int which : {0, 1})
    if (const std::string gap = gap_in(tracks_[which], from_s, to_s); !gap.empty())
      return Error{gap + "; cut that off, or record again", names_[which]};
  PairedTake take;
  take.name = wishes.name;
  take.fps = std::max(
      1.0, std::round(std::min(rate_of(tracks_[0], from_s, to_s), rate_of(tracks_[1], from_s, to_s))));
  const int frames = static_cast<int>(std::floor((to_s - from_s) * take.fps + 1e-6)) + 1;
  take.a = {names_[0], take.fps, {}};
  take.b = {names_[1], take.fps, {}};
  for (int frame = 0; frame < frames; ++frame) {
    const double time_s = from_s + frame / take.fps;
    take.a.poses.push_back(pose_at(tracks_[0], time_s));
    take.b.poses.push_back(pose_at(tracks_[1], time_s));
  }
  if (wishes.leads != ActivePerformer::Unknown) take.roles.push_back({0, frames, wishes.leads});
  if (!wishes.label.empty()) take.labels.push_back({0, frames, wishes.label, {}, {}});
  return take;
}

}  // namespace abrazo
