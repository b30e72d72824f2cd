#pragma once

#include <QKeySequence>
#include <functional>
#include <initializer_list>

class QAction;
class QMainWindow;
class QHBoxLayout;
class QMenu;
class QString;
class QUndoStack;

namespace abrazo {
class RecordedTakes;
struct SweepOutcome;
}  // namespace abrazo

namespace abrazo::widgets {
class LeftoverBar;
class SceneView;
enum class PlotExport;
}  // namespace abrazo::widgets

namespace abrazo::app {

class AnnotationDesk;
class Document;
class LabelKeyFilter;
class LabelQuestions;
class Layouts;
class MainWindow;
class ProjectDesk;
class RenderDialog;
class Shortcuts;
class StreamDesk;
class TakeDesk;
struct RangeRequest;
class UserSettings;

/// Objects that the program needs after the window is assembled.
struct Rooms {
  ProjectDesk& project;
  StreamDesk& streams;
  Layouts& layouts;
  widgets::LeftoverBar& leftovers;
};
/// Adds all actions in menu order, for the program and for tests of the whole window.
Rooms add_all_actions(MainWindow& window);

/// What stands at the right of the menus.
QHBoxLayout& title_row(QMainWindow& window);

/// The menu of the menu bar with this title, made by the first call.
QMenu* menu_of(QMainWindow& window, const QString& title);
/// "View > Layouts" for an action in a submenu.
QString menu_path(const QAction& action);
/// Adds an action with its keys to a menu; active in the whole window. Its id comes from menu and text, see
/// action_id.hpp, and stays if the text changes.
QAction* add_action(QMainWindow& window, QMenu* menu, const QString& text,
                    std::initializer_list<QKeySequence> keys, std::function<void()> act);

/// Null if there is no action of this id.
QAction* action_of(const QMainWindow& window, const QString& id);
/// Moves an action before another entry of its menu; no effect if the other is missing.
void move_before(QMenu& menu, QAction* action, QAction* other);

void add_file_actions(MainWindow& window, RenderDialog& dialog);
/// Films of the screen and of the recording; called by the file actions.
void add_recording_actions(MainWindow& window, RenderDialog& dialog);
/// The reference video: opening, stepping, synchronising, its camera; after the file actions.
void add_video_actions(MainWindow& window, RenderDialog& dialog);
void add_edit_actions(MainWindow& window);
void add_playback_actions(MainWindow& window);
/// The fields of go to, in and out, speed.
void add_timeline_actions(MainWindow& window);
void add_marker_actions(MainWindow& window, AnnotationDesk& desk);
/// What the timeline shows; after the marker actions.
void add_lane_actions(MainWindow& window);
void add_camera_actions(QMainWindow& window, widgets::SceneView& scene);
void add_view_actions(MainWindow& window);
Layouts& add_layout_actions(MainWindow& window);
/// After the file actions.
void add_recent_actions(MainWindow& window);
/// After all actions that add a start to the welcome page.
void add_welcome_actions(MainWindow& window);
void add_character_actions(MainWindow& window);
void add_scene_actions(QMainWindow& window, widgets::SceneView& scene, UserSettings& remembered,
                       QUndoStack& undo);
/// Changes of the cutting plane and of the legend's ranges become undo steps; called by the scene actions.
void keep_scene_edits(widgets::SceneView& scene, QUndoStack& undo);
/// Links the selection of all views.
void add_selection_actions(MainWindow& window);
/// Recording takes of a session.
TakeDesk& add_take_actions(MainWindow& window);
/// Two streamed performers as a take of the library.
void add_pair_actions(MainWindow& window, TakeDesk& takes,
                      std::function<std::pair<QString, QString>()> performers);
/// The user's role and the role control.
void add_role_actions(MainWindow& window);
/// The intended move; after the candidate actions.
void add_intended_move_actions(MainWindow& window);
/// Opening recorded sessions.
widgets::LeftoverBar& add_session_actions(MainWindow& window);
/// New, save, save as: the session file with the project; after the session and recent file actions.
ProjectDesk& add_project_actions(MainWindow& window, TakeDesk& takes);
void add_solve_actions(QMainWindow& window, Document& document);
/// The user's own presets, and the settings of the shown frame.
void add_preset_actions(MainWindow& window);
/// A motion file as a body in the settings.
void add_body_actions(MainWindow& window);
/// The window for a sweep of two settings over the takes of the library.
void add_sweep_actions(MainWindow& window);
/// Connecting to a live stream, calibration, sinks; the panels Connection and Latency.
StreamDesk& add_stream_actions(MainWindow& window);
/// The library browser, and building libraries from motion files.
void add_library_actions(MainWindow& window);
/// How motion files are read; after the file actions.
void add_import_actions(MainWindow& window);
/// Labels of the session and of takes: the panel, the lanes, their keys; after the timeline actions.
void add_annotation_actions(MainWindow& window, AnnotationDesk& desk, LabelKeyFilter& keys);
/// Called by the annotation actions, whose desk they use.
void add_label_actions(MainWindow& window, AnnotationDesk& desk, LabelQuestions& questions);
void add_suggestion_actions(MainWindow& window, AnnotationDesk& desk);
/// Pin, veto and jump; requests of the candidate table become undo steps.
void add_candidate_actions(MainWindow& window);
/// Freezes settings as A, and solves the recording again with others.
void add_compare_actions(MainWindow& window);
/// Motion, meshes, labels, traces and plots as files.
void add_export_actions(MainWindow& window, std::function<RecordedTakes()> takes);
/// After the playback actions: following the live end also moves the plots.
void add_plot_actions(MainWindow& window);
void add_help_actions(MainWindow& window, Shortcuts& shortcuts);
/// The search field for actions at the right of the menu bar; after all other actions.
void add_command_search(QMainWindow& window);

/// Restores size and layout of the window from its last closing; after all panels exist.
void restore_last_layout(MainWindow& window, Layouts& layouts);

/// Offers sessions left by a crash, above the scene.
void offer_leftovers(MainWindow& window, widgets::LeftoverBar& leftovers);

/// Shows the welcome page if the user wants it and there is room beside the scene.
void welcome_at_start(MainWindow& window);

/// Sends the partner as soon as there is a session. Errors are reported.
void send_partner_to(MainWindow& window, StreamDesk& streams, const QString& uri);

/// @param entry  of the recent files; missing files are reported
void open_recent(MainWindow& window, const QString& entry);
void remove_missing_recent(MainWindow& window);

/// Writes a screenshot of the window, including the 3D scene. @return the error, or empty
QString save_screenshot(MainWindow& window, const QString& file);

/// Renders recorded frames to a film in the background; the end is reported.
void render_range(MainWindow& window, const RangeRequest& request);

/// Writes the plots, or the samples in their window, completely or not at all. @return the error, or empty
QString save_plots(MainWindow& window, widgets::PlotExport what, const QString& file);

/// Writes the report of a sweep, JSON or HTML by the file's extension. @return the error, or empty
QString save_sweep(const SweepOutcome& outcome, const QString& file);

}  // namespace abrazo::app
