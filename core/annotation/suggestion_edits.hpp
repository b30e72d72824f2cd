#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

#include "core/annotation/label_edits.hpp"
#include "core/annotation/suggestions.hpp"

namespace abrazo {

/// Suggestions in place of those before, in the first tiers of moves and roles; a tier is made where there is
/// none. An Error when there is nothing to suggest, which says why.
Result<LabelEdit> with_suggestions(const Annotations& annotations, const SuggestedTiers& suggested,
                                   const SuggestionRequest& request);

/// The suggestion becomes a label.
Result<LabelEdit> accept_suggestion(const Annotations& annotations, const EditPlace& place, int suggestion);
/// The same with another value.
Result<LabelEdit> accept_suggestion_as(const Annotations& annotations, const EditPlace& place, int suggestion,
                                       std::string_view value);
Result<LabelEdit> reject_suggestion(const Annotations& annotations, int suggestion);
LabelEdit clear_suggestions(const Annotations& annotations);

/// Each that can be becomes a label, one after another.
struct AcceptedSuggestions {
  LabelEdit edit;
  std::size_t refused = 0;  ///< that stay suggestions
  std::string why = {};     ///< of the last that was refused
};
AcceptedSuggestions accept_suggestions(const Annotations& annotations, const EditPlace& place,
                                       std::span<const int> suggestions);

}  // namespace abrazo
