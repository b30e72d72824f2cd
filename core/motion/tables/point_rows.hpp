#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.hpp"
#include "core/motion/joints/named_motion.hpp"

namespace abrazo {

/// Fields of a point's x, y, z in a row.
struct PointColumn {
  std::string name;
  std::array<std::size_t, 3> fields{};
};

/// Collects rows of a table of positions (TRC, CSV) as frames. An empty field or "NaN" is a gap.
class PointRows {
 public:
  PointRows(std::vector<PointColumn> columns, std::optional<std::size_t> time_field);

  /// @return an Error that names the point if a field is not a number
  Status add(const std::vector<std::string_view>& fields, std::string_view where, int line);

  std::size_t frames() const { return motion_.frames.size(); }
  /// The points in column order, as one motion without a name. Where times jump, missing rows become frames
  /// without visible points, and a warning counts them.
  /// @param seconds_per_time  of the time column
  NamedMotion take(double seconds_per_time = 1.0);

 private:
  void add_time(std::string_view field, int line);
  void fill_jumps(const std::vector<std::size_t>& jumps, double fps);

  std::vector<PointColumn> columns_;
  std::optional<std::size_t> time_field_;
  std::vector<double> times_;
  std::vector<int> time_lines_;
  int time_digits_ = 0;  ///< maximum number of decimals
  NamedMotion motion_;
};

/// Rows preceded by more than 1.5 usual intervals.
/// @param resolution_s resolution of the times
std::vector<std::size_t> time_jumps(const std::vector<double>& times_s, double resolution_s);

/// Frame rate from times, rounded to a whole number if the limited digits of the times explain the
/// difference.
/// @param jumps from `time_jumps`; they are ignored
std::optional<double> rate_of_times(const std::vector<double>& times_s,
                                    const std::vector<std::size_t>& jumps = {});

/// "mm", "cm", "m", "in", "ft", also spelled out; none for any other word.
std::optional<double> metres_of_unit(std::string_view word);

}  // namespace abrazo
