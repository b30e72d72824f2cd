#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/library/store/motion_library.hpp"

namespace abrazo::python {

/// A library with what was odd about the files it was built from.
struct ReadLibrary {
  std::shared_ptr<const MotionLibrary> library;
  std::vector<std::string> warnings;
};

}  // namespace abrazo::python
