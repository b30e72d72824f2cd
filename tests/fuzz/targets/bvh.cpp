#include "core/motion/bvh/bvh.hpp"
#include "tests/fuzz/fuzz_target.hpp"

namespace fuzz = abrazo::fuzz;

ABRAZO_FUZZ_TARGET(bvh)(fuzz::Bytes bytes) {
  fuzz::expect_motions(abrazo::read_bvh(fuzz::text_of(bytes), "input.bvh"));
}
