#include "app/workbench/base/render_dialog.hpp"
#include "app/workbench/export/export_desk.hpp"
#include "app/workbench/keys/key_routing.hpp"
#include "app/workbench/keys/shortcuts.hpp"
#include "app/workbench/keys/undo_of_text.hpp"
#include "app/workbench/labels/annotation_desk.hpp"
#include "app/workbench/labels/label_key_filter.hpp"
#include "app/workbench/project/project_desk.hpp"
#include "app/workbench/shell/actions.hpp"
#include "app/workbench/shell/layouts.hpp"
#include "app/workbench/shell/main_window.hpp"
#include "app/workbench/stream/stream_desk.hpp"
#include "app/workbench/takes/pair_desk.hpp"
#include "app/workbench/takes/take_desk.hpp"
#include "widgets/common/wheel_to_scroll.hpp"
#include "widgets/takes/take_panel.hpp"

namespace abrazo::app {

/// Where one room needs something of another, it gets it here.
Rooms add_all_actions(MainWindow& window) {
  auto* films = new RenderDialog(&window);
  add_file_actions(window, *films);
  add_edit_actions(window);
  add_camera_actions(window, window.scene());
  add_view_actions(window);
  Layouts& layouts = add_layout_actions(window);
  add_scene_actions(window, window.scene(), window.remembered(), window.undoStack());
  add_character_actions(window);
  add_selection_actions(window);
  add_library_actions(window);
  add_import_actions(window);
  add_playback_actions(window);
  add_timeline_actions(window);
  auto* labels = new AnnotationDesk(window);
  auto* label_keys = new LabelKeyFilter(window.document(), window.timeline(), window.ticker(), *labels);
  add_marker_actions(window, *labels);
  add_lane_actions(window);
  add_annotation_actions(window, *labels, *label_keys);
  add_video_actions(window, *films);
  add_solve_actions(window, window.document());
  add_preset_actions(window);
  add_body_actions(window);
  add_sweep_actions(window);
  StreamDesk& streams = add_stream_actions(window);
  TakeDesk& takes = add_take_actions(window);
  QObject::connect(&streams, &StreamDesk::addressFound, &takes,
                   [&takes](bool& ready) { ready = ready && takes.isReadyForStream(); });
  QObject::connect(&streams, &StreamDesk::aboutToReceive, &takes, &TakeDesk::prepareStream);
  QObject::connect(&streams, &StreamDesk::aboutToDisconnect, &takes, &TakeDesk::endWithStream);
  QObject::connect(&takes, &TakeDesk::fileFinished, &streams, &StreamDesk::receiveOnceFound);
  add_pair_actions(window, takes, [&streams] { return std::pair(streams.user(), streams.second()); });
  add_role_actions(window);
  widgets::LeftoverBar& leftovers = add_session_actions(window);
  add_plot_actions(window);
  add_export_actions(window, [&takes] { return takes.takes(); });
  add_candidate_actions(window);
  add_intended_move_actions(window);
  add_compare_actions(window);
  add_recent_actions(window);
  ProjectDesk& project = add_project_actions(window, takes);
  QObject::connect(&takes.panel(), &widgets::TakePanel::saveAsRequested, &project, &ProjectDesk::askSaveAs);
  QObject::connect(&streams, &StreamDesk::connectionChanged, &layouts, [&streams, &layouts] {
    if (streams.isConnected()) layouts.beginLive();
  });
  QObject::connect(&window.document(), &Document::subjectChanged, &layouts,
                   [&window, &layouts] { layouts.showTake(!window.document().subject().empty()); });
  auto* shortcuts = new Shortcuts(window);
  add_help_actions(window, *shortcuts);
  add_welcome_actions(window);
  add_command_search(window);
  shortcuts->begin();
  new widgets::WheelToScroll(&window);
  new UndoOfText(window, window.undoStack());
  new KeyRouting(
      window, [label_keys](const QKeyEvent& event) { return label_keys->claims(event); },
      [label_keys] { return label_keys->works(); });
  return {project, streams, layouts, leftovers};
}

}  // namespace abrazo::app
