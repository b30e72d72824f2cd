#include "core/annotation/label_import.hpp"

#include <algorithm>

namespace abrazo {

namespace {

std::string fresh_name(const Annotations& annotations, const std::string& wanted) {
  std::string name = wanted;
  for (int n = 2; annotations.tier_named(name); ++n) name = wanted + " " + std::to_string(n);
  return name;
}

Status fill_tier(Annotations& next, int tier, const Tier& read, const Annotations::Range& range) {
  const auto before = next.tier(tier)->annotations;
  for (const Annotation& each : before)
    if (const Status gone = next.remove(each.id); !gone) return gone;
  for (const TierInterval& each : read.intervals) {
    const auto drawn = next.draw(tier, each.start_s, each.end_s, each.value, Conflict::Refuse, range);
    if (!drawn) return drawn.error();
    if (const Status said = next.say(*drawn, each); !said) return said;
  }
  return Done{};
}

}  // namespace

TierPlan plan_tiers(const std::vector<Tier>& read, const Annotations& into) {
  TierPlan plan;
  for (const Tier& tier : read) {
    const AnnotationTier* same = into.tier_named(tier.name);
    if (same && same->kind == tier.kind) {
      plan.targets.push_back({TierTarget::Way::Into, same->id});
      continue;
    }
    const auto of_kind = [&tier](const auto& each) { return each.kind == tier.kind; };
    const bool only = std::count_if(read.begin(), read.end(), of_kind) == 1 &&
                      std::count_if(into.tiers().begin(), into.tiers().end(), of_kind) == 1;
    if (only && tier.kind != TierKind::Note)
      plan.targets.push_back({TierTarget::Way::Into, into.first_of(tier.kind)->id});
    else
      plan.targets.push_back({TierTarget::Way::New});
    plan.is_clear = plan.is_clear && only && tier.kind != TierKind::Note;
  }
  return plan;
}

Result<Annotations> with_imported(const std::vector<Tier>& read, const std::vector<TierTarget>& targets,
                                  const Annotations& into, const Annotations::Range& range) {
  Annotations next = into;
  for (std::size_t i = 0; i < read.size(); ++i) {
    const Tier& tier = read[i];
    int id = targets[i].tier;
    if (targets[i].way == TierTarget::Way::LeaveOut) continue;
    if (targets[i].way == TierTarget::Way::New) {
      const auto added = next.add_tier(fresh_name(next, tier.name), tier.kind, tier.vocabulary);
      if (!added) return added.error();
      id = *added;
    }
    const AnnotationTier* known = next.tier(id);
    if (!known) return Error{"the tier no longer exists", tier.name};
    const bool has_values = !known->vocabulary.empty() || !tier.vocabulary.empty();
    if (has_values && known->kind != TierKind::Role)
      if (const Status set = next.set_vocabulary(id, with_values_of(known->vocabulary, tier)); !set)
        return set.error();
    if (const Status filled = fill_tier(next, id, tier, range); !filled)
      return Error{filled.error().message, tier.name};
  }
  return next;
}

Result<TierDocument> read_labels_for(const std::filesystem::path& file, double fps, const std::string& take) {
  auto document = read_tiers(file, {.fps = fps, .take = take});
  if (take.empty() || !document) return document;
  const bool says_nothing = std::all_of(document->tiers.begin(), document->tiers.end(),
                                        [](const Tier& tier) { return tier.intervals.empty(); });
  if (!says_nothing) return document;
  // The labels of one take may be wanted for another.
  auto of_another = read_tiers(file, {.fps = fps, .take = {}});
  if (!of_another || of_another->take.empty()) return document;
  of_another->warnings.push_back(file.filename().string() + " has labels of the take " + of_another->take +
                                 ", none of " + take);
  return of_another;
}

}  // namespace abrazo
