#pragma once

#include <csignal>

namespace abrazo {

/// Makes writes beyond a file size limit (of the shell or the file system) fail as on a full disk, instead of
/// ending the program by a signal. Child processes inherit this.
inline void take_file_limit_for_full_disk() {
  std::signal(SIGXFSZ, SIG_IGN);
}

}  // namespace abrazo
