#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/line_reader.hpp"
#include "core/base/result.hpp"
#include "core/motion/tables/point_rows.hpp"

namespace abrazo {

/// Header of a table of positions.
struct PointCsvHeader {
  char separator = ',';
  std::vector<PointColumn> columns;
  std::optional<std::size_t> time_field;
  double seconds_per_time = 1.0;
  std::optional<double> fps;
  std::optional<double> metres_per_unit;
  std::vector<ImportWarning> warnings;
};

/// Whether a line begins one of the tables that Nexus writes one after the other into a file.
bool begins_section(const std::vector<std::string_view>& fields);

/// Skips to the trajectories of a file of Nexus, which may hold several tables in any order.
/// @return names of the others; `lines` is unchanged if there are no trajectories
std::vector<std::string> skip_to_trajectories(LineReader& lines);

/// Reads up to the line above the first numbers. @return an Error if no line names x, y and z of points
Result<PointCsvHeader> parse_point_csv_header(LineReader& lines, std::string_view where);

}  // namespace abrazo
