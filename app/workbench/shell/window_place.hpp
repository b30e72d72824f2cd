#pragma once

class QWidget;

namespace abrazo::app {

/// Moves a window to the middle of a screen if its title bar is unreachable.
void bring_onto_screen(QWidget& window);

/// The same, and all of it is on its screen, with its frame: the status bar is at the bottom.
void fit_onto_screen(QWidget& window);

}  // namespace abrazo::app
