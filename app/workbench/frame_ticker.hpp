#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>

#include "core/session/frame_history.hpp"
#include "core/session/latest_slot.hpp"
#include "core/session/playback.hpp"

namespace abrazo::app {

/// Polls at display rate: which frame is to be shown now, under the rules of Playback. Nothing queues per
/// frame.
class FrameTicker : public QObject {
  Q_OBJECT
 public:
  explicit FrameTicker(QObject* parent = nullptr);
  /// Both outlive the ticker or the next call; null pointers stop it.
  void setSources(const FrameHistory* history, const LatestSlot<FrameSnapshot>* latest);
  const Playback& playback() const { return m_playback; }
  const FrameSnapshotPtr& shown() const { return m_shown; }
  const FrameHistory* history() const { return m_history; }

 public slots:
  void toggle();
  void pause();
  void seek(double time_s);
  void step(int frames);
  void goToStart();
  void follow();
  void setSpeed(double factor);
  void setLoop(bool on);
  void setIn();
  void setOut();
  void clearRange();
  /// J, K, L: -1 backwards, 0 stop, 1 forwards; again in the same direction doubles the speed.
  void shuttle(int direction);
  void tick();

 signals:
  void frameReady(abrazo::FrameSnapshotPtr frame);
  void playbackChanged(const abrazo::Playback& playback);
  /// Time for the panels that show a span of time: some 12 times a second, and at once after a request.
  void panelsDue();

 private:
  void changed();

  QTimer m_timer;
  QElapsedTimer m_clock;
  QElapsedTimer m_panels;
  bool m_panelsNow = true;
  Playback m_playback;
  FrameSnapshotPtr m_shown;
  const FrameHistory* m_history = nullptr;
  const LatestSlot<FrameSnapshot>* m_latest = nullptr;
};

}  // namespace abrazo::app
