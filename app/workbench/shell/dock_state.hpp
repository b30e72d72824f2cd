#pragma once

#include <QByteArray>

namespace abrazo::app {

/// Whether the bytes have the format of QMainWindow::saveState for a window with docks, without tool bars and
/// groups of floating panels. Check untrusted data before QMainWindow::restoreState: Qt uses the number of a
/// dock area as an index without a check.
/// @param version the version passed to saveState
bool is_dock_state(const QByteArray& bytes, int version);

}  // namespace abrazo::app
