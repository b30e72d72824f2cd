#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/library/store/motion_library.hpp"

namespace abrazo::python {

/// A library with the warnings about its source files.
struct ReadLibrary {
  std::shared_ptr<const MotionLibrary> library;
  std::vector<std::string> warnings;
};

}  // namespace abrazo::python
