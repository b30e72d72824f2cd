#include "core/library/store/motion_library_file.hpp"
#include "tests/fuzz/fuzz_target.hpp"
#include "tests/fuzz/library_checks.hpp"

namespace fuzz = abrazo::fuzz;

/// HDF5 as it stands on a disk, read into memory; a library that is accepted is asked for all it has and for
/// its nearest pairs.
ABRAZO_FUZZ_TARGET(library)(fuzz::Bytes bytes) {
  const fuzz::ScratchFile file("library.h5", bytes);
  const auto library = abrazo::read_library(file.path());
  if (!fuzz::accepted(library)) return;
  fuzz::expect(!library->damage(), "a library in memory that is damaged");
  fuzz::expect_usable(*library);
}
