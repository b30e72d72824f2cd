#include "core/motion/tables/point_csv_header.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <map>
#include <set>

#include "core/base/text.hpp"
#include "core/motion/body/joint_set.hpp"
#include "core/motion/joints/performers.hpp"
#include "core/motion/tables/table_line.hpp"

namespace abrazo {

namespace {

using Fields = std::vector<std::string_view>;

constexpr int header_lines = 40;  ///< no header is longer
constexpr std::size_t most_columns = 100'000;

int axis_of(std::string_view word) {
  if (word.size() != 1) return -1;
  const char c = static_cast<char>(std::tolower(static_cast<unsigned char>(word.front())));
  return c >= 'x' && c <= 'z' ? c - 'x' : -1;
}

/// A column's name in parts: "root_x [mm]" -> root, 0, "mm".
struct AxisName {
  std::string point;
  int axis = -1;
  std::string_view unit;
};
AxisName axis_name(std::string_view field) {
  AxisName name;
  for (const auto& [open, close] : {std::pair('[', ']'), std::pair('(', ')')})
    if (const auto at = field.rfind(open); at != std::string_view::npos && field.back() == close) {
      name.unit = trimmed(field.substr(at + 1, field.size() - at - 2));
      field = trimmed(field.substr(0, at));
      if (const int axis = axis_of(name.unit); axis >= 0 && !field.empty())
        return {std::string(field), axis, {}};  // "Hips[X]"
    }
  if (field.size() < 2) return name;
  const std::string_view marks = "_.:- ";
  if (const int axis = axis_of(field.substr(field.size() - 1)); axis >= 0) {
    std::string_view point = field.substr(0, field.size() - 1);
    const bool apart = marks.find(point.back()) != std::string_view::npos;
    bool capital = field.back() < 'a';  // "LASIX", but not "index"
    if (point.size() > 2 && point.back() == 't' &&
        marks.find(point[point.size() - 2]) != std::string_view::npos)
      capital = true;  // "Hips_tx"
    if (apart) point = point.substr(0, point.size() - 1);
    if ((apart || capital) && !point.empty()) name.point = trimmed(point), name.axis = axis;
  } else if (const int first = axis_of(field.substr(0, 1));
             first >= 0 && field.size() > 2 && marks.find(field[1]) != std::string_view::npos) {
    name.point = trimmed(field.substr(2)), name.axis = first;
  }
  return name;
}

bool is_time(std::string_view field) {
  const std::string word = lower_case(field);
  return word == "t" || word.starts_with("time") || word.starts_with("timestamp");
}
double seconds_of(std::string_view time_name) {
  const std::string word = lower_case(time_name);
  return word.find("ms") != std::string::npos || word.find("milli") != std::string::npos ? 1e-3 : 1.0;
}

void note_time(const Fields& names, PointCsvHeader& header) {
  for (std::size_t f = 0; f < names.size(); ++f)
    if (is_time(names[f])) {
      header.time_field = f;
      header.seconds_per_time = seconds_of(names[f]);
      return;
    }
}

/// "Hips_pos", "Hips.position", "Hips T" without the word behind the point; empty where there is none.
std::string_view without_position_word(std::string_view point) {
  const std::string_view marks = "_.:- ";
  const std::string lower = lower_case(point);
  for (const std::string_view word : {"position", "translation", "translate", "trans", "pos", "t"}) {
    if (!lower.ends_with(word) || lower.size() == word.size()) continue;
    const std::size_t end = lower.size() - word.size();
    if (marks.find(point[end - 1]) != std::string_view::npos) return trimmed(point.substr(0, end - 1));
    if (word.size() > 2 && std::isupper(static_cast<unsigned char>(point[end]))) return point.substr(0, end);
  }
  return {};
}

/// Where the columns of positions are called so, others (rotations, velocities) are no points.
void keep_positions(PointCsvHeader& header) {
  constexpr std::size_t fewest_positions = 8;
  std::vector<PointColumn> positions;
  for (const PointColumn& column : header.columns)
    if (const std::string_view point = without_position_word(column.name); !point.empty())
      positions.push_back({std::string(point), column.fields});
  if (positions.size() < fewest_positions || 3 * positions.size() < header.columns.size()) return;
  if (positions.size() < header.columns.size())
    header.warnings.push_back({"columns", 0,
                               std::to_string(header.columns.size() - positions.size()) + " of " +
                                   std::to_string(header.columns.size()) +
                                   " groups of columns are not called positions and were left out"});
  header.columns = std::move(positions);
}

/// One line that names each column: root_x, root_y, root_z. Points with all three axes, in their order.
bool read_axis_names(const Fields& fields, PointCsvHeader& header) {
  std::map<std::string, std::array<std::optional<std::size_t>, 3>> places;
  std::vector<std::string> order;
  std::string_view unit;
  for (std::size_t f = 0; f < fields.size(); ++f) {
    const AxisName name = axis_name(fields[f]);
    if (name.axis < 0) continue;
    auto& place = places[name.point];
    if (!place[0] && !place[1] && !place[2]) order.push_back(name.point);
    if (!place[static_cast<std::size_t>(name.axis)]) place[static_cast<std::size_t>(name.axis)] = f;
    if (!name.unit.empty()) unit = name.unit;
  }
  for (const std::string& point : order)
    if (const auto& place = places[point]; place[0] && place[1] && place[2])
      header.columns.push_back({point, {*place[0], *place[1], *place[2]}});
  if (header.columns.empty()) return false;
  keep_positions(header);
  if (!unit.empty()) header.metres_per_unit = metres_of_unit(unit);
  note_time(fields, header);
  return true;
}

bool is_axis_line(const Fields& fields) {
  std::size_t triples = 0;
  for (std::size_t f = 0; f + 2 < fields.size(); ++f)
    if (axis_of(fields[f]) == 0 && axis_of(fields[f + 1]) == 1 && axis_of(fields[f + 2]) == 2)
      ++triples, f += 2;
  return triples > 0;
}

/// X, Y, Z below a name above the X.
bool read_axis_line(const Fields& axes, const Fields& names, PointCsvHeader& header) {
  for (std::size_t f = 0; f + 2 < axes.size(); ++f) {
    if (axis_of(axes[f]) != 0 || axis_of(axes[f + 1]) != 1 || axis_of(axes[f + 2]) != 2) continue;
    std::string_view name;
    for (std::size_t n = f; n < f + 3 && name.empty() && n < names.size(); ++n) name = names[n];
    if (!name.empty()) header.columns.push_back({std::string(name), {f, f + 1, f + 2}});
    f += 2;
  }
  note_time(axes, header);
  if (!header.time_field) note_time(names, header);
  return !header.columns.empty();
}

/// "Capture Frame Rate,120,...,Length Units,Meters": the value after a key in Motive's first line.
std::string_view value_behind(const Fields& fields, std::string_view word) {
  for (std::size_t f = 0; f + 1 < fields.size(); ++f)
    if (lower_case(fields[f]) == word) return fields[f + 1];
  return {};
}

/// OptiTrack Motive: lines of types, names, ids, (parents,) properties and axes.
class MotiveHeader {
 public:
  MotiveHeader(LineReader& lines, std::string_view where, PointCsvHeader& header)
      : lines_(lines), where_(where), header_(header) {}
  Status read(const Fields& first);

 private:
  void take_columns(const std::string& type);
  void name_roots();
  std::string_view at(const Fields& row, std::size_t f) const {
    return f < row.size() ? row[f] : std::string_view();
  }

  LineReader& lines_;
  std::string_view where_;
  PointCsvHeader& header_;
  Fields types_, names_, properties_, axes_;
};

void MotiveHeader::take_columns(const std::string& type) {
  for (std::size_t f = 0; f + 2 < axes_.size(); ++f) {
    const bool wanted = lower_case(at(types_, f)) == type && lower_case(at(properties_, f)) == "position";
    if (wanted && axis_of(axes_[f]) == 0 && axis_of(axes_[f + 1]) == 1 && axis_of(axes_[f + 2]) == 2)
      header_.columns.push_back({std::string(at(names_, f)), {f, f + 1, f + 2}}), f += 2;
  }
}

/// The first bone may be called like its skeleton: "Anna", then "Anna:Ab".
void MotiveHeader::name_roots() {
  std::set<std::string> names;
  for (const PointColumn& column : header_.columns) names.insert(column.name);
  for (PointColumn& column : header_.columns) {
    const bool is_skeleton = std::ranges::any_of(
        names, [&](const std::string& name) { return name.starts_with(column.name + ":"); });
    if (is_skeleton && !names.contains(column.name + ":Hip")) column.name += ":Hip";
    // Motive 3 writes that as "Anna:Anna".
    const auto colon = column.name.find(':');
    const std::string skeleton = column.name.substr(0, colon);
    if (colon != std::string::npos && column.name.substr(colon + 1) == skeleton &&
        !names.contains(skeleton + ":Hip"))
      column.name = skeleton + ":Hip";
  }
}

Status MotiveHeader::read(const Fields& first) {
  header_.metres_per_unit = metres_of_unit(value_behind(first, "length units"));
  std::string stated(value_behind(first, "export frame rate"));
  if (header_.separator != ',') std::ranges::replace(stated, ',', '.');
  if (const auto rate = parse_number(stated); rate && *rate > 0) header_.fps = *rate;
  const std::string space = lower_case(value_behind(first, "coordinate space"));
  if (!space.empty() && space != "global")
    return error_at(where_, 1,
                    "its positions are " + in_quotes(space) +
                        ", relative to the parent bone; export from Motive with the coordinate space Global");
  std::string_view line;
  for (int n = 0; n < header_lines && lines_.next(line); ++n) {
    const Fields fields = table_fields(line, header_.separator);
    const std::string label = fields.size() > 1 ? lower_case(fields[1]) : std::string();
    if (label == "type") types_ = fields;
    if (label == "name") names_ = fields;
    if (std::count_if(fields.begin(), fields.end(), [](auto f) { return lower_case(f) == "position"; }) > 0)
      properties_ = fields;
    if (!lower_case(fields[0]).starts_with("frame")) continue;
    axes_ = fields;
    note_time(fields, header_);
    for (const char* type : {"bone", "bone marker", "rigid body", "marker", "rigid body marker"}) {
      take_columns(type);
      if (type == std::string_view("bone")) name_roots();
      if (header_.columns.size() >= 8) return Done{};
      header_.columns.clear();
    }
    return error_at(
        where_, lines_.number(),
        "this export of Motive holds no positions of bones or of 8 markers; export with the bones of "
        "the skeletons");
  }
  return error_at(where_, lines_.number(),
                  "the header of this export of Motive has no line that begins with Frame");
}

/// Nexus and Workstation: the rate has a line of its own, "100" or "100,Hz".
bool is_rate_line(const Fields& fields) {
  return parse_number(fields[0]) && std::all_of(fields.begin() + 1, fields.end(), [](auto field) {
           return field.empty() || lower_case(field) == "hz";
         });
}

Status check_columns(PointCsvHeader& header, std::string_view where, int line) {
  if (header.columns.size() > most_columns)
    return error_at(where, line, "names more than " + std::to_string(most_columns) + " points");
  std::vector<std::string> names;
  for (const PointColumn& column : header.columns) names.push_back(column.name);
  make_names_unique(names, "point", header.warnings);
  for (std::size_t c = 0; c < names.size(); ++c) header.columns[c].name = names[c];
  // Abrazo's own tables are in metres.
  const auto ours = [](const std::string& name) {
    return joint_index(name.substr(name.rfind('.') + 1)).has_value();
  };
  if (!header.metres_per_unit && names.size() % joint_count == 0 &&
      std::all_of(names.begin(), names.end(), ours))
    header.metres_per_unit = 1.0;
  return Done{};
}

}  // namespace

bool begins_section(const std::vector<std::string_view>& fields) {
  constexpr std::array<std::string_view, 6> sections = {"devices",  "joints",       "model outputs",
                                                        "segments", "trajectories", "events"};
  return std::ranges::find(sections, lower_case(fields[0])) != sections.end() &&
         std::all_of(fields.begin() + 1, fields.end(), [](auto field) { return field.empty(); });
}

std::vector<std::string> skip_to_trajectories(LineReader& lines) {
  std::vector<std::string> others;
  LineReader ahead = lines, found = lines;
  bool any = false;
  for (std::string_view line; ahead.next(line);) {
    if (line.empty() || std::isalpha(static_cast<unsigned char>(line.front())) == 0) continue;
    const Fields fields = table_fields(line, table_separator(line, ','));
    if (!begins_section(fields)) continue;
    if (lower_case(fields[0]) != "trajectories")
      others.emplace_back(fields[0]);
    else if (!any)
      found = ahead, any = true;
  }
  if (!any) return {};
  lines = found;
  return others;
}

Result<PointCsvHeader> parse_point_csv_header(LineReader& lines, std::string_view where) {
  PointCsvHeader header;
  std::string_view line;
  Fields before;
  for (int n = 0; n < header_lines && lines.next(line); ++n) {
    if (trimmed(line).empty() || (n == 0 && separator_of_table(line, ',').stated_length > 0)) continue;
    header.separator = table_separator(line, ',');
    const Fields fields = table_fields(line, header.separator);
    if (n == 0 && lower_case(fields[0]) == "format version") {
      if (const Status read = MotiveHeader(lines, where, header).read(fields); !read) return read.error();
      if (const Status fit = check_columns(header, where, lines.number()); !fit) return fit.error();
      return header;
    }
    if (is_rate_line(fields)) header.fps = parse_number(fields[0]);
    const bool found =
        is_axis_line(fields) ? read_axis_line(fields, before, header) : read_axis_names(fields, header);
    if (found) {
      if (header.fps && !(*header.fps > 0)) header.fps.reset();
      if (const Status fit = check_columns(header, where, lines.number()); !fit) return fit.error();
      return header;
    }
    before = fields;
  }
  return Error{
      "no line names the x, y and z of points; expected columns such as root_x, root_y, root_z, or names "
      "over a line of X, Y, Z",
      std::string(where)};
}

}  // namespace abrazo
