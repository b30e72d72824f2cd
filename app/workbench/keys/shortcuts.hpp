#pragma once

#include <QHash>
#include <QObject>
#include <QPointer>

#include "app/workbench/keys/shortcut_table.hpp"

class QAction;

namespace abrazo::app {

class MainWindow;

/// The keys of all actions of the window, as a person wants them: kept in shortcuts.json beside the other
/// settings. Actions that come later get theirs as they come.
class Shortcuts : public QObject {
  Q_OBJECT
 public:
  explicit Shortcuts(MainWindow& window);
  /// Once there are all actions; those that come later are seen.
  void begin();

  const ShortcutTable& table() const { return m_table; }
  QAction* action(const std::string& id) const;
  /// Puts the keys to use and keeps them.
  void change(const ShortcutTable& next);

  /// Portable text, one key and no sequence; empty where it is none.
  static std::string normal(const std::string& key);
  static QString shown(const std::string& key);

 signals:
  void changed();

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void collect();
  void add(QAction& action);
  void apply();
  void save();
  void tell(const QStringList& troubles);

  MainWindow& m_window;
  QString m_file;
  ShortcutTable m_table;
  QHash<QString, QPointer<QAction>> m_actions;
  bool m_isDue = false;
  bool m_isDamaged = false;  ///< the file: put aside before another is written
  QStringList m_told;
};

}  // namespace abrazo::app
