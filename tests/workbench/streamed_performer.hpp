#pragma once

#include <QElapsedTimer>
#include <QString>
#include <QThread>
#include <QTimer>
#include <atomic>
#include <memory>

#include "core/motion/body/clip.hpp"
#include "core/stream/send/pose_sink.hpp"

namespace abrazo::app {

inline StreamUri uri_of(const QString& text) {
  return parse_stream_uri(text.toStdString()).value();
}

/// Sends the poses of a clip as VMC packets, a hundred a second, as long as it is there; from a thread of its
/// own, so that a window which is busy does not make it stumble.
class StreamedPerformer {
 public:
  StreamedPerformer(const Clip& clip, const QString& to)
      : m_clip(clip), m_sink(PoseSink::open(uri_of(to), body_of(clip.poses), "user").value()) {
    m_timer.moveToThread(&m_thread);
    QObject::connect(&m_timer, &QTimer::timeout, &m_timer, [this] { send(); });
    QObject::connect(&m_thread, &QThread::started, &m_timer, [this] {
      m_clock.start();
      m_timer.start(10);
    });
    m_thread.start();
  }
  ~StreamedPerformer() {
    QMetaObject::invokeMethod(&m_timer, "stop", Qt::BlockingQueuedConnection);
    m_thread.quit();
    m_thread.wait();
  }
  StreamedPerformer(const StreamedPerformer&) = delete;
  StreamedPerformer& operator=(const StreamedPerformer&) = delete;
  void standStill() { m_still = true; }

 private:
  void send() {
    const double time_s = 1e-9 * static_cast<double>(m_clock.nsecsElapsed());
    const auto frame = static_cast<std::size_t>(time_s * m_clip.fps);
    m_sink->send({m_clip.poses[m_still ? 0 : frame % m_clip.poses.size()], time_s, true});
  }

  const Clip& m_clip;
  std::unique_ptr<PoseSink> m_sink;
  QThread m_thread;
  QTimer m_timer;
  QElapsedTimer m_clock;
  std::atomic<bool> m_still = false;
};

}  // namespace abrazo::app
