#pragma once

#include <string_view>

#include "core/base/error.hpp"

namespace abrazo::python {

/// The argument that a hint is about, as the end of a sentence.
std::string_view argument_words(Hint hint);

}  // namespace abrazo::python
