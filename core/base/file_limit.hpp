#pragma once

#include <csignal>

namespace abrazo {

/// From here on a file that may grow no further (a limit of the shell or of the file system) fails to be
/// written, as on a full disk, instead of ending the program. Programs that are started from here take it
/// over.
inline void take_file_limit_for_full_disk() {
  std::signal(SIGXFSZ, SIG_IGN);
}

}  // namespace abrazo
