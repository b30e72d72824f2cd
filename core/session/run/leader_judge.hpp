#pragma once

#include <array>
#include <deque>
#include <memory>
#include <optional>
#include <vector>

#include "core/library/store/pose_index.hpp"
#include "core/motion/body/body.hpp"
#include "core/retarget/body_retargeter.hpp"
#include "core/synthesis/step/role_views.hpp"

namespace abrazo {

/// How well a user's motion fits recorded performers who lead, and those who follow.
struct RoleFit {
  double active_m = -1;   ///< d_active: root mean square distance of the joints to the best recorded stretch
  double passive_m = -1;  ///< d_passive; -1 = too little motion seen yet
  /// Running mean of ln(d_passive / d_active): above 0 the user moves like a leader.
  double evidence = 0;
};

/// Judges from the user's motion alone whether the user leads. The partner is synthesised and carries no
/// evidence.
///
/// The user is retargeted to the body of the recorded active and of the recorded passive performers. For
/// either role,
///   d_role^2 = min_c 1/25/L sum_{l<L} |p(t - l T/(L-1)) - p_c(t_c - l T/(L-1))|^2
/// over the recorded stretches that end in one of the k pairs nearest to the present pose (only those
/// annotated with who led). p are the poses of a stretch relative to the root at its end, so that steps and
/// turns count as well as limbs.
class LeaderJudge {
 public:
  static constexpr double stretch_s = 1.0;             ///< T
  static constexpr int poses_of_stretch = 6;           ///< L
  static constexpr int neighbours = 20;                ///< k
  static constexpr double memory_s = 1.0;              ///< time constant of the mean
  static constexpr double between_looks_s = 1.0 / 30;  ///< minimum interval between evaluations

  explicit LeaderJudge(std::shared_ptr<const RoleViews> views);

  /// Adds the user's next pose. A jump back in time or a gap resets the judge.
  void see(const Pose& user, const Body& user_body, double time_s);
  const RoleFit& fit() const { return fit_; }

 private:
  struct Seen {
    double time_s;
    Pose pose;  ///< on the role's body, world
    RootFrame root;
  };
  /// State of one of the two roles.
  struct Side {
    RoleViews::View view;
    std::vector<bool> left_out;  ///< pairs with unknown leader, or led by the other performer
    std::optional<BodyRetargeter> retargeter;
    std::deque<Seen> seen;
    std::vector<PoseMatch> matches;
  };

  void forget();
  std::optional<double> distance(Side& side) const;
  std::optional<double> stretch_distance(const Side& side, int pair, double enough) const;
  static const Seen& seen_before(const Side& side, double time_s);

  std::array<Side, 2> sides_;  ///< active, passive
  std::optional<Body> user_body_;
  double last_look_s_ = -1;
  RoleFit fit_;
};

}  // namespace abrazo
