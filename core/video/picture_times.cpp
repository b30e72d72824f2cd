#include "core/video/picture_times.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace abrazo {
namespace {

constexpr double fallback_hz = 25;
constexpr double even_s = 0.0005;

double middle_of(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

std::vector<double> intervals_of(const std::vector<double>& times_s) {
  std::vector<double> intervals;
  for (std::size_t i = 1; i < times_s.size(); ++i) intervals.push_back(times_s[i] - times_s[i - 1]);
  return intervals;
}

}  // namespace

int PictureTimes::mend_end() {
  constexpr std::size_t most_at_once = 64;  // pictures that decoders hold back, on many cores
  std::size_t own = 1;
  while (own < stamps_ms.size() && stamps_ms[own] > stamps_ms[own - 1]) ++own;
  const bool is_end = own > 1 && stamps_ms.size() - own <= most_at_once &&
                      std::all_of(stamps_ms.begin() + static_cast<std::ptrdiff_t>(own), stamps_ms.end(),
                                  [](double stamp) { return stamp == 0; });
  if (!is_end) return static_cast<int>(stamps_ms.size());
  const double usual =
      middle_of(intervals_of({stamps_ms.begin(), stamps_ms.begin() + static_cast<std::ptrdiff_t>(own)}));
  for (std::size_t i = own; i < stamps_ms.size(); ++i) stamps_ms[i] = stamps_ms[i - 1] + usual;
  return static_cast<int>(own);
}

bool PictureTimes::are_usable() const {
  for (std::size_t i = 0; i < stamps_ms.size(); ++i) {
    if (!std::isfinite(stamps_ms[i])) return false;
    if (i > 0 && stamps_ms[i] <= stamps_ms[i - 1]) return false;
  }
  return true;
}

void add_times(VideoFacts& facts, const PictureTimes& times) {
  const bool usable = times.are_usable();
  const double nominal_hz =
      times.nominal_hz > 0 && std::isfinite(times.nominal_hz) ? times.nominal_hz : fallback_hz;
  for (std::size_t i = 0; i < times.stamps_ms.size(); ++i)
    facts.times_s.push_back(usable ? (times.stamps_ms[i] - times.stamps_ms[0]) / 1000
                                   : static_cast<double>(i) / nominal_hz);
  const std::vector<double> intervals = intervals_of(facts.times_s);
  const double usual_s = intervals.empty() ? 1 / nominal_hz : middle_of(intervals);
  facts.rate_hz = 1 / usual_s;
  facts.is_even = std::ranges::all_of(intervals, [&](double s) { return std::abs(s - usual_s) <= even_s; });
  if (!usable)
    facts.warnings.push_back(
        fmt::format("its pictures carry no times that go upwards; {:.4g} Hz is assumed for all, and going "
                    "back decodes from the beginning",
                    nominal_hz));
  else if (std::abs(times.nominal_hz * usual_s - 1) > 0.01)
    facts.warnings.push_back(
        fmt::format("its header says {:.4g} Hz, most pictures follow at {:.4g} Hz; the "
                    "times of the pictures are used",
                    times.nominal_hz, facts.rate_hz));
  if (times.promised > 0 && times.promised != facts.frames())
    facts.warnings.push_back(
        fmt::format("its header says {} pictures, {} can be shown: the others are cut "
                    "away by an edit list, or are damaged or missing",
                    times.promised, facts.frames()));
}

}  // namespace abrazo
