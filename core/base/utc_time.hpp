#pragma once

#include <string>

namespace abrazo {

/// "2024-05-17T14:03:22Z", now.
std::string utc_now();

}  // namespace abrazo
