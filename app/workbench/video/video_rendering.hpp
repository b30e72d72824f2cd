#pragma once

#include "app/workbench/base/range_rendering.hpp"
#include "app/workbench/video/overlay_film.hpp"

namespace abrazo::app {

class MainWindow;
class VideoDesk;

/// The film of the shown video.
OverlayFilm overlay_film(const MainWindow& window, const VideoDesk& desk, const RangeRequest& request);
/// Renders on a worker; the message bar shows progress, can cancel, and reports the end.
void render_video(MainWindow& window, VideoDesk& desk, const RangeRequest& request);

}  // namespace abrazo::app
