#include "core/motion/tables/point_csv.hpp"

#include <algorithm>

#include "core/base/text.hpp"
#include "core/motion/joints/performers.hpp"
#include "core/motion/tables/point_csv_header.hpp"
#include "core/motion/tables/table_line.hpp"

namespace abrazo {

namespace {

/// A line of units ("mm, mm, mm") below the header.
bool note_units(const std::vector<std::string_view>& fields, PointCsvHeader& header) {
  const std::size_t first = header.columns.front().fields[0];
  if (first >= fields.size() || parse_number(fields[first])) return false;
  const auto unit = metres_of_unit(fields[first]);
  if (unit) header.metres_per_unit = unit;
  return unit.has_value();
}

bool has_number(const std::vector<std::string_view>& fields) {
  for (const std::string_view field : fields)
    if (!field.empty() && field.find_first_of("0123456789") != std::string_view::npos) return true;
  return false;
}

bool is_empty(const std::vector<std::string_view>& fields) {
  return std::ranges::all_of(fields, [](std::string_view field) { return field.empty(); });
}

}  // namespace

Result<std::vector<NamedMotion>> read_point_csv(std::string_view text, std::string_view where) {
  if (trimmed(text).empty())
    return Error{"is empty; expected a table of positions with columns such as root_x, root_y, root_z",
                 std::string(where)};
  LineReader lines(text);
  Result<PointCsvHeader> parsed = parse_point_csv_header(lines, where);
  if (!parsed) return parsed.error();
  PointCsvHeader& header = *parsed;
  PointRows rows(header.columns, header.time_field);
  std::size_t expected = 0;
  for (const PointColumn& column : header.columns)
    for (const std::size_t field : column.fields) expected = std::max(expected, field + 1);
  std::string_view line;
  std::size_t empty = 0;  // a spreadsheet leaves such rows of what was deleted there
  int first_empty = 0;
  while (lines.next(line)) {
    if (trimmed(line).empty()) continue;
    const auto fields = table_fields(line, header.separator);
    if (fields.size() >= expected && is_empty(fields)) {
      if (empty++ == 0) first_empty = lines.number();
      continue;
    }
    // Between others nobody was seen, unless the time tells how many frames are missing.
    if (rows.frames() > 0 && !header.time_field && has_number(fields))
      for (; empty > 0; --empty)
        if (const Status added = rows.add(std::vector<std::string_view>(expected), where, first_empty);
            !added)
          return added.error();
    if (rows.frames() == 0 && note_units(fields, header)) continue;
    if (rows.frames() > 0 && !has_number(fields) && fields.size() < expected) break;  // another table follows
    const bool last = trimmed(lines.rest()).empty();
    if (fields.size() < expected && last && rows.frames() > 0) {
      header.warnings.push_back(
          {"truncated", lines.number(),
           "the file ends inside a row; the " + std::to_string(rows.frames()) + " whole ones were kept"});
      break;
    }
    if (fields.size() < expected)
      return error_at(where, lines.number(),
                      "expected at least " + std::to_string(expected) +
                          " fields, as the header names them, found " + std::to_string(fields.size()));
    if (const Status added = rows.add(fields, where, lines.number()); !added) return added.error();
  }
  if (empty > 0)
    header.warnings.push_back(
        {"empty-rows", first_empty,
         std::to_string(empty) + (empty == 1 ? " empty row was" : " empty rows were") + " left out"});
  if (rows.frames() == 0) return Error{"has no rows of numbers below its header", std::string(where)};
  NamedMotion motion = rows.take(header.seconds_per_time);
  if (header.fps) motion.fps = header.fps;
  motion.metres_per_unit = header.metres_per_unit;
  motion.warnings.insert(motion.warnings.begin(), header.warnings.begin(), header.warnings.end());
  motion.name = stem_of(where);
  return split_performers(std::move(motion), ":.");
}

bool holds_positions(std::string_view head) {
  LineReader lines(head);
  return parse_point_csv_header(lines, "").ok();
}

}  // namespace abrazo
