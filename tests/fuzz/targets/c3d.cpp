#include "core/motion/tables/c3d_reader.hpp"
#include "tests/fuzz/fuzz_target.hpp"

namespace fuzz = abrazo::fuzz;

ABRAZO_FUZZ_TARGET(c3d)(fuzz::Bytes bytes) {
  fuzz::expect_motions(abrazo::read_c3d(fuzz::text_of(bytes), "input.c3d"));
}
