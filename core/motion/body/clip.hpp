#pragma once

#include <string>
#include <vector>

#include "core/base/positions.hpp"

namespace abrazo {

/// One performer's motion in Abrazo's conventions: the 25 joints in metres, right-handed, Y up, floor near y
/// = 0.
struct Clip {
  std::string name;
  double fps = 60.0;
  std::vector<Pose> poses;

  double duration_s() const { return fps > 0 ? static_cast<double>(poses.size()) / fps : 0.0; }
};

}  // namespace abrazo
