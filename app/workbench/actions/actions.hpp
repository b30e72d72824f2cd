#pragma once

#include <QKeySequence>
#include <functional>
#include <initializer_list>

class QAction;
class QMenu;
class QString;

namespace abrazo::widgets {
enum class PlotExport;
}

namespace abrazo::app {

class MainWindow;

/// An action in a menu, with its keys, at work wherever the window has the focus.
QAction* add_action(MainWindow& window, QMenu* menu, const QString& text,
                    std::initializer_list<QKeySequence> keys, std::function<void()> act);

void add_file_actions(MainWindow& window);
void add_edit_actions(MainWindow& window);
void add_playback_actions(MainWindow& window);
void add_view_actions(MainWindow& window);
void add_scene_actions(MainWindow& window);
void add_solve_actions(MainWindow& window);
/// Pin, veto and jump; what the candidate table asks for becomes a step of undo.
void add_candidate_actions(MainWindow& window);
/// After those of playback: whatever follows the live end takes the plots along.
void add_plot_actions(MainWindow& window);
void add_help_actions(MainWindow& window);
/// The field at the right of the menu bar that finds any action; after all others.
void add_command_search(MainWindow& window);

/// Writes the window as it is on the screen, the 3D scene included. @return what went wrong, or nothing
QString save_screenshot(MainWindow& window, const QString& file);

/// Writes the plots, or the samples in their window, whole or not at all. @return what went wrong, or nothing
QString save_plots(MainWindow& window, widgets::PlotExport what, const QString& file);

}  // namespace abrazo::app
