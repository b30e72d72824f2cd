#include "core/evaluation/plots/html_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace abrazo {

namespace {

constexpr std::string_view thin_space = "\u202f";
constexpr std::string_view minus = "\u2212";

std::string with_thousands_apart(std::string digits) {
  const std::size_t point = std::min(digits.find('.'), digits.size());
  for (std::size_t at = point; at > 3; at -= 3) digits.insert(at - 3, thin_space);
  return digits;
}

}  // namespace

std::string number_text(double value, int significant_digits) {
  if (!std::isfinite(value)) return "\u2013";
  if (value == 0) return "0";
  const double size = std::abs(value);
  std::string digits;
  if (size < 1e-4 || size >= 1e12) {
    digits = fmt::format("{:.{}g}", size, significant_digits);
  } else {
    const int decimals = significant_digits - 1 - static_cast<int>(std::floor(std::log10(size)));
    digits = fmt::format("{:.{}f}", size, std::max(0, decimals));
    if (size >= 1e4) digits = with_thousands_apart(std::move(digits));
  }
  return (value < 0 ? std::string(minus) : std::string()) + digits;
}

std::string small_number(double value, double least, int significant_digits) {
  if (value > 0 && value < least / 2) return "< " + plain_number(least);
  return number_text(value, significant_digits);
}

std::string plain_number(double value) {
  std::string digits = number_text(value, 4);
  if (digits.find('.') == std::string::npos || digits.find('e') != std::string::npos) return digits;
  digits.erase(digits.find_last_not_of('0') + 1);
  if (digits.back() == '.') digits.pop_back();
  return digits;
}

std::string fixed_text(double value, int decimals) {
  if (!std::isfinite(value)) return "\u2013";
  return (value < 0 ? std::string(minus) : std::string()) + fmt::format("{:.{}f}", std::abs(value), decimals);
}

std::string percent_text(double share, int decimals) {
  if (!std::isfinite(share)) return "\u2013";
  return fixed_text(100 * share, decimals) + "\u00a0%";
}

std::string count_text(int count, std::string_view singular, std::string_view plural) {
  const std::string many = plural.empty() ? std::string(singular) + "s" : std::string(plural);
  return number_text(count, 1) + " " + (count == 1 ? std::string(singular) : many);
}

}  // namespace abrazo
