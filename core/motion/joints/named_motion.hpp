#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/base/error.hpp"
#include "core/base/positions.hpp"
#include "core/motion/joints/up_axis.hpp"

namespace abrazo {

/// A defect of a file that did not prevent reading it. Always shown, never dropped.
struct ImportWarning {
  std::string
      kind;  ///< short and stable: "frame-count", "glued-numbers", "duplicate-name", "units", "up-axis", ...
  int line = 0;  ///< 1-based; 0 when it concerns the whole file
  std::string detail;
  Hint hint = Hint::None;
  /// The file leaves open how it is to be read, and a person can say so: unit, axis, rate, floor, animation.
  bool asks = false;
};

/// A motion as read from a file: world positions of named points in the file's unit and axes. `import_clip`
/// converts it to a Clip.
struct NamedMotion {
  std::string name;                 ///< of the performer or the file
  std::vector<std::string> points;  ///< unique
  std::vector<int> parents;         ///< per point, -1 for a root
  std::vector<Positions> frames;    ///< per frame: points x 3, file units; NaN for a marker that was not seen
  std::optional<double> fps;        ///< none if the format does not state it (AMC) or the value is invalid
  std::optional<double> metres_per_unit;  ///< nothing where the format does not say
  std::optional<UpAxis> up_axis;          ///< nothing where the format does not say
  std::vector<std::string> animations;    ///< of the file, the ones read first; empty: one
  std::vector<ImportWarning> warnings;
  std::vector<int> inferred_joints = {};  ///< where the points are the 25 joints, made of markers: those that
                                          ///< no marker is near to
};

}  // namespace abrazo
