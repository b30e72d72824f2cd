#pragma once

#include <memory>
#include <optional>

#include "core/base/result.hpp"
#include "core/session/frames/decisions.hpp"
#include "core/session/run/leader_judge.hpp"
#include "core/synthesis/frames/frame_result.hpp"
#include "core/synthesis/step/role_views.hpp"

namespace abrazo {

/// Checks that the library has the annotations that a role control needs.
Status check_role_control(const RoleViews& views, RoleControl by);

/// Input of a RoleSwitch after each step.
struct RoleEvidence {
  const FrameResult& result;
  const Pose& user;                      ///< as received
  const std::optional<Body>& user_body;  ///< of the user; none = unknown
  double time_s = 0;
};

/// Decides about the user's role from frame to frame (docs/decisions/0015).
///
/// Library: the user plays performer A or B of the take that is followed: A when the user is active on a pair
/// whose active performer is A, or passive on one whose active performer is B. The role is the one that this
/// performer has in the take's annotation `look_ahead_s` later; where it is not annotated, the role stays. It
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
  /// The judge of the motion so far; null unless Leader decides.
  const LeaderJudge* judge() const { return judge_ ? &*judge_ : nullptr; }

 private:
  std::optional<UserRole> annotated_role(const RoleEvidence& evidence);
  std::optional<UserRole> leading_role(const RoleEvidence& evidence);

  std::shared_ptr<const RoleViews> views_;
  RoleControl by_ = RoleControl::Hand;
  UserRole role_;
  std::optional<LeaderJudge> judge_;
  double since_s_ = -1;           ///< begin of this role; -1 before the first step under control
  double followed_since_s_ = -1;  ///< of the take
};

}  // namespace abrazo
