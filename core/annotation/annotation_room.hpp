#pragma once

#include <functional>
#include <limits>
#include <string_view>
#include <vector>

#include "core/annotation/annotations.hpp"
#include "core/base/result.hpp"

namespace abrazo {

/// Times closer than this count as equal: a thousandth of the resolution of a label file.
constexpr double same_time_s = 1e-6;

/// An unlimited range.
constexpr Annotations::Range everywhere{-std::numeric_limits<double>::infinity(),
                                        std::numeric_limits<double>::infinity()};

/// The wanted [start, end) of an annotation.
struct Span {
  double start_s = 0, end_s = 0;
};

/// Origin of a span; determines the direction in which neighbours are pushed.
enum class Placing {
  Anywhere,  ///< drawn or moved: neighbours whose middle is earlier go to earlier times
  Resized    ///< neighbours stay on their side
};

/// Makes room for a new span among annotations.
/// @param annotations ascending, not overlapping; changed only on success
/// @param neighbour_side_s of Placing::Resized: annotations that start before it are earlier neighbours
/// @param new_id id for the later part of an annotation that is split
/// @return the free span: the wanted one, with its edges snapped to those of neighbours
Result<Span> make_room(std::vector<Annotation>& annotations, Span wanted, Conflict conflict,
                       const Annotations::Range& range, Placing placing, double neighbour_side_s,
                       std::string_view tier, const std::function<int()>& new_id);

/// "'turn' (3.200-4.150 s)"
std::string spoken(const Annotation& annotation);

}  // namespace abrazo
