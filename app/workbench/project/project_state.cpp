#include "app/workbench/project/project_state.hpp"

#include <QFile>

#include "app/workbench/base/own_presets.hpp"
#include "app/workbench/labels/annotation_desk.hpp"
#include "app/workbench/project/remembered_view.hpp"
#include "app/workbench/shell/main_window.hpp"
#include "app/workbench/shell/window_layout.hpp"
#include "app/workbench/video/video_desk.hpp"
#include "widgets/candidates/candidate_table.hpp"
#include "widgets/plots/plot_panel.hpp"
#include "widgets/scene/values/scene_memory.hpp"
#include "widgets/scene/view/scene_view.hpp"
#include "widgets/settings/settings_panel.hpp"
#include "widgets/timeline/timeline_view.hpp"

namespace abrazo::app {
namespace {

/// In Project::view: before the name of a take, the key of its markers.
constexpr std::string_view markers_key = "markers:";

void add_videos(const MainWindow& window, Project& project) {
  const auto* desk = window.findChild<VideoDesk*>();
  if (!desk) return;
  project.videos = desk->videos();
  const QStringList files = desk->files();
  for (std::size_t i = 0; i < project.videos.size(); ++i) {
    project.videos[i].data = static_cast<int>(project.data.size());
    project.data.push_back(
        unread_reference(DataReference::Use::Video, files.value(static_cast<int>(i)).toStdString()));
  }
}

std::string presets_of(const MainWindow& window) {
  QFile file(window.remembered().folder() + "/presets.json");
  return file.open(QIODevice::ReadOnly) ? file.readAll().toStdString() : std::string();
}

void add_take_markers(const AnnotationDesk& desk, Project& project) {
  for (const auto& [take, markers] : desk.takeMarkers())
    project.view[std::string(markers_key) + take] = text_of(markers);
}

void show_take_markers(MainWindow& window, const Project& project) {
  auto* desk = window.findChild<AnnotationDesk*>();
  for (const auto& [key, text] : project.view)
    if (desk && key.starts_with(markers_key) && key.size() > markers_key.size())
      desk->showMarkers(key.substr(markers_key.size()), markers_of(text));
}

std::map<std::string, std::string> take_markers(const Project& project) {
  auto kept = project.view;
  std::erase_if(kept, [](const auto& entry) { return !entry.first.starts_with(markers_key); });
  return kept;
}

void add_view(MainWindow& window, Project& project) {
  widgets::SceneView& scene = window.scene();
  auto& view = project.view;
  view["layout"] = text_of(window.layoutOfPanels()).toStdString();
  view["lanes"] = window.timeline().lanes().text();
  view["plots"] = widgets::text_of(window.plots().arrangement());
  view["scene"] = widgets::text_of({scene.visibility(), scene.scalar(), scene.options()}).toStdString();
  view["camera"] = text_of(CameraTurn{scene.camera().azimuth_rad, scene.camera().elevation_rad});
  view["cursor_s"] = QString::number(window.ticker().playback().cursor_s, 'g', 17).toStdString();
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
  if (!text("scene").isEmpty()) {
    const widgets::SceneMemory memory = widgets::scene_memory_of(text("scene"));
    window.scene().setVisibility(memory.visibility);
    window.scene().setScalar(memory.scalar);
    window.scene().setOptions(memory.options);
  }
  if (const auto turn = camera_turn_of(text("camera").toStdString()))
    window.scene().lookFrom(turn->azimuth_rad, turn->elevation_rad);
}

void show_decisions(MainWindow& window, const Decisions& decisions) {
  const widgets::Steering steering{decisions.pinned, decisions.vetoes, std::nullopt};
  window.candidates().showSteering(steering);
  window.session()->push(PinPair{steering.pinned});
  window.session()->push(SetVetoes{steering.vetoes});
  (void)window.session()->controlRole(decisions.role_control);  // another library may not say who leads
}

}  // namespace

Project project_of(MainWindow& window) {
  Project project;
  if (!window.session()) return project;
  describe(window.session()->material(), project);
  add_videos(window, project);
  project.markers = window.timeline().markers();
  if (const auto* desk = window.findChild<AnnotationDesk*>()) {
    project.annotations = desk->book();
    project.markers = desk->sessionMarkers();
    add_take_markers(*desk, project);
  }
  project.settings = window.settings().settings();
  const widgets::Steering& steering = window.candidates().steering();
  project.decisions.pinned = steering.pinned;
  project.decisions.vetoes = steering.vetoes;
  project.decisions.role_control = window.session()->roleControl();
  project.presets = presets_of(window);
  add_view(window, project);
  return project;
}

void show_project(MainWindow& window, const Project& project, const QStringList& videos) {
  window.startWith(project.settings);
  show_decisions(window, project.decisions);
  window.timeline().showMarkers(project.markers);
  show_annotations(window, project.annotations);
  show_take_markers(window, project);
  if (auto* desk = window.findChild<VideoDesk*>()) desk->setVideos(project.videos, videos);
  show_view(window, project.view);
}

void show_annotations(MainWindow& window, const AnnotationBook& book) {
  if (auto* desk = window.findChild<AnnotationDesk*>()) desk->setBook(book);
}

Project with_contents(Project project, const Project& before, const std::string& session_file) {
  for (DataReference& data : project.data) {
    auto completed = reference_to(data.absolute_path, data.use, session_file);
    if (completed) {
      data = std::move(*completed);
      continue;
    }
    for (const DataReference& old : before.data)
      if (old.use == data.use && old.absolute_path == data.absolute_path) data = old;
  }
  return project;
}

bool is_same_work(const Project& a, const Project& b) {
  return a.annotations == b.annotations && a.videos == b.videos && a.markers.all() == b.markers.all() &&
         a.settings == b.settings && a.decisions.pinned == b.decisions.pinned &&
         a.decisions.vetoes == b.decisions.vetoes && a.decisions.role_control == b.decisions.role_control &&
         take_markers(a) == take_markers(b);
}

}  // namespace abrazo::app
