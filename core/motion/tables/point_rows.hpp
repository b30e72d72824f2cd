#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.hpp"
#include "core/motion/joints/named_motion.hpp"

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
  /// The points as columns gave them, in one motion without a name. Where times jump, the rows that are
  /// missing become frames in which nothing was seen, and a warning counts them.
  /// @param seconds_per_time  of the time column
  NamedMotion take(double seconds_per_time = 1.0);

 private:
  std::optional<double> number(std::string_view field) const;
  void add_time(std::string_view field, int line);
  void fill_jumps(const std::vector<std::size_t>& jumps, double fps);

  std::vector<PointColumn> columns_;
  std::optional<std::size_t> time_field_;
  bool decimal_commas_;
  std::vector<double> times_;
  std::vector<int> time_lines_;
  int time_digits_ = 0;  ///< behind the point, at most
  NamedMotion motion_;
};

/// Rows before which more than one and a half of the usual intervals passed.
/// @param resolution_s  to which times are rounded
std::vector<std::size_t> time_jumps(const std::vector<double>& times_s, double resolution_s);

/// A rate found from times is rounded to a whole one when times of few digits explain the difference.
/// @param jumps  as `time_jumps` finds them: they do not count
std::optional<double> rate_of_times(const std::vector<double>& times_s,
                                    const std::vector<std::size_t>& jumps = {});

/// What stands most often in a line of a table: a comma, a semicolon or a tab; `usual` where they are as
/// many.
char table_separator(std::string_view line, char usual);

/// "mm", "cm", "m", "in", "ft", spelled out as well; nothing for any other word.
std::optional<double> metres_of_unit(std::string_view word);

}  // namespace abrazo
