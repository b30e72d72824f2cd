#include "core/base/error.hpp"

#include <utility>

#include "core/base/printable.hpp"

namespace abrazo {

std::string Error::text() const {
  return (where.empty() ? std::string() : printable_line(where) + ": ") + printable_line(message);
}

std::string Error::text(HintWords words) const {
  return text() + std::string(words(hint));
}

Error error_at_line(std::string_view where, std::size_t line, std::string message) {
  return {std::move(message), std::string(where) + ":" + std::to_string(line)};
}

}  // namespace abrazo
