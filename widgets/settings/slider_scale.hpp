#pragma once

#include <algorithm>
#include <cmath>

namespace abrazo::widgets {

/// Conversion between a setting's value and a slider position. Independent of Qt. A logarithmic scale from 0
/// reserves its first hundredth for exactly 0.
struct SliderScale {
  double minimum = 0;
  double maximum = 1;
  bool logarithmic = false;
  bool whole_numbers = false;
  double gap_end = 0;  ///< if higher than the minimum: there are no values between the two

  /// @return [0, 1]
  double place(double value) const {
    const double held = std::clamp(value, minimum, maximum);
    if (maximum <= minimum) return 0;
    if (!logarithmic) return (held - minimum) / (maximum - minimum);
    if (held <= lowest()) return minimum > 0 ? 0 : held <= 0 ? 0 : zero_share;
    const double share = std::log(held / lowest()) / std::log(maximum / lowest());
    return minimum > 0 ? share : zero_share + (1 - zero_share) * share;
  }

  /// The value after some keystrokes: steps of 1 % of the scale, or whole numbers. Clamped to the ends.
  double stepped(double from, int steps) const {
    if (whole_numbers) return std::clamp(std::round(from) + steps, minimum, maximum);
    const double reached = value(place(from) + 0.01 * steps);
    const bool left_the_minimum = from <= minimum && steps > 0 && gap_end > minimum;
    return left_the_minimum ? std::max(reached, gap_end) : reached;
  }

  double value(double place) const {
    const double held = std::clamp(place, 0.0, 1.0);
    if (!logarithmic) return beside_gap(rounded(minimum + held * (maximum - minimum)));
    if (minimum > 0) return rounded(minimum * std::pow(maximum / minimum, held));
    if (held < zero_share) return minimum;
    return rounded(lowest() * std::pow(maximum / lowest(), (held - zero_share) / (1 - zero_share)));
  }

 private:
  static constexpr double zero_share = 0.01;
  static constexpr double decades = 1e4;  ///< range of a scale that begins at 0

  double lowest() const { return minimum > 0 ? minimum : maximum / decades; }

  double beside_gap(double value) const {
    if (value >= gap_end) return value;
    return value < (minimum + gap_end) / 2 ? minimum : gap_end;
  }

  /// Rounded to three significant digits of the range, for readable numbers.
  double rounded(double value) const {
    if (whole_numbers) return std::clamp(std::round(value), minimum, maximum);
    const double scale = logarithmic ? std::abs(value) : maximum - minimum;
    if (!(scale > 0)) return value;
    const double decimals = 2 - std::floor(std::log10(scale));
    // A division by a power of ten is the nearest double; a product with 0.01 is 0.6900000000000001.
    const double power = std::pow(10.0, std::abs(decimals));
    const double nearest =
        decimals >= 0 ? std::round(value * power) / power : std::round(value / power) * power;
    return std::clamp(nearest, minimum, maximum);
  }
};

}  // namespace abrazo::widgets
