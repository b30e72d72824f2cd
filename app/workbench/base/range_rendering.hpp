#pragma once

#include <QObject>
#include <QSize>
#include <QTimer>
#include <memory>
#include <optional>

#include "app/workbench/base/film_clock.hpp"
#include "app/workbench/base/film_writer.hpp"
#include "app/workbench/base/running_work.hpp"
#include "core/session/frames/frame_range.hpp"

namespace abrazo::widgets {
class ScenePictures;
class SceneView;
}  // namespace abrazo::widgets

namespace abrazo::app {

struct RangeRequest {
  FilmPlan plan;
  QSize size;  ///< [pixels], even
  bool captions = true;
  QString file;
};

/// Renders recorded frames to a film in an off-screen scene, without dropped pictures, while the window stays
/// responsive. The same frames, camera and size give the same film.
class RangeRendering : public QObject {
  Q_OBJECT
 public:
  /// @param frames frames of the plan
  RangeRendering(FrameRange frames, QObject* parent);
  ~RangeRendering() override;
  /// @param like setup of scene and camera. @return the error, or empty; ended() tells what the encoder
  /// refuses
  QString start(const RangeRequest& request, const widgets::SceneView& like);
  void cancel();
  /// The picture at one time of the plan; fast for successive times.
  QImage picture(double time_s);

 signals:
  void progressed(int done, int all);
  /// @param trouble the error, or empty
  void ended(const QString& trouble);

 private:
  void step();
  void end(const QString& trouble);

  bool m_isEmpty;
  FrameRangeAtTimes m_frames;
  RangeRequest m_request;
  std::unique_ptr<widgets::ScenePictures> m_pictures;
  std::unique_ptr<FilmWriter> m_writer;
  QTimer m_timer;
  int m_done = 0;
  std::optional<RunningWork> m_running;  ///< a window that closes waits until it is cancelled
};

}  // namespace abrazo::app
