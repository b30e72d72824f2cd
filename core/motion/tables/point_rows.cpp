#include "core/motion/tables/point_rows.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/base/line_reader.hpp"
#include "core/base/text.hpp"
#include "core/motion/tables/table_line.hpp"

namespace abrazo {

namespace {
constexpr int exact_digits = 9;  ///< times with this number of digits are not rounded

/// Not a number where nothing was seen; none for a word.
std::optional<double> coordinate(std::string_view field) {
  constexpr double missing = std::numeric_limits<double>::quiet_NaN();
  if (field.empty()) return missing;
  const auto value = table_number(field);
  return value && !std::isfinite(*value) ? missing : value;
}

}  // namespace

PointRows::PointRows(std::vector<PointColumn> columns, std::optional<std::size_t> time_field)
    : columns_(std::move(columns)), time_field_(time_field) {}

Status PointRows::add(const std::vector<std::string_view>& fields, std::string_view where, int line) {
  Positions frame(static_cast<Eigen::Index>(columns_.size()), 3);
  for (std::size_t p = 0; p < columns_.size(); ++p)
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const std::size_t field = columns_[p].fields[axis];
      const std::string_view word = field < fields.size() ? fields[field] : std::string_view();
      const auto value = coordinate(word);
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
  if (time_field_ && *time_field_ < fields.size()) add_time(fields[*time_field_], line);
  return Done{};
}

void PointRows::add_time(std::string_view field, int line) {
  const auto time = coordinate(field);
  if (!time || !std::isfinite(*time)) return;
  times_.push_back(*time);
  time_lines_.push_back(line);
  if (field.find_first_of("eE") != std::string_view::npos) time_digits_ = exact_digits;
  int digits = 0;
  const std::size_t point = field.find_last_of(".,");
  for (std::size_t i = point; i != std::string_view::npos && ++i < field.size();)
    if (field[i] >= '0' && field[i] <= '9') ++digits;
  time_digits_ = std::max(time_digits_, std::min(digits, exact_digits));
}

NamedMotion PointRows::take(double seconds_per_time) {
  for (const PointColumn& column : columns_) {
    motion_.points.push_back(column.name);
    motion_.parents.push_back(-1);
  }
  for (double& time : times_) time *= seconds_per_time;
  if (times_.size() == motion_.frames.size()) {
    const auto jumps = time_jumps(times_, std::pow(10.0, -time_digits_) * seconds_per_time);
    motion_.fps = rate_of_times(times_, jumps);
    if (motion_.fps && !jumps.empty()) fill_jumps(jumps, *motion_.fps);
  }
  return std::move(motion_);
}

void PointRows::fill_jumps(const std::vector<std::size_t>& jumps, double fps) {
  std::vector<double> missing(motion_.frames.size(), 0);
  double all = 0;
  for (const std::size_t row : jumps)
    all += missing[row] = std::max(0.0, std::round((times_[row] - times_[row - 1]) * fps) - 1);
  if (all == 0) return;
  const std::size_t first = jumps.front();
  const std::string what =
      (jumps.size() == 1 ? "the time jumps once"
                         : "the time jumps at " + std::to_string(jumps.size()) + " rows, first") +
      ", from " + exact_text(times_[first - 1]) + " to " + exact_text(times_[first]) + " s";
  // At most as many as there are rows: a wrong time would give hours of empty frames.
  if (!(all <= static_cast<double>(motion_.frames.size()))) {
    motion_.warnings.push_back({"time-jump", time_lines_[first],
                                what +
                                    "; more rows are missing there than there are, and the rows were put one "
                                    "behind the other: export what is before and behind apart"});
    return;
  }
  std::vector<Positions> frames;
  frames.reserve(motion_.frames.size() + static_cast<std::size_t>(all));
  const Positions unseen = Positions::Constant(static_cast<Eigen::Index>(columns_.size()), 3,
                                               std::numeric_limits<double>::quiet_NaN());
  for (std::size_t row = 0; row < missing.size(); ++row) {
    frames.insert(frames.end(), static_cast<std::size_t>(missing[row]), unseen);
    frames.push_back(std::move(motion_.frames[row]));
  }
  motion_.frames = std::move(frames);
  motion_.warnings.push_back({"time-jump", time_lines_[first],
                              what + "; the " + std::to_string(static_cast<std::size_t>(all)) +
                                  " frames that are missing were taken as not seen"});
}

std::vector<std::size_t> time_jumps(const std::vector<double>& times_s, double resolution_s) {
  if (times_s.size() < 3) return {};
  std::vector<double> steps;
  for (std::size_t row = 1; row < times_s.size(); ++row) steps.push_back(times_s[row] - times_s[row - 1]);
  const auto middle = steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2);
  std::nth_element(steps.begin(), middle, steps.end());
  if (!(*middle > 0)) return {};
  // Rounded times differ by up to one unit of their last digit from what they would.
  const double longest = std::max(1.5 * *middle, *middle + 1.5 * resolution_s);
  std::vector<std::size_t> jumps;
  for (std::size_t row = 1; row < times_s.size(); ++row)
    if (times_s[row] - times_s[row - 1] > longest) jumps.push_back(row);
  return jumps;
}

std::optional<double> rate_of_times(const std::vector<double>& times_s,
                                    const std::vector<std::size_t>& jumps) {
  if (times_s.size() < 2 + jumps.size()) return std::nullopt;
  double span = times_s.back() - times_s.front();
  if (!jumps.empty()) {
    // A sum, as the difference of a wrong time would swallow the others.
    span = 0;
    for (std::size_t row = 1; row < times_s.size(); ++row)
      if (!std::binary_search(jumps.begin(), jumps.end(), row)) span += times_s[row] - times_s[row - 1];
  }
  const auto steps = static_cast<double>(times_s.size() - 1 - jumps.size());
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
