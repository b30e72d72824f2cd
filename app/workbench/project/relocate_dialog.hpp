#pragma once

#include <QDialog>
#include <memory>

#include "core/opening/open_files.hpp"

class QLabel;
class QPushButton;
class QTreeWidget;

namespace abrazo::app {

/// Dialog for moved files of a session. A located file proposes the places of others that moved with it;
/// these are used only if the user confirms them.
class RelocateDialog : public QDialog {
  Q_OBJECT
 public:
  RelocateDialog(std::shared_ptr<const OpenedProject> project, QWidget* parent);

  /// The chosen paths; empty for files that were not found.
  Places places() const;
  /// As by the button "Locate…". @param index  into the data
  void pointOut(std::size_t index, const QString& file);
  std::size_t leftMissing() const;

 private:
  struct Choice {
    QString file;           ///< empty: missing
    bool proposed = false;  ///< found by the same move; used if its box stays checked
    bool taken = true;
  };
  void fill();
  void locate();
  void showConsequences();
  std::size_t current() const;

  std::shared_ptr<const OpenedProject> m_project;
  std::map<std::size_t, Choice> m_choices;  ///< missing files, by index into the data
  QTreeWidget* m_list;
  QLabel* m_consequences;
  QPushButton *m_locate, *m_open;
};

/// Opens the dialog over the window and waits for its answer, on the worker that opens a session. The dialog
/// closes if the opening is cancelled.
LocateMissing asking_for_places(QWidget& window);

}  // namespace abrazo::app
