#include "core/library/motion_library_file.hpp"
#include "tests/fuzz/fuzz_target.hpp"

namespace fuzz = abrazo::fuzz;

/// HDF5 as it stands on a disk; a library that is accepted is asked once for its nearest pairs.
ABRAZO_FUZZ_TARGET(library)(fuzz::Bytes bytes) {
  const fuzz::ScratchFile file("library.h5", bytes);
  const auto library = abrazo::read_library(file.path());
  if (!fuzz::accepted(library)) return;
  fuzz::expect(library->pair_count() > 0, "a library without pairs was accepted");
}
