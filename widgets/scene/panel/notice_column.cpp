#include "widgets/scene/panel/notice_column.hpp"

#include <QEvent>

#include "widgets/common/parts.hpp"

namespace abrazo::widgets {

NoticeColumn::NoticeColumn(QWidget* parent) : QWidget(parent), m_bars(column_in(this, {}, 1)) {}

void NoticeColumn::add(QWidget* bar) {
  m_bars->addWidget(bar);
}

void NoticeColumn::addFirst(QWidget* bar) {
  m_bars->insertWidget(0, bar);
}

void NoticeColumn::setRoom(const QRect& room) {
  m_room = room;
  fit();
}

/// A bar was shown or hidden, or has another text.
bool NoticeColumn::event(QEvent* event) {
  if (event->type() == QEvent::LayoutRequest) fit();
  return QWidget::event(event);
}

void NoticeColumn::fit() {
  const int height = m_bars->hasHeightForWidth() ? m_bars->totalHeightForWidth(m_room.width())
                                                 : m_bars->totalSizeHint().height();
  setGeometry(m_room.x(), m_room.y(), m_room.width(), height);
}

}  // namespace abrazo::widgets
