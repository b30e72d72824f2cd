#include "app/workbench/document/session_places.hpp"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QStandardPaths>

#include "app/workbench/base/trash.hpp"

namespace abrazo::app {
namespace {

constexpr const char* log_ending = "-wal";  // SQLite's; there while a file is written, or was when it crashed

}  // namespace

QString sessions_folder() {
  const QString home = qEnvironmentVariable("ABRAZO_HOME");
  if (!home.isEmpty()) return home + "/sessions";
  QString documents = QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation);
  if (documents.isEmpty()) documents = QDir::homePath();
  return documents + "/Abrazo";
}

QString new_session_file(const QString& folder, const QDateTime& now) {
  const QString name = "session " + now.toString("yyyy-MM-dd HH-mm");
  QString file = QDir(folder).filePath(name + ".abrazo");
  for (int next = 2; QFileInfo::exists(file); ++next)
    file = QDir(folder).filePath(QString("%1 (%2).abrazo").arg(name).arg(next));
  return file;
}

QStringList unclosed_sessions(const QString& folder) {
  QStringList files;
  for (const QFileInfo& file : QDir(folder).entryInfoList({"*.abrazo"}, QDir::Files, QDir::Time))
    if (QFileInfo(file.filePath() + log_ending).size() > 0) files << file.filePath();
  return files;
}

QStringList files_of_session(const QString& file) {
  return {file + log_ending, file + "-shm", file + "-journal", file};
}

Status discard_session(const QString& file) {
  return move_to_trash(files_of_session(file));
}

bool rename_session(const QString& file, const QString& to) {
  const QStringList from = files_of_session(file), into = files_of_session(to);
  for (int i = 0; i < from.size(); ++i) {
    if (!QFileInfo::exists(from[i]) || QFile::rename(from[i], into[i])) continue;
    while (--i >= 0)
      if (QFileInfo::exists(into[i])) QFile::rename(into[i], from[i]);
    return false;
  }
  return true;
}

void delete_session(const QString& file) {
  for (const QString& each : files_of_session(file)) QFile::remove(each);
}

}  // namespace abrazo::app
