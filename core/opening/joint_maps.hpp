#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/base/progress.hpp"
#include "core/base/result.hpp"
#include "core/motion/joints/joint_map.hpp"
#include "core/motion/joints/marker_model.hpp"
#include "core/motion/joints/named_motion.hpp"

namespace abrazo {

/// A motion whose file can be read, but whose points are not mapped to joints.
using UnmappedMotion = std::shared_ptr<const NamedMotion>;

/// The first performer of these files that no built-in joint map and no marker model fits; null when there is
/// none, or a joint map is among the files. Reads the files, until progress asks to stop.
UnmappedMotion motion_without_joints(const std::vector<std::string>& files, const Progress& progress = {});

/// Of the joint maps and marker models in a folder the file of the one that fits; empty when none does. A
/// marker model fits when all of its markers are there.
std::string remembered_map(const NamedMotion& motion, const std::string& folder);

/// The same, where there is no joint map for it in a folder either: what loading these files failed for.
UnmappedMotion motion_to_map(const std::vector<std::string>& files, const std::string& folder);

/// Keeps a joint map or a marker model for files with the same points. @return its file
Result<std::string> remember_map(const JointMap& map, const std::string& folder);
Result<std::string> remember_map(const MarkerModel& model, const std::string& folder);

}  // namespace abrazo
