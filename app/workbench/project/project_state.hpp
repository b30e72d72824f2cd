#pragma once

#include "core/session/file/project.hpp"

namespace abrazo::app {

class MainWindow;

/// The present project of the window. Its data references have path and use only; `save_session` reads the
/// files and completes them.
Project project_of(MainWindow& window);

/// Restores panels, lanes, plots, scene and camera of a project, and shortly afterwards the shown take and a
/// parked cursor. Ignores values that are invalid in this
/// version.
void show_view(MainWindow& window, const std::map<std::string, std::string>& view);

}  // namespace abrazo::app
