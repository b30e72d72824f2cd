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

/// Polls at display rate: which frame is to be shown now, under the rules of Playback. Nothing queues per
/// frame: of several requests between two pictures the newest counts.
class FrameTicker : public QObject {
  Q_OBJECT
 public:
  explicit FrameTicker(QObject* parent = nullptr);
  /// Both outlive the ticker or the next call; null pointers stop it.
  void setSources(const FrameHistory* history, const LatestSlot<FrameSnapshot>* latest);
  /// Frames are shown with their candidates numbered as in this library.
  void setLibrary(std::shared_ptr<const MotionLibrary> library);
  /// As it was left: cursor, speed, in and out, within what there is now.
  void resume(const Playback& playback);
  /// How many pictures reached the screen so far: what playing every frame waits for.
  void setPictures(std::function<std::uint64_t()> count) { m_pictures = std::move(count); }
  const Playback& playback() const { return m_playback; }
  const FrameSnapshotPtr& shown() const { return m_shown; }
  const FrameHistory* history() const { return m_history; }
  /// Of the last second or so of playing.
  double achievedSpeed() const { return m_achieved; }
  /// Parks at a frame or time. @return why there is nothing to show there, or nothing
  QString goTo(const TimePlace& place);

 public slots:
  void toggle();
  void pause();
  void seek(double time_s);
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
  void setRange(double from_s, double to_s);
  /// J, K, L: -1 backwards, 0 stop, 1 forwards; again in the same direction doubles the speed.
  void shuttle(int direction);
  /// While the cursor is being dragged the picture comes first: panels keep to their own pace.
  void setScrubbing(bool on);
  void tick();

 signals:
  void frameReady(abrazo::FrameSnapshotPtr frame);
  void playbackChanged(const abrazo::Playback& playback);
  /// Time for the panels that show a span of time: some 12 times a second, and immediately after a request.
  void panelsDue();

 private:
  void changed();
  void advance(double elapsed_s);
  bool waitsForPicture();
  void measure(double played_s, double elapsed_s);

  QTimer m_timer;
  QTimer m_soon;  ///< one tick once the events at hand are done
  QElapsedTimer m_clock;
  QElapsedTimer m_panels;
  QElapsedTimer m_sinceShown;
  bool m_panelsNow = true;
  bool m_scrubbing = false;
  Playback m_playback;
  FrameSnapshotPtr m_shown;
  FrameSnapshotPtr m_kept;  ///< the shown one as the history has it
  std::shared_ptr<const MotionLibrary> m_library;
  const FrameHistory* m_history = nullptr;
  const LatestSlot<FrameSnapshot>* m_latest = nullptr;
  std::function<std::uint64_t()> m_pictures;
  std::uint64_t m_picturesWhenShown = 0;
  double m_achieved = 1, m_played_s = 0, m_elapsed_s = 0;
};

}  // namespace abrazo::app
