#pragma once

#include <vector>

#include "core/annotation/annotations.hpp"
#include "core/library/takes/tier_file.hpp"

namespace abrazo {

/// Target of a tier of a label file.
struct TierTarget {
  enum class Way { LeaveOut, New, Into };
  Way way = Way::New;
  int tier = 0;  ///< of Way::Into

  bool operator==(const TierTarget&) const = default;
};

/// Targets of the tiers of a file by name and kind: the tier of the same name, else the only tier of roles or
/// moves of the same kind, else a new one.
struct TierPlan {
  std::vector<TierTarget> targets;  ///< one for each
  bool is_clear = true;             ///< false: some target is a guess
};
TierPlan plan_tiers(const std::vector<Tier>& read, const Annotations& into);

/// Replaces the content of the target tiers; new values are added to existing vocabularies.
/// @param targets one per tier of `read`
/// @param range valid times of labels [s]; the Error names a tier with a label outside
Result<Annotations> with_imported(const std::vector<Tier>& read, const std::vector<TierTarget>& targets,
                                  const Annotations& into, const Annotations::Range& range);

/// Reads a label file for a subject. A file with labels of a single other take is read for that take, with a
/// warning.
/// @param fps  of the subject's frames; 0 = not known
/// @param take  "" = the session
Result<TierDocument> read_labels_for(const std::filesystem::path& file, double fps, const std::string& take);

}  // namespace abrazo
