#pragma once

#include <QStringList>

#include "core/session/file/project.hpp"

namespace abrazo::app {

class MainWindow;

/// What a person works on in the window, as it is now. The references to data have a path and a use only:
/// `with_contents` completes them, which reads the files.
Project project_of(MainWindow& window);

/// The window as a project has it; its session has just started. What does not fit this version is left as it
/// is.
void show_project(MainWindow& window, const Project& project, const QStringList& videos);

void show_annotations(MainWindow& window, const AnnotationBook& book);

/// The references completed for a session file at `session_file`; those of files that no longer exist
/// as they were in `before`.
Project with_contents(Project project, const Project& before, const std::string& session_file);

/// Whether a person has to be asked before it is lost: all but where panels and camera stand.
bool is_same_work(const Project& a, const Project& b);

}  // namespace abrazo::app
