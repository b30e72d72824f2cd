#pragma once

#include <memory>
#include <vector>

#include "core/base/result.hpp"
#include "core/library/store/motion_library.hpp"
#include "core/library/takes/paired_take.hpp"
#include "core/selection/pair_selector.hpp"
#include "core/synthesis/settings/settings.hpp"

namespace abrazo {

/// Single poses of users, prepared for the search: retargeted to the library's body, normalised, with their
/// feature. The recorded pair replaces the prediction of Eq. 3-4, so that Eq. 7 takes the same time as in a
/// run.
class PoseQueries {
 public:
  /// @param library  the view of the user's role: first bodies are the user's
  PoseQueries(const MotionLibrary& library, UserRole role, bool both_roles)
      : library_(library), role_(role), both_roles_(both_roles) {}

  /// Poses of `take` at `frames`; an Error if the user's performer is unknown.
  Result<std::vector<SelectionQuery>> of(const PairedTake& take, const std::vector<int>& frames) const;

 private:
  const MotionLibrary& library_;
  UserRole role_;
  bool both_roles_;
};

/// The library as a user of this role searches it.
std::shared_ptr<const MotionLibrary> library_for(const std::shared_ptr<const MotionLibrary>& library,
                                                 UserRole role);

/// Pairs that do not come from `take` (which the library need not have), of every take about `rate_hz` of
/// them a second; 0 = all.
std::vector<int> pairs_without(const MotionLibrary& library, const std::string& take, double rate_hz);

}  // namespace abrazo
