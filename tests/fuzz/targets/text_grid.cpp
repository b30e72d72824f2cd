#include "tests/fuzz/tier_checks.hpp"

ABRAZO_FUZZ_TARGET(text_grid)(abrazo::fuzz::Bytes bytes) {
  abrazo::fuzz::expect_tiers(bytes, "input.TextGrid");
}
