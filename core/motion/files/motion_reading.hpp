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
  std::string up = {};                         ///< "y" or "z"
  std::optional<double> metres_per_unit = {};  ///< above 0
  std::optional<double> fps = {};              ///< above 0 [Hz]
  std::string performer = {};          ///< which one of a file with several: its name, or a number from 1
  std::string animation = {};          ///< which one of a file with several; the longest by default
  std::string body_model = {};         ///< file of the body that SMPL parameters are for
  std::optional<double> floor_m = {};  ///< height of the floor above the file's zero [m]

  bool operator==(const MotionReading&) const = default;
};

/// Of the clips the one that is meant by its name or its number from 1.
std::optional<std::size_t> find_performer(const std::vector<ImportedClip>& clips, const std::string& wanted);

/// A motion file of which the points are read once. What only concerns how they are understood (unit, axes,
/// rate, joints, floor, performer) is then answered without the file; another animation, order of joints or
/// body model reads it again.
class MotionPoints {
 public:
  /// All performers of the file, or the one that is asked for.
  /// @param progress  as for load_motion
  Result<std::vector<ImportedClip>> performers(const MotionReading& reading, const Progress& progress = {});
  /// What was read last; empty before, and after a failure.
  const std::vector<NamedMotion>& motions() const { return motions_; }

 private:
  Status read(const MotionReading& reading, const ImportOptions& options, const Progress& progress);

  MotionReading read_;  ///< of which the file, and what needs it read again
  std::vector<NamedMotion> motions_;
};

/// The same of a file that is read for this alone.
Result<std::vector<ImportedClip>> read_performers(const MotionReading& reading,
                                                  const Progress& progress = {});

/// The one performer wanted: an Error that says how many there are when that is not clear.
Result<ImportedClip> read_performer(const MotionReading& reading, const Progress& progress = {});

/// What was odd about a file, a sentence each: "walk.bvh:17: glued-numbers: ...".
std::vector<Warning> warnings_of_import(const MotionReading& reading, const ImportedClip& imported);

}  // namespace abrazo
