#pragma once

#include <QObject>
#include <QString>
#include <vector>

#include "core/session/frames/frame_snapshot.hpp"

namespace abrazo::app {

class MainWindow;

/// When the stages of a start were reached, counted from the start of the process: the time to load the
/// libraries counts as well.
class StartTimes : public QObject {
  Q_OBJECT
 public:
  struct Stage {
    const char* name;
    double after_ms;
  };

  /// Only the first time counts.
  void reached(const char* stage);
  /// From here on: session, first picture of the partner, first picture in which the partner has moved.
  void follow(MainWindow& window);

  const std::vector<Stage>& stages() const { return m_stages; }
  /// A line for each.
  QString text() const;

 signals:
  /// A picture was drawn in which the partner stands otherwise than in the first.
  void moved();

 private:
  void pictureDrawn(const FrameSnapshotPtr& shown);

  std::vector<Stage> m_stages;
  FrameSnapshotPtr m_first;
  bool m_hasMoved = false;
};

/// Milliseconds since this process was started, to the tick of the kernel's clock (10 ms).
double since_process_start_ms();

}  // namespace abrazo::app
