#pragma once

namespace abrazo {

/// The tables of a project: see docs/session-file.md.
extern const char* const project_tables;

}  // namespace abrazo
