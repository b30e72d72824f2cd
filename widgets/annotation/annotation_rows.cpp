#include "widgets/annotation/annotation_rows.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/base/text.hpp"

namespace abrazo::widgets {

std::optional<double> typed_time(std::string_view text, double fps) {
  text = trimmed(text);
  if (text.empty()) return std::nullopt;
  const bool hash = text.front() == '#', f = text.back() == 'f';
  if (hash || f) {
    const auto frame = parse_number(trimmed(hash ? text.substr(1) : text.substr(0, text.size() - 1)));
    if (!frame || fps <= 0) return std::nullopt;
    return *frame / fps;
  }
  if (text.back() == 's') text = trimmed(text.substr(0, text.size() - 1));
  const std::size_t colon = text.find(':');
  const auto seconds = parse_number(colon == std::string_view::npos ? text : text.substr(colon + 1));
  if (!seconds || !std::isfinite(*seconds)) return std::nullopt;
  if (colon == std::string_view::npos) return *seconds;
  const auto minutes = parse_number(text.substr(0, colon));
  if (!minutes || *seconds < 0 || *seconds >= 60) return std::nullopt;
  return 60 * *minutes + *seconds;
}

std::string seconds_text(double time_s) {
  return fmt::format("{:.3f}", time_s);
}

std::string frame_text(double time_s, double fps) {
  return fps > 0 ? fmt::format("{:.0f}", std::round(time_s * fps)) : std::string();
}

std::string coverage_text(const AnnotationTier& tier, const Annotations::Range& range) {
  double covered_s = 0;
  for (const Annotation& each : tier.annotations)
    covered_s += std::max(0.0, std::min(each.end_s, range.last_s) - std::max(each.start_s, range.first_s));
  const double whole_s = range.last_s - range.first_s;
  const std::size_t count = tier.annotations.size();
  if (!(whole_s > 0)) return fmt::format("{} label{}", count, count == 1 ? "" : "s");
  return fmt::format("{} label{}, {:.0f} % of {:.1f} s", count, count == 1 ? "" : "s",
                     std::floor(100 * covered_s / whole_s + 1e-9), whole_s);
}

}  // namespace abrazo::widgets
