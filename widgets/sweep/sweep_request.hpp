#pragma once

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "core/base/text.hpp"
#include "core/synthesis/settings/settings.hpp"

namespace abrazo::widgets {

/// A sweep request in the syntax of the command line.
struct SweepRequest {
  std::string x, y;                ///< "alpha=0:1:5", "velocity-weight=log:0.01:1:5", "foot-locks=off,on"
  std::string metric;              ///< path in report.json
  std::vector<std::string> takes;  ///< evaluated takes; empty = all
};

/// Ends and number of values of one side.
struct SweepSpan {
  double from = 0, to = 1;
  int count = 5;

  bool operator==(const SweepSpan&) const = default;
};

inline bool is_counted(const SettingInfo& info) {
  return info.kind == SettingInfo::Kind::Real || info.kind == SettingInfo::Kind::Integer;
}

/// A useful range around the present value: a decade to either side for logarithmic sliders, else from the
/// lower end to a multiple of the value.
inline SweepSpan usual_span(const SettingInfo& info, double now) {
  const auto two_digits = [](double value) {
    if (!(value > 0)) return value;
    const double digit = std::pow(10.0, std::floor(std::log10(value)) - 1);
    return std::round(value / digit) * digit;
  };
  if (info.key == "step-rate") return {15, 60, 4};
  SweepSpan span;
  if (info.logarithmic) {
    span.from = std::max(info.minimum, two_digits(now / 10));
    span.to = std::min(info.maximum, two_digits(now * 10));
  } else {
    span.from = info.minimum;
    span.to = std::min(info.maximum, two_digits(std::max(4 * now, (info.maximum - info.minimum) / 5)));
  }
  if (info.kind == SettingInfo::Kind::Integer) {
    span.to = std::round(span.to);
    span.count = std::min(5, static_cast<int>(span.to - span.from) + 1);
  }
  return span;
}

/// "alpha=0:1:5". A setting without numbers uses all its values.
inline std::string axis_text(const SettingInfo& info, const std::string& from, const std::string& to,
                             int count) {
  const std::string key(info.key);
  if (info.kind == SettingInfo::Kind::Flag) return key + "=off,on";
  if (info.kind == SettingInfo::Kind::Body) return key + "=scale:0.85,library,scale:1.15";
  if (info.kind == SettingInfo::Kind::Choice) {
    std::string values(info.choices);
    std::replace(values.begin(), values.end(), '|', ',');
    return key + "=" + values;
  }
  if (count == 1) return key + "=" + from;
  const auto lowest = parse_number(from);
  const bool equal_ratios = info.logarithmic && lowest && *lowest > 0;
  return key + "=" + (equal_ratios ? "log:" : "") + from + ":" + to + ":" + std::to_string(count);
}

}  // namespace abrazo::widgets
