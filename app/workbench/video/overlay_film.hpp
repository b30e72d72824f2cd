#pragma once

#include <QImage>
#include <QSize>
#include <QString>
#include <optional>

#include "app/workbench/base/film_plan.hpp"
#include "core/base/progress.hpp"
#include "core/base/result.hpp"
#include "core/session/frames/frame_range.hpp"
#include "core/video/video_frame.hpp"
#include "core/video/video_sync.hpp"
#include "widgets/common/palette.hpp"
#include "widgets/video/overlay_painter.hpp"

namespace abrazo::app {

/// A film of a reference video with what its camera sees of the pair.
struct OverlayFilm {
  FilmPlan plan;  ///< in the time of the subject
  QSize size;     ///< [pixels], even; the video is fitted into it
  QString video, file;
  VideoSync sync;
  std::optional<CameraModel> camera;  ///< without, nothing is drawn over the video
  widgets::OverlayParts parts;
  double opacity = 0.9;
  widgets::Palette palette;
};

/// One picture of it. @param picture  null: black, where the video has none
QImage overlay_picture(const OverlayFilm& film, const VideoFrame* picture,
                       const widgets::VideoOverlay& overlay);

/// Picture by picture and none left out; the file appears whole or not at all. The same video, frames and
/// camera give the same film. For a worker.
/// @param frames  of the plan's time, with one before and one after where there are
Status write_overlay_film(const OverlayFilm& film, FrameRange frames, const Progress& progress);

}  // namespace abrazo::app
