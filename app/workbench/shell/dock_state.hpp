#pragma once

#include <QByteArray>

namespace abrazo::app {

/// Whether the bytes are as QMainWindow::saveState writes them for a window with docks, without tool bars and
/// groups of floating panels. To be asked before QMainWindow::restoreState of what a file says, perhaps a
/// stranger's: Qt believes the number of a dock area and writes where it points to.
/// @param version  that saveState was given
bool is_dock_state(const QByteArray& bytes, int version);

}  // namespace abrazo::app
