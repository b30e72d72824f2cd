#include "app/workbench/document/session_places.hpp"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QStandardPaths>

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

bool discard_session(const QString& file) {
  const bool gone = QFile::moveToTrash(file) || QFile::remove(file);
  if (!gone) return false;
  for (const char* ending : {log_ending, "-shm"}) QFile::remove(file + ending);
  return true;
}

}  // namespace abrazo::app
