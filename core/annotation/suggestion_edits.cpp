#include "core/annotation/suggestion_edits.hpp"

#include <utility>

namespace abrazo {

namespace {

/// The tier for suggestions of a kind; created if missing.
Result<int> tier_for(Annotations& annotations, TierKind kind) {
  if (const AnnotationTier* tier = annotations.first_of(kind)) return tier->id;
  return annotations.add_tier(kind == TierKind::Role ? "role" : "move", kind, {});
}

}  // namespace

Result<LabelEdit> with_suggestions(const Annotations& annotations, const SuggestedTiers& suggested,
                                   const SuggestionRequest& request) {
  LabelEdit edit{annotations, request.moves ? "suggest labels" : "suggest roles"};
  std::vector<int> tiers;
  std::vector<Suggestion> all;
  const auto add = [&](TierKind kind, const std::vector<Suggestion>& list) -> Status {
    const auto tier = tier_for(edit.next, kind);
    if (!tier) return tier.error();
    tiers.push_back(*tier);
    for (Suggestion one : list) {
      one.tier = *tier;
      all.push_back(std::move(one));
    }
    return Done{};
  };
  if (request.moves)
    if (const Status added = add(TierKind::Move, suggested.moves); !added) return added.error();
  if (request.roles)
    if (const Status added = add(TierKind::Role, suggested.roles); !added) return added.error();
  if (all.empty())
    return Error{request.moves ? "The other takes have no labels to learn from"
                               : "The other takes do not say who is active",
                 ""};
  edit.next.suggest(tiers, std::move(all));
  return edit;
}

Result<LabelEdit> accept_suggestion(const Annotations& annotations, const EditPlace& place, int suggestion) {
  LabelEdit edit{annotations, "accept suggestion"};
  const auto id = edit.next.accept(suggestion, place.conflict, place.range);
  if (!id) return id.error();
  return edit;
}

Result<LabelEdit> accept_suggestion_as(const Annotations& annotations, const EditPlace& place, int suggestion,
                                       std::string_view value) {
  LabelEdit edit{annotations, "accept suggestion as " + std::string(value)};
  const auto id = edit.next.accept(suggestion, place.conflict, place.range);
  if (!id) return id.error();
  if (const Status said = edit.next.say(*id, with_value({}, value)); !said) return said.error();
  return edit;
}

Result<LabelEdit> reject_suggestion(const Annotations& annotations, int suggestion) {
  LabelEdit edit{annotations, "reject suggestion"};
  if (const Status done = edit.next.reject(suggestion); !done) return done.error();
  return edit;
}

LabelEdit clear_suggestions(const Annotations& annotations) {
  LabelEdit edit{annotations, "clear suggestions"};
  edit.next.clear_suggestions();
  return edit;
}

AcceptedSuggestions accept_suggestions(const Annotations& annotations, const EditPlace& place,
                                       std::span<const int> suggestions) {
  AcceptedSuggestions accepted{{annotations, ""}};
  for (const int id : suggestions) {
    const auto done = accepted.edit.next.accept(id, place.conflict, place.range);
    if (done) continue;
    ++accepted.refused;
    accepted.why = done.error().text();
  }
  accepted.edit.what = "accept " + std::to_string(suggestions.size() - accepted.refused) + " suggestions";
  return accepted;
}

}  // namespace abrazo
