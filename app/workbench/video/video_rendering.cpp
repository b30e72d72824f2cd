#include "app/workbench/video/video_rendering.hpp"

#include "app/workbench/base/error_words.hpp"
#include "app/workbench/base/job_progress.hpp"
#include "app/workbench/video/overlay_film.hpp"
#include "app/workbench/video/video_desk.hpp"
#include "core/session/frames/frame_history.hpp"
#include "widgets/common/message_bar.hpp"
#include "widgets/video/overlay_section.hpp"
#include "widgets/video/video_panel.hpp"

namespace abrazo::app {
namespace {

constexpr double around_s = 0.5;  // frames before and after the range that poses are interpolated with

/// The film of the shown video.
OverlayFilm overlay_film(const VideoDesk& desk, const RangeRequest& request) {
  OverlayFilm film;
  film.plan = request.plan;
  film.size = request.size;
  film.video = QString::fromStdString(desk.current()->file);
  film.file = request.file;
  film.sync = desk.current()->sync;
  film.camera = desk.current()->camera;
  film.parts = desk.panel().overlay().parts();
  film.opacity = desk.panel().overlay().opacity();
  film.palette = widgets::palette_of(widgets::Theme::Dark);  // as over the picture in either theme
  return film;
}

}  // namespace

void render_video(VideoDesk& desk, const FrameHistory* history, widgets::MessageBar& messages,
                  const RangeRequest& request, QPointer<Job>& running) {
  if (!desk.current() || !history) return messages.showInformation("There is no video to render");
  if (running) return messages.showInformation("A video is being rendered; wait for it, or cancel it");
  const OverlayFilm film = overlay_film(desk, request);
  const FrameRange frames = history->stretch(film.plan.from_s - around_s, film.plan.to_s + around_s);
  const auto is_cancelled = std::make_shared<bool>(false);
  const auto tell = [&messages, is_cancelled](const QString& file, const Status& written) {
    messages.endProgress();
    if (written) return messages.showInformation("Video written to " + file);
    if (*is_cancelled)
      messages.showInformation("Rendering was cancelled; nothing was written");
    else
      messages.showError(words(written.error()));
  };
  auto* job = new Job(
      [tell, film, frames](const Progress& progress) -> Job::Finish {
        return [tell, file = film.file, written = write_overlay_film(film, frames, progress)] {
          tell(file, written);
        };
      },
      &desk);
  running = job;
  show_progress(*job, messages);
  QObject::connect(&messages, &widgets::MessageBar::cancelRequested, job, [job, is_cancelled] {
    *is_cancelled = true;
    job->cancel();
  });
  QObject::connect(job, &Job::finished, job, &QObject::deleteLater);
}

}  // namespace abrazo::app
