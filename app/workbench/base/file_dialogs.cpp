#include "app/workbench/base/file_dialogs.hpp"

#include <QDir>
#include <QFileDialog>
#include <QFileInfo>

#include "app/workbench/base/user_settings.hpp"

namespace abrazo::app {

QStringList ask_files(QWidget* parent, UserSettings& remembered, const QString& title,
                      const QString& filter) {
  const QStringList files = QFileDialog::getOpenFileNames(parent, title, remembered.lastFolder(), filter);
  if (!files.isEmpty()) remembered.setLastFolder(QFileInfo(files.front()).absolutePath());
  return files;
}

QString ask_file(QWidget* parent, UserSettings& remembered, const QString& title, const QString& filter) {
  const QString file = QFileDialog::getOpenFileName(parent, title, remembered.lastFolder(), filter);
  if (!file.isEmpty()) remembered.setLastFolder(QFileInfo(file).absolutePath());
  return file;
}

QString ask_new_file(QWidget* parent, UserSettings& remembered, const QString& title, const QString& name,
                     const QString& ending, const QString& filter) {
  const QString last = remembered.lastFolder();
  const QDir folder(last.isEmpty() ? QDir::homePath() : last);
  QString file = QFileDialog::getSaveFileName(parent, title, folder.filePath(name), filter);
  if (file.isEmpty()) return {};
  if (QFileInfo(file).suffix().isEmpty()) file += ending;
  remembered.setLastFolder(QFileInfo(file).absolutePath());
  return file;
}

}  // namespace abrazo::app
