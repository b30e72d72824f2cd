#include "widgets/intended/intended_move_choice.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <tuple>

namespace abrazo::widgets {

IntendedMove meant_move(const IntendedMoveChoice& choice, IntendedMoveSpan span, double now_s) {
  IntendedMove move;
  if (choice.is_take())
    move.take = choice.take;
  else
    move.label = choice.label;
  move.until_done = span == IntendedMoveSpan::UntilDone;
  if (span == IntendedMoveSpan::FiveSeconds) move.until_s = now_s + 5;
  if (span == IntendedMoveSpan::TenSeconds) move.until_s = now_s + 10;
  return move;
}

std::string choice_title(const IntendedMoveChoice& choice) {
  if (choice.is_take()) return "take " + choice.take;
  if (choice.label.empty()) return "no label";
  std::string title = choice.label;
  std::replace(title.begin(), title.end(), '_', ' ');
  return title;
}

std::string distance_text(double distance_m) {
  if (distance_m < 0) return {};
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.*f m", distance_m < 0.1 ? 3 : 2, distance_m);
  return text.data();
}

std::vector<IntendedMoveChoice> in_order(std::vector<IntendedMoveChoice> choices) {
  const auto key = [](const IntendedMoveChoice& choice) {
    const bool is_unknown = choice.distance_m < 0;
    return std::tuple(choice.is_take(), is_unknown, is_unknown ? 0 : choice.distance_m);
  };
  std::stable_sort(choices.begin(), choices.end(),
                   [&](const IntendedMoveChoice& a, const IntendedMoveChoice& b) { return key(a) < key(b); });
  return choices;
}

std::optional<std::size_t> choice_of_digit(int digit, std::size_t choices) {
  if (digit < 1 || digit > 9 || static_cast<std::size_t>(digit) > choices) return std::nullopt;
  return static_cast<std::size_t>(digit - 1);
}

}  // namespace abrazo::widgets
