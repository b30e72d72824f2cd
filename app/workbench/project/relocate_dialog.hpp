#pragma once

#include <QDialog>
#include <memory>

#include "core/opening/opened_session.hpp"

class QLabel;
class QPushButton;
class QTreeWidget;

namespace abrazo::app {

/// Which files of a session are not where they were, and where a person says they are. One that is pointed
/// out shows where the others of the same move are; they are taken only when the person says so.
class RelocateDialog : public QDialog {
  Q_OBJECT
 public:
  RelocateDialog(std::shared_ptr<const OpenedProject> project, QWidget* parent);

  /// As chosen; what was not found has an empty path.
  Places places() const;
  /// As by the button "Locate…". @param index  into the data
  void pointOut(std::size_t index, const QString& file);
  std::size_t leftMissing() const;

 private:
  struct Choice {
    QString file;           ///< empty: missing
    bool proposed = false;  ///< found by the same move; taken when its box stays ticked
    bool taken = true;
  };
  void fill();
  void locate();
  void showConsequences();
  std::size_t current() const;

  std::shared_ptr<const OpenedProject> m_project;
  std::map<std::size_t, Choice> m_choices;  ///< by index into the data: those that are missing
  QTreeWidget* m_list;
  QLabel* m_consequences;
  QPushButton *m_locate, *m_open;
};

}  // namespace abrazo::app
