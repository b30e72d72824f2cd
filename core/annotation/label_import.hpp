#pragma once

#include <vector>

#include "core/annotation/annotations.hpp"
#include "core/library/takes/tier_file.hpp"

namespace abrazo {

/// Where a tier of a label file goes.
struct TierTarget {
  enum class Way { LeaveOut, New, Into };
  Way way = Way::New;
  int tier = 0;  ///< of Way::Into

  bool operator==(const TierTarget&) const = default;
};

/// Where the tiers of a file go as far as their names and kinds say: into the tier of the same name, else
/// into the only one of the same kind that is one of roles or moves, else into a new one.
struct TierPlan {
  std::vector<TierTarget> targets;  ///< one for each
  bool is_clear = true;             ///< false: some target is a guess
};
TierPlan plan_tiers(const std::vector<Tier>& read, const Annotations& into);

/// What they say in place of what those tiers said; values come into vocabularies that have any.
/// @param targets  one for each of `read`
/// @param range  [s] that labels may have; the Error names the tier with one that is not within
Result<Annotations> with_imported(const std::vector<Tier>& read, const std::vector<TierTarget>& targets,
                                  const Annotations& into, const Annotations::Range& range);

/// A label file for a subject. One that has labels of a single other take is read for that one, with a
/// warning that says so.
/// @param fps  of the subject's frames; 0 = not known
/// @param take  "" = the session
Result<TierDocument> read_labels_for(const std::filesystem::path& file, double fps, const std::string& take);

}  // namespace abrazo
