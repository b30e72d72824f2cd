#include "app/workbench/shell/actions.hpp"

namespace abrazo::app {

void add_all_actions(MainWindow& window) {
  add_file_actions(window);
  add_edit_actions(window);
  add_camera_actions(window);
  add_view_actions(window);
  add_layout_actions(window);
  add_scene_actions(window);
  add_selection_actions(window);
  add_library_actions(window);
  add_playback_actions(window);
  add_timeline_actions(window);
  add_annotation_actions(window);
  add_video_actions(window);
  add_solve_actions(window);
  add_preset_actions(window);
  add_sweep_actions(window);
  add_stream_actions(window);
  add_take_actions(window);
  add_pair_actions(window);
  add_role_actions(window);
  add_session_actions(window);
  add_plot_actions(window);
  add_export_actions(window);
  add_candidate_actions(window);
  add_intended_move_actions(window);
  add_compare_actions(window);
  add_recent_actions(window);
  add_project_actions(window);
  add_help_actions(window);
  add_welcome_actions(window);
  add_command_search(window);
  add_shortcuts(window);
}

}  // namespace abrazo::app
