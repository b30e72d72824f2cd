#include "widgets/timeline/timeline_tracks.hpp"

#include <algorithm>
#include <cctype>

#include "widgets/common/value_range.hpp"

namespace abrazo::widgets {
namespace {

constexpr double gap_s = 0.5;  // without a frame for longer than this, an interval ends

}  // namespace

void TimelineTracks::append(double time_s, int take, std::string_view label, double cost) {
  extend(sources_, time_s, take);
  extend(moves_, time_s, label.empty() ? -1 : label_key(label));
  if (take >= 0) costs_.push_back({time_s, cost});
}

void TimelineTracks::extend(std::deque<Interval>& lane, double time_s, int key) {
  const bool continues = !lane.empty() && time_s - lane.back().to_s < gap_s;
  if (continues) lane.back().to_s = time_s;  // an interval lasts until the next begins
  if (!continues || lane.back().key != key) lane.push_back({time_s, time_s, key});
}

int TimelineTracks::label_key(std::string_view label) {
  const auto found = std::find(labels_.begin(), labels_.end(), label);
  if (found != labels_.end()) return static_cast<int>(found - labels_.begin());
  labels_.emplace_back(label);
  return static_cast<int>(labels_.size()) - 1;
}

void TimelineTracks::drop_before(double time_s) {
  for (auto* lane : {&sources_, &moves_}) {
    while (!lane->empty() && lane->front().to_s < time_s) lane->pop_front();
    if (!lane->empty()) lane->front().from_s = std::max(lane->front().from_s, time_s);
  }
  while (!costs_.empty() && costs_.front().time_s < time_s) costs_.pop_front();
}

void TimelineTracks::clear() {
  sources_.clear();
  moves_.clear();
  costs_.clear();
}

double TimelineTracks::usual_cost(double from_s, double to_s) const {
  const auto before = [](const Sample& sample, double time_s) { return sample.time_s < time_s; };
  std::vector<double> values;
  for (auto it = std::lower_bound(costs_.begin(), costs_.end(), from_s, before);
       it != costs_.end() && it->time_s <= to_s; ++it)
    values.push_back(it->value);
  return robust_upper(std::move(values));
}

std::string_view short_take_name(std::string_view name) {
  std::size_t digits = name.size();
  while (digits > 0 && std::isdigit(static_cast<unsigned char>(name[digits - 1]))) --digits;
  return digits < name.size() ? name.substr(digits) : name;
}

}  // namespace abrazo::widgets
