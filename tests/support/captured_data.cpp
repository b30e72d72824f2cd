#include "tests/support/captured_data.hpp"

#include <cstdlib>

namespace abrazo::test {

std::optional<std::filesystem::path> captured_data() {
  namespace fs = std::filesystem;
  if (const char* named = std::getenv("ABRAZO_DATA")) {
    if (fs::exists(fs::path(named) / "cmu_salsa")) return fs::path(named);
    return std::nullopt;
  }
  const fs::path beside = fs::path(ABRAZO_SOURCE_DIR) / ".." / "shared" / "data";
  if (fs::exists(beside / "cmu_salsa")) return beside;
  return std::nullopt;
}

}  // namespace abrazo::test
