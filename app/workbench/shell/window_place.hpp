#pragma once

class QWidget;

namespace abrazo::app {

/// Moves a window whose head could not be reached with the pointer to the middle of a screen.
void bring_onto_screen(QWidget& window);

}  // namespace abrazo::app
