#include "app/workbench/base/user_settings.hpp"

#include <QDir>
#include <QStandardPaths>

namespace abrazo::app {
namespace {

QString settings_folder() {
  const QString home = qEnvironmentVariable("ABRAZO_HOME");
  const QString folder =
      home.isEmpty() ? QStandardPaths::writableLocation(QStandardPaths::GenericConfigLocation) + "/abrazo"
                     : home;
  QDir().mkpath(folder);
  return folder;
}

}  // namespace

UserSettings::UserSettings()
    : m_folder(settings_folder()), m_store(m_folder + "/workbench.ini", QSettings::IniFormat) {}

QString UserSettings::historyFolder() const {
  if (qEnvironmentVariableIsSet("ABRAZO_HOME")) return m_folder + "/history";
  return QStandardPaths::writableLocation(QStandardPaths::GenericCacheLocation) + "/abrazo/history";
}

}  // namespace abrazo::app
