#include "core/base/error.hpp"

namespace abrazo {

std::string Error::text() const {
  return where.empty() ? message : where + ": " + message;
}

}  // namespace abrazo
