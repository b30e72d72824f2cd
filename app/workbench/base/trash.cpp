#include "app/workbench/base/trash.hpp"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QRegularExpression>
#include <QStandardPaths>
#include <utility>
#include <vector>

namespace abrazo::app {
namespace {

bool is_there(const QString& path) {
  const QFileInfo file(path);
  return file.exists() || file.isSymLink();
}

QString home_trash() {
  return QStandardPaths::writableLocation(QStandardPaths::GenericDataLocation) + "/Trash";
}

/// Without this folder, Qt 5.15 moves files to the working folder and reports success.
bool make_home_trash() {
  const QString trash = home_trash();
  if (!QDir::isAbsolutePath(trash)) return false;
  const bool is_new = !QFileInfo::exists(trash);
  if (!QDir().mkpath(trash + "/files") || !QDir().mkpath(trash + "/info")) return false;
  if (is_new) QFile::setPermissions(trash, QFile::ReadOwner | QFile::WriteOwner | QFile::ExeOwner);
  return true;
}

/// Trash in the home folder; .Trash/UID or .Trash-UID at the top of another file system.
bool is_in_trash(const QString& path) {
  static const QRegularExpression place("/(Trash|\\.Trash/[0-9]+|\\.Trash-[0-9]+)/files/[^/]+$");
  return QDir::isAbsolutePath(path) && place.match(path).hasMatch() && is_there(path);
}

/// With its note of where it came from.
bool take_back(const QString& trashed, const QString& file) {
  const QFileInfo there(trashed);
  if (!QFile::rename(trashed, file)) return false;
  QFile::remove(there.path() + "/../info/" + there.fileName() + ".trashinfo");
  return true;
}

}  // namespace

Status move_to_trash(const QStringList& files) {
  if (!make_home_trash())
    return Error{"was not discarded: there is no trash, and the folder '" + home_trash().toStdString() +
                     "' cannot be made; delete the file yourself",
                 files.isEmpty() ? std::string() : files.back().toStdString()};
  std::vector<std::pair<QString, QString>> moved;  // from, to
  for (const QString& file : files) {
    if (!is_there(file)) continue;
    const QString from = QFileInfo(file).absoluteFilePath();
    QString to;
    const bool is_moved = QFile::moveToTrash(from, &to) && !is_there(from);
    if (is_moved) moved.emplace_back(from, to);
    if (is_moved && is_in_trash(to)) continue;
    for (auto each = moved.rbegin(); each != moved.rend(); ++each)
      if (!take_back(each->second, each->first))
        return Error{"cannot be moved to the trash; it is now '" + each->second.toStdString() + "'",
                     each->first.toStdString()};
    return Error{"was not discarded: it cannot be moved to the trash; delete the file yourself",
                 from.toStdString()};
  }
  return Done{};
}

}  // namespace abrazo::app
