#include <fmt/format.h>

#include "core/annotation/annotations.hpp"

namespace abrazo {

std::vector<Tier> tiers_of(const Annotations& annotations) {
  std::vector<Tier> tiers;
  for (const AnnotationTier& from : annotations.tiers()) {
    Tier tier{from.name, {}, from.vocabulary, from.kind};
    for (const Annotation& annotation : from.annotations)
      tier.intervals.push_back(
          {annotation.start_s, annotation.end_s, annotation.value, annotation.detail, annotation.confidence});
    tiers.push_back(std::move(tier));
  }
  return tiers;
}

Result<Annotations> annotations_of(std::span<const Tier> tiers) {
  Annotations annotations;
  for (const Tier& tier : tiers) {
    const auto id = annotations.add_tier(tier.name, tier.kind, tier.vocabulary);
    if (!id) return id.error();
    for (const TierInterval& interval : tier.intervals) {
      const Annotations::Range as_it_is{interval.start_s, interval.end_s};
      const auto drawn =
          annotations.draw(*id, interval.start_s, interval.end_s, interval.value, Conflict::Refuse, as_it_is);
      if (!drawn)
        return Error{fmt::format("'{}' at {:.3f}-{:.3f} s: {}", interval.value, interval.start_s,
                                 interval.end_s, drawn.error().message),
                     tier.name};
      if (const Status said = annotations.say(*drawn, interval.value, interval.detail, interval.confidence);
          !said)
        return said.error();
    }
  }
  return annotations;
}

}  // namespace abrazo
