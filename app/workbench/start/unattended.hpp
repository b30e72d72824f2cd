#pragma once

#include <QElapsedTimer>
#include <QImage>
#include <QObject>
#include <QTimer>
#include <optional>

#include "app/workbench/start/command_line.hpp"
#include "core/session/frames/frame_snapshot.hpp"
#include "core/video/video_writer.hpp"

namespace abrazo::app {

class MainWindow;
class Responsiveness;
class StartTimes;

/// Carries out --smoke, --start-times, --screenshot and --record, then quits: 0 on success, 1 with a message
/// on failure.
class Unattended : public QObject {
  Q_OBJECT
 public:
  Unattended(MainWindow& window, const CommandLine& asked, const Responsiveness& responsiveness,
             const StartTimes& start, QObject* parent = nullptr);

 private:
  void onFrame(const FrameSnapshotPtr& frame);
  void onTime();
  void recordPicture();
  void finishRecording();
  QString writeMotion(const QString& file) const;
  void quit(const QString& failure);

  MainWindow& m_window;
  CommandLine m_asked;
  const Responsiveness& m_responsiveness;
  QElapsedTimer m_sinceFirst;
  QTimer m_pictures;
  QTimer m_patience;
  int m_shown = 0;
  std::uint64_t m_renderedBefore = 0;
  std::uint64_t m_solvedBefore = 0;
  std::optional<VideoWriter> m_video;
  bool m_done = false;
};

}  // namespace abrazo::app
