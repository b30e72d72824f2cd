#pragma once

#include <optional>
#include <string>
#include <vector>

namespace abrazo {

struct PlotAxis {
  std::string title;  ///< with the unit: "error (cm)"
  bool logarithmic = false;
  std::optional<double> minimum = {}, maximum = {};  ///< otherwise round numbers around the data
};

/// Round numbers (1, 2 or 5 times a power of ten apart) from `low` to `high` inclusive, about `count` of
/// them.
std::vector<double> linear_ticks(double low, double high, int count);

/// Powers of ten from `low` to `high` inclusive; over less than two decades also 2 and 5 times those.
std::vector<double> logarithmic_ticks(double low, double high);

/// Places of values on an axis.
class AxisScale {
 public:
  /// @param low, high      smallest and largest value to be shown; positive when logarithmic
  /// @param begin, end     their places, in the picture's unit
  AxisScale(const PlotAxis& axis, double low, double high, double begin, double end, int tick_count);

  double at(double value) const;
  double low() const { return low_; }
  double high() const { return high_; }
  const std::vector<double>& ticks() const { return ticks_; }

 private:
  void widen_linear(const PlotAxis& axis, int tick_count);
  void widen_logarithmic(const PlotAxis& axis);

  bool logarithmic_;
  double low_, high_, begin_, end_;
  std::vector<double> ticks_;
};

}  // namespace abrazo
