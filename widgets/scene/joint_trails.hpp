#pragma once

#include <array>
#include <deque>
#include <vector>

#include "core/base/positions.hpp"

namespace abrazo::widgets {

/// Where the joints of the pair were during the last moments. Bounded in time and in number.
class JointTrails {
 public:
  static constexpr double length_s = 1.5;
  static constexpr std::size_t most_samples = 200;
  static constexpr double leap_s =
      0.4;  ///< between two frames: the cursor was moved, and the past is another

  /// @param time_s  of the pose; one that is not later than the last, or much later, begins anew
  void add(double time_s, const PairPose& pair);
  void clear() { samples_.clear(); }
  std::size_t size() const { return samples_.size(); }

  struct Lines {
    std::vector<double> xyz;                ///< three per point, world [m]
    std::vector<std::array<int, 2>> lines;  ///< indices of points
    std::vector<double> age;                ///< per line, 0 new to 1 about to go
    std::vector<int> vertex;                ///< per line
  };
  Lines lines_of(const std::vector<int>& vertices) const;

 private:
  struct Sample {
    double time_s;
    PairPose pair;
  };
  std::deque<Sample> samples_;
};

}  // namespace abrazo::widgets
