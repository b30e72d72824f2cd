#include "core/annotation/session_labels.hpp"

#include <algorithm>

#include "core/annotation/annotated_library.hpp"

namespace abrazo {

PairedTake with_session_labels(PairedTake take, const Annotations& session, double began_s) {
  const int frames = static_cast<int>(take.a.poses.size());
  const double fps = take.fps, length_s = frames / fps;
  std::vector<Tier> tiers = tiers_of(session);
  for (Tier& tier : tiers) {
    for (TierInterval& each : tier.intervals) {
      each.start_s = std::max(0.0, each.start_s - began_s);
      each.end_s = std::min(length_s, each.end_s - began_s);
    }
    std::erase_if(tier.intervals, [](const TierInterval& each) { return each.end_s <= each.start_s; });
  }
  const auto shifted = annotations_of(tiers);
  if (!shifted) return take;
  const auto said = take_annotation(*shifted, fps, frames);
  if (!said) return take;
  if (take.labels.empty()) take.labels = said->labels;
  const bool unknown = std::all_of(take.roles.begin(), take.roles.end(), [](const RoleInterval& role) {
    return role.active == ActivePerformer::Unknown;
  });
  if (unknown && !said->roles.empty()) take.roles = said->roles;
  return take;
}

}  // namespace abrazo
