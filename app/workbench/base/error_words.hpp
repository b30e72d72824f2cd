#pragma once

#include <QString>

#include "core/base/error.hpp"
#include "widgets/common/utf8.hpp"

namespace abrazo::app {

/// Text of an Error in the window.
inline QString words(const Error& error) {
  return widgets::text(error.text());
}

}  // namespace abrazo::app
