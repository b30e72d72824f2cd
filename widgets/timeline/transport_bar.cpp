#include "widgets/timeline/transport_bar.hpp"

#include <QActionGroup>
#include <QContextMenuEvent>
#include <QLabel>
#include <QMenu>
#include <QPainter>
#include <QPushButton>
#include <QScopedValueRollback>
#include <QStyle>
#include <QToolButton>
#include <algorithm>
#include <cmath>

#include "widgets/common/icons.hpp"
#include "widgets/common/parts.hpp"
#include "widgets/common/plain_text.hpp"
#include "widgets/common/tabular.hpp"
#include "widgets/common/theme.hpp"

namespace abrazo::widgets {
namespace {

QString speed_number(double factor) {
  return QString::number(factor, 'f', 2) + "×";
}

constexpr int shortest_input_px = 120;  ///< a name that is shortened more says nothing

}  // namespace

/// In one line; what does not fit is left out in its middle, so that name and rate are both seen. Before that
/// it leaves out that the sender is this machine.
class InputLabel : public QLabel {
 public:
  using QLabel::QLabel;
  QString drawn() const {
    const int room = contentsRect().width();
    QString words = text();
    if (fontMetrics().horizontalAdvance(words) > room)
      words.remove(" at this machine").remove(" from this machine");
    return fontMetrics().elidedText(words, Qt::ElideMiddle, room);
  }
  QSize minimumSizeHint() const override { return {1, QLabel::minimumSizeHint().height()}; }

 protected:
  void paintEvent(QPaintEvent*) override {
    QPainter painter(this);
    style()->drawItemText(&painter, contentsRect(), Qt::AlignVCenter | Qt::AlignLeft, palette(), isEnabled(),
                          drawn(), foregroundRole());
  }
};

TransportBar::TransportBar(QWidget* parent) : QWidget(parent), m_palette(palette_of(Theme::Dark)) {
  setFixedHeight(40);
  m_start = button("To the beginning", "To the beginning (Home)");
  m_back = button("One frame back", "One frame back (Left)");
  m_play = button("Play or pause", "Play or pause (Space)");
  m_forward = button("One frame forward", "One frame forward (Right)");
  m_end = button("To the live end", "To the live end (End)");
  m_time = new TabularLabel(this);
  m_time->setFont(interface_font(17));
  m_time->setAccessibleName("Time");
  m_frame = new TabularLabel(this);
  m_frame->setAccessibleName("Frame");
  for (QWidget* field : {m_time, m_frame}) {
    field->setToolTip("Double click to go to a frame or a time (G), right click for the time format");
    field->installEventFilter(this);
  }
  m_state = new TabularLabel(this);
  m_state->setAccessibleName("State of playback");
  m_live = new QPushButton(this);
  m_live->setFocusPolicy(Qt::NoFocus);
  m_live->setCursor(Qt::PointingHandCursor);
  makeSpeeds();
  makeRepeats();
  makeFormats();
  m_recording = new QLabel(this);
  m_recording->setAccessibleName("Recording");
  m_recording->hide();
  m_role = button("Role of the user", {});
  m_role->setPopupMode(QToolButton::InstantPopup);
  m_role->setFocusPolicy(Qt::TabFocus);
  m_role->hide();
  m_livePin = button("Lift the pin of the live partner",
                     "You pinned a pair: the live partner uses it until you unpin it here");
  m_tried = button("Use for the live partner, too",
                   "What you changed is tried on this frame only: the live partner keeps what it has, and "
                   "going back to it takes the change back. Click to use it for the live partner, too");
  for (QToolButton* pin : {m_livePin, m_tried}) {
    pin->setFocusPolicy(Qt::TabFocus);
    pin->hide();
  }
  connect(m_livePin, &QToolButton::clicked, this, &TransportBar::liftPinRequested);
  connect(m_tried, &QToolButton::clicked, this, &TransportBar::useTriedRequested);
  m_input = new InputLabel(this);
  m_input->setObjectName("secondary");
  m_input->setTextFormat(Qt::PlainText);
  arrange();
  writePins();
  connect(m_start, &QToolButton::clicked, this, &TransportBar::startRequested);
  connect(m_back, &QToolButton::clicked, this, [this] { emit stepRequested(-1); });
  connect(m_play, &QToolButton::clicked, this, &TransportBar::toggleRequested);
  connect(m_forward, &QToolButton::clicked, this, [this] { emit stepRequested(1); });
  connect(m_end, &QToolButton::clicked, this, &TransportBar::followRequested);
  connect(m_live, &QPushButton::clicked, this, &TransportBar::followRequested);
  connect(m_loop, &QToolButton::clicked, this, &TransportBar::loopRequested);
  dress();
  showLive();
  showPlayback({}, -1);
}

QToolButton* TransportBar::button(const QString& name, const QString& tip) {
  auto* made = new QToolButton(this);
  made->setObjectName("flat");
  describe(*made, name, tip);
  made->setFocusPolicy(Qt::NoFocus);
  made->setIconSize({16, 16});
  return made;
}

void TransportBar::makeSpeeds() {
  m_speed = button("Speed of playback", "Speed of playback ([ and ], Backspace for 1×)");
  m_speed->setPopupMode(QToolButton::InstantPopup);
  auto* menu = new QMenu(m_speed);
  for (const double factor : {0.01, 0.02, 0.05, 0.1, 0.25, 0.5, 1.0, 2.0, 4.0, 8.0, 10.0})
    connect(menu->addAction(speed_number(factor)), &QAction::triggered, this,
            [this, factor] { emit speedRequested(factor); });
  connect(menu->addAction("Other…"), &QAction::triggered, this, &TransportBar::speedEntryRequested);
  menu->addSeparator();
  m_everyFrame = menu->addAction("Plays every frame, slower than the chosen speed if necessary");
  m_everyFrame->setCheckable(true);
  connect(m_everyFrame, &QAction::triggered, this, &TransportBar::everyFrameRequested);
  m_speed->setMenu(menu);
}

void TransportBar::makeRepeats() {
  m_loop = button("Loop", "Repeats the range between in and out, or everything if they are not set (Ctrl+L)");
  m_loop->setCheckable(true);
  m_loop->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  m_loop->setPopupMode(QToolButton::DelayedPopup);
  m_loop->setContextMenuPolicy(Qt::ActionsContextMenu);
  auto* group = new QActionGroup(this);
  m_overAndOver = new QAction("Over and over", group);
  m_backAndForth = new QAction("Back and forth", group);
  for (QAction* action : {m_overAndOver, m_backAndForth}) {
    action->setCheckable(true);
    m_loop->addAction(action);
  }
  connect(m_overAndOver, &QAction::triggered, this, [this] { emit repeatRequested(Playback::Repeat::Loop); });
  connect(m_backAndForth, &QAction::triggered, this,
          [this] { emit repeatRequested(Playback::Repeat::PingPong); });
}

void TransportBar::makeFormats() {
  m_formats = new QMenu(this);
  auto* group = new QActionGroup(m_formats);
  const std::pair<const char*, TimeFormat> formats[] = {{"Minutes and seconds", TimeFormat::Clock},
                                                        {"Seconds", TimeFormat::Seconds},
                                                        {"Frames", TimeFormat::Frames},
                                                        {"Timecode", TimeFormat::Timecode}};
  for (const auto& [name, format] : formats) {
    QAction* action = group->addAction(m_formats->addAction(name));
    action->setCheckable(true);
    action->setChecked(format == m_format);
    action->setData(static_cast<int>(format));
    connect(action, &QAction::triggered, this, [this, format = format] { emit formatRequested(format); });
  }
}

void TransportBar::arrange() {
  auto* row = row_in(this, {10, 0, 14, 0}, 2);
  for (QToolButton* b : {m_start, m_back, m_play, m_forward, m_end}) row->addWidget(b);
  const std::pair<QWidget*, int> after[] = {{m_time, 10}, {m_frame, 14}, {m_state, 14},
                                            {m_live, 10}, {m_speed, 8},  {m_loop, 0}};
  for (const auto& [widget, space] : after) {
    row->addSpacing(space);
    row->addWidget(widget);
  }
  row->addSpacing(8);
  row->addWidget(m_role);
  for (QToolButton* pin : {m_livePin, m_tried}) {
    row->addSpacing(6);
    row->addWidget(pin);
  }
  row->addStretch(1);
  row->addWidget(m_recording, 0, Qt::AlignVCenter);
  row->addSpacing(12);
  row->addWidget(m_input);
}

void TransportBar::setColours(const Palette& palette) {
  m_palette = palette;
  dress();
  showState();
}

void TransportBar::dress() {
  const QColor ink = m_palette.text;
  m_start->setIcon(icon(Icon::ToStart, ink));
  m_back->setIcon(icon(Icon::StepBack, ink));
  m_forward->setIcon(icon(Icon::StepForward, ink));
  m_end->setIcon(icon(Icon::ToEnd, ink));
  m_play->setIcon(icon(m_shown.state == Playback::State::Parked ? Icon::Play : Icon::Pause, ink));
  m_loop->setIcon(icon(Icon::Loop, m_shown.loop ? ink : m_palette.secondary));
  m_loop->setChecked(m_shown.loop);
  const bool forth = m_shown.repeat == Playback::Repeat::PingPong;
  m_loop->setText(forth ? "back and forth" : "loop");
  m_overAndOver->setChecked(!forth);
  m_backAndForth->setChecked(forth);
  m_everyFrame->setChecked(m_shown.every_frame);
  m_frame->setColour(m_palette.secondary);
  m_recording->setStyleSheet(QString("background: %1; color: #ffffff; border-radius: 5px; padding: 2px 8px; "
                                     "font-weight: 600; font-size: 12px;")
                                 .arg(m_palette.live.name()));
  dressRole();
  for (QToolButton* pin : {m_livePin, m_tried})
    pin->setStyleSheet(QString("QToolButton { color: %1; border: 1px solid %2; border-radius: 6px; "
                               "padding: 2px 8px; font-weight: 600; font-size: 12px; }")
                           .arg(m_palette.text.name(), m_palette.warning.name()));
  const auto coloured = [](const QColor& colour) {
    return QString("QToolButton { color: %1; } QToolButton::menu-indicator { image: none; }")
        .arg(colour.name());
  };
  m_speed->setStyleSheet(coloured(m_palette.secondary));
  m_loop->setStyleSheet(coloured(m_shown.loop ? m_palette.text : m_palette.secondary));
  // Filled if the cursor can return to the live end; plain if it is there. Red is a live performer.
  const bool behind = m_shown.state != Playback::State::Following;
  const bool is_live = m_userInput == UserInput::Stream;
  m_live->setStyleSheet(QString("QPushButton { background: %1; color: %2; border: 1px solid %3; "
                                "border-radius: 6px; padding: 2px 10px; "
                                "font-weight: 600; font-size: 12px; }")
                            .arg(!behind   ? "transparent"
                                 : is_live ? m_palette.live.name()
                                           : m_palette.raised.name(),
                                 !behind   ? m_palette.secondary.name()
                                 : is_live ? "#ffffff"
                                           : m_palette.text.name(),
                                 behind && is_live ? m_palette.live.name() : m_palette.border.name()));
}

void TransportBar::showOfTake(bool on) {
  if (on == m_isOfTake) return;
  m_isOfTake = on;
  m_role->hide();  // of a session, the next frame brings it again
  makeRoom();
}

/// What has an end of its own is not live, and nothing of it says so.
void TransportBar::showKind() {
  m_live->setVisible(m_shown.is_live);
  const QString to = m_shown.is_live ? "To the live end" : "To the end";
  describe(*m_end, to, to + " (End)");
  makeRoom();
}

void TransportBar::setInput(const QString& text, const QString& detail) {
  m_input->setText(text);
  describe(*m_input, "Input: " + text, plain_tip(detail.isEmpty() ? text : text + "\n" + detail));
  makeRoom();
}

void TransportBar::setRate(double rate_hz) {
  m_rate_hz = rate_hz;
  showTime();
}

void TransportBar::setFormat(TimeFormat format) {
  m_format = format;
  for (QAction* action : m_formats->actions())
    action->setChecked(action->data().toInt() == static_cast<int>(format));
  showTime();
}

void TransportBar::showRecording(const QString& words) {
  if (words == m_recorded) return;
  m_recorded = words;
  writeRecording();
  m_recording->setVisible(!words.isEmpty());
  makeRoom();
}

/// "salsa 003 · 00:35", the time alone, or only that it runs.
void TransportBar::writeRecording() {
  const QString whole = "● REC  " + m_recorded;
  m_recording->setToolTip(plain_tip(whole));
  m_recording->setText(m_recorded.isEmpty()         ? QString()
                       : m_room < Room::ShortWords  ? whole
                       : m_room == Room::ShortWords ? "● REC  " + m_recorded.section(" · ", -1)
                                                    : QString("● REC"));
}

void TransportBar::showHeld(bool on) {
  if (on == m_isHeld) return;
  m_isHeld = on;
  showLive();
  showState();
}

void TransportBar::showUserInput(UserInput from) {
  if (from == m_userInput) return;
  m_userInput = from;
  dress();
  showLive();
  showState();
}

void TransportBar::showLive() {
  writeLive();
  makeRoom();
}

/// Who looks at an earlier frame does not see that the input is still answered.
void TransportBar::writeLive() {
  const bool comes = m_userInput != UserInput::None;
  const bool goes_on = !m_isHeld && comes && m_shown.state != Playback::State::Following;
  const QString word = m_isHeld                           ? "HELD"
                       : m_userInput == UserInput::Stream ? "LIVE"
                       : m_userInput == UserInput::Clip   ? "CLIP"
                                                          : "NEWEST";
  m_live->setText(m_room >= Room::ShortWords ? word : word + (goes_on ? " goes on  End" : "  End"));
  const QString how = m_userInput == UserInput::Clip
                          ? "Solve > Hold the input still (Ctrl+Space) holds the clip"
                          : "A stream cannot be held; Live > Disconnect ends it";
  m_live->setToolTip(
      m_isHeld  ? "To the live end (End). The input is held: nothing is recorded until it is released"
      : goes_on ? "To the live end (End). It goes on: the input is answered and recorded while you look at "
                  "earlier frames. " +
                      how
      : comes ? "Follow the live end (End)"
              : "To the newest frame (End). Nothing comes in");
}

void TransportBar::showRole(bool user_is_active, const QString& by) {
  const bool is_new = user_is_active != m_userIsActive || by != m_roleBy || m_role->text().isEmpty();
  m_userIsActive = user_is_active;
  m_roleBy = by;
  if (m_isOfTake) return;  // a take has no user
  if (!is_new && !m_role->isHidden()) return;
  writeRole();
  m_role->show();
  dressRole();
  makeRoom();
}

void TransportBar::writeRole() {
  const QString role = m_userIsActive ? "leads" : "follows";
  const QString by = m_roleBy.isEmpty() ? QString() : " · " + m_roleBy;
  m_role->setText((m_room >= Room::ShortestWords ? role : "user " + role) +
                  (m_room < Room::ShortWords ? by : QString()) + " ▾");
  describe(*m_role, "Role of the user: " + role,
           (m_userIsActive ? "The user leads, the partner follows" : "The user follows, the partner leads") +
               by + " (U switches)");
}

/// The colour of the character that the user is; the partner leads in dashes.
void TransportBar::dressRole() {
  const QColor ink = m_userIsActive ? m_palette.active : m_palette.passive;
  m_role->setStyleSheet(
      QString("QToolButton { color: %1; border: 1.5px %2 %3; border-radius: 6px; padding: 2px 8px; "
              "font-weight: 600; font-size: 12px; } "
              "QToolButton::menu-indicator { image: none; width: 0; }")
          .arg(m_palette.text.name(), m_userIsActive ? "solid" : "dashed", ink.name()));
}

void TransportBar::showPins(bool live, bool tried) {
  if (m_livePin->isHidden() == !live && m_tried->isHidden() == !tried) return;
  m_livePin->setVisible(live);
  m_tried->setVisible(tried);
  makeRoom();
}

void TransportBar::writePins() {
  const bool is_short = m_room == Room::ShortWords, is_shortest = m_room >= Room::ShortestWords;
  const QString pinned = is_short || is_shortest ? "pinned ✕" : "pinned by you ✕";
  m_livePin->setText(is_shortest || m_userInput == UserInput::Clip ? pinned : "live: " + pinned);
  m_tried->setText(is_shortest ? "what if" : is_short ? "what if ✓" : "what if · use for live");
}

void TransportBar::setRoleMenu(QMenu* menu) {
  m_role->setMenu(menu);
}

QString TransportBar::inputText() const {
  return m_input->isHidden() ? QString() : m_input->drawn();
}

QString TransportBar::recordingText() const {
  return m_recording->text();
}

QString TransportBar::roleText() const {
  return m_role->isHidden() ? QString() : m_role->text();
}

/// Leaves out as little as there is room for.
void TransportBar::makeRoom() {
  if (!m_isPlaced || m_makesRoom) return;
  // A bar that is too narrow for all of its parts is resized by its layout meanwhile.
  const QScopedValueRollback<bool> once(m_makesRoom, true);
  for (const Room room :
       {Room::All, Room::NoInput, Room::NoFrame, Room::ShortWords, Room::ShortestWords, Room::FewParts}) {
    leaveOut(room);
    if (leastWidth() <= width()) return;
  }
}

/// Frame, loop and speed are in the menus as well, and the steps and ends have keys.
void TransportBar::leaveOut(Room room) {
  m_room = room;
  m_input->setVisible(room == Room::All);
  for (QWidget* part : {static_cast<QWidget*>(m_frame), static_cast<QWidget*>(m_loop)})
    part->setVisible(room <= Room::NoInput);
  for (QWidget* part : {m_start, m_back, m_forward, m_end}) part->setVisible(room < Room::FewParts);
  m_speed->setVisible(room < Room::FewParts || m_shown.speed != 1);
  writeLive();
  writeState();
  m_state->fit();
  writeRole();
  writePins();
  writeRecording();
}

/// Rather nothing of the input than a name that nobody can read.
int TransportBar::leastWidth() const {
  layout()->invalidate();
  const int input_px = std::min(m_input->sizeHint().width(), shortest_input_px);
  return layout()->minimumSize().width() + (m_input->isHidden() ? 0 : input_px);
}

void TransportBar::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  m_isPlaced = true;
  makeRoom();
}

bool TransportBar::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::MouseButtonDblClick) {
    emit placeEntryRequested();
    return true;
  }
  if (event->type() == QEvent::ContextMenu) {
    m_formats->popup(static_cast<QContextMenuEvent*>(event)->globalPos());
    return true;
  }
  return QWidget::eventFilter(watched, event);
}

QString TransportBar::stateText() const {
  return m_state->text();
}

QString TransportBar::timeText() const {
  return m_time->text();
}

QString TransportBar::speedText() const {
  return m_speed->text();
}

void TransportBar::showPlayback(const Playback& playback, long long frame) {
  const bool look = playback.state != m_shown.state || playback.loop != m_shown.loop ||
                    playback.repeat != m_shown.repeat || playback.every_frame != m_shown.every_frame;
  const bool kind = playback.is_live != m_shown.is_live;
  m_shown = playback;
  m_shownFrame = frame;
  if (kind) showKind();
  if (look) {
    dress();
    showLive();
  }
  showTime();
  showState();
  showSpeed();
}

void TransportBar::showAchieved(double speed) {
  if (speed == m_achieved) return;
  m_achieved = speed;
  showSpeed();
}

void TransportBar::showTime() {
  const auto written = [this](TimeFormat format) {
    return QString::fromStdString(time_text(format, m_shown.cursor_s, m_shownFrame, m_rate_hz));
  };
  m_time->setText(written(m_format));
  // The other of time and frame is beside it.
  const QString of = m_frames > 0 ? QString(" of %1").arg(m_frames) : QString();
  const QString frame = m_shownFrame < 0 ? "no frame" : QString("frame %1").arg(m_shownFrame) + of;
  m_frame->setText(m_format == TimeFormat::Frames ? written(TimeFormat::Clock) : frame);
}

void TransportBar::showState() {
  const int before = m_state->sizeHint().width();
  writeState();
  if (m_state->sizeHint().width() != before) makeRoom();
}

void TransportBar::writeState() {
  const QString late = QString(" −%1 s").arg(std::max(0.0, m_shown.behind_live_s()), 0, 'f', 1);
  const bool is_late = m_shown.is_live && m_shown.state != Playback::State::Following;
  const QString behind = is_late && m_room < Room::ShortWords ? late : QString();
  m_state->setToolTip(is_late ? "Behind the live end:" + late : QString());
  switch (m_shown.state) {
    case Playback::State::Parked:
      m_state->setText("PARKED" + behind);
      m_state->setColour(m_shown.is_live ? m_palette.warning : m_palette.secondary);
      break;
    case Playback::State::Playing:
      m_state->setText((m_shown.speed < 0 ? "PLAYING BACK" : "PLAYING") + behind);
      m_state->setColour(m_palette.text);
      break;
    case Playback::State::Following:
      m_state->setText(m_isHeld                           ? "‖ HELD"
                       : m_userInput == UserInput::Stream ? "● LIVE"
                       : m_userInput == UserInput::Clip   ? "▶ CLIP"
                                                          : "○ NO INPUT");
      m_state->setColour(m_isHeld || m_userInput == UserInput::None ? m_palette.warning
                         : m_userInput == UserInput::Clip           ? m_palette.text
                         : m_palette.dark                           ? m_palette.live.lighter(135)
                                                                    : m_palette.live);
      break;
  }
}

void TransportBar::showSpeed() {
  const double asked = std::abs(m_shown.speed);
  constexpr double noticed = 0.05;
  const bool differs = m_shown.state == Playback::State::Playing && m_achieved >= 0 &&
                       std::abs(m_achieved - asked) > noticed * asked;
  const QString text = (m_shown.speed < 0 ? "−" : "") + speed_number(asked) +
                       (differs ? QString(" (is %1)").arg(m_achieved, 0, 'f', 2) : QString()) +
                       (m_shown.every_frame ? " every frame" : "");
  if (text == m_speed->text()) return;
  m_speed->setText(text);
  makeRoom();
}

}  // namespace abrazo::widgets
