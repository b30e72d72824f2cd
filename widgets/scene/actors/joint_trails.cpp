#include "widgets/scene/actors/joint_trails.hpp"

#include <algorithm>

namespace abrazo::widgets {

void JointTrails::add(double time_s, const PairPose& pair) {
  if (!samples_.empty()) {
    const double passed = time_s - samples_.back().time_s;
    if (passed == 0) {  // the same moment, solved again
      samples_.back().pair = pair;
      return;
    }
    if (passed < 0 || passed > leap_s) samples_.clear();
  }
  // Thinned rather than cut: the last sample moves along until the one before it is far enough behind.
  const double apart_s = length_s_ / static_cast<double>(most_samples - 2);
  const std::size_t kept = samples_.size();
  if (kept >= 2 && samples_[kept - 1].time_s - samples_[kept - 2].time_s < apart_s) samples_.pop_back();
  samples_.push_back({time_s, pair});
  while (samples_.size() > most_samples || samples_.front().time_s < time_s - length_s_) samples_.pop_front();
}

JointTrails::Lines JointTrails::lines_of(const std::vector<int>& vertices) const {
  Lines trail;
  for (const int vertex : vertices) {
    const int first = static_cast<int>(trail.xyz.size() / 3);
    for (std::size_t s = 0; s < samples_.size(); ++s) {
      for (int axis = 0; axis < 3; ++axis) trail.xyz.push_back(samples_[s].pair(vertex, axis));
      if (s == 0) continue;
      const int here = first + static_cast<int>(s);
      trail.lines.push_back({here - 1, here});
      trail.age.push_back(std::min(1.0, (samples_.back().time_s - samples_[s].time_s) / length_s_));
      trail.vertex.push_back(vertex);
    }
  }
  return trail;
}

}  // namespace abrazo::widgets
