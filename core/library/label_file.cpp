#include <fmt/format.h>

#include <algorithm>
#include <climits>

#include "core/base/text.hpp"
#include "core/library/manifest.hpp"

namespace abrazo {

namespace {

struct LabelRow {
  LabelInterval interval;
  std::size_t line = 0;  ///< 1-based
};

Error at_line(std::string_view where, std::size_t line, std::string message) {
  return {std::move(message), fmt::format("{}:{}", where, line)};
}

bool is_header(const std::vector<std::string_view>& fields) {
  return fields.size() > 1 && lower_case(fields[0]) == "take" && !parse_integer(fields[1]);
}

Result<int> parse_frame(std::string_view field, const char* what, std::string_view where, std::size_t line) {
  const auto number = parse_integer(field);
  if (!number || *number < 0 || *number > INT_MAX)
    return at_line(where, line,
                   fmt::format("expected {} as a frame number from 0 on, found \"{}\"", what, field));
  return static_cast<int>(*number);
}

Result<LabelInterval> parse_row(const std::vector<std::string_view>& fields, std::string_view where,
                                std::size_t line) {
  const auto start = parse_frame(fields[1], "start_frame", where, line);
  if (!start) return start.error();
  const auto end = parse_frame(fields[2], "end_frame", where, line);
  if (!end) return end.error();
  if (*end <= *start)
    return at_line(
        where, line,
        fmt::format("the label ends at frame {}, which is not after its start {}; end is exclusive", *end,
                    *start));
  if (fields[3].empty()) return at_line(where, line, "the label is empty; name it or leave the line out");
  const auto field = [&](std::size_t i) {
    return i < fields.size() ? std::string(fields[i]) : std::string();
  };
  return LabelInterval{*start, *end, field(3), field(4), field(5)};
}

/// Sorts by start and refuses what overlaps.
Result<std::vector<LabelInterval>> ordered(std::vector<LabelRow> rows, std::string_view where) {
  std::stable_sort(rows.begin(), rows.end(),
                   [](const LabelRow& a, const LabelRow& b) { return a.interval.start < b.interval.start; });
  std::vector<LabelInterval> labels;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (i > 0 && rows[i].interval.start < rows[i - 1].interval.end)
      return at_line(where, rows[i].line,
                     fmt::format("frames {}-{} overlap those of line {} (until {}); a frame has one label",
                                 rows[i].interval.start, rows[i].interval.end, rows[i - 1].line,
                                 rows[i - 1].interval.end));
    labels.push_back(std::move(rows[i].interval));
  }
  return labels;
}

std::string_view without_byte_order_mark(std::string_view csv) {
  constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
  if (csv.starts_with(byte_order_mark)) csv.remove_prefix(byte_order_mark.size());
  return csv;
}

}  // namespace

std::vector<std::string> takes_in_labels(std::string_view csv) {
  std::vector<std::string> takes;
  bool first = true;
  for (const std::string_view text : split_lines(without_byte_order_mark(csv))) {
    if (trimmed(text).empty()) continue;
    const auto fields = split_fields(text, ',');
    if (std::exchange(first, false) && is_header(fields)) continue;
    if (std::find(takes.begin(), takes.end(), fields[0]) == takes.end()) takes.emplace_back(fields[0]);
  }
  return takes;
}

Result<std::vector<LabelInterval>> parse_labels(std::string_view csv, std::string_view take,
                                                std::string_view where) {
  csv = without_byte_order_mark(csv);
  std::vector<LabelRow> rows;
  bool first = true;
  std::size_t line = 0;
  for (const std::string_view text : split_lines(csv)) {
    ++line;
    if (trimmed(text).empty()) continue;
    const auto fields = split_fields(text, ',');
    if (std::exchange(first, false) && is_header(fields)) continue;
    if (fields.size() < 4)
      return at_line(
          where, line,
          fmt::format("expected take,start_frame,end_frame,label, found {} fields", fields.size()));
    if (fields[0] != take) continue;
    auto interval = parse_row(fields, where, line);
    if (!interval) return interval.error();
    rows.push_back({std::move(*interval), line});
  }
  return ordered(std::move(rows), where);
}

}  // namespace abrazo
