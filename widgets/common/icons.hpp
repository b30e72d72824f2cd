#pragma once

#include <QColor>
#include <QIcon>
#include <functional>

class QPainter;

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

/// An icon that is painted, in pixels of 1x, with smooth edges; sharp at 1x and 2x.
QIcon painted_icon(const QSize& size, const std::function<void(QPainter&)>& paint);

/// The program's mark, as on the desktop.
QIcon program_icon();

}  // namespace abrazo::widgets
