#pragma once

#include <functional>
#include <limits>
#include <string_view>
#include <vector>

#include "core/annotation/annotations.hpp"
#include "core/base/result.hpp"

namespace abrazo {

/// Times closer than this are one: a thousandth of what a label file resolves.
constexpr double same_time_s = 1e-6;

/// A time without an end on either side.
constexpr Annotations::Range everywhere{-std::numeric_limits<double>::infinity(),
                                        std::numeric_limits<double>::infinity()};

/// [start, end) that an annotation is to have.
struct Span {
  double start_s = 0, end_s = 0;
};

/// How an edit found its span: which of its neighbours are pushed to which side follows from it.
enum class Placing {
  Anywhere,  ///< drawn or moved: neighbours whose middle is earlier go to earlier times
  Resized    ///< neighbours stay on the side where they are
};

/// Makes room for a span among annotations that do not have it yet.
/// @param annotations  ascending, not overlapping; changed only when the answer is a span
/// @param neighbour_side_s  of Placing::Resized: what starts before it is an earlier neighbour
/// @param new_id  gives the later part of an annotation that is cut in two its id
/// @return the span that is free now: the wanted one with its edges on those of neighbours that they meant
Result<Span> make_room(std::vector<Annotation>& annotations, Span wanted, Conflict conflict,
                       const Annotations::Range& range, Placing placing, double neighbour_side_s,
                       std::string_view tier, const std::function<int()>& new_id);

/// "'turn' (3.200-4.150 s)"
std::string spoken(const Annotation& annotation);

}  // namespace abrazo
