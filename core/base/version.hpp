#pragma once

namespace abrazo {

/// "0.1.0", from the build.
const char* version();

}  // namespace abrazo
