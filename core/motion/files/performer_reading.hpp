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
  std::string performer = {};                  ///< name, or number from 1, in a file with several
  std::string animation = {};                  ///< name in a file with several; default: the longest
};

/// All performers of the file, or the requested one.
Result<std::vector<ImportedClip>> read_performers(const MotionReading& reading);

/// The requested performer; an Error with the number of performers if it is ambiguous.
Result<ImportedClip> read_performer(const MotionReading& reading);

/// Warnings about a file, one sentence each: "walk.bvh:17: glued-numbers: ...".
std::vector<std::string> warnings_of_import(const MotionReading& reading, const ImportedClip& imported);

}  // namespace abrazo
