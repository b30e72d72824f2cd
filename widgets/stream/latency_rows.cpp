#include "widgets/stream/latency_rows.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace abrazo::widgets {
namespace {

LatencyRow row(std::string_view name, std::string_view meaning, std::span<const LatencySample> samples,
               const LatencySample* here, double (*value)(const LatencySample&, int), int argument) {
  LatencyRow made{std::string(name), std::string(meaning)};
  if (here) made.here = value(*here, argument);
  std::vector<double> values;
  values.reserve(samples.size());
  for (const LatencySample& sample : samples) values.push_back(value(sample, argument));
  made.p50 = share_of(values, 0.5);
  made.p95 = share_of(values, 0.95);
  made.p99 = share_of(std::move(values), 0.99);
  return made;
}

}  // namespace

double share_of(std::vector<double> values, double share) {
  std::erase_if(values, [](double v) { return !std::isfinite(v); });
  if (values.empty()) return LatencySample::none;
  const auto place = static_cast<std::ptrdiff_t>(std::ceil(share * static_cast<double>(values.size()))) - 1;
  const auto wanted = values.begin() + std::max<std::ptrdiff_t>(place, 0);
  std::nth_element(values.begin(), wanted, values.end());
  return *wanted;
}

std::vector<LatencyRow> latency_rows(std::span<const LatencySample> samples, const LatencySample* here) {
  std::vector<LatencyRow> rows;
  rows.push_back(row(
      "Interval", "between the arrivals of two poses", samples, here,
      [](const LatencySample& s, int) { return s.interval; }, 0));
  for (int stage = 0; stage < latency_stage_count; ++stage) {
    const LatencyStageInfo& info = info_of(static_cast<LatencyStage>(stage));
    rows.push_back(row(
        info.name, info.meaning, samples, here,
        [](const LatencySample& s, int which) { return s.stage(static_cast<LatencyStage>(which)); }, stage));
  }
  const bool is_sent = here ? here->is_sent : !samples.empty() && samples.back().is_sent;
  rows.push_back(row(
      is_sent ? "In → out" : "In → pose",
      is_sent ? "from the first packet of the user's pose to the last packet of the partner's"
              : "from the first packet of the user's pose to the partner's pose; nothing is sent on",
      samples, here, [](const LatencySample& s, int) { return s.end_to_end; }, 0));
  rows.push_back(row(
      "In → screen", "from the first packet of the user's pose until the pair is drawn", samples, here,
      [](const LatencySample& s, int) { return s.to_screen; }, 0));
  return rows;
}

std::string latency_text(double ms) {
  if (!std::isfinite(ms)) return "–";
  std::array<char, 32> text{};
  const double size = std::abs(ms);
  std::snprintf(text.data(), text.size(), "%.*f", size >= 99.95 ? 0 : size >= 9.995 ? 1 : 2, ms);
  return text.data();
}

LatencyVerdict verdict_of(double p95_ms, double delay_ms, double interval_ms) {
  if (!std::isfinite(p95_ms)) return LatencyVerdict::None;
  constexpr double usual_ms = 10, late = 3;
  const double allowed = std::isfinite(interval_ms) ? std::max(interval_ms, usual_ms) : usual_ms;
  const double own = p95_ms - delay_ms;
  return own <= allowed          ? LatencyVerdict::Good
         : own <= late * allowed ? LatencyVerdict::Warning
                                 : LatencyVerdict::Bad;
}

}  // namespace abrazo::widgets
