#pragma once

#include <QWidget>

#include "core/session/frames/playback.hpp"
#include "core/session/frames/time_place.hpp"
#include "widgets/common/palette.hpp"
#include "widgets/common/user_input.hpp"

class QActionGroup;
class QLabel;
class QMenu;
class QPushButton;
class QToolButton;

namespace abrazo::widgets {

class InputLabel;
class TabularLabel;

/// Play, step, time, state, speed, loop. Emits requests; shows what it is given. In a narrow bar it leaves
/// out parts and words, which the tooltips have; it cuts none.
class TransportBar : public QWidget {
  Q_OBJECT
 public:
  explicit TransportBar(QWidget* parent = nullptr);
  void setColours(const Palette& palette);
  /// A take has no user and no live end: what speaks of these is hidden.
  void showOfTake(bool on);
  /// @param text  what plays the user, such as "VMC from this machine · 60 Hz"; shortened where it does not
  /// fit
  /// @param detail  more about it, for the tooltip
  void setInput(const QString& text, const QString& detail = {});
  /// Rate of the timecode; 0 = none.
  void setRate(double rate_hz);
  double rate() const { return m_rate_hz; }
  /// How many frames there are; 0 = the number grows.
  void setFrames(long long count) { m_frames = count; }
  void setFormat(TimeFormat format);
  TimeFormat format() const { return m_format; }
  /// The take being recorded, "salsa 003 · 00:35"; empty = none.
  void showRecording(const QString& words);
  /// Whether the input is held: the live end stays where it is.
  void showHeld(bool on);
  /// What the poses of the user come from; from nowhere if none arrive, and the partner holds its last pose.
  void showUserInput(UserInput from);
  /// The user's role. @param by role control: "by hand", "by the library"
  void showRole(bool user_is_active, const QString& by);
  /// @param live  the live partner is pinned  @param tried  a pin is tried on the parked frame only
  void showPins(bool live, bool tried);
  /// Menu of the role button.
  void setRoleMenu(QMenu* menu);
  /// As it is drawn; empty = there is no room for it.
  QString inputText() const;
  QString recordingText() const;
  QString roleText() const;
  QString stateText() const;
  QString timeText() const;
  QString speedText() const;

 public slots:
  /// @param frame index of the shown frame; -1 = none
  void showPlayback(const abrazo::Playback& playback, long long frame);
  /// The actual speed; shown if it differs from the requested one.
  void showAchieved(double speed);

 signals:
  void toggleRequested();
  void stepRequested(int frames);
  void startRequested();
  void followRequested();
  void speedRequested(double factor);
  void speedEntryRequested();
  void everyFrameRequested(bool on);
  void loopRequested(bool on);
  void repeatRequested(abrazo::Playback::Repeat repeat);
  void liftPinRequested();
  void useTriedRequested();
  void placeEntryRequested();
  void formatRequested(abrazo::TimeFormat format);

 protected:
  void resizeEvent(QResizeEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  /// How much is left out.
  enum class Room { All, NoInput, NoFrame, ShortWords, ShortestWords, FewParts };

  QToolButton* button(const QString& name, const QString& tip);
  void makeSpeeds();
  void makeRepeats();
  void makeFormats();
  void arrange();
  void dress();
  void makeRoom();
  void leaveOut(Room room);
  int leastWidth() const;
  void showKind();
  void showTime();
  void showLive();
  void writeLive();
  void showState();
  void writeState();
  void writeRole();
  void writePins();
  void writeRecording();
  void showSpeed();
  void dressRole();

  Palette m_palette;
  Playback m_shown;
  long long m_shownFrame = -1, m_frames = 0;
  double m_achieved = 1;
  double m_rate_hz = 0;
  TimeFormat m_format = TimeFormat::Clock;
  QLabel* m_recording;
  QToolButton* m_role;
  QToolButton *m_livePin, *m_tried;
  bool m_userIsActive = true, m_isHeld = false;
  UserInput m_userInput = UserInput::None;
  bool m_isOfTake = false;
  bool m_makesRoom = false;
  bool m_isPlaced = false;  ///< has the width of the window
  Room m_room = Room::All;
  QString m_roleBy, m_recorded;
  QToolButton *m_start, *m_back, *m_play, *m_forward, *m_end, *m_speed, *m_loop;
  TabularLabel *m_time, *m_frame, *m_state;
  QPushButton* m_live;
  InputLabel* m_input;
  QMenu* m_formats;
  QAction *m_everyFrame = nullptr, *m_backAndForth = nullptr, *m_overAndOver = nullptr;
};

}  // namespace abrazo::widgets
