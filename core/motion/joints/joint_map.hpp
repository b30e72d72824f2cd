#pragma once

#include <array>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/base/result.hpp"
#include "core/motion/body/joint_set.hpp"

namespace abrazo {

/// Defines one of the 25 joints by a file's points: a weighted sum of points (weights add up to 1; a weight
/// may be negative or above 1 to extend beyond the last point of a limb).
struct JointRule {
  struct Term {
    std::string point;
    double weight = 1;
  };
  std::vector<Term> terms;
};

/// Rules for all 25 joints; for each joint the first alternative whose points all exist applies.
struct JointMap {
  std::string name;
  std::array<std::vector<JointRule>, joint_count> rules;
};

/// Built-in maps: "cmu" (ASF names, and what Abrazo writes), "cmu-bvh", "mixamo", "lafan", "unity" (also
/// VMC), "xsens", "motive" (OptiTrack), "smpl", "joint-centres", "theia", "mediapipe".
const std::vector<JointMap>& builtin_joint_maps();

/// A map from a JSON file: {"name": "...", "joints": {"root": "Hips" | {"Hips": 0.5, "Spine": 0.5} |
/// [alternatives]}}.
Result<JointMap> parse_joint_map(std::string_view json, std::string_view where);

/// A joint map applied to the points of one file or stream.
struct JointBinding {
  std::array<std::vector<std::pair<int, double>>, joint_count> terms;  ///< per joint: point index, weight
  std::vector<int> missing;    ///< joints without an existing alternative; must be empty for computation
  std::vector<int> estimated;  ///< joints for which a later alternative mixes other points

  /// @param points P x 3, the points of the binding
  Pose joints_of(const Positions& points) const;
};

/// Matches the map's points by exact name, then ignoring a namespace ("mixamorig:Hips", "take:root"), letter
/// case, blanks and underscores.
JointBinding bind_joints(const JointMap& map, const std::vector<std::string>& points);

/// A point's name in normalised form, for inexact matches: "mixamorig:LeftToe_End" -> "lefttoeend".
std::string plain_point_name(std::string_view name);

/// The JSON that reads back to the same map.
std::string joint_map_json(const JointMap& map);

/// "ltoes (LeftToe_End or LeftToeBase_End)": the joint and the points that define it.
std::string describe_joint(const JointMap& map, int joint);

}  // namespace abrazo
