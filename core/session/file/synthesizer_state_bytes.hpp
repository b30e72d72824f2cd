#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/base/result.hpp"
#include "core/synthesis/step/synthesizer_state.hpp"

namespace abrazo {

/// Serialises a synthesizer's state exactly to the bit: a version, then every field in order, little-endian.
/// About 28 kB.
std::vector<std::uint8_t> synthesizer_state_bytes(const SynthesizerState& state);

/// Also reads versions 1 and 2, which have no history and no motion of the partner. An Error for a later
/// version, missing bytes or surplus bytes.
Result<SynthesizerState> parse_synthesizer_state(std::span<const std::uint8_t> bytes);

}  // namespace abrazo
