#include "tests/fuzz/tier_checks.hpp"

ABRAZO_FUZZ_TARGET(elan_text)(abrazo::fuzz::Bytes bytes) {
  abrazo::fuzz::expect_tiers(bytes, "input.txt");
}
