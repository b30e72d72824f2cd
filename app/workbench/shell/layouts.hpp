#pragma once

#include <QObject>
#include <QStringList>
#include <map>

#include "app/workbench/shell/window_layout.hpp"

namespace abrazo::app {

class MainWindow;

/// Named layouts of the window: one for each task, which keeps the user's changes, and the user's own, each a
/// file in the folder `layouts` beside the remembered settings.
class Layouts : public QObject {
  Q_OBJECT
 public:
  explicit Layouts(MainWindow& window);

  /// The tasks.
  static QStringList builtIn() { return {"Inspect", "Annotate", "Live"}; }
  const QString& task() const { return m_task; }
  QStringList own() const;
  QString fileOf(const QString& name) const;

  /// Errors are reported in the message bar. @return whether it was done
  bool choose(const QString& name);
  /// The task's own panels, without the user's changes.
  void reset();
  /// Whether a task's layout comes by itself: with a stream, and with a take that is annotated, until that is
  /// left.
  void setFollowsWork(bool on) { m_followsWork = on; }
  void beginLive();
  void showTake(bool on);
  bool save(const QString& name);
  bool remove(const QString& name);

  /// Restores the layout of the last closing; the default if that cannot be read.
  bool restoreLast();
  bool saveLast();

 signals:
  void ownChanged();
  void taskChanged(const QString& task);

 private:
  bool tell(const Status& done);
  bool restore(const QString& file);
  QString fileOfTask(const QString& task) const;
  void showOnly(const QStringList& panels);

  MainWindow& m_window;
  QString m_task = "Inspect";
  QString m_before;  ///< task that a take interrupted; empty = none
  std::map<QString, WindowLayout> m_kept;
  bool m_followsWork = false;
};

}  // namespace abrazo::app
