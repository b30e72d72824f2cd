#pragma once

#include <QListWidget>

class QUndoStack;

namespace abrazo::app {

/// The changes that can be undone and redone; choosing one goes back or forward to it. QUndoView is not used:
/// it changes the stack, which resets its rows, while it still handles the choice of a row, and then reads
/// the row that is gone (a crash while letters were typed into it).
class ChangeHistory : public QListWidget {
  Q_OBJECT
 public:
  ChangeHistory(QUndoStack& stack, QWidget* parent = nullptr);

 private:
  void refresh();

  QUndoStack& m_stack;
};

}  // namespace abrazo::app
