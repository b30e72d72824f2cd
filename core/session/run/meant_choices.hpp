#pragma once

#include <string>
#include <vector>

#include "core/base/result.hpp"
#include "core/session/frames/decisions.hpp"
#include "core/synthesis/frame_result.hpp"
#include "core/synthesis/role_views.hpp"

namespace abrazo {

/// A move that a person can mean, and how near the user is to it: "turn (0.12 m)".
struct MeantChoice {
  std::string label;             ///< "" = pairs without one
  int pairs = 0;                 ///< that may be selected
  int nearest = -1;              ///< the pair of this label whose features are nearest to the user's
  double feature_distance = -1;  ///< of that pair, Euclidean [m]; -1 without a frame
  double pose_distance = -1;  ///< root mean square over the joints, normalised poses [m]; -1 without a frame
};

/// Every label that may be selected, the nearest to a frame's user first.
/// @param frame  under `user_role`; null: in alphabetical order, without distances
std::vector<MeantChoice> meant_choices(const RoleViews& views, UserRole user_role, const FrameResult* frame);

/// Whether any pair that may be selected is meant; the Error lists the labels or takes there are, with
/// counts.
Status check_meant(const RoleViews& views, const MeantMove& move);

}  // namespace abrazo
