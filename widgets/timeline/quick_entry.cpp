#include "widgets/timeline/quick_entry.hpp"

#include <QApplication>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QPointer>
#include <QVBoxLayout>
#include <algorithm>

namespace abrazo::widgets {

QuickEntry* QuickEntry::open(QWidget& widget, const QPoint& above, const QString& prompt,
                             const QString& start, Take take) {
  QWidget& window = *widget.window();
  for (auto* other : window.findChildren<QuickEntry*>()) delete other;
  auto* entry = new QuickEntry(window, prompt, start, std::move(take));
  entry->m_corner = widget.mapTo(&window, above);
  entry->settle();
  entry->show();
  entry->raise();
  entry->m_field->setFocus(Qt::PopupFocusReason);
  entry->m_field->selectAll();
  return entry;
}

QuickEntry::QuickEntry(QWidget& window, const QString& prompt, const QString& start, Take take)
    : QFrame(&window), m_take(std::move(take)), m_before(QApplication::focusWidget()) {
  setObjectName("quickEntry");
  setStyleSheet(
      "#quickEntry { background: palette(window); border: 1px solid palette(highlight); border-radius: 6px; "
      "}");
  setAttribute(Qt::WA_StyledBackground);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(12, 8, 12, 10);
  column->setSpacing(6);
  auto* title = new QLabel(prompt, this);
  title->setObjectName("secondary");
  m_field = new QLineEdit(start, this);
  m_field->setAccessibleName(prompt);
  m_field->setMinimumWidth(300);
  m_field->installEventFilter(this);
  m_complaint = new QLabel(this);
  m_complaint->setWordWrap(true);
  m_complaint->hide();
  column->addWidget(title);
  column->addWidget(m_field);
  column->addWidget(m_complaint);
}

QString QuickEntry::complaint() const {
  return m_complaint->text();
}

/// Above its corner, and inside the window.
void QuickEntry::settle() {
  constexpr int widest = 420, margin = 8;
  setFixedWidth(std::min(widest, std::max(200, parentWidget()->width() - 2 * margin)));
  const int tall =
      layout()->hasHeightForWidth() ? layout()->totalHeightForWidth(width()) : sizeHint().height();
  resize(width(), tall);
  const int x =
      std::clamp(m_corner.x(), margin, std::max(margin, parentWidget()->width() - width() - margin));
  const int y = std::clamp(m_corner.y() - height(), margin,
                           std::max(margin, parentWidget()->height() - height() - margin));
  move(x, y);
}

void QuickEntry::accept() {
  const QPointer<QuickEntry> self(this);  // what takes the text may open another
  const QString complaint = m_take(m_field->text());
  if (!self) return;
  if (complaint.isEmpty()) return leave();
  m_complaint->setText(complaint);
  m_complaint->show();
  m_field->selectAll();
  settle();
}

void QuickEntry::leave() {
  m_field->removeEventFilter(this);
  hide();
  if (m_before && m_before->isVisible()) m_before->setFocus(Qt::PopupFocusReason);
  deleteLater();
}

bool QuickEntry::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::ShortcutOverride) {
    const int key = static_cast<QKeyEvent*>(event)->key();
    if (key == Qt::Key_Escape || key == Qt::Key_Return || key == Qt::Key_Enter) event->accept();
  }
  if (event->type() == QEvent::KeyPress) {
    const int key = static_cast<QKeyEvent*>(event)->key();
    if (key == Qt::Key_Escape) return leave(), true;
    if (key == Qt::Key_Return || key == Qt::Key_Enter) return accept(), true;
  }
  if (event->type() == QEvent::FocusOut && isVisible() &&
      static_cast<QFocusEvent*>(event)->reason() != Qt::PopupFocusReason &&
      static_cast<QFocusEvent*>(event)->reason() != Qt::ActiveWindowFocusReason) {
    m_before = nullptr;  // somebody went elsewhere on purpose
    leave();
  }
  return QFrame::eventFilter(watched, event);
}

}  // namespace abrazo::widgets
