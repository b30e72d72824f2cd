#pragma once

#include <array>
#include <vector>

#include "core/library/store/motion_library.hpp"
#include "core/synthesis/frames/frame_result.hpp"

namespace abrazo::widgets {

/// An overlap of two limbs: the nearest points of their axes [m], world.
struct ContactLine {
  Vec3 on_leader = Vec3::Zero(), on_follower = Vec3::Zero();
  double depth_m = 0, allowed_m = 0;

  Vec3 middle() const { return 0.5 * (on_leader + on_follower); }
  /// Deeper than in the recorded pair by more than 5 mm: a penetration, not a contact.
  bool is_excess() const { return depth_m > allowed_m + 0.005; }
};

/// One per collision of the frame, deepest first.
std::vector<ContactLine> contact_lines(const FrameResult& frame);

/// Bones of colliding limbs: of the leader, of the follower.
std::array<std::vector<int>, 2> colliding_bones(const FrameResult& frame);

/// Hands that hold one another in the selected pair: vertices of leader and follower.
std::vector<std::array<int, 2>> held_hands(const FrameResult& frame);

inline constexpr double floor_contact_m = 0.06;  ///< a toe joint lower than this is on the floor
/// Toe bases and toe tips of both bodies on the floor, as vertices.
std::vector<int> floor_contacts(const PairPose& pair);

/// The silhouette of the capsule around a b in view direction `direction` (unit), as a closed polyline. A
/// capsule that points at the eye gives a circle.
std::vector<Vec3> capsule_outline(const Vec3& a, const Vec3& b, double radius_m, const Vec3& direction);

/// "12 mm", with the depth in the recorded pair if it overlaps too: "12 mm (recorded 9)".
std::string depth_text(double depth_m, double allowed_m);

}  // namespace abrazo::widgets
