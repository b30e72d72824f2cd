#pragma once

#include <vector>

#include "core/session/file/frame_row.hpp"
#include "tests/fuzz/fuzz_target.hpp"

namespace abrazo::fuzz {

/// A small session file with something in every table, as this program writes it.
const std::vector<std::uint8_t>& session_template();
/// One of its frames.
const FrameRow& frame_template();

/// Reads everything that a session file has; what is refused is refused with a reason.
void read_session(const std::filesystem::path& path);

}  // namespace abrazo::fuzz
