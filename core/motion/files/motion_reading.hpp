#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/base/result.hpp"
#include "core/motion/files/import_clip.hpp"

namespace abrazo {

/// A motion file with a person's options as text. Options that are not set are detected.
struct MotionReading {
  std::string file = {};
  std::string skeleton = {};                   ///< the .asf of an .amc
  std::string joint_map = {};                  ///< a built-in map or marker model by its name, or a JSON file
  std::string joints = {};                     ///< order of the joints of an array: its name, or a file
  std::string up = {};                         ///< name of an UpAxis: "y", "-z"
  std::optional<double> metres_per_unit = {};  ///< above 0
  std::optional<double> fps = {};              ///< above 0 [Hz]
  std::string performer = {};          ///< the performer in a file with several: its name, or a number from 1
  std::string animation = {};          ///< the animation in a file with several; by default the longest
  std::string body_model = {};         ///< body model file for SMPL parameters
  std::optional<double> floor_m = {};  ///< height of the floor above the file's zero [m]

  bool operator==(const MotionReading&) const = default;
};

/// The clip with this name or number (from 1).
std::optional<std::size_t> find_performer(const std::vector<ImportedClip>& clips, const std::string& wanted);

/// A motion file whose points are read once. Changes of their interpretation (unit, axes,
/// rate, joints, floor, performer) do not read the file again; another animation, order of joints or
/// body model does.
class MotionPoints {
 public:
  /// All performers of the file, or the requested one.
  /// @param progress  as for load_motion
  Result<std::vector<ImportedClip>> performers(const MotionReading& reading, const Progress& progress = {});
  /// The last result; empty before the first, and after a failure.
  const std::vector<NamedMotion>& motions() const { return motions_; }

 private:
  Status read(const MotionReading& reading, const ImportOptions& options, const Progress& progress);

  MotionReading read_;  ///< the file, and the options that require reading it again
  std::vector<NamedMotion> motions_;
};

/// The same for a file that is read only once.
Result<std::vector<ImportedClip>> read_performers(const MotionReading& reading,
                                                  const Progress& progress = {});

/// The only performer: an Error with their number if there are several.
Result<ImportedClip> read_performer(const MotionReading& reading, const Progress& progress = {});

/// Problems of a file, one sentence each: "walk.bvh:17: glued-numbers: ...".
std::vector<Warning> warnings_of_import(const MotionReading& reading, const ImportedClip& imported);

}  // namespace abrazo
