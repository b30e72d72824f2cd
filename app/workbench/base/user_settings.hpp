#pragma once

#include <QByteArray>
#include <QSettings>
#include <QString>
#include <QStringList>

namespace abrazo::app {

/// Values remembered between two starts. ABRAZO_HOME sets the folder.
class UserSettings {
 public:
  UserSettings();
  QString folder() const { return m_folder; }
  /// Folder of unsaved work.
  QString autosaveFolder() const { return m_folder + "/autosave"; }
  /// Folder of histories on disk: ABRAZO_HOME/history, else abrazo/history in the cache folder of the user.
  QString historyFolder() const;
  /// Bound of the history on disk [GB]; 0 = in memory only.
  double historyBound() const { return m_store.value("history/gigabytes", 4.0).toDouble(); }
  void setHistoryBound(double gigabytes) { m_store.setValue("history/gigabytes", gigabytes); }
  /// Folder of joint maps that the user made for unknown motions.
  QString jointMapFolder() const { return m_folder + "/joint-maps"; }
  /// Folder of the user's rules for reading similar motion files.
  QString importRuleFolder() const { return m_folder + "/import-rules"; }
  /// Whether the last imported motion was to be a rule for similar files.
  bool remembersImports() const { return m_store.value("import/remembers", false).toBool(); }
  void setRemembersImports(bool on) { m_store.setValue("import/remembers", on); }

  QByteArray geometry() const { return m_store.value("window/geometry").toByteArray(); }
  void setGeometry(const QByteArray& geometry) { m_store.setValue("window/geometry", geometry); }
  QString theme() const { return m_store.value("window/theme", "dark").toString(); }
  void setTheme(const QString& theme) { m_store.setValue("window/theme", theme); }
  QString plots() const { return m_store.value("plots/panes").toString(); }
  void setPlots(const QString& panes) { m_store.setValue("plots/panes", panes); }
  QString timelineLanes() const { return m_store.value("timeline/lanes").toString(); }
  void setTimelineLanes(const QString& names) { m_store.setValue("timeline/lanes", names); }
  /// Setup of the scene, as one JSON object.
  QString scene() const { return m_store.value("scene/setup").toString(); }
  void setScene(const QString& setup) { m_store.setValue("scene/setup", setup); }
  QString lastFolder() const { return m_store.value("files/folder").toString(); }
  void setLastFolder(const QString& folder) { m_store.setValue("files/folder", folder); }
  /// Latest first; see recent_files.hpp.
  QStringList recent() const { return m_store.value("files/recent").toStringList(); }
  void setRecent(const QStringList& entries) { m_store.setValue("files/recent", entries); }
  /// URIs of streams and sinks, latest first.
  QStringList recentStreams() const { return m_store.value("live/streams").toStringList(); }
  void setRecentStreams(const QStringList& uris) { m_store.setValue("live/streams", uris); }
  QStringList recentSinks() const { return m_store.value("live/sinks").toStringList(); }
  void setRecentSinks(const QStringList& uris) { m_store.setValue("live/sinks", uris); }
  /// Whose layout the window had.
  QString task() const { return m_store.value("window/task").toString(); }
  void setTask(const QString& task) { m_store.setValue("window/task", task); }
  bool welcome() const { return m_store.value("window/welcome", true).toBool(); }
  void setWelcome(bool at_start) { m_store.setValue("window/welcome", at_start); }
  QString takeName() const { return m_store.value("takes/name").toString(); }
  void setTakeName(const QString& name) { m_store.setValue("takes/name", name); }
  int takeCountdown() const { return m_store.value("takes/countdown", 0).toInt(); }
  void setTakeCountdown(int seconds) { m_store.setValue("takes/countdown", seconds); }
  /// Whether every frame of a live stream is recorded, not only takes.
  bool keepsEverything() const { return m_store.value("takes/everything", true).toBool(); }
  void setKeepsEverything(bool on) { m_store.setValue("takes/everything", on); }

 private:
  QString m_folder;
  QSettings m_store;
};

}  // namespace abrazo::app
