#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <set>
#include <utility>

#include "core/annotation/annotations.hpp"

namespace abrazo {

namespace {

/// Ids and names seen so far.
struct Seen {
  int next_id = 1;
  std::set<int> ids;
  std::set<std::string, std::less<>> names;

  Status take_id(int id, const std::string& of) {
    if (id < 1 || id >= next_id)
      return Error{of + " has the number " + std::to_string(id) + ", which was never given", {}};
    if (!ids.insert(id).second)
      return Error{of + " has the number " + std::to_string(id) + ", which something else has", {}};
    return Done{};
  }
};

Status check_interval(double start_s, double end_s, const std::string& of) {
  if (std::isfinite(start_s) && std::isfinite(end_s) && start_s < end_s) return Done{};
  return Error{of + " does not end after it begins", {}};
}

Status check_tier(const AnnotationTier& tier, Seen& seen) {
  const std::string name = "the tier '" + tier.name + "'";
  if (Status fresh = seen.take_id(tier.id, name); !fresh) return fresh;
  if (tier.name.empty()) return Error{"a tier has no name", {}};
  if (!seen.names.insert(tier.name).second) return Error{name + " is used twice", {}};
  double free_s = -std::numeric_limits<double>::infinity();
  for (const Annotation& one : tier.annotations) {
    const std::string what = "'" + one.value + "' of " + name;
    if (Status fresh = seen.take_id(one.id, what); !fresh) return fresh;
    if (Status whole = check_interval(one.start_s, one.end_s, what); !whole) return whole;
    if (one.start_s < free_s) return Error{what + " begins before the one before it ends", {}};
    free_s = one.end_s;
  }
  return Done{};
}

}  // namespace

Result<Annotations> Annotations::restored(std::vector<AnnotationTier> tiers,
                                          std::vector<Suggestion> suggestions, int next_id) {
  Seen seen{next_id, {}, {}};
  for (const AnnotationTier& tier : tiers)
    if (const Status good = check_tier(tier, seen); !good) return good.error();
  for (const Suggestion& one : suggestions) {
    const std::string what = "the suggestion '" + one.value + "'";
    if (const Status fresh = seen.take_id(one.id, what); !fresh) return fresh.error();
    if (const Status whole = check_interval(one.start_s, one.end_s, what); !whole) return whole.error();
    if (std::none_of(tiers.begin(), tiers.end(), [&](const auto& tier) { return tier.id == one.tier; }))
      return Error{what + " is for a tier that is not there", {}};
  }
  Annotations restored;
  restored.tiers_ = std::move(tiers);
  restored.suggestions_ = std::move(suggestions);
  restored.next_id_ = next_id;
  return restored;
}

}  // namespace abrazo
