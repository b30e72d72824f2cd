#include "core/motion/tables/trc_reader.hpp"
#include "tests/fuzz/fuzz_target.hpp"

namespace fuzz = abrazo::fuzz;

ABRAZO_FUZZ_TARGET(trc)(fuzz::Bytes bytes) {
  fuzz::expect_motions(abrazo::read_trc(fuzz::text_of(bytes), "input.trc"));
}
