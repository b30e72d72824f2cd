#include "tests/fuzz/tier_checks.hpp"

ABRAZO_FUZZ_TARGET(tier_json)(abrazo::fuzz::Bytes bytes) {
  abrazo::fuzz::expect_tiers(bytes, "input.json");
}
