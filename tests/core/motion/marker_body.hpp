#pragma once

#include <Eigen/Geometry>
#include <cmath>
#include <string>
#include <vector>

#include "core/motion/body/joint_set.hpp"
#include "core/motion/joints/named_motion.hpp"
#include "tests/support/bodies.hpp"

namespace abrazo::test {

/// A body whose joints are known, and the markers that Plug-in Gait asks for on its skin [m]: knees 10.5 cm
/// wide, ankles 7, elbows 7.4, markers of 14 mm. The pelvis is one that Harrington's regression holds for.
struct MarkedBody {
  NamedMotion markers;
  std::vector<Pose> poses;
};

/// The arms bent, the knees bent by `knee_rad`; the body turned and moved over the frames.
inline MarkedBody marked_body(int frames, double knee_rad) {
  using namespace joints;
  MarkedBody body;
  body.markers.name = "anna", body.markers.fps = 100, body.markers.metres_per_unit = 1.0;
  const double width = 0.24, depth = 0.16;
  Pose pose = standing_pose();
  const Vec3 front(0, 0.95, 0.08);
  const auto put = [&](int joint, const Vec3& place) { pose.row(joint) = place.transpose(); };
  put(Root, Vec3(0, 0.95, 0));
  const Vec3 left = Vec3::UnitX(), up = Vec3::UnitY(), forward = Vec3::UnitZ();
  std::vector<std::pair<std::string, Vec3>> markers = {{"LASI", front + width / 2 * left},
                                                       {"RASI", front - width / 2 * left},
                                                       {"LPSI", Vec3(0.04, 0.95, 0.08 - depth)},
                                                       {"RPSI", Vec3(-0.04, 0.95, 0.08 - depth)},
                                                       {"C7", Vec3(0, 1.49, -0.06)},
                                                       {"CLAV", Vec3(0, 1.43, 0.08)},
                                                       {"T10", Vec3(0, 1.20, -0.11)},
                                                       {"STRN", Vec3(0, 1.27, 0.11)}};
  for (const int side : {1, -1}) {
    const std::string s = side > 0 ? "L" : "R";
    const auto at = [&](int left_joint) { return side > 0 ? left_joint : mirrored_joint(left_joint); };
    // Harrington 2007 for 240 and 160 mm: 86.5 to the side, 82.9 down, 48.3 back.
    const Vec3 hip = front + Vec3(side * 0.0865, -0.0829, -0.0483);
    const Vec3 knee = hip + 0.41 * Vec3(0, -std::cos(knee_rad), std::sin(knee_rad));
    const Vec3 ankle = knee + 0.41 * Vec3(0, -std::cos(knee_rad), -std::sin(knee_rad));
    put(at(left_hip), hip), put(at(left_knee), knee), put(at(left_ankle), ankle);
    const Vec3 outward = side * left;
    markers.push_back({s + "KNE", knee + (0.105 / 2 + 0.007) * outward});
    markers.push_back({s + "ANK", ankle + (0.07 / 2 + 0.007) * outward});
    markers.push_back({s + "THI", (hip + knee) / 2 + 0.09 * outward});
    markers.push_back({s + "TIB", (knee + ankle) / 2 + 0.07 * outward});
    const Vec3 toe = ankle + Vec3(0, -0.05, 0.12);
    put(at(left_toe_base), toe);
    markers.push_back({s + "TOE", toe + Vec3(0, 0.020, 0)});
    markers.push_back({s + "HEE", ankle + Vec3(0, -0.03, -0.07)});
    const Vec3 shoulder(side * 0.19, 1.38, 0.01);
    const Vec3 elbow = shoulder + 0.28 * Vec3(0, -1, 0);
    const Vec3 wrist = elbow + 0.25 * Vec3(0, 0, 1);
    put(at(left_shoulder), shoulder), put(at(left_elbow), elbow), put(at(left_wrist), wrist);
    markers.push_back({s + "SHO", shoulder + Vec3(0, 0.17 * 0.38, 0)});
    markers.push_back({s + "UPA", (shoulder + elbow) / 2 + 0.06 * outward});
    markers.push_back({s + "ELB", elbow + (0.074 / 2 + 0.007) * outward});
    // The palm looks down: the thumb is inside.
    markers.push_back({s + "WRA", wrist - 0.035 * outward});
    markers.push_back({s + "WRB", wrist + 0.035 * outward});
    const Vec3 hand = wrist + 0.08 * forward;
    put(at(left_hand), hand);
    markers.push_back({s + "FIN", hand + 0.0195 * up});
    markers.push_back({s + "FHD", Vec3(side * 0.07, 1.68, 0.09)});
    markers.push_back({s + "BHD", Vec3(side * 0.07, 1.68, -0.07)});
  }
  put(LowerNeck, Vec3(0, 1.46, 0.01));
  put(Head, Vec3(0, 1.63, 0.01));
  for (const auto& [name, place] : markers)
    body.markers.points.push_back(name), body.markers.parents.push_back(-1);
  for (int f = 0; f < frames; ++f) {
    const Eigen::Matrix3d turn = Eigen::AngleAxisd(0.03 * f, up).toRotationMatrix();
    const Vec3 shift(0.01 * f, 0, 0.3 * std::sin(0.05 * f));
    Positions& frame = body.markers.frames.emplace_back(static_cast<Eigen::Index>(markers.size()), 3);
    for (std::size_t m = 0; m < markers.size(); ++m)
      frame.row(static_cast<Eigen::Index>(m)) = (turn * markers[m].second + shift).transpose();
    body.poses.push_back(moved(pose, 0.03 * f, shift));
  }
  return body;
}

}  // namespace abrazo::test
