#include "core/motion/point_rows.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/base/text.hpp"
#include "core/motion/line_reader.hpp"

namespace abrazo {

PointRows::PointRows(std::vector<PointColumn> columns, std::optional<std::size_t> time_field,
                     bool decimal_commas)
    : columns_(std::move(columns)), time_field_(time_field), decimal_commas_(decimal_commas) {}

std::optional<double> PointRows::number(std::string_view field) const {
  constexpr double missing = std::numeric_limits<double>::quiet_NaN();
  if (field.size() > 1 && field.front() == '"' && field.back() == '"')
    field = field.substr(1, field.size() - 2);
  if (field.empty()) return missing;
  std::optional<double> value;
  if (decimal_commas_ && field.find(',') != std::string_view::npos) {
    std::string with_point(field.substr(0, 64));
    std::replace(with_point.begin(), with_point.end(), ',', '.');
    value = parse_number(with_point);
  } else {
    value = parse_number(field);
  }
  if (value && !std::isfinite(*value)) return missing;
  return value;
}

Status PointRows::add(const std::vector<std::string_view>& fields, std::string_view where, int line) {
  Positions frame(static_cast<Eigen::Index>(columns_.size()), 3);
  for (std::size_t p = 0; p < columns_.size(); ++p)
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const std::size_t field = columns_[p].fields[axis];
      const std::string_view word = field < fields.size() ? fields[field] : std::string_view();
      const auto value = number(word);
      if (!value)
        return error_at(where, line,
                        "expected a number for " + columns_[p].name + "'s " + "xyz"[axis] + " (column " +
                            std::to_string(field + 1) + "), found " + in_quotes(word) +
                            "; correct it, or leave it empty where the point was not seen");
      frame(static_cast<Eigen::Index>(p), static_cast<Eigen::Index>(axis)) = *value;
    }
  // A point with a coordinate missing is missing.
  for (Eigen::Index p = 0; p < frame.rows(); ++p)
    if (!frame.row(p).allFinite()) frame.row(p).setConstant(std::numeric_limits<double>::quiet_NaN());
  motion_.frames.push_back(std::move(frame));
  if (time_field_ && *time_field_ < fields.size())
    if (const auto time = number(fields[*time_field_]); time && std::isfinite(*time)) times_.push_back(*time);
  return Done{};
}

NamedMotion PointRows::take(double seconds_per_time) {
  for (const PointColumn& column : columns_) {
    motion_.points.push_back(column.name);
    motion_.parents.push_back(-1);
  }
  for (double& time : times_) time *= seconds_per_time;
  if (times_.size() == motion_.frames.size()) motion_.fps = rate_of_times(times_);
  return std::move(motion_);
}

std::optional<double> rate_of_times(const std::vector<double>& times_s) {
  if (times_s.size() < 2) return std::nullopt;
  const double span = times_s.back() - times_s.front();
  const auto steps = static_cast<double>(times_s.size() - 1);
  if (!(span > 0) || !std::isfinite(span)) return std::nullopt;
  const double fps = steps / span;
  const double whole = std::round(fps);
  // Times have at least three digits behind the point: the span is wrong by at most 1 ms.
  const double doubt = std::max(1e-6, 1e-3 / span) * fps;
  return whole >= 1 && std::abs(fps - whole) <= std::min(doubt, 5e-4 * whole) ? whole : fps;
}

std::optional<double> metres_of_unit(std::string_view word) {
  struct Unit {
    std::string_view name;
    double metres;
  };
  static constexpr std::array units = {
      Unit{"mm", 0.001},
      Unit{"millimeters", 0.001},
      Unit{"millimetres", 0.001},
      Unit{"millimeter", 0.001},
      Unit{"cm", 0.01},
      Unit{"centimeters", 0.01},
      Unit{"centimetres", 0.01},
      Unit{"centimeter", 0.01},
      Unit{"dm", 0.1},
      Unit{"m", 1.0},
      Unit{"meters", 1.0},
      Unit{"metres", 1.0},
      Unit{"meter", 1.0},
      Unit{"in", 0.0254},
      Unit{"inch", 0.0254},
      Unit{"inches", 0.0254},
      Unit{"ft", 0.3048},
      Unit{"feet", 0.3048},
      Unit{"foot", 0.3048},
  };
  const std::string wanted = lower_case(trimmed(word));
  for (const Unit& unit : units)
    if (unit.name == wanted) return unit.metres;
  return std::nullopt;
}

}  // namespace abrazo
