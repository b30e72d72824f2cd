#include <QMenu>
#include <algorithm>

#include "app/workbench/labels/annotation_desk.hpp"
#include "app/workbench/shell/actions.hpp"
#include "app/workbench/shell/main_window.hpp"
#include "widgets/common/message_bar.hpp"
#include "widgets/timeline/quick_entry.hpp"
#include "widgets/timeline/timeline_view.hpp"

namespace abrazo::app {
namespace {

using widgets::QuickEntry;
using widgets::TimelineView;

void add(MainWindow& window, double time_s, const QString& name) {
  Markers next = window.document().markers();
  const int id = next.add(time_s, name.toStdString());
  window.document().changeMarkers(next, "add marker");
  window.timeline().selectMarker(id);
}

QPoint over_the_timeline(const TimelineView& timeline, double time_s) {
  return {static_cast<int>(timeline.axis().x(time_s)), 0};
}

void add_named(MainWindow& window) {
  if (!window.session()) return;
  const double time_s = window.ticker().playback().cursor_s;  // where the key was pressed, also while live
  TimelineView& timeline = window.timeline();
  QuickEntry::open(timeline, over_the_timeline(timeline, time_s), "Name of the marker", {},
                   [&window, time_s](const QString& name) -> QString {
                     add(window, time_s, name);
                     return {};
                   });
}

void rename(MainWindow& window, int id) {
  TimelineView& timeline = window.timeline();
  const Marker* marker = window.document().markers().find(id);
  if (!marker) return window.messages().showInformation("Select a marker first: click its flag");
  QuickEntry::open(timeline, over_the_timeline(timeline, marker->time_s), "Name of the marker",
                   QString::fromStdString(marker->name), [&window, id](const QString& name) -> QString {
                     Markers next = window.document().markers();
                     next.rename(id, name.toStdString());
                     window.document().changeMarkers(next, "rename marker");
                     return {};
                   });
}

void remove(MainWindow& window, AnnotationDesk& desk) {
  Document& document = window.document();
  if (document.labels().selected() != 0)
    return void(document.edit(remove_label(document.annotations(), desk.place())));
  Markers next = document.markers();
  const int id = window.timeline().selectedMarker();
  if (!next.find(id))
    return window.messages().showInformation("Select a label or a marker first: click it in the timeline");
  next.remove(id);
  document.changeMarkers(next, "delete marker");
}

/// Of moves of the sources and of labels.
std::vector<double> edges_of(const MainWindow& window, const AnnotationDesk& desk, double here, bool on) {
  const auto& tracks = window.timeline().tracks();
  std::vector<double> edges;
  if (const auto edge = on ? tracks.edge_after(here) : tracks.edge_before(here)) edges.push_back(*edge);
  if (const auto edge = edge_beside(window.document().annotations(), desk.place(), on))
    edges.push_back(*edge);
  return edges;
}

/// To the nearest marker or edge in that direction.
void jump(MainWindow& window, const AnnotationDesk& desk, bool on) {
  const Markers& markers = window.document().markers();
  constexpr double apart_s = 1e-6;
  const double here = window.ticker().playback().cursor_s;
  const Marker* marker = on ? markers.after(here) : markers.before(here);
  std::optional<double> there;
  if (marker) there = marker->time_s;
  for (const double edge : edges_of(window, desk, here, on))
    if (on ? edge > here + apart_s && (!there || edge < *there)
           : edge < here - apart_s && (!there || edge > *there))
      there = edge;
  if (!there)
    return window.messages().showInformation(on ? "No marker, move or label begins after this"
                                                : "No marker, move or label begins before this");
  window.ticker().seek(*there);
  if (marker && marker->time_s == *there) window.timeline().selectMarker(marker->id);
}

}  // namespace

void add_marker_actions(MainWindow& window, AnnotationDesk& desk) {
  QMenu* menu = menu_of(window, "Timeline");
  TimelineView& timeline = window.timeline();
  add_action(window, menu, "Marker", {QKeySequence("M")},
             [&window] { add(window, window.ticker().playback().cursor_s, {}); });
  add_action(window, menu, "Marker with a name…", {QKeySequence("Shift+M")},
             [&window] { add_named(window); });
  add_action(window, menu, "Previous marker or edge", {QKeySequence("Ctrl+Left")},
             [&window, &desk] { jump(window, desk, false); });
  add_action(window, menu, "Next marker or edge", {QKeySequence("Ctrl+Right")},
             [&window, &desk] { jump(window, desk, true); });
  add_action(window, menu, "Rename marker…", {},
             [&window] { rename(window, window.timeline().selectedMarker()); });
  add_action(window, menu, "Delete label or marker", {QKeySequence("Del")},
             [&window, &desk] { remove(window, desk); });
  QObject::connect(&timeline, &TimelineView::markerEntryRequested, &window,
                   [&window](int id) { rename(window, id); });
}

}  // namespace abrazo::app
