#include "core/motion/tables/point_csv.hpp"

#include <algorithm>

#include "core/base/statistics.hpp"
#include "core/base/text.hpp"
#include "core/motion/body/body.hpp"
#include "core/motion/joints/map_choice.hpp"
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

/// Turns of joints in degrees, in columns called like places.
bool look_like_angles(const NamedMotion& motion) {
  constexpr std::size_t fewest_frames = 10;
  constexpr double full_turn = 360.5, steady = 0.5;
  const ChosenMap chosen = choose_map(motion, {});
  if (!chosen.fits() || motion.frames.size() < fewest_frames) return false;
  std::vector<std::vector<double>> lengths(bone_count);
  for (const Positions& frame : motion.frames) {
    if (!frame.allFinite()) continue;
    if (frame.cwiseAbs().maxCoeff() > full_turn) return false;
    const Body body = body_of(chosen.binding.joints_of(frame));
    for (std::size_t b = 0; b < lengths.size(); ++b) lengths[b].push_back(body.bone_lengths[b]);
  }
  std::size_t unsteady = 0;
  for (std::vector<double>& bone : lengths) {
    if (bone.empty()) return false;
    const auto [least, most] = std::ranges::minmax(bone);
    if (most - least > steady * percentile(bone, 0.5)) ++unsteady;
  }
  return 2 * unsteady > lengths.size();
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
  const std::vector<std::string> others = skip_to_trajectories(lines);
  Result<PointCsvHeader> parsed = parse_point_csv_header(lines, where);
  if (!parsed) return parsed.error();
  PointCsvHeader& header = *parsed;
  if (!others.empty())
    header.warnings.push_back({"sections", 0, "the trajectories were read; not read: " + some_of(others)});
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
    // Another table follows, its name perhaps filled up with commas.
    const bool names_only = !has_number(fields) && !is_empty(fields);
    if (rows.frames() > 0 && names_only && (fields.size() < expected || begins_section(fields))) break;
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
  if (look_like_angles(motion))
    return Error{
        "its numbers look like angles, not positions: bones would change their lengths all the time; export "
        "the positions of the joints",
        std::string(where)};
  return split_performers(std::move(motion), ":.");
}

bool holds_positions(std::string_view head) {
  LineReader lines(head);
  return parse_point_csv_header(lines, "").ok();
}

}  // namespace abrazo
