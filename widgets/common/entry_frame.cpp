#include "widgets/common/entry_frame.hpp"

#include <QApplication>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QVBoxLayout>
#include <algorithm>
#include <utility>

#include "widgets/common/parts.hpp"

namespace abrazo::widgets {
namespace {

constexpr int margin = 8;  // pixels to the window's edges

bool is_return(int key) {
  return key == Qt::Key_Return || key == Qt::Key_Enter;
}

}  // namespace

EntryFrame::EntryFrame(QWidget& window, const QString& prompt, const QString& start, Take take)
    : QFrame(&window), m_take(std::move(take)), m_before(QApplication::focusWidget()) {
  setObjectName("entryFrame");
  setAttribute(Qt::WA_StyledBackground);
  m_title = quiet_label(prompt, this);
  m_field = new QLineEdit(start, this);
  m_field->setAccessibleName(prompt);
  m_field->installEventFilter(this);
  m_complaint = new QLabel(this);
  m_complaint->setWordWrap(true);
  m_complaint->hide();
  auto* column = new QVBoxLayout(this);
  column->setSpacing(6);
  for (QWidget* part :
       {static_cast<QWidget*>(m_title), static_cast<QWidget*>(m_field), static_cast<QWidget*>(m_complaint)})
    column->addWidget(part);
}

void EntryFrame::openAt(const QPoint& corner) {
  m_corner = corner;
  settle();
  show();
  raise();
  m_field->setFocus(Qt::PopupFocusReason);
  m_field->selectAll();
}

QString EntryFrame::complaint() const {
  return m_complaint->text();
}

QString EntryFrame::value() const {
  return m_field->text();
}

void EntryFrame::moveInside(QPoint place) {
  const auto inside = [](int at, int size, int room) {
    return std::clamp(at, margin, std::max(margin, room - size - margin));
  };
  move(inside(place.x(), width(), parentWidget()->width()),
       inside(place.y(), height(), parentWidget()->height()));
}

void EntryFrame::take(const QString& value) {
  const QPointer<EntryFrame> self(this);  // what takes it may open another
  const QString complaint = m_take(value);
  if (!self) return;
  if (complaint.isEmpty()) return leave();
  m_complaint->setText(complaint);
  m_complaint->show();
  m_field->selectAll();
  settle();
}

void EntryFrame::leave() {
  m_field->removeEventFilter(this);
  hide();
  if (m_before && m_before->isVisible()) m_before->setFocus(Qt::PopupFocusReason);
  deleteLater();
}

bool EntryFrame::press(const QKeyEvent& key) {
  if (key.key() == Qt::Key_Escape) return leave(), true;
  if (is_return(key.key())) return take(value()), true;
  return false;
}

bool EntryFrame::keepsFromWindow(int key) const {
  return key == Qt::Key_Escape || is_return(key);
}

bool EntryFrame::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::ShortcutOverride && keepsFromWindow(static_cast<QKeyEvent*>(event)->key())) {
    event->accept();
    return true;
  }
  if (event->type() == QEvent::KeyPress && press(*static_cast<QKeyEvent*>(event))) return true;
  if (event->type() == QEvent::FocusOut && isVisible() &&
      static_cast<QFocusEvent*>(event)->reason() != Qt::PopupFocusReason &&
      static_cast<QFocusEvent*>(event)->reason() != Qt::ActiveWindowFocusReason) {
    m_before = nullptr;  // the user moved the focus
    leave();
  }
  return QFrame::eventFilter(watched, event);
}

}  // namespace abrazo::widgets
