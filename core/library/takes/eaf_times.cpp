#include "core/library/takes/eaf_times.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "core/base/text.hpp"

namespace abrazo {

namespace {

using Annotation = EafContents::Annotation;
using TierElement = EafContents::TierElement;

using Siblings = std::vector<const Annotation*>;

/// Along the chain of previous annotations, if there is one; unreachable ones follow in file order.
Siblings chained(const Siblings& siblings) {
  std::map<std::string_view, const Annotation*> after;
  for (const Annotation* one : siblings)
    if (!one->previous.empty()) after.emplace(one->previous, one);
  Siblings ordered;
  for (const Annotation* one : siblings) {
    if (!one->previous.empty()) continue;
    ordered.push_back(one);
    for (auto next = after.find(one->id); next != after.end(); next = after.find(ordered.back()->id)) {
      ordered.push_back(next->second);
      after.erase(next);
    }
  }
  const std::set<const Annotation*> reached(ordered.begin(), ordered.end());
  for (const Annotation* one : siblings)
    if (reached.find(one) == reached.end()) ordered.push_back(one);
  return ordered;
}

bool divides_its_parent(const EafContents& contents, const TierElement& tier) {
  const auto type = contents.types.find(tier.type);
  return type != contents.types.end() && type->second.constraint == "Symbolic_Subdivision";
}

}  // namespace

Error EafTimes::in_tier(const TierElement& tier, std::string message) const {
  return {std::move(message), fmt::format("{}: tier {}", where_, in_quotes(tier.id))};
}

/// Slots without a value, evenly between those around them that have one. Each tier has its own chain of
/// slots; one slot can be the end of an annotation and the start of the next.
Status EafTimes::resolve_slots_of(const TierElement& tier) {
  std::vector<std::pair<std::size_t, Slot*>> chain;
  for (const Annotation& one : tier.annotations) {
    if (!one.alignable) continue;
    for (const std::string* id : {&one.first, &one.last}) {
      const auto slot = slots_.find(*id);
      if (slot == slots_.end())
        return in_tier(tier,
                       fmt::format("annotation {} names the time slot {}, which the file does not have; "
                                   "add it to TIME_ORDER",
                                   in_quotes(one.id), in_quotes(*id)));
      chain.emplace_back(slot->second.place, &slot->second);
    }
  }
  std::sort(chain.begin(), chain.end());
  chain.erase(std::unique(chain.begin(), chain.end()), chain.end());
  for (std::size_t i = 0; i < chain.size(); ++i) {
    if (chain[i].second->known) continue;
    std::size_t next = i;
    while (next < chain.size() && !chain[next].second->known) ++next;
    if (i == 0 || next == chain.size())
      return in_tier(tier, fmt::format("its {} annotation has a time slot without a value, and there is none "
                                       "{} it to know its time by; give the slot a TIME_VALUE",
                                       i == 0 ? "first" : "last", i == 0 ? "before" : "after"));
    const double from_s = chain[i - 1].second->time_s;
    const double step_s = (chain[next].second->time_s - from_s) / static_cast<double>(next - i + 1);
    for (std::size_t k = i; k < next; ++k) {
      chain[k].second->time_s = from_s + step_s * static_cast<double>(k - i + 1);
      chain[k].second->known = true;
      ++interpolated_;
    }
  }
  return Done{};
}

Status EafTimes::resolve_slots(const EafContents& contents) {
  for (std::size_t i = 0; i < contents.slots.size(); ++i) {
    const EafContents::TimeSlot& slot = contents.slots[i];
    if (!slots_.emplace(slot.id, Slot{i, slot.time_s.value_or(0), slot.time_s.has_value()}).second)
      return Error{fmt::format("two time slots are named {}; give each its own name", in_quotes(slot.id)),
                   where_};
  }
  for (const TierElement& tier : contents.tiers) {
    if (const Status found = resolve_slots_of(tier); !found) return found;
    for (const Annotation& one : tier.annotations) {
      if (!one.alignable) continue;
      const EafSpan span{slots_.at(one.first).time_s, slots_.at(one.last).time_s};
      if (!spans_.emplace(one.id, span).second)
        return in_tier(
            tier, fmt::format("the annotation name {} is used twice; give each its own", in_quotes(one.id)));
    }
  }
  return Done{};
}

Status EafTimes::divide(const EafContents& contents, const Family& family, const EafSpan& whole) {
  const Siblings siblings = chained(family.siblings);
  const bool divided = divides_its_parent(contents, *family.tier) || siblings.size() > 1;
  const double step_s =
      (whole.end_s - whole.start_s) / (divided ? static_cast<double>(siblings.size()) : 1.0);
  for (std::size_t i = 0; i < siblings.size(); ++i) {
    // The end of one is the start of the next to the last bit.
    const auto boundary = [&](std::size_t at) { return whole.start_s + step_s * static_cast<double>(at); };
    const double start_s = boundary(i);
    const double end_s = i + 1 == siblings.size() ? whole.end_s : boundary(i + 1);
    if (!spans_.emplace(siblings[i]->id, EafSpan{start_s, end_s}).second)
      return in_tier(*family.tier, fmt::format("the annotation name {} is used twice; give each its own",
                                               in_quotes(siblings[i]->id)));
  }
  return Done{};
}

/// Annotations that refer to others, each generation from the one before it.
Status EafTimes::resolve_references(const EafContents& contents) {
  std::map<std::string_view, std::vector<Family>> children;
  for (const TierElement& tier : contents.tiers)
    for (const Annotation& one : tier.annotations) {
      if (one.alignable) continue;
      std::vector<Family>& families = children[one.parent];
      if (families.empty() || families.back().tier != &tier) families.push_back({&tier, {}});
      families.back().siblings.push_back(&one);
    }
  std::vector<std::string_view> parents;
  for (const auto& [id, span] : spans_) parents.push_back(id);
  while (!parents.empty()) {
    const auto found = children.find(parents.back());
    parents.pop_back();
    if (found == children.end()) continue;
    const EafSpan whole = spans_.at(found->first);
    for (const Family& family : found->second) {
      if (const Status divided = divide(contents, family, whole); !divided) return divided;
      for (const Annotation* one : family.siblings) parents.push_back(one->id);
    }
    children.erase(found);
  }
  if (children.empty()) return Done{};
  const auto& [parent, families] = *children.begin();
  return in_tier(*families.front().tier,
                 fmt::format("annotation {} refers to {}, which the file does not have, or which refers back "
                             "to it; correct its ANNOTATION_REF",
                             in_quotes(families.front().siblings.front()->id), in_quotes(parent)));
}

Status EafTimes::resolve(const EafContents& contents, std::string_view where) {
  where_ = where;
  if (const Status slots = resolve_slots(contents); !slots) return slots;
  return resolve_references(contents);
}

}  // namespace abrazo
