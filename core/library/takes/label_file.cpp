#include <fmt/format.h>

#include <algorithm>
#include <climits>
#include <cmath>

#include "core/base/text.hpp"
#include "core/library/takes/csv_text.hpp"
#include "core/library/takes/manifest.hpp"

namespace abrazo {

namespace {

struct LabelRow {
  LabelInterval interval;
  std::size_t line = 0;  ///< 1-based
};

bool is_header(const std::vector<std::string>& fields) {
  return fields.size() > 1 && lower_case(fields[0]) == "take" && !parse_number(fields[1]);
}

Result<int> parse_frame(std::string_view field, const char* what, std::string_view where, std::size_t line) {
  const auto number = parse_number(field);  // pandas writes 12.0
  if (!number || !(*number >= 0 && *number <= INT_MAX) || *number != std::floor(*number))
    return error_at_line(where, line,
                         fmt::format("expected {} as a frame number from 0 on, found \"{}\"", what, field));
  return static_cast<int>(*number);
}

Result<LabelInterval> parse_row(const std::vector<std::string>& fields, std::string_view where,
                                std::size_t line) {
  const auto start = parse_frame(fields[1], "start_frame", where, line);
  if (!start) return start.error();
  const auto end = parse_frame(fields[2], "end_frame", where, line);
  if (!end) return end.error();
  if (*end <= *start)
    return error_at_line(
        where, line,
        fmt::format("the label ends at frame {}, which is not after its start {}; end is exclusive", *end,
                    *start));
  if (fields[3].empty())
    return error_at_line(where, line, "the label is empty; name it or leave the line out");
  const auto field = [&](std::size_t i) { return i < fields.size() ? fields[i] : std::string(); };
  return LabelInterval{
      .start = *start, .end = *end, .label = field(3), .detail = field(4), .confidence = field(5)};
}

/// Sorts by start and refuses what overlaps.
Result<std::vector<LabelInterval>> ordered(std::vector<LabelRow> rows, std::string_view where) {
  std::stable_sort(rows.begin(), rows.end(),
                   [](const LabelRow& a, const LabelRow& b) { return a.interval.start < b.interval.start; });
  std::vector<LabelInterval> labels;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (i > 0 && rows[i].interval.start < rows[i - 1].interval.end)
      return error_at_line(
          where, rows[i].line,
          fmt::format("frames {}-{} overlap those of line {} (until {}); a frame has one label",
                      rows[i].interval.start, rows[i].interval.end, rows[i - 1].line,
                      rows[i - 1].interval.end));
    labels.push_back(std::move(rows[i].interval));
  }
  return labels;
}

}  // namespace

std::vector<std::string> takes_in_labels(std::string_view csv) {
  std::vector<std::string> takes;
  const auto rows = parse_csv(csv, "");
  if (!rows) return takes;
  for (const CsvRow& row : *rows) {
    if (&row == &rows->front() && is_header(row.fields)) continue;
    if (std::find(takes.begin(), takes.end(), row.fields[0]) == takes.end()) takes.push_back(row.fields[0]);
  }
  return takes;
}

Result<std::vector<LabelInterval>> parse_labels(std::string_view csv, std::string_view take,
                                                std::string_view where) {
  const auto table = parse_csv(csv, where);
  if (!table) return table.error();
  std::vector<LabelRow> rows;
  for (const CsvRow& row : *table) {
    if (&row == &table->front() && is_header(row.fields)) continue;
    if (row.fields.size() < 4)
      return error_at_line(
          where, row.line,
          fmt::format("expected take,start_frame,end_frame,label, found {} fields", row.fields.size()));
    if (row.fields[0] != take) continue;
    auto interval = parse_row(row.fields, where, row.line);
    if (!interval) return interval.error();
    rows.push_back({std::move(*interval), row.line});
  }
  return ordered(std::move(rows), where);
}

}  // namespace abrazo
