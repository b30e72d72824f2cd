#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/progress.hpp"
#include "core/base/result.hpp"
#include "core/motion/body/clip.hpp"
#include "core/motion/joints/joint_map.hpp"
#include "core/motion/joints/joint_order.hpp"
#include "core/motion/joints/marker_model.hpp"
#include "core/motion/joints/named_motion.hpp"

namespace abrazo {

/// Options set by a person; none = detected and noted in the report.
struct ImportOptions {
  std::optional<double> metres_per_unit;
  std::optional<double> fps;
  std::optional<UpAxis> up_axis;
  std::optional<JointMap> joint_map;
  std::optional<JointOrder> joint_order;    ///< of arrays of positions without names
  std::optional<MarkerModel> marker_model;  ///< instead of a joint map
  std::string animation;          ///< the animation to read if the file has several; empty = the longest
  std::string body_model;         ///< body model file for SMPL parameters (SmplBodyFile); empty = none
  std::optional<double> floor_m;  ///< height of the floor above the file's zero [m]
};

/// How a file was interpreted. Every guess is marked.
struct ImportReport {
  std::string joint_map;  ///< name of the map or marker model used
  /// The points of each joint, "Hips" or "0.5 LeftHip + 0.5 RightHip"; empty: from markers.
  std::array<std::string, joint_count> joint_points;
  std::vector<int> inferred_joints;  ///< joints that the file lacks, ascending
  double metres_per_unit = 1;
  bool unit_guessed = false;
  double fps = 0;
  bool fps_guessed = false;
  UpAxis up_axis = UpAxis::Y;
  bool up_axis_guessed = false;
  double height_m = 0;                  ///< of the head joint while standing (Body::height)
  double floor_y_m = 0;                 ///< 5th percentile of the toe-base height before any correction
  double floor_shift_m = 0;             ///< added to every y if the floor was far from 0; otherwise 0
  std::vector<std::string> animations;  ///< NamedMotion::animations
  std::vector<ImportWarning> warnings;

  /// Whether a person should confirm how the file is read: it has several animations, or a
  /// warning requires it.
  bool asks() const;
  /// Whether a warning of this kind requires it: "up-axis", "units".
  bool asks_about(std::string_view kind) const;
};

struct ImportedClip {
  Clip clip;
  ImportReport report;
};

/// Converts a file's points to the 25 joints in metres, Y up.
/// @return an Error if no joint map fits, or positions are not all finite
Result<ImportedClip> import_clip(const NamedMotion& motion, const ImportOptions& options);

/// Performers of one take stand on one floor: all are moved by the same amount, that of the lowest, or not at
/// all where one of them rests near 0. Whoever is in the air then stays there, with a warning.
void share_floor(std::span<ImportedClip* const> performers);

/// Whether a built-in joint map or marker model finds all joints among the points.
bool joints_are_known(const NamedMotion& motion);

/// Whether this is the name of a built-in joint map or marker model, not a file.
bool is_builtin_joint_map(const std::string& name);

/// Sets the conversion of points to joints: a built-in joint map or marker model by its name, or by its file.
Status choose_joints(const std::string& name_or_file, ImportOptions& options);

/// The points of any known motion file (motion_format.hpp), one motion for each performer. The content
/// decides the format, not the extension. Gaps of markers are filled where that is safe, and reported.
/// @param skeleton  as for load_motion
/// @param options   of which joint_order, animation and body_model say how to read
/// @param progress  can cancel the reading of a scene (FBX, glTF, Collada); the others are fast
Result<std::vector<NamedMotion>> read_motion_points(const std::string& file, const std::string& skeleton,
                                                    const ImportOptions& options = {},
                                                    const Progress& progress = {});

/// Imports all motions of one file: performers share unit, axes and floor. Objects that are not performers
/// are left out with a warning, unless there is nothing else.
Result<std::vector<ImportedClip>> import_performers(const std::string& file,
                                                    const std::vector<NamedMotion>& motions,
                                                    const ImportOptions& options);

/// Reads any known motion file and imports it. Several performers in one file give several clips. Objects
/// that are not performers (a box with markers) are left out with a warning, unless there is nothing else.
/// @param skeleton the .asf of an .amc; when empty, the .asf beside the file that matches by name
/// ("60_01.amc" -> "60.asf")
/// @param progress  as for read_motion_points
Result<std::vector<ImportedClip>> load_motion(const std::string& file, const std::string& skeleton,
                                              const ImportOptions& options, const Progress& progress = {});

}  // namespace abrazo
