#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "core/session/frames/frame_snapshot.hpp"

namespace abrazo::app {

class MainWindow;
class Responsiveness;

/// What the window and its session did since the line before, as one JSON object per line: for whoever
/// watches a program that runs for hours.
class StatusLines : public QObject {
  Q_OBJECT
 public:
  /// @param write  called every `interval_s`, with a line that ends
  StatusLines(MainWindow& window, const Responsiveness& responsiveness, double interval_s,
              std::function<void(const std::string&)> write);

  /// Of now; begins the next stretch.
  std::string line();

 private:
  void noteFrames();

  MainWindow& m_window;
  const Responsiveness& m_responsiveness;
  QTimer m_timer, m_collect;
  QElapsedTimer m_since;
  std::vector<FrameTimes> m_times;  ///< of the frames since the line before
  std::uint64_t m_next = 0;         ///< index of the frame to be noted next
  std::uint64_t m_relaxed = 0, m_failed = 0, m_dropped = 0, m_pictures = 0;
};

}  // namespace abrazo::app
