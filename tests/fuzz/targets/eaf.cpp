#include "tests/fuzz/tier_checks.hpp"

ABRAZO_FUZZ_TARGET(eaf)(abrazo::fuzz::Bytes bytes) {
  abrazo::fuzz::expect_tiers(bytes, "input.eaf");
}
