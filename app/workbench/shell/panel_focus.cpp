#include "app/workbench/shell/panel_focus.hpp"

#include <QApplication>
#include <QDockWidget>
#include <algorithm>

#include "app/workbench/shell/main_window.hpp"
#include "app/workbench/shell/panel_area.hpp"
#include "widgets/scene/view/scene_view.hpp"
#include "widgets/timeline/timeline_view.hpp"
#include "widgets/timeline/transport_bar.hpp"

namespace abrazo::app {
namespace {

bool can_have_keyboard(const QWidget& widget) {
  return widget.isVisible() && widget.isEnabled() && (widget.focusPolicy() & Qt::TabFocus);
}

/// The widget that shows where the keyboard is once this place has it.
QWidget* first_in(QWidget& place) {
  if (QWidget* proxy = place.focusProxy()) return proxy;
  if (can_have_keyboard(place)) return &place;
  const QList<QWidget*> inside = place.findChildren<QWidget*>();
  const auto found =
      std::ranges::find_if(inside, [](const QWidget* child) { return can_have_keyboard(*child); });
  return found == inside.end() ? nullptr : *found;
}

bool holds(const QWidget& place, const QWidget* widget) {
  return widget && (&place == widget || place.isAncestorOf(widget));
}

}  // namespace

std::vector<QWidget*> focus_places(const MainWindow& window) {
  std::vector<QWidget*> places;
  if (QWidget* page = window.besideScene(); page && page->isVisible()) places.push_back(page);
  places.push_back(&window.scene());
  for (QDockWidget* panel : window.panels().panels())
    if (panel->isVisible() && !panel->visibleRegion().isEmpty()) places.push_back(panel->widget());
  places.push_back(&window.transport());
  places.push_back(&window.timeline());
  std::erase_if(places, [](QWidget* place) { return !first_in(*place); });
  return places;
}

void focus_panel(MainWindow& window, int by) {
  const std::vector<QWidget*> places = focus_places(window);
  if (places.empty()) return;
  const auto count = static_cast<int>(places.size());
  const auto here = std::ranges::find_if(
      places, [](const QWidget* place) { return holds(*place, QApplication::focusWidget()); });
  const int now = here == places.end() ? (by > 0 ? -1 : count) : static_cast<int>(here - places.begin());
  QWidget* target = first_in(*places[static_cast<std::size_t>((now + by + count) % count)]);
  target->activateWindow();  // a floating panel is a separate window
  target->setFocus(by > 0 ? Qt::TabFocusReason : Qt::BacktabFocusReason);
}

}  // namespace abrazo::app
