#include "widgets/takes/leftover_bar.hpp"

#include <QLabel>
#include <QPushButton>

#include "widgets/common/parts.hpp"
#include "widgets/common/plain_text.hpp"

namespace abrazo::widgets {

LeftoverBar::LeftoverBar(QWidget* parent) : QWidget(parent) {
  setObjectName("leftover");
  setAttribute(Qt::WA_StyledBackground);
  setAccessibleName("Sessions that were not closed");
  m_text = new QLabel(this);
  m_text->setWordWrap(true);
  m_open = new QPushButton("Open", this);
  m_keep = new QPushButton("Keep it", this);
  m_keep->setToolTip("The file stays where it is and is not offered again");
  m_discard = new QPushButton("Discard", this);
  m_discard->setToolTip("Moves a session to the trash; asks before changes or a history are deleted");
  auto* row = row_in(this, {12, 6, 12, 6}, 6);
  row->addWidget(m_text, 1);
  const auto connect_button = [this, row](QPushButton* button, auto signal) {
    row->addWidget(button);
    connect(button, &QPushButton::clicked, this, [this, button, signal] {
      if (button == m_discard && confirmDiscard && !confirmDiscard(m_sessions.front())) return;
      const QString file = m_sessions.front().file;
      next();
      emit(this->*signal)(file);
    });
  };
  connect_button(m_open, &LeftoverBar::openRequested);
  connect_button(m_keep, &LeftoverBar::keepRequested);
  connect_button(m_discard, &LeftoverBar::discardRequested);
  hide();
}

void LeftoverBar::setColours(const Palette& palette) {
  setStyleSheet(QString("QWidget#leftover { background: %1; border-left: 3px solid %2; }")
                    .arg(palette.raised.name(), palette.warning.name()));
}

void LeftoverBar::offer(std::vector<LeftoverSession> sessions) {
  m_sessions = std::move(sessions);
  showFirst();
}

void LeftoverBar::next() {
  m_sessions.erase(m_sessions.begin());
  showFirst();
}

void LeftoverBar::showFirst() {
  setVisible(!m_sessions.empty());
  if (m_sessions.empty()) return;
  const QString more = m_sessions.size() > 1 ? QString("   (1 of %1)").arg(m_sessions.size()) : QString();
  m_text->setText(m_sessions.front().words + more);
  m_text->setToolTip(plain_tip(m_sessions.front().file));
}

QString LeftoverBar::text() const {
  return m_text->text();
}

}  // namespace abrazo::widgets
