#pragma once

#include <QDialog>
#include <string>

class QHBoxLayout;
class QLabel;
class QLineEdit;
class QPushButton;
class QTreeWidget;

namespace abrazo::app {

class KeyEntry;
class Shortcuts;

/// All actions with their keys; changes take effect immediately.
class ShortcutDialog : public QDialog {
  Q_OBJECT
 public:
  ShortcutDialog(Shortcuts& shortcuts, QWidget* parent);
  /// Id of the chosen row; empty = none.
  std::string chosen() const;
  void choose(const std::string& id);
  QString verdict() const;

 private:
  QWidget* makeEditor();
  void fill();
  void filter(const QString& words);
  void showChosen();
  void judge();
  void addKey();
  void removeKey(const std::string& key);

  Shortcuts& m_shortcuts;
  QLineEdit* m_filter;
  QTreeWidget* m_rows;
  QLabel *m_name, *m_verdict;
  QHBoxLayout* m_keys;  ///< a button for each key of the chosen row
  KeyEntry* m_entry;
  QPushButton *m_add, *m_reset, *m_resetAll;
};

}  // namespace abrazo::app
