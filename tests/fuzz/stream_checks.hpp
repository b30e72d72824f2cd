#pragma once

#include <string_view>

#include "tests/fuzz/fuzz_target.hpp"

namespace abrazo::fuzz {

/// The packets through the whole receiver of a scheme but for its socket: decoder, assembly of the joints,
/// calibration, jitter buffer, health. Poses that come out are finite; memory does not grow with what is
/// sent.
void receive(std::string_view uri, Bytes bytes);

}  // namespace abrazo::fuzz
