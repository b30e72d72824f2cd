#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/annotation/annotations.hpp"
#include "core/base/progress.hpp"
#include "core/base/result.hpp"
#include "core/library/store/motion_library.hpp"

namespace abrazo {

/// Request of suggestions for a take, from its geometry (holds, facing, turns, change of places, who moves
/// first) and from labelled neighbours: similar frames of the library's other takes.
struct SuggestionRequest {
  std::string take;  ///< of the library; its own roles and labels are ignored
  bool moves = true;
  bool roles = true;
};

/// Suggested intervals without tier and id that tile the take, in seconds = frame / fps.
struct SuggestedTiers {
  std::vector<Suggestion> moves;
  std::vector<Suggestion> roles;  ///< "a" or "b"
};
Result<SuggestedTiers> suggest_annotations(const MotionLibrary& library, const SuggestionRequest& request,
                                           const Progress& progress);

}  // namespace abrazo
