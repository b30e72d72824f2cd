#include "core/library/takes/paired_take.hpp"

#include <algorithm>

namespace abrazo {

namespace {

/// The interval that contains `frame` among ascending, non-overlapping ones; null if there is none.
template <typename Interval>
const Interval* interval_at(const std::vector<Interval>& intervals, int frame) {
  const auto after = std::upper_bound(intervals.begin(), intervals.end(), frame,
                                      [](int f, const Interval& interval) { return f < interval.start; });
  if (after == intervals.begin()) return nullptr;
  const Interval& candidate = *std::prev(after);
  return frame < candidate.end ? &candidate : nullptr;
}

}  // namespace

ActivePerformer active_at(const PairedTake& take, int frame) {
  const RoleInterval* interval = interval_at(take.roles, frame);
  return interval ? interval->active : ActivePerformer::Unknown;
}

std::string_view label_at(const std::vector<LabelInterval>& labels, int frame) {
  const LabelInterval* interval = interval_at(labels, frame);
  return interval ? std::string_view(interval->label) : std::string_view();
}

}  // namespace abrazo
