#include "app/workbench/project/remembered_view.hpp"

#include <cmath>
#include <numbers>

#include "core/base/text.hpp"

namespace abrazo::app {

std::string text_of(const CameraTurn& turn) {
  return exact_text(turn.azimuth_rad) + " " + exact_text(turn.elevation_rad);
}

std::optional<CameraTurn> camera_turn_of(const std::string& text) {
  const auto words = split_words(text);
  const auto azimuth = words.size() == 2 ? parse_number(words[0]) : std::nullopt;
  const auto elevation = words.size() == 2 ? parse_number(words[1]) : std::nullopt;
  if (!azimuth || !elevation || !std::isfinite(*azimuth)) return std::nullopt;
  if (!(std::abs(*elevation) <= std::numbers::pi / 2)) return std::nullopt;
  return CameraTurn{std::remainder(*azimuth, 2 * std::numbers::pi), *elevation};
}

}  // namespace abrazo::app
