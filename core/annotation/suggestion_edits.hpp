#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

#include "core/annotation/label_edits.hpp"
#include "core/annotation/suggestions.hpp"

namespace abrazo {

/// Replaces the suggestions in the first tiers of moves and roles; creates missing tiers. An Error with the
/// reason if there is nothing to suggest.
Result<LabelEdit> with_suggestions(const Annotations& annotations, const SuggestedTiers& suggested,
                                   const SuggestionRequest& request);

/// Turns a suggestion into a label.
Result<LabelEdit> accept_suggestion(const Annotations& annotations, const EditPlace& place, int suggestion);
/// The same with another value.
Result<LabelEdit> accept_suggestion_as(const Annotations& annotations, const EditPlace& place, int suggestion,
                                       std::string_view value);
Result<LabelEdit> reject_suggestion(const Annotations& annotations, int suggestion);
LabelEdit clear_suggestions(const Annotations& annotations);

/// Accepts suggestions one by one.
struct AcceptedSuggestions {
  LabelEdit edit;
  std::size_t refused = 0;  ///< number that stay suggestions
  std::string why = {};     ///< reason of the last refusal
};
AcceptedSuggestions accept_suggestions(const Annotations& annotations, const EditPlace& place,
                                       std::span<const int> suggestions);

}  // namespace abrazo
