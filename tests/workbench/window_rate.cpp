// What the whole window costs: pictures per second and processor time per picture while the solver runs at
// 120 Hz, while a recorded range plays and while a parked picture is turned; and the longest time in which
// the window did not answer, for everything that could hold it up. Prints; not a test.
//   window_rate [--seconds N] [--size WxH] [FILE...]   each file (library, manifest, motion) is opened in
//   turn

#include <QAction>
#include <QApplication>
#include <QElapsedTimer>
#include <QMouseEvent>
#include <QPushButton>
#include <QTemporaryDir>
#include <QTimer>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <functional>
#include <string>

#include "app/workbench/shell/actions.hpp"
#include "app/workbench/shell/main_window.hpp"
#include "app/workbench/start/allocation.hpp"
#include "app/workbench/start/responsiveness.hpp"
#include "app/workbench/stream/stream_desk.hpp"
#include "core/opening/generated_set.hpp"
#include "widgets/scene/view/scene_view.hpp"

namespace abrazo::app {
namespace {

/// The poses of a clip with one between each two: an input of twice the rate.
Clip doubled(const Clip& clip) {
  Clip twice{clip.name, 2 * clip.fps, {}};
  for (std::size_t p = 0; p + 1 < clip.poses.size(); ++p) {
    twice.poses.push_back(clip.poses[p]);
    twice.poses.push_back(0.5 * (clip.poses[p] + clip.poses[p + 1]));
  }
  return twice;
}

/// The demo with a leader who moves at 120 Hz or more.
Result<Material> fast_demo(const Progress& progress) {
  auto demo = generated_dance(progress);
  while (demo && demo->input.fps < 119) demo->input = doubled(demo->input);
  return demo;
}

double thread_s() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

/// Processor time of the window's thread and of the software renderer's: what a picture costs without the
/// solver.
double picture_s() {
  double seconds = thread_s();
  for (const auto& task : std::filesystem::directory_iterator("/proc/self/task")) {
    std::string name;
    std::ifstream(task.path() / "comm") >> name;
    double used_ns = 0;
    std::ifstream(task.path() / "schedstat") >> used_ns;
    if (name.starts_with("llvmpipe")) seconds += 1e-9 * used_ns;
  }
  return seconds;
}

/// Names what took longer than it was told to watch for.
class Application : public QApplication {
 public:
  using QApplication::QApplication;
  double watched_ms = 1e9;

  bool notify(QObject* receiver, QEvent* event) override {
    const QByteArray who =
        QByteArray(receiver->metaObject()->className()) + ' ' + receiver->objectName().toUtf8();
    const int type = event->type();
    const double before_s = thread_s();
    QElapsedTimer clock;
    clock.start();
    const bool accepted = QApplication::notify(receiver, event);
    const double ms = 1e-6 * static_cast<double>(clock.nsecsElapsed());
    const double own_ms = 1000 * (thread_s() - before_s);
    if (own_ms > watched_ms)
      std::printf("  %5.0f ms, %5.0f of its own: event %d of %s\n", ms, own_ms, type, who.constData());
    return accepted;
  }
};

class Measurement {
 public:
  Measurement(MainWindow& window, Responsiveness& responsiveness, double seconds)
      : m_window(window), m_responsiveness(responsiveness), m_seconds(seconds) {
    std::printf("%-44s %6s %9s %9s %9s %8s %8s\n", "", "fps", "ms/image", "GUI busy", "solved/s", "99 % ms",
                "longest");
  }

  /// @param each  called every 16 ms, as a hand on the mouse would
  void during(const char* what, const std::function<void()>& each = {}) {
    QTimer hand;
    if (each) QObject::connect(&hand, &QTimer::timeout, each);
    hand.start(16);
    QElapsedTimer clock;
    measured(what, [&] {
      clock.start();
      while (static_cast<double>(clock.elapsed()) < 1000 * m_seconds) turn();
    });
  }

  void until(const char* what, const std::function<void()>& begin, const std::function<bool()>& reached) {
    QTimer beat;  // wakes the loop below
    beat.start(16);
    QElapsedTimer clock;
    measured(what, [&] {
      clock.start();
      begin();
      while (!reached() && clock.elapsed() < 120'000) turn();
      for (const qint64 end = clock.elapsed() + 1000; clock.elapsed() < end;) turn();
    });
  }

 private:
  static void turn() { QApplication::processEvents(QEventLoop::WaitForMoreEvents); }

  std::uint64_t solved() const {
    const auto newest = m_window.session() ? m_window.session()->latest().newest() : nullptr;
    return newest ? newest->index : 0;
  }

  void measured(const char* what, const std::function<void()>& run) {
    m_responsiveness.begin(what);
    const auto pictures = m_window.scene().renderedFrames(), steps = solved();
    const double processor_s = picture_s();
    const double own_s = thread_s();
    QElapsedTimer clock;
    clock.start();
    run();
    const double seconds = 1e-9 * static_cast<double>(clock.nsecsElapsed());
    const double used_s = picture_s() - processor_s;
    const auto rendered = static_cast<double>(m_window.scene().renderedFrames() - pictures);
    const auto stepped = solved() >= steps ? static_cast<double>(solved() - steps) : 0;
    const AnswerTimes& times = m_responsiveness.times();
    std::printf("%-44s %6.1f %9.1f %8.0f%% %9.1f %8.0f %8.0f\n", what, rendered / seconds,
                rendered > 0 ? 1000 * used_s / rendered : 0, 100 * (thread_s() - own_s) / seconds,
                stepped / seconds, times.within_ms(0.99), times.longest_ms());
    std::fflush(stdout);
  }

  MainWindow& m_window;
  Responsiveness& m_responsiveness;
  double m_seconds;
};

/// The left button held over the scene, to and fro.
class DragOfScene {
 public:
  explicit DragOfScene(QWidget& scene)
      : m_under(scene.childAt(scene.width() / 4, scene.height() / 2)), m_from(m_under->rect().center()) {
    send(QEvent::MouseButtonPress);
  }
  void operator()() {
    ++m_step;
    send(QEvent::MouseMove);
  }

 private:
  void send(QEvent::Type type) {
    const QPointF at = m_from + QPointF(200 * std::sin(0.05 * m_step), 0);
    QMouseEvent event(type, at, m_under->mapToGlobal(at.toPoint()), Qt::LeftButton, Qt::LeftButton, {});
    QApplication::sendEvent(m_under, &event);
  }

  QWidget* m_under;
  QPointF m_from;
  int m_step = 0;
};

struct Asked {
  double seconds = 6;
  double watched_ms = 1e9;
  QSize size = {1280, 720};
  QStringList files, triggers;
};

Asked asked_of(const QStringList& words) {
  Asked asked;
  for (int w = 1; w < words.size(); ++w) {
    if (words[w] == "--trigger" && w + 1 < words.size())
      asked.triggers << words[++w];
    else if (words[w] == "--seconds" && w + 1 < words.size())
      asked.seconds = words[++w].toDouble();
    else if (words[w] == "--trace" && w + 1 < words.size())
      asked.watched_ms = words[++w].toDouble();
    else if (words[w] == "--size" && w + 1 < words.size())
      asked.size = {words[w + 1].section('x', 0, 0).toInt(), words[w + 1].section('x', 1, 1).toInt()}, ++w;
    else
      asked.files << words[w];
  }
  return asked;
}

/// Presses the button of this text in a dialog that is open.
void press(const QString& text) {
  for (QWidget* top : QApplication::topLevelWidgets())
    for (QPushButton* button : top->findChildren<QPushButton*>())
      if (button->isVisible() && button->text().startsWith(text)) return button->click();
  std::printf("no button is called %s\n", text.toUtf8().constData());
}

/// Chooses what the menus call so ("ENTRY", or "ENTRY>BUTTON" to press a button in the dialog that it opens),
/// and closes a modal dialog when its time is over.
bool trigger(MainWindow& window, const QString& asked, double seconds) {
  const QString text = asked.section('>', 0, 0), button = asked.section('>', 1);
  if (!button.isEmpty()) QTimer::singleShot(200, [button] { press(button); });
  for (QAction* action : window.findChildren<QAction*>()) {
    if (!QString(action->text()).remove('&').startsWith(text)) continue;
    QTimer::singleShot(static_cast<int>(1000 * seconds), [] {
      if (QWidget* dialog = QApplication::activeModalWidget()) dialog->close();
    });
    action->trigger();
    return true;
  }
  std::printf("no menu has an entry %s\n", text.toUtf8().constData());
  return false;
}

void measure(MainWindow& window, Responsiveness& responsiveness, const Asked& asked) {
  Measurement measurement(window, responsiveness, asked.seconds);
  bool opened = false, failed = false;
  const QObject here;
  QObject::connect(&window.document(), &Document::began, &here, [&opened] { opened = true; });
  QObject::connect(&window, &MainWindow::failed, &here, [&failed](const QString& why) {
    failed = true;
    std::printf("could not be opened: %s\n", why.toUtf8().constData());
  });
  Settings settings = preset("responsive").value();
  settings.step_rate_hz = 120;
  measurement.until(
      "opening the demo", [&] { window.openMaterial(fast_demo); }, [&] { return opened; });
  if (!opened) return;
  std::printf("input: %.0f Hz, step rate: %.0f Hz\n", window.session()->material().input.fps,
              settings.step_rate_hz);

  window.document().putSettings(settings);
  measurement.during("solving at 120 Hz, shown live");
  FrameTicker& ticker = window.ticker();
  ticker.goToStart();
  ticker.toggle();
  measurement.during("playing what was recorded, solver running");
  ticker.pause();
  measurement.during("parked, camera turning, solver running", DragOfScene(window.scene()));
  measurement.during("parked, untouched, solver running");
  window.session()->push(PauseInput{true});
  measurement.during("parked, untouched, input paused");
  measurement.during("scrubbing", [&, step = 0]() mutable {
    const auto span = window.session()->history().span();
    const double share = 0.5 + 0.5 * std::sin(0.11 * ++step);
    ticker.seek(span.first_s + share * (span.last_s - span.first_s));
  });
  ticker.follow();
  window.session()->push(PauseInput{false});
  measurement.during("dragging a setting", [&, step = 0]() mutable {
    settings.alpha = 0.5 + 0.4 * std::sin(0.07 * ++step);
    window.document().putSettings(settings);
  });
  measurement.until(
      "changing the colours",
      [&] {
        window.setTheme(widgets::Theme::Light);
        QTimer::singleShot(500, &window, [&window] { window.setTheme(widgets::Theme::Dark); });
      },
      [] { return true; });
  auto* streams = window.findChild<StreamDesk*>();
  for (const char* address : {"vmc://127.0.0.1:39651", "xsens://127.0.0.1:39652"})
    measurement.until(
        "connecting to a stream", [&] { streams->connectTo(address); },
        [&] { return streams->isConnected(); });
  measurement.until(
      "disconnecting", [&] { streams->disconnectStream(); }, [&] { return !streams->isConnected(); });
  for (const QString& file : asked.files) {
    opened = failed = false;
    measurement.until(("opening " + file.section('/', -1)).toUtf8().constData(),
                      [&] { window.openFiles({file}); }, [&] { return opened || failed; });
  }
  for (const QString& text : asked.triggers) {
    bool there = true;
    measurement.until(
        text.toUtf8().constData(), [&] { there = trigger(window, text, asked.seconds); },
        [&, clock = QElapsedTimer()]() mutable {
          if (!clock.isValid()) clock.start();
          return !there || static_cast<double>(clock.elapsed()) > 1000 * asked.seconds;
        });
  }
  measurement.until(
      "closing", [&] { window.close(); }, [&] { return !window.isVisible(); });
}

}  // namespace
}  // namespace abrazo::app

int main(int argc, char** argv) {
  using namespace abrazo;
  app::return_freed_memory();
  app::Application application(argc, argv);
  const QTemporaryDir home;
  qputenv("ABRAZO_HOME", home.path().toUtf8());
  const app::Asked asked = app::asked_of(QApplication::arguments());
  application.watched_ms = asked.watched_ms;
  app::UserSettings remembered;
  app::MainWindow window(remembered);
  window.setPlaysAsLive(true);
  window.setTheme(widgets::Theme::Dark);
  app::add_all_actions(window);
  window.resize(asked.size);
  window.show();
  app::Responsiveness responsiveness;  // there is a window that can answer
  app::measure(window, responsiveness, asked);
  return 0;
}
