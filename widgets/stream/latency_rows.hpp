#pragma once

#include <span>
#include <string>
#include <vector>

#include "widgets/common/latency_sample.hpp"

namespace abrazo::widgets {

/// One line of the latency table: value of the shown frame and percentiles over recent frames [ms].
struct LatencyRow {
  std::string name, meaning;
  double here = LatencySample::none;
  double p50 = LatencySample::none, p95 = LatencySample::none, p99 = LatencySample::none;
};

/// Arrival interval, the stages, in to out, in to screen.
/// @param samples of recent frames; @param here of the shown frame, may be null
std::vector<LatencyRow> latency_rows(std::span<const LatencySample> samples, const LatencySample* here);

/// "2.14", "123"; "–" if there is none: three significant digits, at most two decimals.
std::string latency_text(double ms);

enum class LatencyVerdict { None, Good, Warning, Bad };

/// Rates in to out minus the configured delay: good within one interval of the input (or 10 ms if that is
/// longer), bad from three intervals on, because the partner then answers an outdated pose.
/// @param p95_ms in to out; @param interval_ms median interval of the input; NaN = none
LatencyVerdict verdict_of(double p95_ms, double delay_ms, double interval_ms);

/// Percentile of the finite values; NaN without any.
double share_of(std::vector<double> values, double share);

}  // namespace abrazo::widgets
