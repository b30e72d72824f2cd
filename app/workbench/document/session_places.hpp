#pragma once

#include <QDateTime>
#include <QString>
#include <QStringList>

#include "core/base/result.hpp"

namespace abrazo::app {

/// Default folder of sessions: ABRAZO_HOME/sessions, else Abrazo in the documents folder.
QString sessions_folder();

/// A file there that does not exist yet: "session 2026-11-21 14-03.abrazo".
QString new_session_file(const QString& folder, const QDateTime& now);

/// Session files there that were not closed properly.
QStringList unclosed_sessions(const QString& folder);

/// The file and what SQLite writes beside it, there or not. The file itself is the last.
QStringList files_of_session(const QString& file);

/// Moves all files of the session to the trash, or none.
Status discard_session(const QString& file);

/// Renames all files of the session, or none.
bool rename_session(const QString& file, const QString& to);

/// Deletes all files of the session for good.
void delete_session(const QString& file);

}  // namespace abrazo::app
