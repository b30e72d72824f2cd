#include "core/session/file/session_edit.hpp"
#include "tests/fuzz/session_template.hpp"

namespace fuzz = abrazo::fuzz;

/// An SQLite database, byte by byte; then a take of it is renamed.
ABRAZO_FUZZ_TARGET(session_file)(fuzz::Bytes bytes) {
  const fuzz::ScratchFile file("session.abrazo", bytes);
  fuzz::read_session(file.path());
  if (!fuzz::accepted(abrazo::edit_session_takes(file.path().string(), {{"first", "second"}}))) return;
  fuzz::read_session(file.path());
}
