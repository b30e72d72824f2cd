#pragma once

#include <array>
#include <deque>
#include <vector>

#include "core/base/positions.hpp"

namespace abrazo::widgets {

/// Recent paths of the joints of the pair. Bounded in time and number.
class JointTrails {
 public:
  static constexpr std::size_t most_samples = 400;
  static constexpr double leap_s = 0.4;  ///< a larger gap between frames means that the cursor was moved

  void set_length(double length_s) { length_s_ = length_s; }
  double length_s() const { return length_s_; }

  /// @param time_s of the pose; a time that is not later than the last, or much later, restarts the trail. A
  /// pose within the trail's time resolution replaces the last.
  void add(double time_s, const PairPose& pair);
  void clear() { samples_.clear(); }
  std::size_t size() const { return samples_.size(); }
  /// Start of the known past; the trail has room for earlier poses.
  double known_since_s() const { return samples_.empty() ? 0 : samples_.front().time_s; }
  double last_s() const { return samples_.empty() ? 0 : samples_.back().time_s; }

  struct Lines {
    std::vector<double> xyz;                ///< three per point, world [m]
    std::vector<std::array<int, 2>> lines;  ///< indices of points
    std::vector<double> age;                ///< per line, 0 = new to 1 = oldest
    std::vector<int> vertex;                ///< per line
  };
  Lines lines_of(const std::vector<int>& vertices) const;

 private:
  struct Sample {
    double time_s;
    PairPose pair;
  };
  std::deque<Sample> samples_;
  double length_s_ = 1.5;
};

}  // namespace abrazo::widgets
