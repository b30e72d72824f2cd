#pragma once

#include <QColor>
#include <QIcon>

namespace abrazo::widgets {

enum class Icon {
  ToStart,
  StepBack,
  Play,
  Pause,
  StepForward,
  ToEnd,
  Loop,
  Close,
  Warning,
  Information,
  Lock,
  Unlock,
  Reset,
  More
};

/// A single-weight line icon on a 16 px grid, sharp at 1x and 2x.
QIcon icon(Icon which, const QColor& colour);

/// The program's mark, as on the desktop.
QIcon program_icon();

}  // namespace abrazo::widgets
