#pragma once

#include "core/session/file/project.hpp"

namespace abrazo::app {

class MainWindow;

/// What a person works on in the window, as it is now. The references to data have a path and a use only:
/// `save_session` completes them, which reads the files.
Project project_of(MainWindow& window);

/// Panels, lanes, plots, scene and camera as a project has them. What does not fit this version is left as it
/// is.
void show_view(MainWindow& window, const std::map<std::string, std::string>& view);

}  // namespace abrazo::app
