// saving_victim FILE: the workbench sets a marker and saves the demo's project into FILE by keys, about once
// a second, until it is killed. Says on standard output, with the time of the monotonic clock [s]: "marked N
// TIME" when there are N markers, "saving N TIME" when they begin to be saved, "saved N TIME" and "refused N
// TIME" at the end of that.
#include <QAction>
#include <QApplication>
#include <QTest>
#include <QTimer>
#include <chrono>
#include <cstdio>

#include "app/workbench/project/project_desk.hpp"
#include "app/workbench/shell/actions.hpp"
#include "app/workbench/shell/main_window.hpp"
#include "core/base/file_limit.hpp"

using namespace abrazo;

namespace {

void say(const char* what, std::size_t markers) {
  const double now_s =
      std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
  std::printf("%s %zu %.3f\n", what, markers, now_s);
  std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
  take_file_limit_for_full_disk();
  QApplication application(argc, argv);
  if (argc != 2) return 2;
  const QString file = QString::fromLocal8Bit(argv[1]);
  app::UserSettings remembered;
  app::MainWindow window(remembered);
  window.setPlaysAsLive(true);
  window.resize(1000, 700);
  const app::Rooms rooms = app::add_all_actions(window);
  rooms.project.setAsks(true);
  rooms.project.askLibrary = [] { return app::ProjectDesk::LibraryAnswer::SaveWithout; };
  window.show();
  QApplication::setActiveWindow(&window);  // a bare display has nobody who would
  window.openDemo();
  const auto markers = [&window] {
    const Project& project = window.document().project();
    std::size_t count = project.markers.all().size();
    for (const auto& [take, of_take] : project.take_markers) count += of_take.all().size();
    return count;
  };
  std::size_t saving = 0, turns = 0;
  QObject::connect(&rooms.project, &app::ProjectDesk::saved, [&] { say("saved", saving); });
  QObject::connect(&rooms.project, &app::ProjectDesk::notSaved, [&] { say("refused", saving); });
  QTimer turn;
  QObject::connect(&turn, &QTimer::timeout, [&] {
    if (!window.session() || !window.ticker().shown() || window.ticker().shown()->index < 10) return;
    if (QAction* mark = app::action_of(window, "timeline.marker")) mark->trigger();
    say("marked", markers());
    // Every third turn is left unsaved, so that there is something to be offered.
    if (++turns % 3 == 0 || rooms.project.isSaving()) return;
    saving = markers();
    say("saving", saving);
    if (rooms.project.file().isEmpty())
      rooms.project.saveAs(file);
    else
      QTest::keyClick(&window, Qt::Key_S, Qt::ControlModifier);
  });
  turn.start(1000);
  return QApplication::exec();
}
