#pragma once

#include <string>
#include <vector>

#include "core/base/result.hpp"

namespace abrazo {

/// Checks that intervals of frames [start, end) are valid for a take: not empty, ascending, not overlapping.
/// @param what  "role", "label": of the Error  @param where  which take it names
template <typename Interval>
Status check_intervals(const std::vector<Interval>& intervals, const char* what, const std::string& where) {
  for (std::size_t i = 0; i < intervals.size(); ++i)
    if (intervals[i].start < 0 || intervals[i].end <= intervals[i].start ||
        (i > 0 && intervals[i].start < intervals[i - 1].end))
      return Error{std::string(what) + " " + std::to_string(i) + " [" + std::to_string(intervals[i].start) +
                       ", " + std::to_string(intervals[i].end) +
                       ") is empty, overlaps the one before it, or is out of order",
                   where};
  return Done{};
}

}  // namespace abrazo
