#pragma once

#include <QString>
#include <string_view>

#include "core/base/error.hpp"

namespace abrazo::app {

/// What the window offers for a hint, as the end of a sentence.
std::string_view window_words(Hint hint);

/// An error as it is told in the window.
QString words(const Error& error);

}  // namespace abrazo::app
