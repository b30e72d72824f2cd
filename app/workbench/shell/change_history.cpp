#include "app/workbench/shell/change_history.hpp"

#include <QSignalBlocker>
#include <QUndoStack>

namespace abrazo::app {

ChangeHistory::ChangeHistory(QUndoStack& stack, QWidget* parent) : QListWidget(parent), m_stack(stack) {
  setAccessibleName("History of changes");
  setFrameShape(QFrame::NoFrame);
  connect(&stack, &QUndoStack::indexChanged, this, &ChangeHistory::refresh);
  // Queued: what is undone may change the stack and with it the rows, which are being read here.
  connect(
      this, &QListWidget::currentRowChanged, &stack,
      [&stack](int row) {
        if (row >= 0 && row <= stack.count()) stack.setIndex(row);
      },
      Qt::QueuedConnection);
  refresh();
}

void ChangeHistory::refresh() {
  const QSignalBlocker silent(this);
  while (count() > m_stack.count() + 1) delete takeItem(count() - 1);
  while (count() < m_stack.count() + 1) addItem(QString());
  for (int row = 0; row < count(); ++row) {
    const QString words = row == 0 ? QString("As it was opened") : m_stack.text(row - 1);
    if (item(row)->text() != words) item(row)->setText(words);
  }
  setCurrentRow(m_stack.index());
}

}  // namespace abrazo::app
