#pragma once

#include <cstddef>
#include <deque>
#include <string>
#include <string_view>
#include <vector>

namespace abrazo::widgets {

/// What the lanes of the timeline show, kept up frame by frame. Plain data, no toolkit.
class TimelineTracks {
 public:
  struct Interval {
    double from_s = 0;
    double to_s = 0;
    int key = -1;  ///< take, or index into labels()
  };
  struct Sample {
    double time_s = 0;
    double value = 0;
  };

  /// Frames come in ascending time. @param take  -1 when nothing was selected
  void append(double time_s, int take, std::string_view label, double cost);
  void drop_before(double time_s);
  void clear();

  const std::deque<Interval>& sources() const { return sources_; }
  const std::deque<Interval>& moves() const { return moves_; }
  const std::deque<Sample>& costs() const { return costs_; }
  const std::string& label(int key) const { return labels_[static_cast<std::size_t>(key)]; }

  /// How high the curve must reach for the costs in [from, to]: the largest, unless single ones tower.
  double usual_cost(double from_s, double to_s) const;

 private:
  static void extend(std::deque<Interval>& lane, double time_s, int key);
  int label_key(std::string_view label);

  std::deque<Interval> sources_, moves_;
  std::deque<Sample> costs_;
  std::vector<std::string> labels_;
};

/// The digits at the end of a take's name ("salsa_06" -> "06"), or the whole name.
std::string_view short_take_name(std::string_view name);

}  // namespace abrazo::widgets
