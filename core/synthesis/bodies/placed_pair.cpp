#include "core/synthesis/bodies/placed_pair.hpp"

#include <Eigen/Geometry>

#include "core/motion/body/joint_set.hpp"
#include "core/synthesis/motion/foot_plants.hpp"

namespace abrazo {

namespace {

constexpr double shortest_m = 1e-6;
/// A foot that is already there is left alone: inverse kinematics decides about straight knees.
constexpr double is_there_m = 1e-9;

double hip_height(const Pose& pose) {
  return 0.5 * (pose(joints::left_hip, 1) + pose(joints::right_hip, 1));
}

}  // namespace

double BodyChange::legs() const {
  const double recorded_m = from.leg_length();
  return recorded_m > shortest_m ? to.leg_length() / recorded_m : 1;
}

ToeBases toe_bases(const Pose& pose) {
  return {joint_at(pose, joints::left_toe_base), joint_at(pose, joints::right_toe_base)};
}

Pose rebuilt(const Pose& recorded, const BodyChange& change, const Vec3& place) {
  Pose pose;
  pose.row(joints::Root) << place.x(), recorded(joints::Root, 1), place.z();
  for (int joint = 1; joint < joint_count; ++joint) {
    const int parent = joint_parents[static_cast<std::size_t>(joint)];
    Vec3 along = recorded.row(joint) - recorded.row(parent);
    // A bone that the recorded body does not have continues in the direction of its parent bone.
    if (along.norm() < shortest_m && parent > 0)
      along = recorded.row(parent) - recorded.row(joint_parents[static_cast<std::size_t>(parent)]);
    along = along.norm() < shortest_m ? Vec3(Vec3::UnitY()) : Vec3(along.normalized());
    pose.row(joint) =
        pose.row(parent) + change.to.bone_lengths[static_cast<std::size_t>(joint - 1)] * along.transpose();
  }
  pose.col(1).array() += change.legs() * hip_height(recorded) - hip_height(pose);
  return pose;
}

Pose standing_at(Pose pose, const Body& body, const ToeBases& toe_bases) {
  const Vec3 side = along_floor(pose.row(joints::left_hip) - pose.row(joints::right_hip));
  const Vec3 forward =
      side.norm() > shortest_m ? Vec3(side.cross(Vec3::UnitY()).normalized()) : Vec3::UnitZ();
  const ToeBases now = abrazo::toe_bases(pose);
  for (const bool left : {true, false}) {
    const std::size_t side_of = left ? 0 : 1;
    if ((now[side_of] - toe_bases[side_of]).norm() > is_there_m)
      place_foot(pose, body, left, toe_bases[side_of], forward);
  }
  return pose;
}

}  // namespace abrazo
