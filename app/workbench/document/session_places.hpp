#pragma once

#include <QDateTime>
#include <QString>
#include <QStringList>

namespace abrazo::app {

/// Default folder of sessions: ABRAZO_HOME/sessions, else Abrazo in the documents folder.
QString sessions_folder();

/// A file there that does not exist yet: "session 2026-11-21 14-03.abrazo".
QString new_session_file(const QString& folder, const QDateTime& now);

/// Session files there that were not closed properly.
QStringList unclosed_sessions(const QString& folder);

/// Moves the session, with the remains of a crash, to the wastebasket, or deletes it.
bool discard_session(const QString& file);

}  // namespace abrazo::app
