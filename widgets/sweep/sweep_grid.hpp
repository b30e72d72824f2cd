#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace abrazo::widgets {

/// The best value of a metric.
enum class SweepGoal { Lowest, Highest, NearestZero };

/// One point of a grid.
struct SweepCell {
  enum class State {
    Waiting,
    Measured,
    Undefined,  ///< evaluated, but without a value of the metric
    Failed
  };
  State state = State::Waiting;
  double value = 0;         ///< when measured
  std::string explanation;  ///< of a failure
};

/// A side of a grid: a setting and the values it takes.
struct SweepSide {
  std::string key;    ///< of the setting
  std::string title;  ///< "α temporal smoothness"
  std::string unit;
  std::vector<std::string> values;
};

/// Unit of a figure of report.json by its path: "m", "ms", "µs", "m/s", "ASF units"; empty for counts and
/// shares.
std::string metric_unit(std::string_view metric);

/// A figure of report.json in words: "partner: mean joint error [m]".
std::string metric_words(std::string_view metric);

/// Viridis (van der Walt and Smith 2015) at [0, 1] as red, green, blue in [0, 1].
std::array<double, 3> sweep_colour(double fraction);

/// Data of a heat map of two settings. Points are ordered by x first; y grows upwards.
class SweepGrid {
 public:
  SweepGrid() = default;
  SweepGrid(SweepSide x, SweepSide y, std::string metric, SweepGoal goal);

  const SweepSide& x() const { return x_; }
  const SweepSide& y() const { return y_; }
  const std::string& metric() const { return metric_; }
  SweepGoal goal() const { return goal_; }
  bool empty() const { return cells_.empty(); }
  int columns() const { return static_cast<int>(x_.values.size()); }
  int rows() const { return static_cast<int>(y_.values.size()); }
  int points() const { return static_cast<int>(cells_.size()); }
  int point_at(int column, int row) const { return row * columns() + column; }
  std::pair<int, int> place_of(int point) const { return {point % columns(), point / columns()}; }

  const SweepCell& cell(int point) const { return cells_[static_cast<std::size_t>(point)]; }
  void set(int point, SweepCell cell) { cells_[static_cast<std::size_t>(point)] = std::move(cell); }
  /// Shows another metric of the same points.
  void set_metric(std::string metric, SweepGoal goal);

  int count(SweepCell::State state) const;
  /// The first point with the best value so far.
  std::optional<int> best() const;
  /// Smallest and largest value so far.
  std::optional<std::pair<double, double>> range() const;
  /// Position of a value in that range; 0.5 if all are equal.
  double fraction_of(double value) const;

  /// The neighbouring point for an arrow key, clamped to the edges.
  int moved(int point, int right, int up) const;

  /// "α 0.5, w_Δ 0.2".
  std::string place_text(int point) const;
  /// "0.183 m"; "not evaluated yet"; "no value"; "failed: ...".
  std::string value_text(int point) const;
  /// "Best so far (lowest): α 0.5, w_Δ 0.2: 0.183 m. Worst: 0.3 m."
  std::string best_text() const;

 private:
  SweepSide x_, y_;
  std::string metric_;
  SweepGoal goal_ = SweepGoal::Lowest;
  std::vector<SweepCell> cells_;
};

}  // namespace abrazo::widgets
