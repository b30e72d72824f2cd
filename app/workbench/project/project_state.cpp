#include "app/workbench/project/project_state.hpp"

#include <QFile>
#include <QTimer>
#include <algorithm>

#include "app/workbench/base/own_presets.hpp"
#include "app/workbench/project/remembered_view.hpp"
#include "app/workbench/shell/main_window.hpp"
#include "app/workbench/shell/window_layout.hpp"
#include "widgets/plots/plot_panel.hpp"
#include "widgets/scene/view/scene_view.hpp"
#include "widgets/timeline/timeline_view.hpp"

namespace abrazo::app {
namespace {

/// Behind the data of the session; the document counts its own files alone.
void add_video_files(const Document& document, Project& project) {
  for (ProjectVideo& video : project.videos) video.data += static_cast<int>(project.data.size());
  const auto files = document.live().video_files();
  project.data.insert(project.data.end(), files.begin(), files.end());
}

std::string presets_of(const MainWindow& window) {
  QFile file(window.remembered().folder() + "/presets.json");
  return file.open(QIODevice::ReadOnly) ? file.readAll().toStdString() : std::string();
}

void add_view(MainWindow& window, Project& project) {
  const widgets::SceneView& scene = window.scene();
  const Playback& playback = window.ticker().playback();
  auto& view = project.view;
  view["layout"] = text_of(window.layoutOfPanels()).toStdString();
  view["lanes"] = window.timeline().lanes().text();
  view["plots"] = widgets::text_of(window.plots().arrangement());
  view["scene"] = widgets::text_of(scene.memory()).toStdString();
  view["camera"] = text_of(CameraTurn{scene.camera().azimuth_rad, scene.camera().elevation_rad});
  view["subject"] = window.document().subject();
  if (playback.state != Playback::State::Following)
    view["parked_s"] = QString::number(playback.cursor_s, 'g', 17).toStdString();
}

/// The take that was annotated, if the library has it, and the place where the cursor was parked.
void go_back_to(MainWindow& window, const std::string& subject, const QString& parked) {
  if (!window.session()) return;
  const auto& takes = window.session()->material().library->takes();
  const bool has_take =
      std::ranges::any_of(takes, [&](const LibraryTake& take) { return take.name == subject; });
  if (has_take) window.requestSubject(QString::fromStdString(subject));
  bool is_time = false;
  Playback place = window.ticker().playback();
  place.state = Playback::State::Parked;
  place.cursor_s = parked.toDouble(&is_time);
  if (is_time && (has_take || subject.empty())) window.ticker().resume(place);
}

}  // namespace

Project project_of(MainWindow& window) {
  if (!window.session()) return {};
  Project project = window.document().project();
  project.decisions.meant.reset();
  describe(window.session()->material(), project);
  add_video_files(window.document(), project);
  project.presets = presets_of(window);
  add_view(window, project);
  return project;
}

void show_view(MainWindow& window, const std::map<std::string, std::string>& view) {
  const auto text = [&view](const char* key) {
    const auto found = view.find(key);
    return found == view.end() ? QString() : QString::fromStdString(found->second);
  };
  if (!text("layout").isEmpty())
    if (const auto layout = parse_layout(text("layout").toUtf8(), "layout"))
      window.setLayoutOfPanels(*layout);
  if (!text("lanes").isEmpty()) {
    widgets::TimelineLanes lanes = window.timeline().lanes();
    lanes.set_text(text("lanes").toStdString());
    window.timeline().setLanes(lanes);
  }
  if (!text("plots").isEmpty())
    window.plots().setArrangement(widgets::arrangement_of(text("plots").toStdString()));
  if (!text("scene").isEmpty()) window.scene().setMemory(widgets::scene_memory_of(text("scene")));
  if (const auto turn = camera_turn_of(text("camera").toStdString()))
    window.scene().lookFrom(turn->azimuth_rad, turn->elevation_rad);
  // Once all parts of the window have taken the session.
  QTimer::singleShot(0, &window, [&window, subject = text("subject"), parked = text("parked_s")] {
    go_back_to(window, subject.toStdString(), parked);
  });
}

}  // namespace abrazo::app
