#pragma once

#include "core/library/takes/tier_file.hpp"
#include "tests/fuzz/fuzz_target.hpp"

namespace abrazo::fuzz {

/// A label file of the name's format: what is read holds together, and can be written and read again.
void expect_tiers(Bytes bytes, const std::string& name);

}  // namespace abrazo::fuzz
