#include "app/workbench/shell/panel_area.hpp"

#include <QCloseEvent>
#include <QDockWidget>
#include <QLayout>
#include <QScrollArea>
#include <QStyle>
#include <QTabBar>
#include <QTimer>
#include <algorithm>
#include <cmath>
#include <utility>

#include "app/workbench/shell/dock_state.hpp"
#include "app/workbench/shell/panel_title.hpp"
#include "app/workbench/shell/window_place.hpp"
#include "widgets/common/section_header.hpp"

namespace abrazo::app {
namespace {

constexpr int plots_height = 172;
constexpr int usual_head = 32, low_head = 24;  // low where height is scarce
constexpr int candidates_share = 55;           // per cent of the right side
// More panels of a side share the last place as tabs: each needs some height to be read.
constexpr int most_stacked_beside = 2, most_stacked_below = 1;

widgets::SectionHeader* head_for(QWidget* content, const QString& title) {
  for (auto* head : content->findChildren<widgets::SectionHeader*>(QString(), Qt::FindDirectChildrenOnly))
    if (head->title() == title) return head;
  return new widgets::SectionHeader(title);
}

/// That a panel of settings asks for on top of what it needs.
int room_for_tuned(const QDockWidget& panel) {
  const QWidget& kept = *panel.widget();
  return std::max(0, kept.minimumHeight() - kept.minimumSizeHint().height());
}

int least_height(const QDockWidget& panel) {
  return panel.minimumSizeHint().height() - (panel.objectName() == "settings" ? room_for_tuned(panel) : 0);
}

}  // namespace

PanelArea::PanelArea() {
  setWindowFlags(Qt::Widget);  // a QMainWindow is a top-level window by default
  setDockOptions(QMainWindow::AllowTabbedDocks | QMainWindow::AllowNestedDocks);
  setTabPosition(Qt::AllDockWidgetAreas, QTabWidget::North);
  for (const Qt::Corner corner : {Qt::TopLeftCorner, Qt::BottomLeftCorner})
    setCorner(corner, Qt::LeftDockWidgetArea);
  for (const Qt::Corner corner : {Qt::TopRightCorner, Qt::BottomRightCorner})
    setCorner(corner, Qt::RightDockWidgetArea);
}

QDockWidget* PanelArea::add(const QString& id, const QString& title, QWidget* content,
                            Qt::DockWidgetArea area, bool shown) {
  auto* dock = new QDockWidget(title, this);
  dock->setObjectName(id);
  dock->setAccessibleName(title);
  dock->setAllowedAreas(Qt::LeftDockWidgetArea | Qt::RightDockWidgetArea | Qt::BottomDockWidgetArea);
  auto* head = new PanelTitle(head_for(content, title), dock);
  if (area == Qt::BottomDockWidgetArea) head->header().setFixedHeight(low_head);
  dock->setTitleBarWidget(head);
  content->setAttribute(Qt::WA_StyledBackground);  // the panel's colour, whatever class it is
  dock->setWidget(content);
  dock->installEventFilter(this);
  for (auto* scroll : content->findChildren<QScrollArea*>())
    if (scroll->accessibleName().isEmpty()) scroll->setAccessibleName(title);
  connect(head, &PanelTitle::closeRequested, this, [this, id] { want(id, false); });
  connect(head, &PanelTitle::moveRequested, this, [this, dock](Qt::DockWidgetArea side) {
    dock->setFloating(false);
    addDockWidget(side, dock);
    want(dock->objectName(), true);  // also where there was no room for panels at that side
  });
  connect(dock, &QDockWidget::topLevelChanged, this, &PanelArea::showWhatFits, Qt::QueuedConnection);
  // Elsewhere it had another size, and others made room for it.
  connect(dock, &QDockWidget::dockLocationChanged, this, [this, id] { m_sizes.erase(id); });
  m_panels.push_back({dock, head, area, shown, shown});
  place(m_panels.back());
  dock->setVisible(shown && hasRoom(m_panels.back()));
  return dock;
}

void PanelArea::place(Panel& panel) {
  std::vector<QDockWidget*> there;
  for (const Panel& other : m_panels)
    if (other.dock != panel.dock && other.usual_side == panel.usual_side &&
        dockWidgetArea(other.dock) == panel.usual_side)
      there.push_back(other.dock);
  const int most = panel.usual_side == Qt::BottomDockWidgetArea ? most_stacked_below : most_stacked_beside;
  addDockWidget(panel.usual_side, panel.dock);
  if (static_cast<int>(there.size()) < most) return;
  tabifyDockWidget(there.front(), panel.dock);
  there.front()->raise();
}

PanelArea::Panel* PanelArea::find(const QString& id) {
  const auto found =
      std::ranges::find_if(m_panels, [&](const Panel& panel) { return panel.dock->objectName() == id; });
  return found == m_panels.end() ? nullptr : &*found;
}

const PanelArea::Panel* PanelArea::find(const QString& id) const {
  return const_cast<PanelArea*>(this)->find(id);
}

QDockWidget* PanelArea::panel(const QString& id) const {
  const Panel* found = find(id);
  return found ? found->dock : nullptr;
}

std::vector<QDockWidget*> PanelArea::panels() const {
  std::vector<QDockWidget*> docks;
  for (const Panel& panel : m_panels) docks.push_back(panel.dock);
  return docks;
}

void PanelArea::setHead(const QString& id, const QString& text) {
  if (Panel* found = find(id)) found->title->header().setTitle(text);
}

void PanelArea::setColours(const widgets::Palette& palette) {
  for (const Panel& panel : m_panels) panel.title->setColours(palette);
}

bool PanelArea::isWanted(const QString& id) const {
  const Panel* found = find(id);
  return found && found->wanted;
}

void PanelArea::want(const QString& id, bool on) {
  Panel* found = find(id);
  if (!found) return;
  const bool changed = found->wanted != on;
  found->wanted = on;
  if (on && !hasRoom(*found)) wantSide(dockWidgetArea(found->dock), true);
  showWhatFits();
  if (on) found->dock->raise();
  if (changed) emit wantedChanged(id, on);
}

void PanelArea::wantSide(Qt::DockWidgetArea side, bool on) {
  std::optional<bool>& wish = side == Qt::LeftDockWidgetArea    ? m_wishes.left
                              : side == Qt::RightDockWidgetArea ? m_wishes.right
                                                                : m_wishes.plots;
  wish.reset();
  const PanelPlan usual = plan_panels(m_window, m_wishes, m_beside);
  const bool usually = side == Qt::LeftDockWidgetArea    ? usual.left
                       : side == Qt::RightDockWidgetArea ? usual.right
                                                         : usual.plots;
  // What the size decides anyway is no wish: in another size the panels come and go by themselves again.
  if (on != usually) wish = on;
  const auto is_there = [&](const Panel& panel) { return dockWidgetArea(panel.dock) == side; };
  const auto is_wanted = [&](const Panel& panel) { return is_there(panel) && panel.wanted; };
  if (on && std::ranges::none_of(m_panels, is_wanted))
    for (Panel& panel : m_panels)
      if (is_there(panel) && panel.usually_shown) panel.wanted = true;
  arrangeFor(m_window);
}

bool PanelArea::hasRoom(const Panel& panel) const {
  if (panel.dock->isFloating()) return true;
  switch (dockWidgetArea(panel.dock)) {
    case Qt::LeftDockWidgetArea:
      return m_room.left;
    case Qt::RightDockWidgetArea:
      return m_room.right;
    default:
      return m_room.plots;
  }
}

/// Of panels that share a place.
QList<QTabBar*> PanelArea::tabBars() const {
  return findChildren<QTabBar*>(QString(), Qt::FindDirectChildrenOnly);
}

/// Qt makes one whenever panels begin to share a place, with a light line below it that no sheet takes away.
void PanelArea::prepareTabBars() {
  for (QTabBar* tabs : tabBars()) {
    tabs->setAccessibleName("Panels that share a place");
    tabs->setDrawBase(false);
    // "Cand…" and "Comp…" name nothing; arrows lead to the others. Each call lays the window out, which calls
    // this.
    if (tabs->elideMode() != Qt::ElideNone) tabs->setElideMode(Qt::ElideNone);
  }
}

/// Which panels a person sees, so that they are in front again when there is room again.
void PanelArea::noteFront() {
  if (!isVisible()) return;
  for (const Panel& panel : m_panels) {
    if (panel.dock->isHidden()) continue;
    if (panel.dock->visibleRegion().isEmpty())
      m_front.erase(panel.dock->objectName());
    else
      m_front.insert(panel.dock->objectName());
  }
}

void PanelArea::showWhatFits() {
  noteFront();
  PanelPlan shown = m_room;
  shown.left = shown.right = shown.plots = false;
  QList<QDockWidget*> returned;
  for (const Panel& panel : m_panels) {
    const bool visible = panel.wanted && hasRoom(panel);
    if (panel.dock->isHidden() == visible) {
      panel.dock->setVisible(visible);
      if (visible) returned << panel.dock;
    }
    const Qt::DockWidgetArea side = dockWidgetArea(panel.dock);
    if (!visible || panel.dock->isFloating()) continue;
    shown.left |= side == Qt::LeftDockWidgetArea;
    shown.right |= side == Qt::RightDockWidgetArea;
    shown.plots |= side == Qt::BottomDockWidgetArea;
  }
  for (QDockWidget* dock : returned)
    if (m_front.contains(dock->objectName())) dock->raise();
  prepareTabBars();
  emit arranged(shown);
}

void PanelArea::arrangeFor(QSize window) {
  m_window = window;
  m_room = plan_panels(window, m_wishes, m_beside);
  for (const Panel& panel : m_panels)
    if (panel.usual_side != Qt::BottomDockWidgetArea)
      setHeadHeight(panel, m_room.has_low_heads ? low_head : usual_head);
  showWhatFits();
  keepTuned();
  restoreSizes();
}

/// A dock keeps the least height that it had with its former head until its layout is made again: panels
/// would overlap.
void PanelArea::setHeadHeight(const Panel& panel, int height) {
  if (panel.title->header().height() == height) return;
  panel.title->header().setFixedHeight(height);
  for (QWidget* changed : {static_cast<QWidget*>(panel.title), static_cast<QWidget*>(panel.dock)}) {
    changed->layout()->invalidate();
    changed->layout()->activate();
  }
}

void PanelArea::leaveRoomBeside(int width) {
  m_beside = width;
  arrangeFor(m_window);
}

/// 0 for a panel that has its place for itself.
int PanelArea::heightOfTabs(QDockWidget* panel) const {
  const QList<QDockWidget*> others = tabifiedDockWidgets(panel);
  if (std::ranges::all_of(others, [](const QDockWidget* other) { return other->isHidden(); })) return 0;
  int height = 0;
  for (const QTabBar* tabs : tabBars()) height = std::max(height, tabs->sizeHint().height());
  return height;
}

/// Of the tallest of the panels that share it.
int PanelArea::leastHeightOfPlace(QDockWidget* panel) const {
  int height = least_height(*panel);
  for (const QDockWidget* other : tabifiedDockWidgets(panel))
    if (!other->isHidden()) height = std::max(height, least_height(*other));
  return height + heightOfTabs(panel);
}

/// Of the places at this side above one another. @param without  a panel whose place does not count
int PanelArea::leastHeight(Qt::DockWidgetArea side, const QDockWidget* without) const {
  const int border = style()->pixelMetric(QStyle::PM_DockWidgetSeparatorExtent, nullptr, this);
  std::set<const QDockWidget*> counted{without};
  int height = 0;
  for (const Panel& panel : m_panels) {
    QDockWidget* dock = panel.dock;
    if (dock->isHidden() || dock->isFloating() || dockWidgetArea(dock) != side) continue;
    const QList<QDockWidget*> others = tabifiedDockWidgets(dock);
    const auto is_counted = [&](const QDockWidget* other) { return counted.contains(other); };
    if (is_counted(dock) || std::ranges::any_of(others, is_counted)) continue;
    counted.insert(dock);
    height += leastHeightOfPlace(dock) + (height > 0 ? border : 0);
  }
  return height;
}

int PanelArea::neededHeight() const {
  QDockWidget* settings = panel("settings");
  if (!settings || settings->isHidden() || settings->isFloating() ||
      dockWidgetArea(settings) == Qt::BottomDockWidgetArea)
    return 0;
  constexpr int borders = 2;
  const int head = m_room.has_low_heads ? low_head : usual_head;
  const int own = head + borders + settings->widget()->sizeHint().height() + heightOfTabs(settings);
  return own + leastHeight(dockWidgetArea(settings), settings);
}

QSize PanelArea::minimumSizeHint() const {
  QSize least = QMainWindow::minimumSizeHint();
  const QDockWidget* settings = panel("settings");
  if (!settings) return least;
  // Only the side of the settings can give way.
  const int centre = centralWidget() ? centralWidget()->minimumSizeHint().height() : 0;
  const int others = std::max({leastHeight(Qt::LeftDockWidgetArea), leastHeight(Qt::RightDockWidgetArea),
                               centre + leastHeight(Qt::BottomDockWidgetArea)});
  const int given = room_for_tuned(*settings);
  least.setHeight(std::min(least.height(), std::max(least.height() - given, others)));
  return least;
}

/// The settings that are tuned most are in view as far as the candidates leave room for them.
void PanelArea::keepTuned() {
  QDockWidget* settings = panel("settings");
  if (!settings) return;
  const int needed = neededHeight(), wanted = settings->widget()->sizeHint().height();
  const int lacking = std::max(0, needed - height());
  const int kept = needed > 0 && m_favoured.isEmpty() ? std::max(0, wanted - lacking) : 0;
  if (kept != settings->widget()->minimumHeight()) {
    settings->widget()->setMinimumHeight(kept);
    // As in setHeadHeight(): else the sizes are shared out with the height that it had.
    settings->layout()->invalidate();
    settings->layout()->activate();
  }
  if (needed == std::exchange(m_needed, needed)) return;
  emit neededHeightChanged();
}

void PanelArea::favour(const QString& id) {
  if (id == m_favoured) return;
  m_favoured = id;
  keepTuned();
  restoreSizes();
}

int PanelArea::planned(Qt::DockWidgetArea side) const {
  return side == Qt::LeftDockWidgetArea ? m_room.left_width : m_room.right_width;
}

/// As they are now: after a person moved a border, or a layout was chosen. Not while the window is resized.
void PanelArea::rememberSizes() {
  int tabs_height = 0;  // at the sides it counts with the panels of a place
  for (const QTabBar* tabs : tabBars())
    if (tabs->isVisible()) tabs_height = tabs->height();
  for (const Panel& panel : m_panels) {
    const QDockWidget& dock = *panel.dock;
    if (dock.isHidden() || dock.isFloating() || dock.visibleRegion().isEmpty()) continue;
    const Qt::DockWidgetArea side = dockWidgetArea(panel.dock);
    const bool follows = side != Qt::BottomDockWidgetArea && std::abs(dock.width() - planned(side)) <= 2;
    const bool shares = side != Qt::BottomDockWidgetArea && !tabifiedDockWidgets(panel.dock).isEmpty();
    const auto known = m_sizes.find(dock.objectName());
    const bool lends_height = !m_favoured.isEmpty() && known != m_sizes.end();
    const int height = lends_height ? known->second.height() : dock.height() + (shares ? tabs_height : 0);
    m_sizes[dock.objectName()] = {follows ? 0 : dock.width(), height};
  }
}

void PanelArea::restoreSizes() {
  QList<QDockWidget*> beside, all;
  QList<int> widths, heights;
  for (const Panel& panel : m_panels) {
    const auto known = m_sizes.find(panel.dock->objectName());
    if (known == m_sizes.end() || panel.dock->isHidden() || panel.dock->isFloating()) continue;
    all << panel.dock;
    heights << known->second.height();
    const Qt::DockWidgetArea side = dockWidgetArea(panel.dock);
    if (side == Qt::BottomDockWidgetArea) continue;
    beside << panel.dock;
    widths << (known->second.width() > 0 ? known->second.width() : planned(side));
  }
  resizeDocks(beside, widths, Qt::Horizontal);
  resizeDocks(all, heights, Qt::Vertical);
  QDockWidget *favoured = panel(m_favoured), *settings = panel("settings");
  if (favoured && settings && !favoured->isHidden() && !settings->isHidden() &&
      dockWidgetArea(favoured) == dockWidgetArea(settings))
    resizeDocks({favoured, settings}, {height(), 1}, Qt::Vertical);
}

void PanelArea::applyUsualSizes() {
  m_hasSizes = true;
  for (const Panel& panel : m_panels) {
    if (panel.dock->isHidden()) continue;
    const bool left = panel.usual_side == Qt::LeftDockWidgetArea;
    if (panel.usual_side == Qt::BottomDockWidgetArea)
      resizeDocks({panel.dock}, {plots_height}, Qt::Vertical);
    else
      resizeDocks({panel.dock}, {left ? m_room.left_width : m_room.right_width}, Qt::Horizontal);
  }
  if (QDockWidget* upper = panel("candidates"), *lower = panel("settings");
      upper && lower && !upper->isHidden() && !lower->isHidden())
    resizeDocks({upper, lower}, {candidates_share, 100 - candidates_share}, Qt::Vertical);
  raiseFirstOfEachPlace();
  m_sizes.clear();
  QTimer::singleShot(0, this, &PanelArea::rememberSizes);
}

void PanelArea::raiseFirstOfEachPlace() {
  // NOLINTNEXTLINE(modernize-loop-convert): clang 14 does not compile gcc 12's std::views::reverse
  for (auto panel = m_panels.rbegin(); panel != m_panels.rend(); ++panel)
    if (!panel->dock->isHidden() && !panel->dock->isFloating()) panel->dock->raise();
}

void PanelArea::showEvent(QShowEvent* event) {
  QMainWindow::showEvent(event);
  if (!m_hasSizes) return applyUsualSizes();
  if (m_sizes.empty()) QTimer::singleShot(0, this, &PanelArea::rememberSizes);
}

void PanelArea::resizeEvent(QResizeEvent* event) {
  QMainWindow::resizeEvent(event);
  keepTuned();
  restoreSizes();
}

/// Also when a border between panels is let go, and when a panel needs another height.
bool PanelArea::event(QEvent* event) {
  const bool done = QMainWindow::event(event);
  if (event->type() == QEvent::LayoutRequest) {
    prepareTabBars();
    keepTuned();
  }
  if (event->type() == QEvent::MouseButtonRelease) QTimer::singleShot(0, this, &PanelArea::rememberSizes);
  return done;
}

void PanelArea::reset() {
  m_wishes = {};
  for (Panel& panel : m_panels) {
    panel.wanted = panel.usually_shown;
    panel.dock->setFloating(false);
    removeDockWidget(panel.dock);
  }
  for (Panel& panel : m_panels) place(panel);
  arrangeFor(m_window);
  applyUsualSizes();
  for (const Panel& panel : m_panels) emit wantedChanged(panel.dock->objectName(), panel.wanted);
}

WindowLayout PanelArea::state() const {
  WindowLayout layout;
  layout.docks = saveState(layout_version);
  layout.sides = m_wishes;
  layout.sizes = m_sizes;
  for (const Panel& panel : m_panels) {
    layout.known << panel.dock->objectName();
    if (panel.wanted) layout.shown << panel.dock->objectName();
  }
  return layout;
}

bool PanelArea::setState(const WindowLayout& layout) {
  if (!is_dock_state(layout.docks, layout_version) || !restoreState(layout.docks, layout_version))
    return false;
  m_hasSizes = !layout.sizes.empty();  // empty: of a window that had no room for panels
  m_sizes = layout.sizes;
  m_wishes = layout.sides;
  for (Panel& panel : m_panels) {
    const QString id = panel.dock->objectName();
    const bool is_known = layout.known.contains(id);
    panel.wanted = is_known ? layout.shown.contains(id) : panel.usually_shown;
    if (!panel.dock->isFloating() && (!is_known || dockWidgetArea(panel.dock) == Qt::NoDockWidgetArea))
      place(panel);
    if (panel.dock->isFloating()) bring_onto_screen(*panel.dock);
    emit wantedChanged(id, panel.wanted);
  }
  arrangeFor(m_window);
  if (!isVisible()) return true;
  if (!m_hasSizes) applyUsualSizes();
  QTimer::singleShot(0, this, &PanelArea::rememberSizes);
  return true;
}

bool PanelArea::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::Close && watched->isWidgetType() && isVisible())
    want(watched->objectName(), false);
  return QMainWindow::eventFilter(watched, event);
}

}  // namespace abrazo::app
