#pragma once

#include <vector>

class QWidget;

namespace abrazo::app {

class MainWindow;

/// The focus cycle of F6: welcome page, scene, visible panels, transport and timeline.
std::vector<QWidget*> focus_places(const MainWindow& window);

/// Moves the focus to the next place (1), or the previous one (-1). Does not remember the focus within a
/// place.
void focus_panel(MainWindow& window, int by);

}  // namespace abrazo::app
