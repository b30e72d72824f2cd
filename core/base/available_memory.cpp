#include "core/base/available_memory.hpp"

#include <fstream>
#include <limits>
#include <string>

namespace abrazo {

std::uint64_t available_memory_bytes() {
  std::ifstream file("/proc/meminfo");
  std::string name, unit;
  for (std::uint64_t value = 0; file >> name >> value; std::getline(file, unit))
    if (name == "MemAvailable:") return value * 1024;
  return std::numeric_limits<std::uint64_t>::max();
}

}  // namespace abrazo
