#include "core/library/takes/elan_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "core/base/text.hpp"

namespace abrazo {

namespace {

constexpr const char* elan_form =
    "expected ELAN's tab-delimited text: tier, participant, begin time, end time, duration and annotation, "
    "with a "
    "tab between them";

enum class TimeForm { Clock, OneNumber, Thousandths };

/// "00:01:02.340", "62.34" or "62340".
std::optional<TimeForm> form_of(std::string_view word) {
  if (word.empty()) return std::nullopt;
  if (std::count(word.begin(), word.end(), ':') == 2) return TimeForm::Clock;
  if (!parse_number(word)) return std::nullopt;
  return word.find_first_of(".,") == std::string_view::npos ? TimeForm::Thousandths : TimeForm::OneNumber;
}

std::optional<double> seconds_of(std::string_view word, TimeForm form) {
  std::string plain(word);
  std::replace(plain.begin(), plain.end(), ',', '.');
  double seconds = 0;
  const auto parts = split_fields(plain, ':');
  if ((form == TimeForm::Clock) != (parts.size() == 3)) return std::nullopt;
  for (const std::string_view part : parts) {
    const auto number = parse_number(part);
    if (!number || !(*number >= 0) || !std::isfinite(*number)) return std::nullopt;
    seconds = 60 * seconds + *number;
  }
  return form == TimeForm::Thousandths ? seconds / 1000 : seconds;
}

/// Where the columns stand; `end` or `duration` is -1 where it is not exported.
struct ElanColumns {
  int tier = 0, begin = -1, end = -1, duration = -1, value = -1;
  TimeForm form = TimeForm::OneNumber;
};

using ElanFields = std::vector<std::string_view>;

std::optional<ElanColumns> titled_columns(const ElanFields& titles) {
  ElanColumns columns{-1};
  const auto time = [&](std::string_view title, std::string_view word, int at, int& column) {
    if (!title.starts_with(word)) return;
    const TimeForm form = title.find("hh:mm:ss") != std::string_view::npos  ? TimeForm::Clock
                          : title.find("ss.msec") != std::string_view::npos ? TimeForm::OneNumber
                                                                            : TimeForm::Thousandths;
    // Of several forms the seconds: they are exported to the millisecond, as the clock is.
    if (column < 0 || form == TimeForm::OneNumber) column = at, columns.form = form;
  };
  for (std::size_t i = 0; i < titles.size(); ++i) {
    const std::string title = lower_case(trimmed(titles[i]));
    const int at = static_cast<int>(i);
    if (title == "tier") columns.tier = at;
    if (title == "annotation") columns.value = at;
    time(title, "begin time", at, columns.begin);
    time(title, "end time", at, columns.end);
    time(title, "duration", at, columns.duration);
  }
  const bool whole = columns.tier >= 0 && columns.begin >= 0 && columns.value >= 0 &&
                     (columns.end >= 0 || columns.duration >= 0);
  return whole ? std::optional(columns) : std::nullopt;
}

/// Without titles: behind tier and participant the times, each in all forms that were exported; then the
/// annotation.
std::optional<ElanColumns> usual_columns(const ElanFields& row) {
  if (row.size() < 5) return std::nullopt;
  const std::size_t first = 2;
  std::size_t times = 0;
  while (first + times + 1 < row.size() && form_of(trimmed(row[first + times]))) ++times;
  if (first + times + 1 != row.size()) return std::nullopt;
  for (const std::size_t kinds : {3U, 2U}) {
    if (times == 0 || times % kinds != 0) continue;
    const std::size_t forms = times / kinds;
    ElanColumns columns{0, 2, static_cast<int>(2 + forms), -1, static_cast<int>(row.size() - 1)};
    columns.form = *form_of(trimmed(row[first]));
    const auto begin = seconds_of(trimmed(row[first]), columns.form);
    const auto end = seconds_of(trimmed(row[first + forms]), columns.form);
    if (!begin || !end || *end < *begin) continue;
    if (kinds == 3) {
      const auto duration = seconds_of(trimmed(row[first + 2 * forms]), columns.form);
      if (!duration || std::abs(*end - *begin - *duration) > 0.0015) continue;
    }
    return columns;
  }
  return std::nullopt;
}

}  // namespace

Result<TierDocument> parse_elan_text(std::string_view text, std::string_view where) {
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
  std::optional<ElanColumns> columns;
  std::vector<std::string> order;
  std::map<std::string, Tier> tiers;
  std::size_t number = 0;
  for (const std::string_view line : split_lines(text)) {
    ++number;
    // ELAN can write where the media are above everything.
    if (trimmed(line).empty() || line.front() == '"' || line.front() == '#') continue;
    const ElanFields row = split_fields(line, '\t');
    if (!columns) {
      columns = titled_columns(row);
      if (columns) continue;
      columns = usual_columns(row);
      if (!columns)
        return error_at_line(where, number, std::string(elan_form) + ", found " + in_quotes(line));
    }
    const auto field = [&](int at) {
      return at >= 0 && static_cast<std::size_t>(at) < row.size() ? trimmed(row[static_cast<std::size_t>(at)])
                                                                  : std::string_view();
    };
    const auto begin = seconds_of(field(columns->begin), columns->form);
    auto end = seconds_of(field(columns->end >= 0 ? columns->end : columns->duration), columns->form);
    if (begin && end && columns->end < 0) *end += *begin;
    if (!begin || !end)
      return error_at_line(where, number,
                           "expected the times of an annotation, found " + in_quotes(field(columns->begin)) +
                               " and " +
                               in_quotes(field(columns->end >= 0 ? columns->end : columns->duration)));
    if (!(*end > *begin))
      return error_at_line(
          where, number,
          fmt::format("the annotation ends at {:.3f} s, and begins at {:.3f} s", *end, *begin));
    const std::string name(field(columns->tier));
    Tier& tier = tiers[name];
    if (tier.intervals.empty()) {
      order.push_back(name);
      tier.name = name.empty() ? "annotations" : name;
      tier.kind = kind_of_name(tier.name);
    }
    tier.intervals.push_back({*begin, *end, std::string(field(columns->value))});
  }
  if (order.empty()) return Error{std::string("has no annotations; ") + elan_form, std::string(where)};
  TierDocument document;
  for (const std::string& name : order) {
    Tier& tier = tiers[name];
    std::ranges::stable_sort(tier.intervals, {}, &TierInterval::start_s);
    document.tiers.push_back(std::move(tier));
  }
  return document;
}

}  // namespace abrazo
