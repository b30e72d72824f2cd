#pragma once

#include <span>
#include <string>
#include <vector>

#include "widgets/common/latency_sample.hpp"

namespace abrazo::widgets {

/// One line of the latency table: that of the shown frame, and how it was over the last while [ms].
struct LatencyRow {
  std::string name, meaning;
  double here = LatencySample::none;
  double p50 = LatencySample::none, p95 = LatencySample::none, p99 = LatencySample::none;
};

/// Arrival interval, the stages, in to out, in to screen.
/// @param samples  of the last while; @param here  of the shown frame, null when there is none
std::vector<LatencyRow> latency_rows(std::span<const LatencySample> samples, const LatencySample* here);

/// "2.14", "123"; "–" where there is none: three figures, at most two after the point.
std::string latency_text(double ms);

enum class LatencyVerdict { None, Good, Warning, Bad };

/// Of in to out less the delay that was asked for: good within one interval of the input (or 10 ms where that
/// is longer), bad from three on: then the partner answers a pose that is long gone.
/// @param p95_ms  in to out; @param interval_ms  median of the input's; NaN when there is none
LatencyVerdict verdict_of(double p95_ms, double delay_ms, double interval_ms);

/// The value below which `share` of those are that are finite; NaN without any.
double share_of(std::vector<double> values, double share);

}  // namespace abrazo::widgets
