#include "core/motion/tables/point_csv.hpp"
#include "tests/fuzz/fuzz_target.hpp"

namespace fuzz = abrazo::fuzz;

ABRAZO_FUZZ_TARGET(point_csv)(fuzz::Bytes bytes) {
  fuzz::expect_motions(abrazo::read_point_csv(fuzz::text_of(bytes), "input.csv"));
}
