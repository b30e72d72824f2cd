#include "app/workbench/shell/window_place.hpp"

#include <QGuiApplication>
#include <QScreen>
#include <QStyle>
#include <QWidget>
#include <algorithm>

namespace abrazo::app {
namespace {

constexpr int least_to_hold = 48;  // pixels of a window's head that suffice to move it

}  // namespace

void bring_onto_screen(QWidget& window) {
  const QRect frame = window.frameGeometry();
  const QRect head(frame.topLeft(), QSize(frame.width(), least_to_hold));
  const auto reaches = [&](const QScreen* screen) {
    const QRect seen = screen->availableGeometry().intersected(head);
    return seen.width() >= least_to_hold && seen.height() >= least_to_hold / 3;
  };
  const QList<QScreen*> screens = QGuiApplication::screens();
  if (screens.isEmpty() || std::ranges::any_of(screens, reaches)) return;
  const QRect room = screens.front()->availableGeometry();
  window.resize(window.size().boundedTo(room.size()));
  window.move(room.center() - window.rect().center());
}

void fit_onto_screen(QWidget& window) {
  bring_onto_screen(window);
  if (!window.screen()) return;
  const QRect room = window.screen()->availableGeometry();
  // A window that was never shown does not know its frame yet.
  const QSize frame = (window.frameGeometry().size() - window.size())
                          .expandedTo({0, window.style()->pixelMetric(QStyle::PM_TitleBarHeight)});
  window.resize(window.size().boundedTo(room.size() - frame));
  const QSize whole = window.size() + frame;
  // A window that cannot be made as small as the screen begins at its top left.
  window.move(std::max(room.left(), std::min(window.x(), room.right() + 1 - whole.width())),
              std::max(room.top(), std::min(window.y(), room.bottom() + 1 - whole.height())));
}

}  // namespace abrazo::app
