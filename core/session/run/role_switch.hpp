#pragma once

#include <memory>
#include <optional>

#include "core/base/result.hpp"
#include "core/session/frames/decisions.hpp"
#include "core/session/run/leader_judge.hpp"
#include "core/synthesis/frame_result.hpp"
#include "core/synthesis/role_views.hpp"

namespace abrazo {

/// Whether the library says enough for something other than the hand to decide.
Status check_role_control(const RoleViews& views, RoleControl by);

/// What a RoleSwitch is given after each step.
struct RoleEvidence {
  const FrameResult& result;
  const Pose& user;                      ///< as it came
  const std::optional<Body>& user_body;  ///< measures of the user; none while they are not known
  double time_s = 0;
};

/// Decides about the user's role from frame to frame (docs/decisions/0015).
///
/// Library: the user plays performer A or B of the take that is followed: A when the user is active on a pair
/// whose active performer is A, or passive on one whose active performer is B. The role is the one that this
/// performer has in the take's annotation `look_ahead_s` later; where it is not annotated, it stays. It
/// counts once the same take was followed without a cut for `followed_s`.
///
/// Leader: the mean evidence of LeaderJudge has to pass ln(clearly_better) on the other side.
///
/// Either way a role is kept for at least `dwell_s`.
class RoleSwitch {
 public:
  static constexpr double look_ahead_s = 0.1;
  static constexpr double followed_s = 0.15;
  static constexpr double dwell_s = 1;
  static constexpr double clearly_better = 1.2;  ///< ratio of the distances, geometric mean

  RoleSwitch(std::shared_ptr<const RoleViews> views, UserRole role);

  void control(RoleControl by, UserRole role);
  /// @return the role from the next step on
  UserRole after(const RoleEvidence& evidence);
  UserRole role() const { return role_; }
  /// Of the motion so far, while who leads decides.
  const LeaderJudge* judge() const { return judge_ ? &*judge_ : nullptr; }

 private:
  std::optional<UserRole> annotated_role(const RoleEvidence& evidence);
  std::optional<UserRole> leading_role(const RoleEvidence& evidence);

  std::shared_ptr<const RoleViews> views_;
  RoleControl by_ = RoleControl::Hand;
  UserRole role_;
  std::optional<LeaderJudge> judge_;
  double since_s_ = -1;           ///< of this role; before the first step under control not yet
  double followed_since_s_ = -1;  ///< of the take
};

}  // namespace abrazo
