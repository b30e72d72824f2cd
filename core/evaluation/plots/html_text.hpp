#pragma once

#include <limits>
#include <string>
#include <string_view>

namespace abrazo {

/// Value of a figure that does not exist; shown as a dash.
inline constexpr double not_known = std::numeric_limits<double>::quiet_NaN();

/// A part of a whole; not known if the whole is 0.
inline double share_of(double part, double whole) {
  return whole > 0 ? part / whole : not_known;
}

/// "12 400", "0.35": with this number of significant digits, thousands separated from 10 000 on, no exponent
/// for common sizes; "–" for what is not finite.
std::string number_text(double value, int significant_digits = 3);

/// The same, but "< 0.01" where a positive value is less than half of `least`.
std::string small_number(double value, double least, int significant_digits = 3);

/// As many digits as a round number needs: "60", "0.5", "2.5".
std::string plain_number(double value);

/// A number with this many decimals; "–" if it is not known.
std::string fixed_text(double value, int decimals);

/// "12.3 %" of 0.123.
std::string percent_text(double share, int decimals = 1);

/// "3 moves", "1 move".
std::string count_text(int count, std::string_view singular, std::string_view plural = "");

}  // namespace abrazo
