#include "tests/fuzz/tier_checks.hpp"

ABRAZO_FUZZ_TARGET(webvtt)(abrazo::fuzz::Bytes bytes) {
  abrazo::fuzz::expect_tiers(bytes, "input.vtt");
}
