#include <QAction>
#include <QMenu>
#include <QPointer>

#include "app/workbench/base/file_dialogs.hpp"
#include "app/workbench/base/render_dialog.hpp"
#include "app/workbench/document/open_video.hpp"
#include "app/workbench/shell/actions.hpp"
#include "app/workbench/shell/main_window.hpp"
#include "app/workbench/shell/panel_area.hpp"
#include "app/workbench/video/camera_desk.hpp"
#include "app/workbench/video/video_desk.hpp"
#include "app/workbench/video/video_rendering.hpp"
#include "widgets/video/camera_section.hpp"
#include "widgets/video/sync_section.hpp"
#include "widgets/video/video_panel.hpp"
#include "widgets/video/video_view.hpp"

namespace abrazo::app {
namespace {

void choose(MainWindow& window, VideoDesk& desk) {
  const QStringList files =
      ask_files(&window, window.remembered(), "Open video", video_filter() + ";;All files (*)");
  if (!files.isEmpty()) desk.open(files);
}

/// Before existing entries, so that the actions for opening stay together.
void add_to_file_menu(MainWindow& window, VideoDesk& desk) {
  QMenu* file = menu_of(window, "File");
  QAction* open = add_action(window, file, "Open video…", {}, [&window, &desk] { choose(window, desk); });
  file->removeAction(open);
  const auto entries = file->actions();
  file->insertAction(entries.size() > 1 ? entries[1] : nullptr, open);
}

void add_stepping(MainWindow& window, QMenu* menu, VideoDesk& desk) {
  add_action(window, menu, "Previous picture of the video", {QKeySequence("Alt+,")},
             [&desk] { desk.step(-1); });
  add_action(window, menu, "Next picture of the video", {QKeySequence("Alt+.")}, [&desk] { desk.step(1); });
  add_action(window, menu, "Link the video with the timeline, or step it alone",
             {QKeySequence("Ctrl+Shift+L")}, [&desk] { desk.setLinked(!desk.isLinked()); });
  add_action(window, menu, "Video and timeline show the same moment", {QKeySequence("Ctrl+M")},
             [&desk] { desk.setSyncPoint(); });
  add_action(window, menu, "Clear the video's synchronisation", {}, [&desk] { desk.clearSync(); });
  menu->addSeparator();
}

void add_camera(MainWindow& window, QMenu* menu, VideoDesk& desk, CameraDesk& camera) {
  auto& section = desk.panel().camera();
  const auto show = [&window] { window.panels().want("video", true); };
  add_action(window, menu, "Pick joints in the video", {}, [&section, &camera, show] {
    show();
    camera.setPicking(!section.isPicking());
  });
  add_action(window, menu, "Intrinsics of the camera…", {}, [&camera] { camera.askIntrinsics(); });
  add_action(window, menu, "Load camera…", {}, [&camera] { camera.askCamera(); });
  add_action(window, menu, "Save camera…", {}, [&camera] { camera.askWhereToSave(); });
  menu->addSeparator();
}

/// The dialog that renders ranges of the scene does so of the video.
void add_rendering(MainWindow& window, VideoDesk& desk, RenderDialog* dialog) {
  QObject::connect(&desk, &VideoDesk::currentChanged, dialog, [&desk, dialog] {
    const auto facts = desk.currentVideo() ? desk.currentVideo()->facts() : nullptr;
    dialog->offerVideo(facts ? QSize(facts->width, facts->height) : QSize(), facts ? facts->rate_hz : 0);
  });
  QObject::connect(dialog, &RenderDialog::videoRenderRequested, &window,
                   [&window, &desk, dialog, running = QPointer<Job>()]() mutable {
                     RangeRequest request = dialog->request();
                     request.file = ask_new_file(dialog, window.remembered(), "Render as video",
                                                 "overlay.mp4", ".mp4", "Video (*.mp4)");
                     if (request.file.isEmpty()) return;
                     dialog->hide();
                     render_video(desk, window.ticker().history(), window.messages(), request, running);
                   });
}

}  // namespace

void add_video_actions(MainWindow& window, RenderDialog& dialog) {
  auto* desk = new VideoDesk(window);
  auto* camera = new CameraDesk(window, *desk);
  widgets::VideoPanel& panel = desk->panel();
  window.addPanel("video", "Video", &panel, Qt::RightDockWidgetArea, false);
  QObject::connect(&panel, &widgets::VideoPanel::openRequested, desk,
                   [&window, desk] { choose(window, *desk); });
  QObject::connect(&window, &MainWindow::videosOffered, desk, &VideoDesk::open);
  add_to_file_menu(window, *desk);
  QMenu* menu = menu_of(window, "Video");
  add_stepping(window, menu, *desk);
  add_camera(window, menu, *desk, *camera);
  add_action(window, menu, "Close the video", {}, [desk] { desk->close(); });
  add_rendering(window, *desk, &dialog);
}

}  // namespace abrazo::app
