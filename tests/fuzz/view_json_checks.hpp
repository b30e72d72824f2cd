#pragma once

#include <string_view>

namespace abrazo::fuzz {

/// Layout of the panels, markers, camera and scene, each read from this text: what comes out is within
/// bounds, and the same when it was written and read again.
void expect_view(std::string_view text);

}  // namespace abrazo::fuzz
