#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "core/session/frames/frame_snapshot.hpp"

namespace abrazo::widgets {
class SceneView;
}

namespace abrazo::app {

class Document;
class Responsiveness;

/// Periodic figures of the window and its session, one JSON object per line, for monitoring long runs.
class StatusLines : public QObject {
  Q_OBJECT
 public:
  /// @param write called every `interval_s` with a complete line
  StatusLines(Document& document, const widgets::SceneView& scene, const Responsiveness& responsiveness,
              double interval_s, std::function<void(const std::string&)> write);

  /// The line for the time since the previous one.
  std::string line();

 private:
  void noteFrames();

  Document& m_document;
  const widgets::SceneView& m_scene;
  const Responsiveness& m_responsiveness;
  QTimer m_timer, m_collect;
  QElapsedTimer m_since;
  std::vector<FrameTimes> m_times;  ///< of the frames since the previous line
  std::uint64_t m_next = 0;         ///< index of the next frame
  std::uint64_t m_relaxed = 0, m_failed = 0, m_dropped = 0, m_pictures = 0;
};

}  // namespace abrazo::app
