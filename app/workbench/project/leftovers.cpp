#include "app/workbench/project/leftovers.hpp"

#include <QDateTime>
#include <QFileInfo>
#include <algorithm>

#include "app/workbench/base/user_settings.hpp"
#include "app/workbench/document/session_places.hpp"
#include "app/workbench/project/autosave.hpp"
#include "app/workbench/project/history_desk.hpp"
#include "core/session/file/session_file.hpp"

namespace abrazo::app {
namespace {

using widgets::LeftoverSession;

QString minutes(double seconds) {
  return seconds < 90 ? QString("%1 s").arg(seconds, 0, 'f', 0)
                      : QString("%1 min").arg(seconds / 60, 0, 'f', 0);
}

/// Those that can be opened and that no program is writing.
std::vector<LeftoverSession> unclosed(const QStringList& files) {
  std::vector<LeftoverSession> found;
  for (const QString& file : files) {
    const auto session = SessionFile::open(file.toStdString());
    if (!session || (*session)->is_being_recorded()) continue;
    const SessionContents& contents = (*session)->contents();
    const auto is_closed = [](const SessionRun& run) { return run.finished; };
    if (std::ranges::all_of(contents.runs, is_closed)) continue;
    const std::size_t takes = contents.takes.size();
    const QDateTime begun =
        contents.runs.empty()
            ? QFileInfo(file).lastModified()
            : QDateTime::fromString(QString::fromStdString(contents.runs.front().begun_at), Qt::ISODate);
    found.push_back({file, QString("Session of %1 was not closed; %2, %3 take%4")
                               .arg(begun.toLocalTime().toString("d MMM HH:mm"),
                                    minutes(contents.last_s - contents.first_s))
                               .arg(takes)
                               .arg(takes == 1 ? "" : "s")});
  }
  return found;
}

/// Changes that were kept for programs that are gone; what cannot be read is offered, too, to be thrown away.
std::vector<LeftoverSession> unsaved(const QStringList& files) {
  std::vector<LeftoverSession> found;
  for (const QString& file : files) {
    const QString words = words_of_autosave(file);
    found.push_back({file, words.isEmpty() ? "Changes that were not saved cannot be read" : words,
                     session_of_autosave(file)});
  }
  return found;
}

/// Histories of programs that are gone.
std::vector<LeftoverSession> histories(const QStringList& files) {
  std::vector<LeftoverSession> found;
  for (const QString& file : files) {
    const auto session = SessionFile::open(file.toStdString());
    const QString length =
        session ? minutes((*session)->contents().last_s - (*session)->contents().first_s) : "cannot be read";
    found.push_back({file,
                     QString("History of %1, kept on disk when the program ended: %2")
                         .arg(QFileInfo(file).lastModified().toString("d MMM HH:mm"), length),
                     {}});
  }
  return found;
}

}  // namespace

LeftoverFiles leftover_files(const UserSettings& remembered) {
  return {unclosed_sessions(sessions_folder()), Autosave::leftBehind(remembered.autosaveFolder()),
          HistoryDesk::leftBehind(remembered.historyFolder())};
}

std::vector<LeftoverSession> described(const LeftoverFiles& files) {
  // Unsaved work opens together with its recording.
  auto found = unsaved(files.autosaves);
  for (LeftoverSession& session : unclosed(files.sessions))
    if (std::ranges::none_of(found, [&](const auto& one) { return one.belongsTo == session.file; }))
      found.push_back(std::move(session));
  for (LeftoverSession& history : histories(files.histories)) found.push_back(std::move(history));
  return found;
}

}  // namespace abrazo::app
