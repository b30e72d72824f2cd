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

}  // namespace abrazo::app
