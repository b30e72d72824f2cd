#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/annotation/annotation_room.hpp"
#include "core/annotation/annotations.hpp"

namespace abrazo {

std::vector<Tier> tiers_of(const Annotations& annotations) {
  std::vector<Tier> tiers;
  for (const AnnotationTier& from : annotations.tiers()) {
    Tier tier{from.name, {}, from.vocabulary, from.kind};
    tier.intervals.assign(from.annotations.begin(), from.annotations.end());
    tiers.push_back(std::move(tier));
  }
  return tiers;
}

namespace {

Error not_taken(const TierInterval& interval, std::string_view why, const std::string& tier) {
  return {fmt::format("'{}' at {:.3f}-{:.3f} s: {}", interval.value, interval.start_s, interval.end_s, why),
          tier};
}

/// Edges that differ by rounding alone are put together, as where an annotation is drawn.
Status take_intervals(std::vector<TierInterval> intervals, AnnotationTier& tier, int& next_id) {
  std::stable_sort(intervals.begin(), intervals.end(),
                   [](const TierInterval& a, const TierInterval& b) { return a.start_s < b.start_s; });
  for (TierInterval& one : intervals) {
    if (!std::isfinite(one.start_s) || !std::isfinite(one.end_s))
      return not_taken(one, "an interval needs finite times", tier.name);
    const Annotation* before = tier.annotations.empty() ? nullptr : &tier.annotations.back();
    if (before && one.start_s < before->end_s - same_time_s)
      return not_taken(one, spoken(*before) + " is in the way; make one of them shorter", tier.name);
    if (before && one.start_s <= before->end_s + same_time_s) one.start_s = before->end_s;
    if (one.end_s - one.start_s <= same_time_s)
      return not_taken(one, "an interval needs some length", tier.name);
    tier.annotations.push_back({std::move(one), next_id++});
  }
  return Done{};
}

}  // namespace

Result<Annotations> annotations_of(std::span<const Tier> tiers) {
  Annotations named;  // refuses names and vocabularies that cannot be
  std::vector<AnnotationTier> taken;
  int next_id = 1;
  for (const Tier& tier : tiers) {
    const auto id = named.add_tier(tier.name, tier.kind, tier.vocabulary);
    if (!id) return id.error();
    AnnotationTier& to = taken.emplace_back(*named.tier(*id));
    to.id = next_id++;
    if (const Status done = take_intervals(tier.intervals, to, next_id); !done) return done.error();
  }
  return Annotations::restored(std::move(taken), {}, next_id);
}

}  // namespace abrazo
