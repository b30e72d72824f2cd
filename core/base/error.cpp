#include "core/base/error.hpp"

#include "core/base/printable.hpp"

namespace abrazo {

std::string Error::text() const {
  return printable(where.empty() ? message : where + ": " + message);
}

}  // namespace abrazo
