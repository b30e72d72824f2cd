#include "core/base/error.hpp"

#include "core/base/printable.hpp"

namespace abrazo {

std::string Error::text() const {
  return (where.empty() ? std::string() : printable_line(where) + ": ") + printable(message);
}

}  // namespace abrazo
