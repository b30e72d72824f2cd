#include "widgets/timeline/timeline_tracks.hpp"

#include <algorithm>
#include <cctype>

#include "core/session/frames/frame_gaps.hpp"

namespace abrazo::widgets {
namespace {

using Interval = TimelineTracks::Interval;
using Lane = TimelineTracks::Lane;

/// The first interval that ends after a time.
Lane::const_iterator ending_after(const Lane& lane, double time_s) {
  return std::upper_bound(lane.begin(), lane.end(), time_s,
                          [](double t, const Interval& interval) { return t < interval.to_s; });
}

}  // namespace

double TimelineTracks::longest_gap_s() const {
  return gap_beyond_s(left_out_s_);
}

bool TimelineTracks::has_gap_of_curves(double from_s, double to_s) const {
  auto there = ending_after(by_intent_, from_s);
  double until_s = from_s;
  for (; until_s < to_s && there != by_intent_.end(); ++there) {
    if (there->from_s > until_s) return true;
    until_s = there->to_s;
  }
  return until_s < to_s;
}

void TimelineTracks::append(const TrackRow& row) {
  left_out_s_ = std::max(left_out_s_, row.left_out_s);
  const double gap = gap_beyond_s(row.left_out_s);
  extend(sources_, row.time_s, gap, row.take, row.source_changed);
  extend(moves_, row.time_s, gap, label_key(row.label));
  extend(leaders_, row.time_s, gap, static_cast<int>(row.leader));
  extend(user_roles_, row.time_s, gap, row.user_is_active ? 1 : 0);
  pairs_.push_back({row.time_s, row.pair});
  if (row.take < 0) return;
  extend(by_intent_, row.time_s, gap, row.is_by_intent ? 1 : 0);
  costs_.append(row.time_s, row.cost);
  energies_.append(row.time_s, row.energy);
}

void TimelineTracks::extend(Lane& lane, double time_s, double gap_s, int key, bool begins) {
  const bool continues = !lane.empty() && time_s - lane.back().to_s < gap_s;
  if (continues) lane.back().to_s = time_s;  // an interval lasts until the next begins
  if (!continues || begins || lane.back().key != key) lane.push_back({time_s, time_s, key});
}

int TimelineTracks::label_key(std::string_view label) {
  if (label.empty()) return -1;
  const auto found = std::find(labels_.begin(), labels_.end(), label);
  if (found != labels_.end()) return static_cast<int>(found - labels_.begin());
  labels_.emplace_back(label);
  return static_cast<int>(labels_.size()) - 1;
}

void TimelineTracks::drop_before(double time_s) {
  for (Lane* lane : {&sources_, &moves_, &leaders_, &user_roles_, &by_intent_}) {
    while (!lane->empty() && lane->front().to_s < time_s) lane->pop_front();
    if (!lane->empty()) lane->front().from_s = std::max(lane->front().from_s, time_s);
  }
  while (!pairs_.empty() && pairs_.front().time_s < time_s) {
    pairs_.pop_front();
    older_pairs_ -= older_pairs_ > 0;
  }
  costs_.drop_before(time_s);
  energies_.drop_before(time_s);
}

void TimelineTracks::thin_older(std::size_t newest, std::size_t most_older) {
  constexpr std::size_t at_once = 8192;
  costs_.thin_older(newest, most_older);
  energies_.thin_older(newest, most_older);
  const auto thin = [this](std::size_t first, std::size_t count, std::size_t step) {
    std::size_t to = first;
    for (std::size_t from = first; from < first + count; from += step) pairs_[to++] = pairs_[from];
    pairs_.erase(pairs_.begin() + static_cast<std::ptrdiff_t>(to),
                 pairs_.begin() + static_cast<std::ptrdiff_t>(first + count));
    return to - first;
  };
  while (pairs_.size() >= older_pairs_ + newest + at_once) {
    older_pairs_ += thin(older_pairs_, at_once, std::size_t{1} << pairs_level_);
    if (older_pairs_ <= most_older) continue;
    older_pairs_ = thin(0, older_pairs_, 2);
    ++pairs_level_;
  }
}

void TimelineTracks::renumber(const std::vector<int>& takes,
                              const std::function<PairFacts(int, bool)>& facts) {
  for (Interval& interval : sources_)
    if (interval.key >= 0) interval.key = takes[static_cast<std::size_t>(interval.key)];
  moves_.clear();
  leaders_.clear();
  const double gap = std::max(longest_gap_s(), pairs_apart_s());
  auto role = user_roles_.begin();
  for (Selection& chosen : pairs_) {
    while (role != user_roles_.end() && std::next(role) != user_roles_.end() &&
           std::next(role)->from_s <= chosen.time_s)
      ++role;
    const bool user_is_active = role == user_roles_.end() || role->key == 1;
    const PairFacts now = facts(chosen.pair, user_is_active);
    chosen.pair = now.pair;
    extend(moves_, chosen.time_s, gap, label_key(now.label));
    extend(leaders_, chosen.time_s, gap, static_cast<int>(now.leader));
  }
}

int TimelineTracks::pair_at(double time_s) const {
  const auto after = std::upper_bound(pairs_.begin(), pairs_.end(), time_s,
                                      [](double t, const Selection& chosen) { return t < chosen.time_s; });
  if (after == pairs_.begin()) return -1;
  const Selection& here = *std::prev(after);
  return time_s - here.time_s < std::max(longest_gap_s(), pairs_apart_s()) ? here.pair : -1;
}

/// Older pairs are not farther apart, unless frames are missing.
double TimelineTracks::pairs_apart_s() const {
  return older_pairs_ > 1 ? 2 * (pairs_[1].time_s - pairs_[0].time_s) : 0;
}

bool TimelineTracks::is_by_intent_at(double time_s) const {
  const auto after = std::upper_bound(by_intent_.begin(), by_intent_.end(), time_s,
                                      [](double t, const Interval& interval) { return t < interval.from_s; });
  return after != by_intent_.begin() && std::prev(after)->key == 1;
}

std::optional<double> TimelineTracks::edge_before(double time_s) const {
  constexpr double apart_s = 1e-6;
  auto here = std::lower_bound(moves_.begin(), moves_.end(), time_s - apart_s,
                               [](const Interval& interval, double t) { return interval.from_s < t; });
  if (here == moves_.begin()) return std::nullopt;
  return std::prev(here)->from_s;
}

std::optional<double> TimelineTracks::edge_after(double time_s) const {
  constexpr double apart_s = 1e-6;
  const auto next = std::upper_bound(moves_.begin(), moves_.end(), time_s + apart_s,
                                     [](double t, const Interval& interval) { return t < interval.from_s; });
  if (next == moves_.end()) return std::nullopt;
  return next->from_s;
}

const Interval* interval_at(const Lane& lane, double time_s) {
  const auto found = ending_after(lane, time_s);
  return found != lane.end() && found->from_s <= time_s ? &*found : nullptr;
}

Lane drawn(const Lane& lane, double from_s, double to_s, double least_s) {
  Lane shown;
  auto it = ending_after(lane, from_s);
  while (it != lane.end() && it->from_s <= to_s) {
    shown.push_back(*it);
    const double next_s = it->from_s + least_s;
    it = it->to_s >= next_s ? std::next(it) : ending_after(lane, next_s);
  }
  return shown;
}

std::string_view short_take_name(std::string_view name) {
  std::size_t digits = name.size();
  while (digits > 0 && std::isdigit(static_cast<unsigned char>(name[digits - 1]))) --digits;
  return digits < name.size() ? name.substr(digits) : name;
}

}  // namespace abrazo::widgets
