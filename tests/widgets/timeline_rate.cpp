// What it costs to draw the timeline and to take new frames, with hours of history. Prints; not a test.

#include <QApplication>
#include <QElapsedTimer>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <functional>
#include <vector>

#include "tests/widgets/synthetic_frames.hpp"
#include "widgets/common/theme.hpp"
#include "widgets/timeline/timeline_view.hpp"

namespace {

using namespace abrazo;
using namespace abrazo::widgets;

constexpr double rate_hz = 120;

TrackRow row(int frame) {
  static const char* const moves[] = {"turn", "open hold", "closed hold", "walk", "in and out"};
  const int source = frame / 37;  // a new source three times a second: more than a dance has
  return {.time_s = frame / rate_hz,
          .pair = source % 8,
          .take = (source % 8) / 4,
          .label = moves[frame / 173 % 5],
          .source_changed = frame % 37 == 0,
          .leader = frame / 4001 % 2 == 0 ? Leader::User : Leader::Partner,
          .cost = 0.2 + 0.1 * std::sin(frame / 50.0) + (frame % 1009 == 0 ? 0.8 : 0),
          .energy = 0.02 + 0.01 * std::sin(frame / 31.0)};
}

/// Of processor time: other programs do not count.
double median_ms(int times, const std::function<void()>& act) {
  std::vector<double> taken;
  for (int i = 0; i < times; ++i) {
    const std::clock_t before = std::clock();
    act();
    taken.push_back(1000.0 * static_cast<double>(std::clock() - before) / CLOCKS_PER_SEC);
  }
  std::nth_element(taken.begin(), taken.begin() + times / 2, taken.end());
  return taken[static_cast<std::size_t>(times / 2)];
}

void measure(int frames) {
  TimelineView view;
  TimelineLanes all;
  for (int lane = 0; lane < timeline_lane_count; ++lane) all.set_shown(static_cast<TimelineLane>(lane), true);
  view.setLibrary(test::two_take_library());
  view.setLanes(all);
  view.resize(1600, view.sizeHint().height());
  view.show();
  QElapsedTimer until_exposed;
  until_exposed.start();
  while (until_exposed.elapsed() < 300) QApplication::processEvents(QEventLoop::AllEvents, 10);
  std::vector<TrackRow> rows;
  for (int frame = 0; frame < frames; ++frame) rows.push_back(row(frame));
  view.append(rows);
  Playback playback;
  playback.extend(0, frames / rate_hz);
  const FrameHistory empty;
  const auto draw = [&view] {
    view.setColours(palette_of(Theme::Dark));  // nothing of the last picture is kept
    view.repaint();
  };
  int next = frames;
  const auto refresh = [&] {  // as the window does it, with ten new frames
    std::vector<TrackRow> fresh;
    for (int i = 0; i < 10; ++i) fresh.push_back(row(next++));
    view.append(fresh);
    playback.extend(0, next / rate_hz);
    view.refresh(empty, playback);
    view.repaint();
  };
  view.refresh(empty, playback);
  const double usual = median_ms(21, draw), live = median_ms(21, refresh);
  view.showAll();
  const double whole = median_ms(21, draw), whole_live = median_ms(21, refresh);
  playback.seek(frames / rate_hz / 2);
  view.refresh(empty, playback);
  const double cursor = median_ms(21, [&] {
    playback.seek(playback.cursor_s + 0.01);
    view.showPlayback(playback);
    view.repaint();
  });
  std::printf(
      "%8d frames (%.1f h): 35 s in view %.2f ms, with new frames %.2f ms; all in view %.2f ms, with new "
      "frames %.2f ms; the cursor alone %.2f ms\n",
      frames, frames / rate_hz / 3600, usual, live, whole, whole_live, cursor);
}

}  // namespace

int main(int argc, char** argv) {
  QApplication application(argc, argv);
  apply_theme(application, palette_of(Theme::Dark));
  for (const int frames : {1'000, 100'000, 1'000'000}) measure(frames);
  return 0;
}
