#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.hpp"
#include "core/motion/named_motion.hpp"

namespace abrazo {

/// Which fields of a row are a point's x, y, z.
struct PointColumn {
  std::string name;
  std::array<std::size_t, 3> fields{};
};

/// Rows of a table of positions (TRC, CSV) gathered to frames. An empty field or "NaN" is a gap.
class PointRows {
 public:
  /// @param decimal_commas  "0,5" is a half
  PointRows(std::vector<PointColumn> columns, std::optional<std::size_t> time_field, bool decimal_commas);

  /// @return an Error that names the point, when a field is no number
  Status add(const std::vector<std::string_view>& fields, std::string_view where, int line);

  std::size_t frames() const { return motion_.frames.size(); }
  /// The points as columns gave them, in one motion without a name. @param seconds_per_time  of the time
  /// column
  NamedMotion take(double seconds_per_time = 1.0);

 private:
  std::optional<double> number(std::string_view field) const;

  std::vector<PointColumn> columns_;
  std::optional<std::size_t> time_field_;
  bool decimal_commas_;
  std::vector<double> times_;
  NamedMotion motion_;
};

/// A rate found from times is rounded to a whole one when times of few digits explain the difference.
std::optional<double> rate_of_times(const std::vector<double>& times_s);

/// "mm", "cm", "m", "in", "ft", spelled out as well; nothing for any other word.
std::optional<double> metres_of_unit(std::string_view word);

}  // namespace abrazo
