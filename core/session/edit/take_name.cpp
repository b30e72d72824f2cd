#include "core/session/edit/take_name.hpp"

#include <algorithm>
#include <cctype>

#include "core/base/text.hpp"

namespace abrazo {
namespace {

constexpr std::size_t most_digits = 6, least_digits = 3;

bool is_digit(char c) {
  return std::isdigit(static_cast<unsigned char>(c)) != 0;
}

std::string without_end(std::string_view stem) {
  constexpr std::string_view between = " _-.";
  while (!stem.empty() && between.find(stem.back()) != std::string_view::npos) stem.remove_suffix(1);
  return std::string(stem);
}

}  // namespace

TakeName parse_take_name(std::string_view text) {
  text = trimmed(text);
  std::size_t digits = 0;
  while (digits < text.size() && is_digit(text[text.size() - 1 - digits])) ++digits;
  if (digits == 0 || digits > most_digits) return {std::string(text), 0};
  const std::string stem = without_end(text.substr(0, text.size() - digits));
  return {stem, static_cast<int>(*parse_integer(text.substr(text.size() - digits)))};
}

std::string text_of(const TakeName& name) {
  std::string digits = std::to_string(name.number);
  digits.insert(0, least_digits - std::min(least_digits, digits.size()), '0');
  return name.stem.empty() ? digits : name.stem + " " + digits;
}

std::string next_take_name(std::string_view typed, const std::vector<std::string>& names) {
  TakeName next = parse_take_name(typed);
  if (next.stem.empty() && next.number == 0) next.stem = "take";
  int highest = 0;
  bool is_free = next.number > 0;
  for (const std::string& each : names) {
    const TakeName other = parse_take_name(each);
    if (other.stem != next.stem) continue;
    highest = std::max(highest, other.number);
    is_free = is_free && other.number != next.number;
  }
  if (!is_free) next.number = highest + 1;
  return text_of(next);
}

std::string again_name(const std::vector<std::string>& names) {
  if (names.empty()) return {};
  const TakeName last = parse_take_name(names.back());
  return next_take_name(last.stem.empty() ? std::to_string(last.number) : last.stem, names);
}

}  // namespace abrazo
