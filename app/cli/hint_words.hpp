#pragma once

#include <string_view>

#include "core/base/error.hpp"

namespace abrazo::app {

/// The option that a hint is about, as the end of a sentence.
std::string_view option_words(Hint hint);

}  // namespace abrazo::app
