#pragma once

#include <QByteArray>
#include <QSettings>
#include <QString>

namespace abrazo::app {

/// What is remembered between two starts. ABRAZO_HOME moves it.
class UserSettings {
 public:
  UserSettings();
  QString folder() const { return m_folder; }

  QByteArray geometry() const { return m_store.value("window/geometry").toByteArray(); }
  void setGeometry(const QByteArray& geometry) { m_store.setValue("window/geometry", geometry); }
  QString theme() const { return m_store.value("window/theme", "dark").toString(); }
  void setTheme(const QString& theme) { m_store.setValue("window/theme", theme); }
  QString plots() const { return m_store.value("plots/panes").toString(); }
  void setPlots(const QString& panes) { m_store.setValue("plots/panes", panes); }
  QString lastFolder() const { return m_store.value("files/folder").toString(); }
  void setLastFolder(const QString& folder) { m_store.setValue("files/folder", folder); }

 private:
  QString m_folder;
  QSettings m_store;
};

}  // namespace abrazo::app
