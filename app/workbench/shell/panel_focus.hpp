#pragma once

#include <vector>

class QWidget;

namespace abrazo::app {

class MainWindow;

/// The places that F6 goes round: the welcome page, the scene, the panels that are seen, the transport and
/// the timeline.
std::vector<QWidget*> focus_places(const MainWindow& window);

/// Gives the keyboard to the next place (1), or the one before (-1). Where a place was left is not
/// remembered.
void focus_panel(MainWindow& window, int by);

}  // namespace abrazo::app
