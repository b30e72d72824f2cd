#include "core/annotation/annotation_room.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace abrazo {

namespace {

bool overlaps(const Annotation& annotation, const Span& span) {
  return annotation.start_s < span.end_s - same_time_s && annotation.end_s > span.start_s + same_time_s;
}

/// Edges that differ from a neighbour's by rounding alone are meant to be the neighbour's.
Span aligned(Span span, const std::vector<Annotation>& annotations) {
  for (const Annotation& other : annotations) {
    if (std::abs(span.start_s - other.end_s) <= same_time_s) span.start_s = other.end_s;
    if (std::abs(span.end_s - other.start_s) <= same_time_s) span.end_s = other.start_s;
  }
  return span;
}

Error in_the_way(const std::vector<Annotation>& annotations, const Span& span, std::string_view tier) {
  constexpr int named_at_most = 3;
  std::string names;
  int count = 0;
  for (const Annotation& other : annotations)
    if (overlaps(other, span) && ++count <= named_at_most)
      names += (names.empty() ? "" : ", ") + spoken(other);
  if (count > named_at_most) names += fmt::format(" and {} more", count - named_at_most);
  return {fmt::format("{} {} in the way; move {}, or let conflicts replace or push", names,
                      count > 1 ? "are" : "is", count > 1 ? "them" : "it"),
          std::string(tier)};
}

/// What is left of the annotations when the span is taken out of them.
std::vector<Annotation> without_span(const std::vector<Annotation>& annotations, const Span& span,
                                     const std::function<int()>& new_id) {
  std::vector<Annotation> rest;
  for (const Annotation& other : annotations) {
    if (!overlaps(other, span)) {
      rest.push_back(other);
      continue;
    }
    Annotation before = other, after = other;
    before.end_s = span.start_s;
    after.start_s = span.end_s;
    const bool has_before = before.duration_s() > same_time_s, has_after = after.duration_s() > same_time_s;
    if (has_before && has_after) after.id = new_id();
    if (has_before) rest.push_back(before);
    if (has_after) rest.push_back(after);
  }
  return rest;
}

Error no_room(const Annotation& pushed, double beyond_s, const char* end, std::string_view tier) {
  return {fmt::format("no room to push on: {} would end up {:.3f} s beyond the {}; make the new interval "
                      "shorter, or let conflicts replace",
                      spoken(pushed), beyond_s, end),
          std::string(tier)};
}

void shift(Annotation& annotation, double by_s) {
  annotation.start_s += by_s;
  annotation.end_s += by_s;
}

/// The annotations with the overlapped ones moved on, the earlier ones to earlier times. Each moves as little
/// as it must, with its length.
Result<std::vector<Annotation>> pushed(std::vector<Annotation> annotations, const Span& span,
                                       const Annotations::Range& range, double side_s, bool by_middle,
                                       std::string_view tier) {
  const auto later =
      std::partition_point(annotations.begin(), annotations.end(), [&](const Annotation& other) {
        return (by_middle ? (other.start_s + other.end_s) / 2 : other.start_s) < side_s;
      });
  double edge_s = span.end_s;
  for (auto other = later; other != annotations.end() && other->start_s < edge_s; edge_s = other++->end_s) {
    shift(*other, edge_s - other->start_s);
    if (other->end_s > range.last_s + same_time_s)
      return no_room(*other, other->end_s - range.last_s, "end", tier);
  }
  edge_s = span.start_s;
  for (auto other = std::make_reverse_iterator(later); other != annotations.rend() && other->end_s > edge_s;
       edge_s = other++->start_s) {
    shift(*other, edge_s - other->end_s);
    if (other->start_s < range.first_s - same_time_s)
      return no_room(*other, range.first_s - other->start_s, "start", tier);
  }
  return annotations;
}

}  // namespace

std::string spoken(const Annotation& annotation) {
  return fmt::format("'{}' ({:.3f}-{:.3f} s)", annotation.value, annotation.start_s, annotation.end_s);
}

Result<Span> make_room(std::vector<Annotation>& annotations, Span wanted, Conflict conflict,
                       const Annotations::Range& range, Placing placing, double neighbour_side_s,
                       std::string_view tier, const std::function<int()>& new_id) {
  const Span span = aligned(wanted, annotations);
  const bool free = std::none_of(annotations.begin(), annotations.end(),
                                 [&](const Annotation& other) { return overlaps(other, span); });
  if (free) return span;
  if (conflict == Conflict::Refuse) return in_the_way(annotations, span, tier);
  if (conflict == Conflict::Replace) {
    annotations = without_span(annotations, span, new_id);
    return span;
  }
  const bool by_middle = placing == Placing::Anywhere;
  auto moved = pushed(annotations, span, range,
                      by_middle ? (span.start_s + span.end_s) / 2 : neighbour_side_s, by_middle, tier);
  if (!moved) return moved.error();
  annotations = std::move(*moved);
  return span;
}

}  // namespace abrazo
