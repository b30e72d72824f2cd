#pragma once

#include <QObject>
#include <QString>
#include <vector>

#include "core/session/frames/frame_snapshot.hpp"

namespace abrazo::widgets {
class SceneView;
}

namespace abrazo::app {

class Document;
class FrameTicker;

/// Times of the stages of a start, from the start of the process, including the loading of libraries.
class StartTimes : public QObject {
  Q_OBJECT
 public:
  struct Stage {
    const char* name;
    double after_ms;
  };

  /// Only the first call per stage counts.
  void reached(const char* stage);
  /// Tracks the stages: session, first picture of the partner, first picture in which the partner has moved.
  void follow(Document& document, FrameTicker& ticker, widgets::SceneView& scene);

  const std::vector<Stage>& stages() const { return m_stages; }
  /// One line per stage.
  QString text() const;

 signals:
  /// The partner has moved in a drawn picture.
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
