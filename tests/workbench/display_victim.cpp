// display_victim: the workbench records its demo, with a marker that was not saved, until its display is
// gone or it is told to end. Says on standard output "recording FILE", then every 50 ms "TIME MONOTONIC":
// session time of the newest frame that was solved, and when it was looked at [s].
#include <QAction>
#include <QApplication>
#include <QTimer>
#include <chrono>
#include <cstdio>

#include "app/workbench/document/live_session.hpp"
#include "app/workbench/project/project_desk.hpp"
#include "app/workbench/shell/actions.hpp"
#include "app/workbench/shell/main_window.hpp"
#include "app/workbench/start/termination.hpp"
#include "app/workbench/takes/take_desk.hpp"

using namespace abrazo;

namespace {

double monotonic_s() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}
}  // namespace

int main(int argc, char** argv) {
  QApplication application(argc, argv);
  app::UserSettings remembered;
  app::MainWindow window(remembered);
  window.setPlaysAsLive(true);
  window.setTheme(widgets::Theme::Dark);
  window.resize(1000, 700);
  const app::Rooms rooms = app::add_all_actions(window);
  rooms.project.setAsks(true);
  const app::Termination termination;
  app::close_when_told(window, rooms.project, termination);
  window.show();
  window.openDemo();
  auto* takes = window.findChild<app::TakeDesk*>();
  bool is_recording = false;
  QTimer look;
  QObject::connect(&look, &QTimer::timeout, [&] {
    auto* session = window.session();
    if (!session || !window.ticker().shown()) return;
    if (!is_recording) {
      is_recording = true;
      takes->toggle();
      if (QAction* mark = app::action_of(window, "timeline.marker")) mark->trigger();
      return;
    }
    const auto recorder = session->engine().recorder();
    if (!recorder || recorder->state().frames == 0) return;
    static const bool said = std::printf("recording %s\n", recorder->state().path.c_str()) > 0;
    const auto newest = session->engine().latest().newest();
    if (said && newest) std::printf("%.6f %.6f\n", newest->time_s, monotonic_s());
    std::fflush(stdout);
  });
  look.start(50);
  return QApplication::exec();
}
