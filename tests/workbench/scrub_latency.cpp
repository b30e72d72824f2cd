// How long it takes from moving the mouse in the timeline to the picture of that frame on the screen, in the
// whole window with the solver running. Prints; not a test.
//
//   scrub_latency [width height [seconds of history [FILE]]]    FILE: a session, whose frames are read from
//   disk

#include <QApplication>
#include <QElapsedTimer>
#include <QMouseEvent>
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <vector>

#include "app/workbench/shell/actions.hpp"
#include "app/workbench/shell/main_window.hpp"
#include "widgets/scene/view/scene_view.hpp"
#include "widgets/timeline/timeline_view.hpp"

namespace {

using namespace abrazo;

double ms(const QElapsedTimer& clock) {
  return static_cast<double>(clock.nsecsElapsed()) * 1e-6;
}

template <typename Condition>
bool until(Condition reached, int patience_ms) {
  QElapsedTimer clock;
  clock.start();
  while (!reached()) {
    if (clock.elapsed() >= patience_ms) return false;
    QApplication::processEvents(QEventLoop::AllEvents | QEventLoop::WaitForMoreEvents, 5);
  }
  return true;
}

void send(QWidget& to, QEvent::Type type, const QPointF& place, Qt::MouseButton button) {
  QMouseEvent event(type, place, to.mapToGlobal(place.toPoint()), button,
                    type == QEvent::MouseButtonRelease ? Qt::NoButton : Qt::LeftButton, {});
  QApplication::sendEvent(&to, &event);
}

void report(const char* what, std::vector<double> taken) {
  if (taken.empty()) return;
  std::sort(taken.begin(), taken.end());
  const auto at = [&taken](double share) {
    return taken[static_cast<std::size_t>(share * static_cast<double>(taken.size() - 1))];
  };
  std::printf("%s: %zu pictures, p50 %.1f ms, p95 %.1f ms, p99 %.1f ms, longest %.1f ms\n", what,
              taken.size(), at(0.5), at(0.95), at(0.99), taken.back());
}

/// Places of a slow hand going to and fro over what is in view.
double place_at(const widgets::TimelineAxis& axis, double last_s, int step) {
  const double right = std::min(axis.right_px(), axis.x(last_s)), left = std::max(axis.left_px, axis.x(0));
  const int there = static_cast<int>(right - left) - 4;
  const int along = step * 7 % (2 * there);
  return left + 2 + (along < there ? along : 2 * there - along);
}

/// One request after another: each waits for its picture.
std::vector<double> one_by_one(app::MainWindow& window, int requests) {
  widgets::TimelineView& timeline = window.timeline();
  std::vector<double> taken;
  for (int i = 0; i < requests; ++i) {
    const auto before = window.scene().renderedFrames();
    const FrameSnapshotPtr shown = window.ticker().shown();
    QElapsedTimer clock;
    clock.start();
    send(timeline, QEvent::MouseMove, {place_at(timeline.axis(), window.ticker().playback().last_s, i), 60},
         Qt::NoButton);
    const bool there = until([&] { return window.scene().renderedFrames() > before; }, 1000);
    if (there && window.ticker().shown() != shown) taken.push_back(ms(clock));
  }
  return taken;
}

/// A hand that does not wait: a move every 8 ms; of each picture, how old the move is that it shows.
std::vector<double> in_one_go(app::MainWindow& window, int moves) {
  widgets::TimelineView& timeline = window.timeline();
  std::vector<double> taken;
  QElapsedTimer clock;
  clock.start();
  double asked_at = 0, shown_from = 0;
  const QMetaObject::Connection ready =
      QObject::connect(&window.ticker(), &app::FrameTicker::frameReady, [&] { shown_from = asked_at; });
  auto pictures = window.scene().renderedFrames();
  for (int i = 0; i < moves; ++i) {
    asked_at = ms(clock);
    send(timeline, QEvent::MouseMove, {place_at(timeline.axis(), window.ticker().playback().last_s, i), 60},
         Qt::NoButton);
    while (ms(clock) < 8.0 * (i + 1)) {
      QApplication::processEvents(QEventLoop::AllEvents, 1);
      if (window.scene().renderedFrames() == pictures) continue;
      pictures = window.scene().renderedFrames();
      taken.push_back(ms(clock) - shown_from);
    }
  }
  QObject::disconnect(ready);
  return taken;
}

}  // namespace

int main(int argc, char** argv) {
  const int width = argc > 2 ? std::atoi(argv[1]) : 1600, height = argc > 2 ? std::atoi(argv[2]) : 1000;
  const double wanted_s = argc > 3 ? std::atof(argv[3]) : 12;
  QApplication application(argc, argv);
  app::UserSettings remembered;
  app::MainWindow window(remembered);
  window.setPlaysAsLive(true);
  window.setTheme(widgets::Theme::Dark);
  app::add_all_actions(window);
  window.resize(width, height);
  window.show();
  argc > 4 ? window.openFiles({QString::fromLocal8Bit(argv[4])}) : window.openDemo();
  if (!until([&] { return window.ticker().playback().last_s > wanted_s; }, 120'000)) {
    std::fprintf(stderr, "the demo did not start\n");
    return 1;
  }
  const auto span = window.session()->history().span();
  std::printf("window %dx%d, scene %dx%d, %.0f s of history, %.0f of them on disk only, the solver running\n",
              width, height, window.scene().width(), window.scene().height(), span.last_s,
              std::max(0.0, span.memory_first_s - span.first_s));
  widgets::TimelineView& timeline = window.timeline();
  send(timeline, QEvent::MouseButtonPress, {timeline.axis().x(2), 60}, Qt::LeftButton);
  until([] { return false; }, 300);
  report("one request after another", one_by_one(window, 150));
  report("a move every 8 ms, age of the newest shown", in_one_go(window, 400));
  send(timeline, QEvent::MouseButtonRelease, {timeline.axis().x(2), 60}, Qt::LeftButton);
  return 0;
}
