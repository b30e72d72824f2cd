#include "core/session/file/session_file.hpp"
#include "core/session/file/project.hpp"
#include "tests/fuzz/session_template.hpp"

namespace fuzz = abrazo::fuzz;

/// An SQLite database, byte by byte; one of an older version is also brought to this one's.
ABRAZO_FUZZ_TARGET(session_file)(fuzz::Bytes bytes) {
  const fuzz::ScratchFile file("session.abrazo", bytes);
  fuzz::read_session(file.path());
  if (!fuzz::accepted(abrazo::migrate_session(file.path().string()))) return;
  fuzz::read_session(file.path());
}
