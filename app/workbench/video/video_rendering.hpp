#pragma once

#include "app/workbench/base/range_rendering.hpp"
#include "app/workbench/video/overlay_film.hpp"

namespace abrazo::app {

class MainWindow;
class VideoDesk;

/// What is rendered of the shown video.
OverlayFilm overlay_film(const MainWindow& window, const VideoDesk& desk, const RangeRequest& request);
/// On a worker while the window goes on; the bar shows how far it is and cancels, and tells the end.
void render_video(MainWindow& window, VideoDesk& desk, const RangeRequest& request);

}  // namespace abrazo::app
