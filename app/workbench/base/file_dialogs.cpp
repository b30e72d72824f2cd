#include "app/workbench/base/file_dialogs.hpp"

#include <QDir>
#include <QFileInfo>

#include "app/workbench/base/user_settings.hpp"
#include "widgets/common/file_dialog.hpp"

namespace abrazo::app {

QStringList ask_files(QWidget* parent, UserSettings& remembered, const QString& title,
                      const QString& filter) {
  const QStringList files = widgets::choose_files(parent, title, remembered.lastFolder(), filter);
  if (!files.isEmpty()) remembered.setLastFolder(QFileInfo(files.front()).absolutePath());
  return files;
}

QString ask_file(QWidget* parent, UserSettings& remembered, const QString& title, const QString& filter) {
  const QString file = widgets::choose_file(parent, title, remembered.lastFolder(), filter);
  if (!file.isEmpty()) remembered.setLastFolder(QFileInfo(file).absolutePath());
  return file;
}

QString ask_new_file(QWidget* parent, UserSettings& remembered, const QString& title, const QString& name,
                     const QString& ending, const QString& filter) {
  const QString last = remembered.lastFolder();
  const QDir folder(last.isEmpty() ? QDir::homePath() : last);
  const QString file = widgets::choose_new_file(parent, title, folder.filePath(name), ending, filter);
  if (!file.isEmpty()) remembered.setLastFolder(QFileInfo(file).absolutePath());
  return file;
}

}  // namespace abrazo::app
