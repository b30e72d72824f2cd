#include "core/library/store/motion_library_file.hpp"
#include "tests/fuzz/fuzz_target.hpp"
#include "tests/fuzz/library_checks.hpp"

namespace fuzz = abrazo::fuzz;

/// The same file as one larger than memory: its poses and meshes are looked at only when they are asked for.
ABRAZO_FUZZ_TARGET(mapped_library)(fuzz::Bytes bytes) {
  const fuzz::ScratchFile file("mapped.h5", bytes);
  const auto library = abrazo::read_library(file.path(), {.largest_in_memory_bytes = 0});
  if (fuzz::accepted(library)) fuzz::expect_usable(*library);
}
