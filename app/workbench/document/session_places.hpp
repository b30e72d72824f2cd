#pragma once

#include <QDateTime>
#include <QString>
#include <QStringList>

namespace abrazo::app {

/// Where sessions are kept by default: ABRAZO_HOME/sessions, else Abrazo in the folder of
/// documents.
QString sessions_folder();

/// A file there that does not exist yet: "session 2026-11-21 14-03.abrazo".
QString new_session_file(const QString& folder, const QDateTime& now);

/// Files there that a program did not close.
QStringList unclosed_sessions(const QString& folder);

/// The session with all that a crash may have left beside it, into the wastebasket or away.
bool discard_session(const QString& file);

}  // namespace abrazo::app
