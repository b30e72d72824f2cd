#include "core/base/version.hpp"

namespace abrazo {

const char* version() {
  return ABRAZO_VERSION;
}

}  // namespace abrazo
