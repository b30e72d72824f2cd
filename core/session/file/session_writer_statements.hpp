#pragma once

#include "core/session/file/session_database.hpp"
#include "core/session/file/session_writer.hpp"

namespace abrazo {

/// Statements prepared once, for what is written in every frame.
struct SessionWriter::Statements {
  SessionStatement frame, pose, pair, settings, learning, decisions, begin, commit;
};

}  // namespace abrazo
