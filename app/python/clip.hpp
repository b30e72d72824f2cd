#pragma once

#include <string>
#include <vector>

#include "core/motion/body/clip.hpp"

namespace abrazo::python {

/// A clip with the warnings about its file.
struct ReadClip {
  Clip clip;
  std::vector<std::string> warnings;
};

}  // namespace abrazo::python
