#pragma once

#include <QObject>
#include <QStringList>

#include "app/workbench/shell/window_layout.hpp"

namespace abrazo::app {

class MainWindow;

/// Named layouts of the window: three built-in ones, and the user's own, each a file in the folder `layouts`
/// beside the remembered settings.
class Layouts : public QObject {
  Q_OBJECT
 public:
  explicit Layouts(MainWindow& window);

  static QStringList builtIn() { return {"Explore", "Tune", "Present"}; }
  QStringList own() const;
  QString fileOf(const QString& name) const;

  /// Errors are reported in the message bar. @return whether it was done
  bool choose(const QString& name);
  bool save(const QString& name);
  bool remove(const QString& name);

  /// Restores the layout of the last closing; the default if that cannot be read.
  bool restoreLast();
  bool saveLast();

 signals:
  void ownChanged();

 private:
  bool tell(const Status& done);
  bool restore(const QString& file);
  void showOnly(const QStringList& panels);

  MainWindow& m_window;
};

}  // namespace abrazo::app
