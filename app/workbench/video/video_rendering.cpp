#include "app/workbench/video/video_rendering.hpp"

#include "app/workbench/base/error_words.hpp"
#include "app/workbench/base/job_progress.hpp"
#include "app/workbench/shell/main_window.hpp"
#include "app/workbench/video/video_desk.hpp"
#include "widgets/common/message_bar.hpp"
#include "widgets/video/overlay_section.hpp"
#include "widgets/video/video_panel.hpp"

namespace abrazo::app {
namespace {

constexpr double around_s = 0.5;  // frames before and after the range that poses are interpolated with
const char* const job_name = "videoRendering";

}  // namespace

OverlayFilm overlay_film(const MainWindow& window, const VideoDesk& desk, const RangeRequest& request) {
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
  (void)window;
  return film;
}

void render_video(MainWindow& window, VideoDesk& desk, const RangeRequest& request) {
  const FrameHistory* history = window.ticker().history();
  if (!desk.current() || !history) return window.messages().showInformation("There is no video to render");
  if (window.findChild<Job*>(job_name))
    return window.messages().showInformation("A video is being rendered; wait for it, or cancel it");
  const OverlayFilm film = overlay_film(window, desk, request);
  const FrameRange frames = history->stretch(film.plan.from_s - around_s, film.plan.to_s + around_s);
  auto& messages = window.messages();
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
      &window);
  job->setObjectName(job_name);
  show_progress(*job, messages);
  QObject::connect(&messages, &widgets::MessageBar::cancelRequested, job, [job, is_cancelled] {
    *is_cancelled = true;
    job->cancel();
  });
  QObject::connect(job, &Job::finished, job, &QObject::deleteLater);
}

}  // namespace abrazo::app
