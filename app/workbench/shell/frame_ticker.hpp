#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>
#include <functional>

#include "core/session/frames/frame_history.hpp"
#include "core/session/frames/latest_slot.hpp"
#include "core/session/frames/playback.hpp"
#include "core/session/frames/time_place.hpp"

namespace abrazo::app {

/// Polls at display rate for the frame to show, under the rules of Playback. Nothing queues per frame: of
/// several requests between two pictures the newest counts.
class FrameTicker : public QObject {
  Q_OBJECT
 public:
  explicit FrameTicker(QObject* parent = nullptr);
  /// Both outlive the ticker or the next call; null pointers stop it.
  void setSources(const FrameHistory* history, const LatestSlot<FrameSnapshot>* latest);
  /// The frames end there, however many are solved so far: they are played once, from the beginning.
  void setEnd(double end_s);
  /// Converts candidates of shown frames to this library.
  void setLibrary(std::shared_ptr<const MotionLibrary> library);
  /// Restores cursor, speed, in and out, within the available range.
  void resume(const Playback& playback);
  /// Sets the counter of drawn pictures, for playing every frame.
  void setPictures(std::function<std::uint64_t()> count) { m_pictures = std::move(count); }
  const Playback& playback() const { return m_playback; }
  const FrameSnapshotPtr& shown() const { return m_shown; }
  const FrameHistory* history() const { return m_history; }
  /// Speed over about the last second of playing.
  double achievedSpeed() const { return m_achieved; }
  /// Parks at a frame or time. @return the reason if there is no frame, or empty
  QString goTo(const TimePlace& place);

 public slots:
  void toggle();
  void pause();
  void seek(double time_s);
  /// Places that are asked for snap to frames of this rate; 0: they do not.
  void setFrameRate(double frames_hz) { m_frames_hz = frames_hz; }
  void step(int frames);
  void goToStart();
  void follow();
  void setSpeed(double factor);
  void changeSpeed(int steps);
  void setEveryFrame(bool on);
  void setLoop(bool on);
  void setRepeat(abrazo::Playback::Repeat repeat);
  void setIn();
  void setOut();
  void clearIn();
  void clearOut();
  /// @param drag  number of the drag that it is part of; 0 = of none
  void setRange(double from_s, double to_s, int drag = 0);
  /// As they were before; not reported by `endsChanged`.
  void restoreEnds(const abrazo::Playback::Ends& ends);
  /// J, K, L: -1 backwards, 0 stop, 1 forwards; again in the same direction doubles the speed.
  void shuttle(int direction);
  /// While the cursor is dragged the scene has priority; panels update at their own rate.
  void setScrubbing(bool on);
  /// A panel has more to show, or something else to show: panels are due soon even when parked.
  void askForPanels();
  void tick();

 signals:
  void frameReady(abrazo::FrameSnapshotPtr frame);
  void playbackChanged(const abrazo::Playback& playback);
  /// A request changed `playback()`, at once; frames of it are shown later.
  void playbackAsked();
  /// In or out were set or cleared. @param drag  see setRange
  void endsChanged(const abrazo::Playback::Ends& before, const abrazo::Playback::Ends& after, int drag);
  /// Playing ended at once: the looped range has no frames.
  void nothingToPlay();
  /// Update of panels that show a time span: about 10 times per second, twice when parked, and immediately
  /// after a request.
  void panelsDue();

 private:
  void changed();
  void changeEnds(const std::function<void()>& change, int drag = 0);
  void advance(double elapsed_s);
  bool waitsForPicture();
  void passOverGap();
  void measure(double played_s, double elapsed_s);

  QTimer m_timer;
  QTimer m_soon;        ///< one tick after the pending events
  QTimer m_panelsTurn;  ///< the panels after the scene was drawn
  QElapsedTimer m_clock;
  QElapsedTimer m_panels;
  QElapsedTimer m_sinceShown;
  bool m_panelsNow = true;
  bool m_panelsSoon = false;
  bool m_scrubbing = false;
  Playback m_playback;
  FrameSnapshotPtr m_shown;
  FrameSnapshotPtr m_kept;  ///< the shown frame as in the history
  std::shared_ptr<const MotionLibrary> m_library;
  const FrameHistory* m_history = nullptr;
  const LatestSlot<FrameSnapshot>* m_latest = nullptr;
  std::function<std::uint64_t()> m_pictures;
  std::uint64_t m_picturesWhenShown = 0;
  double m_frames_hz = 0;
  std::optional<double> m_end_s;  ///< none: where the newest frame is
  double m_achieved = 1, m_played_s = 0, m_elapsed_s = 0;
};

}  // namespace abrazo::app
