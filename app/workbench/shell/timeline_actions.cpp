#include <QAction>
#include <QMenu>

#include "app/workbench/base/error_words.hpp"
#include "app/workbench/shell/actions.hpp"
#include "app/workbench/shell/main_window.hpp"
#include "core/base/text.hpp"
#include "widgets/timeline/quick_entry.hpp"
#include "widgets/timeline/timeline_view.hpp"
#include "widgets/timeline/transport_bar.hpp"

namespace abrazo::app {
namespace {

using widgets::QuickEntry;
using widgets::TimelineLane;
using widgets::TimelineView;
using widgets::TransportBar;

constexpr double zoom_step = 0.7;
const QPoint above_the_time(150, 0);

/// Checks that a place exists. @return the error, or empty
QString find(MainWindow& window, const QString& text, double& time_s) {
  const FrameTicker& ticker = window.ticker();
  const auto place = parse_time_place(text.toStdString(), window.transport().rate());
  if (!place) return words(place.error());
  if (!ticker.history()) return "Nothing is open yet";
  const auto found = find_time(*place, *ticker.history(), ticker.playback().cursor_s);
  if (!found) return words(found.error());
  time_s = *found;
  return {};
}

void ask_place(MainWindow& window) {
  QuickEntry::open(window.transport(), above_the_time,
                   "Go to frame or time: 690, 11.5s, 0:11.5, 00:00:11:15, +30, -1s",
                   window.transport().timeText(), [&window](const QString& text) {
                     double time_s = 0;
                     const QString wrong = find(window, text, time_s);
                     if (wrong.isEmpty()) window.ticker().seek(time_s);
                     return wrong;
                   });
}

void ask_range(MainWindow& window) {
  const auto range = window.ticker().playback().range();
  const auto written = [](double time_s) { return QString::fromStdString(clock_text(time_s)); };
  const QString start = range ? written(range->from_s) + " to " + written(range->to_s) : QString();
  QuickEntry::open(window.transport(), above_the_time, "In and out: 690 to 900, 0:11.5 to 0:15", start,
                   [&window](const QString& text) -> QString {
                     const QStringList ends = text.split(" to ");
                     if (ends.size() != 2) return "Write two places with \"to\" between them: 0:11.5 to 0:15";
                     double from_s = 0, to_s = 0;
                     QString wrong = find(window, ends[0], from_s);
                     if (wrong.isEmpty()) wrong = find(window, ends[1], to_s);
                     if (wrong.isEmpty() && from_s == to_s)
                       wrong = "In and out are the same; they need a frame between them";
                     if (wrong.isEmpty()) window.ticker().setRange(from_s, to_s);
                     return wrong;
                   });
}

void ask_speed(MainWindow& window) {
  QuickEntry::open(
      window.transport(), above_the_time, "Speed, 0.01 to 10",
      QString::number(std::abs(window.ticker().playback().speed)), [&window](QString text) -> QString {
        text = text.remove("×").trimmed();
        const auto speed = parse_number(text.toStdString());
        if (!speed || *speed < Playback::slowest || *speed > Playback::fastest)
          return "'" + text +
                 "' is not a speed; write a number from 0.01 to 10, 1 is the speed of the recording";
        window.ticker().setSpeed(*speed);
        return {};
      });
}

void add_lanes(MainWindow& window, QMenu* menu) {
  TimelineView& timeline = window.timeline();
  widgets::TimelineLanes remembered;
  if (const QString names = window.remembered().timelineLanes(); !names.isEmpty())
    remembered.set_text(names.toStdString());
  timeline.setLanes(remembered);
  for (int lane = 0; lane < widgets::timeline_lane_count; ++lane) {
    const auto which = static_cast<TimelineLane>(lane);
    const std::string_view name = widgets::info_of(which).name;
    QAction* action = add_action(
        window, menu, "Lane: " + QString::fromUtf8(name.data(), static_cast<int>(name.size())).toLower(), {},
        [&timeline, which] {
          widgets::TimelineLanes lanes = timeline.lanes();
          lanes.set_shown(which, !lanes.is_shown(which));
          timeline.setLanes(lanes);
        });
    action->setCheckable(true);
    const auto show = [action, which, &timeline] { action->setChecked(timeline.lanes().is_shown(which)); };
    QObject::connect(&timeline, &TimelineView::lanesChanged, action, show);
    show();
  }
  QObject::connect(&timeline, &TimelineView::lanesChanged, &window, [&window, &timeline] {
    window.remembered().setTimelineLanes(QString::fromStdString(timeline.lanes().text()));
  });
}

void add_formats(MainWindow& window, QMenu* menu) {
  TransportBar& transport = window.transport();
  const std::pair<const char*, TimeFormat> formats[] = {{"Time in minutes and seconds", TimeFormat::Clock},
                                                        {"Time in seconds", TimeFormat::Seconds},
                                                        {"Time in frames", TimeFormat::Frames},
                                                        {"Time as timecode", TimeFormat::Timecode}};
  for (const auto& [name, format] : formats)
    add_action(window, menu, name, {}, [&transport, format = format] { transport.setFormat(format); });
  QObject::connect(&transport, &TransportBar::formatRequested, &transport, &TransportBar::setFormat);
  QObject::connect(&window.document(), &Document::began, &transport, [&window, &transport] {
    if (window.session()) transport.setRate(window.session()->material().input.fps);
  });
}

}  // namespace

void add_timeline_actions(MainWindow& window) {
  QMenu* menu = menu_of(window, "Timeline");
  add_action(window, menu, "Go to frame or time…", {QKeySequence("G")}, [&window] { ask_place(window); });
  add_action(window, menu, "In and out by number…", {}, [&window] { ask_range(window); });
  add_action(window, menu, "Speed by number…", {}, [&window] { ask_speed(window); });
  menu->addSeparator();
}

void add_lane_actions(MainWindow& window) {
  QMenu* menu = menu_of(window, "Timeline");
  TimelineView& timeline = window.timeline();
  menu->addSeparator();
  add_action(window, menu, "Timeline: show all", {QKeySequence("Z")}, [&timeline] { timeline.showAll(); });
  add_action(window, menu, "Timeline: zoom to in and out", {QKeySequence("Shift+Z")},
             [&timeline] { timeline.showRange(); });
  add_action(window, menu, "Timeline: shorter span", {}, [&timeline] { timeline.zoom(zoom_step); });
  add_action(window, menu, "Timeline: longer span", {}, [&timeline] { timeline.zoom(1 / zoom_step); });
  menu->addSeparator();
  add_formats(window, menu);
  menu->addSeparator();
  add_lanes(window, menu_of(window, "Lanes"));
  QObject::connect(&window.transport(), &TransportBar::placeEntryRequested, &window,
                   [&window] { ask_place(window); });
  QObject::connect(&window.transport(), &TransportBar::speedEntryRequested, &window,
                   [&window] { ask_speed(window); });
  QObject::connect(&timeline, &TimelineView::rangeEntryRequested, &window, [&window] { ask_range(window); });
  QObject::connect(&timeline, &TimelineView::menuRequested, menu,
                   [menu](const QPoint& at) { menu->popup(at); });
}

}  // namespace abrazo::app
