#pragma once

#include <cstddef>
#include <string>

namespace abrazo::app {

/// Limits of this process from now on.
struct Confinement {
  std::size_t memory_bytes = 0;  ///< of addresses
  unsigned processor_s = 0;
  std::string folder;  ///< below which files may be read; empty: none may be opened
};

/// Applies the limits: memory, processor time and open files; no file may grow, no process may be started,
/// and no core file is written after a crash. If the kernel supports Landlock, only files in the folder can
/// be opened. This process ends when its parent does.
/// @return false if the system refuses the limits; a kernel without Landlock is not a failure
bool confine(const Confinement& to);

}  // namespace abrazo::app
