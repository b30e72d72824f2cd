#pragma once

#include <QString>

#include <string_view>

namespace abrazo::widgets {

/// UTF-8 text of core as a QString.
inline QString text(std::string_view utf8) {
  return QString::fromUtf8(utf8.data(), static_cast<int>(utf8.size()));
}

}  // namespace abrazo::widgets
