#pragma once

#include <cstddef>
#include <string>

namespace abrazo::app {

/// What this process may still do from here on.
struct Confinement {
  std::size_t memory_bytes = 0;  ///< of addresses
  unsigned processor_s = 0;
  std::string folder;  ///< below which files may be read; empty: none may be opened
};

/// Takes the limits: memory, processor time, open files, no file may grow, no process may be started, no
/// trace of memory is written after a crash. Where the kernel has Landlock, nothing but the folder can be
/// opened either. Ends this process when its parent does.
/// @return false when the system does not grant the limits; without Landlock it is true
bool confine(const Confinement& to);

}  // namespace abrazo::app
