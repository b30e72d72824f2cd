#pragma once

#include <string>
#include <vector>

#include "core/base/result.hpp"
#include "core/session/frames/decisions.hpp"
#include "core/synthesis/frames/frame_result.hpp"
#include "core/synthesis/step/role_views.hpp"

namespace abrazo {

/// A move that can be declared as intended, and the user's distance to it: "turn (0.12 m)".
struct MeantChoice {
  std::string label;             ///< "" = pairs without one
  int pairs = 0;                 ///< that may be selected
  int nearest = -1;              ///< pair of this label nearest to the user in feature space
  double feature_distance = -1;  ///< of that pair, Euclidean [m]; -1 without a frame
  double pose_distance = -1;  ///< root mean square over the joints, normalised poses [m]; -1 without a frame
};

/// All selectable labels, nearest to a frame's user first.
/// @param frame  under `user_role`; null: in alphabetical order, without distances
std::vector<MeantChoice> meant_choices(const RoleViews& views, UserRole user_role, const FrameResult* frame);

/// Checks that a move matches a selectable pair; the Error lists the available labels or takes with counts.
Status check_meant(const RoleViews& views, const IntendedMove& move);

}  // namespace abrazo
