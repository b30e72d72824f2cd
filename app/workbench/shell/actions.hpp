#pragma once

#include <QKeySequence>
#include <functional>
#include <initializer_list>

class QAction;
class QMenu;
class QString;

namespace abrazo {
struct SweepOutcome;
}

namespace abrazo::widgets {
class LeftoverBar;
enum class PlotExport;
}  // namespace abrazo::widgets

namespace abrazo::app {

class AnnotationDesk;
class LabelKeyFilter;
class LabelQuestions;
class Layouts;
class MainWindow;
class ProjectDesk;
class RenderDialog;
class Shortcuts;
class StreamDesk;
class TakeDesk;
class ViewRecording;
struct ExportSources;
struct PairSources;
struct RangeRequest;

/// What the program asks of the window once it is assembled.
struct Rooms {
  ProjectDesk& project;
  StreamDesk& streams;
  Layouts& layouts;
  widgets::LeftoverBar& leftovers;
};
/// Every action there is, in the order of the menus: for the program and for tests of the whole window.
Rooms add_all_actions(MainWindow& window);

/// "View > Layouts" of an action in a menu of a menu.
QString menu_path(const QAction& action);
/// An action in a menu, with its keys, at work wherever the window has the focus. Its id is that of menu and
/// words, see action_id.hpp, and stays when it changes its words.
QAction* add_action(MainWindow& window, QMenu* menu, const QString& text,
                    std::initializer_list<QKeySequence> keys, std::function<void()> act);

/// Null when there is none of this id.
QAction* action_of(const MainWindow& window, const QString& id);
/// From where it stands in a menu to before another entry; it stays where there is no other.
void move_before(QMenu& menu, QAction* action, QAction* other);

void add_file_actions(MainWindow& window, RenderDialog& dialog);
/// Films of the screen and of what was recorded; called by those of files.
void add_recording_actions(MainWindow& window, RenderDialog& dialog);
/// The reference video: opening, stepping, synchronising, its camera; after those of files.
void add_video_actions(MainWindow& window, RenderDialog& dialog);
void add_edit_actions(MainWindow& window);
void add_playback_actions(MainWindow& window);
/// The fields of go to, in and out, speed.
void add_timeline_actions(MainWindow& window);
void add_marker_actions(MainWindow& window, AnnotationDesk& desk);
/// What the timeline shows; after those of markers.
void add_lane_actions(MainWindow& window);
void add_camera_actions(MainWindow& window);
void add_view_actions(MainWindow& window);
Layouts& add_layout_actions(MainWindow& window);
/// After those of files.
void add_recent_actions(MainWindow& window);
/// After whatever offers something to begin with.
void add_welcome_actions(MainWindow& window);
void add_scene_actions(MainWindow& window);
/// Links the selection of all views.
void add_selection_actions(MainWindow& window);
/// Recording takes of a session.
TakeDesk& add_take_actions(MainWindow& window);
/// Two streamed performers as a take of the library.
void add_pair_actions(MainWindow& window, TakeDesk& takes, PairSources sources);
/// Which role the user has, and who decides about it.
void add_role_actions(MainWindow& window);
/// The move that the user intends; after those of candidates.
void add_intended_move_actions(MainWindow& window);
/// Opening recorded sessions.
widgets::LeftoverBar& add_session_actions(MainWindow& window, TakeDesk& takes);
/// New, save, save as: the session file with the project; after those of sessions and recent files.
ProjectDesk& add_project_actions(MainWindow& window, TakeDesk& takes);
void add_solve_actions(MainWindow& window);
/// One's own presets, and what the shown frame was solved with.
void add_preset_actions(MainWindow& window);
/// The window that tries a grid of two settings on the takes of the library.
void add_sweep_actions(MainWindow& window);
/// Connecting to a live stream, calibrating, sending on; the panels of connection and latency.
StreamDesk& add_stream_actions(MainWindow& window);
/// The library browser, and building libraries of motion files.
void add_library_actions(MainWindow& window);
/// Labels of the session and of takes: the panel, the lanes, their keys; after those of the timeline.
void add_annotation_actions(MainWindow& window, AnnotationDesk& desk, LabelKeyFilter& keys);
/// Called by those of annotation, whose desk they ask.
void add_label_actions(MainWindow& window, AnnotationDesk& desk, LabelQuestions& questions);
void add_suggestion_actions(MainWindow& window, AnnotationDesk& desk);
/// Pin, veto and jump; what the candidate table asks for becomes a step of undo.
void add_candidate_actions(MainWindow& window);
/// Freezes settings as A, and solves again with others what was recorded.
void add_compare_actions(MainWindow& window);
/// Motion, meshes, labels, traces and plots as files.
void add_export_actions(MainWindow& window, ExportSources sources);
/// After those of playback: whatever follows the live end takes the plots along.
void add_plot_actions(MainWindow& window);
void add_help_actions(MainWindow& window, Shortcuts& shortcuts);
/// The field at the right of the menu bar that finds any action; after all others.
void add_command_search(MainWindow& window);

/// Size and place of the window and its panels as they were when it was closed last; after all panels exist.
void restore_last_layout(MainWindow& window, Layouts& layouts);

/// Sessions that a crash left behind, above the scene.
void offer_leftovers(MainWindow& window, widgets::LeftoverBar& leftovers);

/// Shows the welcome page where a person wants it and there is room for it beside the scene.
void welcome_at_start(MainWindow& window);

/// As soon as there is a session. Errors are reported.
void send_partner_to(MainWindow& window, StreamDesk& streams, const QString& uri);

/// @param entry  of the recent files; missing files are reported
void open_recent(MainWindow& window, const QString& entry);
void remove_missing_recent(MainWindow& window);

/// Writes the window as it is on the screen, the 3D scene included. @return what went wrong, or nothing
QString save_screenshot(MainWindow& window, const QString& file);

/// Films until it is stopped; what prevents it is reported.
void start_recording(MainWindow& window, ViewRecording& recording, const QString& file);
/// Films recorded frames while the window goes on; the end is reported.
void render_range(MainWindow& window, const RangeRequest& request);

/// Writes the plots, or the samples in their window, whole or not at all. @return what went wrong, or nothing
QString save_plots(MainWindow& window, widgets::PlotExport what, const QString& file);

/// Writes the report of a sweep, JSON or a page by the file's ending. @return what went wrong, or nothing
QString save_sweep(const SweepOutcome& outcome, const QString& file);

}  // namespace abrazo::app
