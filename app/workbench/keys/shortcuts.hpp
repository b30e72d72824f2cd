#pragma once

#include <QHash>
#include <QObject>
#include <QPointer>

#include "app/workbench/keys/shortcut_table.hpp"

class QAction;

namespace abrazo::app {

class MainWindow;

/// The user's keys of all actions of the window, stored in shortcuts.json beside the other settings. Actions
/// added later get theirs when they are added.
class Shortcuts : public QObject {
  Q_OBJECT
 public:
  explicit Shortcuts(MainWindow& window);
  /// Call after all actions exist; later ones are detected.
  void begin();

  const ShortcutTable& table() const { return m_table; }
  QAction* action(const std::string& id) const;
  /// Applies and stores the keys.
  void change(const ShortcutTable& next);

  /// Portable text of one key, no sequence; empty if invalid.
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
  bool m_isDamaged = false;  ///< the file is damaged: moved aside before writing another
  QStringList m_told;
};

}  // namespace abrazo::app
