#include "core/motion/body/body_segments.hpp"

#include "core/motion/body/joint_set.hpp"

namespace abrazo {

namespace {

struct Sexes {
  double male, female;
  double of(SegmentTable table) const {
    switch (table) {
      case SegmentTable::Male:
        return male;
      case SegmentTable::Female:
        return female;
      case SegmentTable::Mean:
        break;
    }
    return 0.5 * (male + female);
  }
};

struct Row {
  std::string_view name;
  Sexes mass, centre;
  std::array<int, 2> proximal, distal;
};

using namespace joints;
constexpr std::array<int, 2> at(int joint) {
  return {joint, joint};
}

constexpr Sexes upper_arm_mass{.0271, .0255}, upper_arm_centre{.5772, .5754};
constexpr Sexes forearm_mass{.0162, .0138}, forearm_centre{.4574, .4559};
constexpr Sexes hand_mass{.0061, .0056}, hand_centre{.7900, .7474};
constexpr Sexes thigh_mass{.1416, .1478}, thigh_centre{.4095, .3612};
constexpr Sexes shank_mass{.0433, .0481}, shank_centre{.4395, .4352};
constexpr Sexes foot_mass{.0137, .0129}, foot_centre{.4415, .4014};

constexpr std::array<Row, segment_count> rows = {{
    {"head", {.0694, .0668}, {.5002, .4841}, at(Head), at(Thorax)},
    {"trunk", {.4346, .4257}, {.4310, .3782}, {left_shoulder, right_shoulder}, {left_hip, right_hip}},
    {"left upper arm", upper_arm_mass, upper_arm_centre, at(left_shoulder), at(left_elbow)},
    {"right upper arm", upper_arm_mass, upper_arm_centre, at(right_shoulder), at(right_elbow)},
    {"left forearm", forearm_mass, forearm_centre, at(left_elbow), at(left_wrist)},
    {"right forearm", forearm_mass, forearm_centre, at(right_elbow), at(right_wrist)},
    {"left hand", hand_mass, hand_centre, at(left_wrist), at(left_hand)},
    {"right hand", hand_mass, hand_centre, at(right_wrist), at(right_hand)},
    {"left thigh", thigh_mass, thigh_centre, at(left_hip), at(left_knee)},
    {"right thigh", thigh_mass, thigh_centre, at(right_hip), at(right_knee)},
    {"left shank", shank_mass, shank_centre, at(left_knee), at(left_ankle)},
    {"right shank", shank_mass, shank_centre, at(right_knee), at(right_ankle)},
    {"left foot", foot_mass, foot_centre, at(left_ankle), at(left_toe_tip)},
    {"right foot", foot_mass, foot_centre, at(right_ankle), at(right_toe_tip)},
}};

}  // namespace

std::array<BodySegment, segment_count> body_segments(SegmentTable table) {
  std::array<BodySegment, segment_count> segments;
  for (std::size_t s = 0; s < rows.size(); ++s)
    segments[s] = {rows[s].name, rows[s].mass.of(table), rows[s].centre.of(table), rows[s].proximal,
                   rows[s].distal};
  return segments;
}

Vec3 segment_centre(const BodySegment& segment, const Pose& pose) {
  const auto middle = [&](const std::array<int, 2>& ends) -> Vec3 {
    return 0.5 * (pose.row(ends[0]) + pose.row(ends[1])).transpose();
  };
  return (1 - segment.centre) * middle(segment.proximal) + segment.centre * middle(segment.distal);
}

Vec3 centre_of_mass(const std::array<BodySegment, segment_count>& segments, const Pose& pose) {
  Vec3 sum = Vec3::Zero();
  double mass = 0;
  for (const BodySegment& segment : segments) {
    sum += segment.mass * segment_centre(segment, pose);
    mass += segment.mass;
  }
  return sum / mass;
}

}  // namespace abrazo
