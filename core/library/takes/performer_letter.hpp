#pragma once

#include <string_view>

#include "core/library/takes/paired_take.hpp"

namespace abrazo {

/// "a", "b" or "unknown", as in manifests and label files.
constexpr std::string_view letter_of(ActivePerformer active) {
  return active == ActivePerformer::A ? "a" : active == ActivePerformer::B ? "b" : "unknown";
}

}  // namespace abrazo
