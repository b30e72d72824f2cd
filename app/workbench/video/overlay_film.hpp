#pragma once

#include <QImage>
#include <QSize>
#include <QString>
#include <optional>

#include "app/workbench/base/film_clock.hpp"
#include "core/base/progress.hpp"
#include "core/base/result.hpp"
#include "core/session/frames/frame_range.hpp"
#include "core/video/video_frame.hpp"
#include "core/video/video_sync.hpp"
#include "widgets/common/palette.hpp"
#include "widgets/video/overlay_painter.hpp"

namespace abrazo::app {

/// A film of a reference video with the overlay of the pair.
struct OverlayFilm {
  FilmPlan plan;  ///< in subject time
  QSize size;     ///< [pixels], even; the video is fitted into it
  QString video, file;
  VideoSync sync;
  std::optional<CameraModel> camera;  ///< none = no overlay
  widgets::OverlayParts parts;
  double opacity = 0.9;
  widgets::Palette palette;
};

/// One picture of the film. @param picture null = black, where the video has none
QImage overlay_picture(const OverlayFilm& film, const VideoFrame* picture,
                       const widgets::VideoOverlay& overlay);

/// Writes all pictures of the film; the file appears completely or not at all. The same video, frames and
/// camera give the same film. Call on a worker.
/// @param frames of the plan's time, with one before and one after if available
Status write_overlay_film(const OverlayFilm& film, FrameRange frames, const Progress& progress);

}  // namespace abrazo::app
