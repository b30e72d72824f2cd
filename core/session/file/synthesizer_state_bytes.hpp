#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/base/result.hpp"
#include "core/synthesis/synthesizer_state.hpp"

namespace abrazo {

/// A synthesizer's state as bytes that read back to the same bits: a version, then every field in order,
/// little-endian. Some 28 kB.
std::vector<std::uint8_t> synthesizer_state_bytes(const SynthesizerState& state);

/// Reads versions 1 and 2 too, which knew no history and no motion of the partner. Refuses what is of a later
/// version, cut short or has bytes left over.
Result<SynthesizerState> parse_synthesizer_state(std::span<const std::uint8_t> bytes);

}  // namespace abrazo
