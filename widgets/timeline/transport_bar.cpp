#include "widgets/timeline/transport_bar.hpp"

#include <QHBoxLayout>
#include <QLabel>
#include <QMenu>
#include <QPushButton>
#include <QToolButton>
#include <cmath>

#include "widgets/common/icons.hpp"
#include "widgets/common/tabular.hpp"
#include "widgets/common/theme.hpp"

namespace abrazo::widgets {

QString clock_text(double time_s) {
  const auto milliseconds = static_cast<long long>(std::llround(std::max(0.0, time_s) * 1000));
  const long long minutes = milliseconds / 60000 % 60, hours = milliseconds / 3600000;
  const QString tail = QString("%1:%2.%3")
                           .arg(minutes, 2, 10, QChar('0'))
                           .arg(milliseconds / 1000 % 60, 2, 10, QChar('0'))
                           .arg(milliseconds % 1000, 3, 10, QChar('0'));
  return hours > 0 ? QString("%1:").arg(hours) + tail : tail;
}

TransportBar::TransportBar(QWidget* parent) : QWidget(parent), m_palette(palette_of(Theme::Dark)) {
  setFixedHeight(40);
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(10, 0, 14, 0);
  row->setSpacing(2);
  m_start = button("To the beginning (Home)");
  m_back = button("One frame back (Left)");
  m_play = button("Play or pause (Space)");
  m_forward = button("One frame on (Right)");
  m_end = button("To the live end (End)");
  for (QToolButton* b : {m_start, m_back, m_play, m_forward, m_end}) row->addWidget(b);
  m_time = new TabularLabel(this);
  m_time->setFont(interface_font(17));
  m_frame = new TabularLabel(this);
  m_state = new TabularLabel(this);
  m_live = new QPushButton("LIVE  End", this);
  m_live->setFocusPolicy(Qt::NoFocus);
  m_live->setCursor(Qt::PointingHandCursor);
  m_live->setToolTip("Follow what comes in (End)");
  m_speed = button("Speed of playback ([ and ], Backspace for 1×)");
  m_speed->setPopupMode(QToolButton::InstantPopup);
  auto* speeds = new QMenu(m_speed);
  for (const double factor : {0.1, 0.25, 0.5, 1.0, 2.0, 4.0})
    connect(speeds->addAction(QString::number(factor, 'f', 2) + "×"), &QAction::triggered, this,
            [this, factor] { emit speedRequested(factor); });
  m_speed->setMenu(speeds);
  m_speed->setStyleSheet("QToolButton::menu-indicator { image: none; }");
  m_loop = button("Play the range between in and out over and over");
  m_loop->setCheckable(true);
  m_loop->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  m_loop->setText("loop");
  m_input = new QLabel(this);
  m_input->setObjectName("secondary");
  row->addSpacing(10);
  row->addWidget(m_time);
  row->addSpacing(14);
  row->addWidget(m_frame);
  row->addSpacing(14);
  row->addWidget(m_state);
  row->addSpacing(10);
  row->addWidget(m_live);
  row->addSpacing(8);
  row->addWidget(m_speed);
  row->addWidget(m_loop);
  row->addStretch(1);
  m_input->setMinimumWidth(1);
  row->addWidget(m_input);
  connect(m_start, &QToolButton::clicked, this, &TransportBar::startRequested);
  connect(m_back, &QToolButton::clicked, this, [this] { emit stepRequested(-1); });
  connect(m_play, &QToolButton::clicked, this, &TransportBar::toggleRequested);
  connect(m_forward, &QToolButton::clicked, this, [this] { emit stepRequested(1); });
  connect(m_end, &QToolButton::clicked, this, &TransportBar::followRequested);
  connect(m_live, &QPushButton::clicked, this, &TransportBar::followRequested);
  connect(m_loop, &QToolButton::clicked, this, &TransportBar::loopRequested);
  dress();
  showPlayback({}, -1);
}

QToolButton* TransportBar::button(const QString& tip) {
  auto* made = new QToolButton(this);
  made->setObjectName("flat");
  made->setToolTip(tip);
  made->setFocusPolicy(Qt::NoFocus);
  made->setIconSize({16, 16});
  return made;
}

void TransportBar::setColours(const Palette& palette) {
  m_palette = palette;
  dress();
  showPlayback(m_shown, -2);
}

void TransportBar::dress() {
  const QColor ink = m_palette.text;
  m_start->setIcon(icon(Icon::ToStart, ink));
  m_back->setIcon(icon(Icon::StepBack, ink));
  m_forward->setIcon(icon(Icon::StepForward, ink));
  m_end->setIcon(icon(Icon::ToEnd, ink));
  m_play->setIcon(icon(m_shown.state == Playback::State::Parked ? Icon::Play : Icon::Pause, ink));
  m_loop->setIcon(icon(Icon::Loop, m_shown.loop ? ink : m_palette.secondary));
  m_frame->setColour(m_palette.secondary);
  m_speed->setStyleSheet(QString("QToolButton { color: %1; } QToolButton::menu-indicator { image: none; }")
                             .arg(m_palette.secondary.name()));
  m_loop->setStyleSheet(QString("QToolButton { color: %1; }")
                            .arg((m_shown.loop ? m_palette.text : m_palette.secondary).name()));
  // Filled when there is something to go back to; quiet when already there.
  const bool behind = m_shown.state != Playback::State::Following;
  m_live->setStyleSheet(QString("QPushButton { background: %1; color: %2; border: 1px solid %3; "
                                "border-radius: 6px; padding: 2px 10px; "
                                "font-weight: 600; font-size: 12px; }")
                            .arg(behind ? m_palette.live.name() : "transparent",
                                 behind ? "#ffffff" : m_palette.secondary.name(),
                                 behind ? m_palette.live.name() : m_palette.border.name()));
}

void TransportBar::setInput(const QString& text) {
  m_input->setText(text);
  makeRoom();
}

/// Rather nothing than half a name.
void TransportBar::makeRoom() {
  constexpr int others_px = 620;
  m_input->setVisible(width() >= others_px + m_input->sizeHint().width());
}

void TransportBar::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  makeRoom();
}

QString TransportBar::stateText() const {
  return m_state->text();
}

void TransportBar::showPlayback(const Playback& playback, long long frame) {
  const bool look = playback.state != m_shown.state || playback.loop != m_shown.loop;
  m_shown = playback;
  if (look) dress();
  m_time->setText(clock_text(playback.cursor_s));
  if (frame >= -1) m_frame->setText(frame < 0 ? "no frame" : QString("frame %1").arg(frame));
  switch (playback.state) {
    case Playback::State::Parked:
      m_state->setText(QString("PARKED −%1 s").arg(std::max(0.0, playback.behind_live_s()), 0, 'f', 1));
      m_state->setColour(m_palette.warning);
      break;
    case Playback::State::Playing:
      m_state->setText(QString("PLAYING −%1 s").arg(std::max(0.0, playback.behind_live_s()), 0, 'f', 1));
      m_state->setColour(m_palette.text);
      break;
    case Playback::State::Following:
      m_state->setText("● LIVE");
      m_state->setColour(m_palette.dark ? m_palette.live.lighter(135) : m_palette.live);
      break;
  }
  m_speed->setText(QString::number(playback.speed, 'f', 2) + "×");
}

}  // namespace abrazo::widgets
