#include "core/evaluation/sweep/sweep_axis.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/base/text.hpp"
#include "core/synthesis/settings/settings.hpp"
#include "core/synthesis/settings/settings_check.hpp"

namespace abrazo {

namespace {

constexpr long long most_values = 1000;
constexpr std::string_view forms =
    "SETTING=FROM:TO:COUNT is expected, as in alpha=0:1:5, or SETTING=log:FROM:TO:COUNT, or the values "
    "themselves: SETTING=A,B,C";

/// A value as one would write it: equal steps of 0.1 without the last bits, equal ratios with few digits.
double rounded(double value, int digits) {
  return *parse_number(fmt::format("{:.{}g}", value, digits));
}

struct Span {
  bool logarithmic = false;
  double from = 0, to = 0;
  long long count = 0;

  double at(long long index) const {
    if (index == 0) return from;
    if (index == count - 1) return to;
    const double part = static_cast<double>(index) / static_cast<double>(count - 1);
    return logarithmic ? from * std::pow(to / from, part) : from + part * (to - from);
  }
};

Result<Span> parse_span(std::string_view text, std::string_view whole) {
  Span span;
  auto fields = split_fields(text, ':');
  if (fields.front() == "log") {
    span.logarithmic = true;
    fields.erase(fields.begin());
  }
  if (fields.size() != 3) return Error{std::string(forms), std::string(whole)};
  const auto from = parse_number(fields[0]), to = parse_number(fields[1]);
  const auto count = parse_integer(fields[2]);
  if (!from || !to || !count || !std::isfinite(*from) || !std::isfinite(*to))
    return Error{std::string(forms), std::string(whole)};
  span.from = *from, span.to = *to, span.count = *count;
  if (span.count < 2 || span.count > most_values)
    return Error{fmt::format("from 2 to {} values are expected, not {}; one value alone is SETTING=VALUE",
                             most_values, span.count),
                 std::string(whole)};
  if (span.logarithmic && !(span.from > 0 && span.to > 0))
    return Error{"equal ratios need both ends above 0; leave out log: or begin above 0", std::string(whole)};
  return span;
}

Result<std::vector<std::string>> spread(const SettingInfo& info, std::string_view text,
                                        std::string_view whole) {
  if (info.kind != SettingInfo::Kind::Real && info.kind != SettingInfo::Kind::Integer) {
    std::string values = info.kind == SettingInfo::Kind::Flag   ? "off,on"
                         : info.kind == SettingInfo::Kind::Body ? "scale:0.85,scale:1.15"
                                                                : std::string(info.choices);
    std::replace(values.begin(), values.end(), '|', ',');
    return Error{
        fmt::format("{0} has no numbers to count through; name its values, as in {0}={1}", info.key, values),
        std::string(whole)};
  }
  const auto span = parse_span(text, whole);
  if (!span) return span.error();
  std::vector<std::string> values;
  for (long long i = 0; i < span->count; ++i) {
    const double value = span->at(i);
    values.push_back(exact_text(info.kind == SettingInfo::Kind::Integer
                                    ? std::round(value)
                                    : rounded(value, span->logarithmic ? 4 : 8)));
  }
  return values;
}

Status check_values(const SweepAxis& axis, std::string_view whole) {
  for (const std::string& value : axis.values) {
    Settings scratch;
    Status usable = set_setting(scratch, axis.key, value);
    if (usable) usable = check_settings(scratch);
    if (!usable) return Error{usable.error().message, std::string(whole)};
    if (std::count(axis.values.begin(), axis.values.end(), value) > 1)
      return Error{fmt::format("gives {} twice; ask for fewer values or a wider range", value),
                   std::string(whole)};
  }
  return Done{};
}

}  // namespace

Result<SweepAxis> parse_sweep_axis(std::string_view text) {
  const std::size_t equals = text.find('=');
  if (equals == std::string_view::npos) return Error{std::string(forms), std::string(text)};
  const std::string_view key = trimmed(text.substr(0, equals)), rest = text.substr(equals + 1);
  const SettingInfo* const info = find_setting(key);
  if (info == nullptr)
    return Error{fmt::format("{} is not a setting; there are {}", in_quotes(key), setting_names()),
                 std::string(text)};
  SweepAxis axis{std::string(key), {}};
  if (rest.find(':') == std::string_view::npos) {
    for (const std::string_view value : split_fields(rest, ',')) {
      const auto number = parse_number(value);
      axis.values.push_back(number ? exact_text(*number) : std::string(value));
    }
  } else {
    auto values = spread(*info, rest, text);
    if (!values) return values.error();
    axis.values = std::move(*values);
  }
  if (const Status usable = check_values(axis, text); !usable) return usable.error();
  return axis;
}

}  // namespace abrazo
