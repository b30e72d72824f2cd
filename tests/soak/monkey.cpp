// monkey: does at random what a person may do with the workbench, for minutes or a night, and says what came
// of it.
//
//   xvfb-run -a -s "-screen 0 1600x1000x24" build/release/bin/monkey --seed 7 --minutes 10 --sender
//   build/release/bin/abrazo
//
// Actions, keys, clicks, drags, wheel, values, sizes, dialogs, files, a stream that comes and goes, closing
// and opening again. A seed gives the same wishes again; what they meet depends on time. Answers 1 after a
// crash, when the window was unanswered for more than 0.5 s, not counting the wait for a processor (not in
// the preset `asan-window`, whose code is slow), when memory in use while no window exists grew by more than
// 60 MB after the first quarter, or when memory leaked (preset `asan-window`); says the seed and the last 50
// things it did. `--watch 0.25` prints where the window is once it has been unanswered that long.
#include <execinfo.h>
#include <fcntl.h>
#include <malloc.h>
#include <unistd.h>
#ifdef __SANITIZE_ADDRESS__
#include <sanitizer/lsan_interface.h>
#endif

#include <QAction>
#include <QApplication>
#include <QDesktopServices>
#include <QDialog>
#include <QDir>
#include <QElapsedTimer>
#include <QFileDialog>
#include <QLineEdit>
#include <QMenu>
#include <QMouseEvent>
#include <QProcess>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QTest>
#include <QTimer>
#include <QWheelEvent>
#include <array>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <memory>
#include <random>

#include "app/workbench/project/project_desk.hpp"
#include "app/workbench/shell/actions.hpp"
#include "app/workbench/shell/main_window.hpp"
#include "app/workbench/start/allocation.hpp"
#include "app/workbench/stream/stream_desk.hpp"
#include "core/base/file_limit.hpp"
#include "tests/soak/answer_watch.hpp"
#include "widgets/common/plain_text.hpp"

using namespace abrazo;

namespace {

constexpr double unanswered_s = 0.5;
constexpr double growth_mb = 60;

/// The last things that were done, as a signal handler can write them.
class Diary {
 public:
  void note(const QString& what) {
    std::snprintf(lines_[next_ % lines_.size()].data(), lines_[0].size(), "%llu %s\n",
                  static_cast<unsigned long long>(next_), what.toUtf8().constData());
    ++next_;
  }
  const char* last() const { return next_ == 0 ? "" : lines_[(next_ - 1) % lines_.size()].data(); }
  std::size_t count() const { return next_; }
  void write_to(int fd) const {
    for (std::size_t i = next_ > lines_.size() ? next_ - lines_.size() : 0; i < next_; ++i) {
      const auto& line = lines_[i % lines_.size()];
      if (::write(fd, line.data(), std::strlen(line.data())) < 0) return;
    }
  }

 private:
  std::array<std::array<char, 240>, 50> lines_{};
  std::size_t next_ = 0;
};

Diary diary;
std::array<char, 40> seed_line{};

void on_crash(int signal) {
  const char* words = "monkey: CRASH, the last things done:\n";
  if (::write(STDERR_FILENO, words, std::strlen(words)) > 0 &&
      ::write(STDERR_FILENO, seed_line.data(), std::strlen(seed_line.data())) > 0)
    diary.write_to(STDERR_FILENO);
  // `addr2line -Cfipe PROGRAM ADDRESS` names the lines.
  std::array<void*, 100> calls{};
  ::backtrace_symbols_fd(calls.data(), ::backtrace(calls.data(), static_cast<int>(calls.size())),
                         STDERR_FILENO);
  std::signal(signal, SIG_DFL);
  std::raise(signal);
}

#ifdef __SANITIZE_ADDRESS__
// GCC does not install the header that declares it.
extern "C" std::size_t __sanitizer_get_current_allocated_bytes();  // NOLINT(bugprone-reserved-identifier)
constexpr bool is_instrumented = true;
#else
constexpr bool is_instrumented = false;
#endif

/// Memory in use: resident and of no file, because the code of a library is read as it is first needed; or
/// AddressSanitizer's own count, because what its allocator adds and keeps is several times what is in use.
double used_mb() {
#ifdef __SANITIZE_ADDRESS__
  return static_cast<double>(__sanitizer_get_current_allocated_bytes()) / 1e6;
#else
  ::malloc_trim(0);  // pages that were freed and are kept for what comes do not count
  std::ifstream file("/proc/self/statm");
  long pages = 0, resident = 0, of_files = 0;
  file >> pages >> resident >> of_files;
  return static_cast<double>(resident - of_files) * static_cast<double>(::sysconf(_SC_PAGESIZE)) / 1e6;
#endif
}

/// Memory that nothing points to any more, where AddressSanitizer counts it: it says what and whence. Looked
/// for while all runs, as the program ends without freeing anything.
bool leaks() {
#ifdef __SANITIZE_ADDRESS__
  return __lsan_do_recoverable_leak_check() != 0;
#else
  return false;
#endif
}

struct Wish {
  unsigned seed = 1;
  double minutes = 10;
  double watched_s = unanswered_s;  ///< from when on it says where the window is; what counts is unanswered_s
  QString sender;                   ///< `abrazo`, which makes the data and sends the stream; empty: no stream
};

class Monkey : public QObject {
 public:
  explicit Monkey(const Wish& wish) : m_wish(wish), m_random(wish.seed) {
    m_home.setAutoRemove(true);
    qputenv("ABRAZO_HOME", (m_home.path() + "/home").toUtf8());
    qputenv("HOME", m_home.path().toUtf8());
    QDir::setCurrent(m_home.path());
    if (!wish.sender.isEmpty())
      QProcess::execute(wish.sender, {"demo", "-o", m_home.path() + "/demo", "--minutes", "0.2", "--quiet"});
    open();
    m_clock.start();
    connect(&m_beat, &QTimer::timeout, this, &Monkey::beat);
    m_beat.start(20);
    // Queued, as a timer does not fire again below the event loop of a dialog that its own turn has opened.
    connect(&m_turns, &QTimer::timeout, this, [this] {
      QMetaObject::invokeMethod(
          this, [this] { turn(); }, Qt::QueuedConnection);
    });
    m_turns.start(60);
  }
  ~Monkey() override { endSender(); }

  /// @return whether nothing was wrong
  bool report() {
    m_window.reset();
    noteMemory();
    std::printf(
        "monkey: seed %u, %.1f min, %zu things done, %d windows, %d times unanswered (longest %.2f s), "
        "%d times for want of a processor (longest %.2f s), memory without a window %.0f MB after a "
        "quarter, %.0f MB at the end; most with one %.0f MB\n",
        m_wish.seed, minutes(), diary.count(), m_windows, m_unanswered, m_longest, m_starved,
        m_longestStarved, m_memoryEarly, m_memoryLast, m_memoryMost);
    std::fflush(stdout);
    const bool answers = is_instrumented || m_unanswered == 0;
    const bool good = answers && m_memoryLast - m_memoryEarly < growth_mb;
    if (!good) diary.write_to(STDOUT_FILENO);
    return good;
  }

 private:
  // ---- the window ----
  void open() {
    m_remembered = std::make_unique<app::UserSettings>();
    m_window = std::make_unique<app::MainWindow>(*m_remembered);
    m_window->resize(1280, 860);
    const app::Rooms rooms = app::add_all_actions(*m_window);
    rooms.project.setAsks(true);
    m_streams = &rooms.streams;
    m_window->show();
    m_window->openDemo();
    ++m_windows;
    m_watch.forget();  // opening is measured elsewhere
  }
  void openAgainWhenClosed() {
    if (m_window->isVisible()) return;
    diary.note("opens the window again");
    m_window.reset();
    noteMemory();
    m_remembered.reset();
    open();
  }

  double minutes() const { return static_cast<double>(m_clock.elapsed()) / 60e3; }

  /// Between two windows the program holds the same each time, whatever the last one had open.
  void noteMemory() {
    m_memoryLast = used_mb();
    if (m_memoryEarly == 0 || minutes() < m_wish.minutes / 4) m_memoryEarly = m_memoryLast;
    m_watch.forget();
  }

  void beat() {
    const soak::AnswerWatch::Gap gap = m_watch.beat();
    m_longest = std::max(m_longest, gap.own_s());
    m_longestStarved = std::max(m_longestStarved, gap.whole_s);
    if (gap.whole_s > unanswered_s) {
      ++(gap.own_s() > unanswered_s ? m_unanswered : m_starved);
      std::printf("monkey: unanswered for %.2f s, of them %.2f s without a processor, after: %s", gap.whole_s,
                  gap.starved_s, diary.last());
      std::fflush(stdout);
    }
    if (m_window && minutes() >= m_sampled + 0.5) sample();
    if (minutes() > m_wish.minutes && !m_isDone) {
      m_isDone = true;
      const bool leaked = leaks();
      const bool good = report();
      endSender();
      m_home.remove();
      std::_Exit(good && !leaked ? 0 : 1);
    }
  }

  void sample() {
    m_sampled = minutes();
    const app::LiveSession* session = m_window->session();
    const double history_mb = session ? static_cast<double>(session->history().span().bytes) / 1e6 : 0;
    const double used = used_mb();
    m_memoryMost = std::max(m_memoryMost, used);
    std::printf(
        "monkey: %.1f min, %d windows, %.0f MB in use, %.0f MB of them frames of the history; %.0f MB "
        "between the last two windows\n",
        m_sampled, m_windows, used, history_mb, m_memoryLast);
    std::fflush(stdout);
    m_watch.forget();  // giving back a large heap takes long
  }

  // ---- chance ----
  int below(int count) {
    return count <= 0 ? 0 : static_cast<int>(m_random() % static_cast<unsigned>(count));
  }
  bool chance(int percent) { return below(100) < percent; }
  template <typename List>
  auto one_of(const List& list) {
    return list[static_cast<int>(below(static_cast<int>(list.size())))];
  }

  // ---- a turn ----
  void turn() {
    if (QWidget* menu = QApplication::activePopupWidget()) return inMenu(menu);
    if (QWidget* dialog = QApplication::activeModalWidget()) return inDialog(dialog);
    openAgainWhenClosed();
    const int what = below(100);
    if (what < 40) return triggerOne();
    if (what < 58) return pressOne(m_window.get());
    if (what < 74) return clickOne(m_window.get(), false);
    if (what < 84) return clickOne(m_window.get(), true);
    if (what < 90) return turnWheel();
    if (what < 93) return resizeIt();
    if (what < 96) return changeStream();
    if (what < 99) return openFile();
    if (chance(30)) {
      diary.note("closes the window");
      m_window->close();
    }
  }

  void inMenu(QWidget* menu) {
    const int key =
        one_of(QVector<int>{Qt::Key_Down, Qt::Key_Up, Qt::Key_Right, Qt::Key_Return, Qt::Key_Escape});
    diary.note(QString("menu key %1").arg(key));
    QTest::keyClick(menu, static_cast<Qt::Key>(key));
  }

  /// Files are named only in our own folder: a dialog of files can rename and remove.
  void inDialog(QWidget* dialog) {
    if (auto* files = qobject_cast<QFileDialog*>(dialog)) {
      auto* name = files->findChild<QLineEdit*>("fileNameEdit");
      if (!name || chance(50)) {
        diary.note("leaves the dialog of files");
        return files->reject();
      }
      const QString chosen =
          m_home.path() + "/" + one_of(QStringList{"a", "b.abrazo", "c.bvh", "d.csv", "e.png", "demo.h5"});
      diary.note("names the file " + chosen);
      name->setText(chosen);
      return QTest::keyClick(name, Qt::Key_Return);
    }
    if (chance(25)) {
      diary.note(QString("leaves the dialog ") + dialog->metaObject()->className());
      auto* asked = qobject_cast<QDialog*>(dialog);
      return asked ? asked->reject() : static_cast<void>(dialog->close());
    }
    chance(50) ? pressOne(dialog) : clickOne(dialog, false);
  }

  void triggerOne() {
    QVector<QAction*> actions;
    for (QAction* action : m_window->findChildren<QAction*>())
      if (action->isEnabled() && !action->isSeparator() && !action->menu() && !action->text().isEmpty())
        actions << action;
    if (actions.isEmpty()) return;
    QAction* action = one_of(actions);
    diary.note("action " + action->objectName() + " \"" + action->text() + "\"");
    action->trigger();
  }

  void pressOne(QWidget* in) {
    static const QVector<int> keys = {
        Qt::Key_Space,    Qt::Key_Left,   Qt::Key_Right,  Qt::Key_Up,         Qt::Key_Down, Qt::Key_Tab,
        Qt::Key_Escape,   Qt::Key_Return, Qt::Key_Delete, Qt::Key_Home,       Qt::Key_End,  Qt::Key_PageUp,
        Qt::Key_PageDown, Qt::Key_F1,     Qt::Key_F2,     Qt::Key_0,          Qt::Key_1,    Qt::Key_5,
        Qt::Key_9,        Qt::Key_Minus,  Qt::Key_Period, Qt::Key_BracketLeft};
    const int key = chance(40) ? Qt::Key_A + below(26) : one_of(keys);
    const auto modifiers = one_of(QVector<Qt::KeyboardModifiers>{
        Qt::NoModifier, Qt::NoModifier, Qt::NoModifier, Qt::ShiftModifier, Qt::ControlModifier,
        Qt::AltModifier, Qt::ControlModifier | Qt::ShiftModifier});
    QWidget* focus = in->window()->focusWidget();
    QWidget* to = focus && focus->isVisible() ? focus : in;
    diary.note(
        QString("key %1 with %2 to %3").arg(key).arg(int(modifiers)).arg(to->metaObject()->className()));
    QTest::keyClick(to, static_cast<Qt::Key>(key), modifiers);
  }

  void clickOne(QWidget* in, bool drags) {
    QVector<QWidget*> visible;
    for (QWidget* widget : in->findChildren<QWidget*>())
      if (widget->isVisible() && widget->isEnabled() && widget->window() == in->window() &&
          widget->width() > 2 && widget->height() > 2)
        visible << widget;
    if (visible.isEmpty()) return;
    const QPointer<QWidget> widget = one_of(visible);
    const auto place = [&] { return QPoint(below(widget->width()), below(widget->height())); };
    const auto button = one_of(QVector<Qt::MouseButton>{Qt::LeftButton, Qt::LeftButton, Qt::LeftButton,
                                                        Qt::RightButton, Qt::MiddleButton});
    const QPoint from = place();
    diary.note(QString("%1 %2 at %3,%4 with button %5")
                   .arg(drags ? "drag" : "click", widget->metaObject()->className())
                   .arg(from.x())
                   .arg(from.y())
                   .arg(int(button)));
    if (!drags)
      return chance(15) ? QTest::mouseDClick(widget, button, {}, from)
                        : QTest::mouseClick(widget, button, {}, from);
    QTest::mousePress(widget, button, {}, from);
    for (int step = 0; step < 4 && widget; ++step) {
      QMouseEvent move(QEvent::MouseMove, place(), Qt::NoButton, button, Qt::NoModifier);
      QApplication::sendEvent(widget, &move);
    }
    if (widget) QTest::mouseRelease(widget, button, {}, place());
  }

  void turnWheel() {
    QVector<QWidget*> visible;
    for (QWidget* widget : m_window->findChildren<QWidget*>())
      if (widget->isVisible()) visible << widget;
    QWidget* widget = one_of(visible);
    const QPoint at(widget->width() / 2, widget->height() / 2);
    diary.note(QString("wheel over ") + widget->metaObject()->className());
    QWheelEvent wheel(at, widget->mapToGlobal(at), {}, {0, chance(50) ? 120 : -360}, Qt::NoButton,
                      chance(20) ? Qt::ControlModifier : Qt::NoModifier, Qt::NoScrollPhase, false);
    QApplication::sendEvent(widget, &wheel);
  }

  void resizeIt() {
    const QSize size(640 + below(960), 420 + below(560));
    diary.note(QString("size %1x%2").arg(size.width()).arg(size.height()));
    m_window->resize(size);
  }

  // ---- streams and files ----
  void endSender() {
    if (!m_sender) return;
    beat();
    m_sender->kill();
    m_sender->waitForFinished(2000);
    m_sender.reset();
    m_watch.forget();  // the window is not to blame
  }
  void changeStream() {
    if (m_wish.sender.isEmpty()) return;
    const QString uri = one_of(QStringList{"vmc://127.0.0.1:39641", "xsens://127.0.0.1:39642"});
    if (m_streams->isConnected() && chance(50)) {
      diary.note("disconnects the stream");
      m_streams->disconnectStream();
    } else if (m_sender && chance(50)) {
      diary.note("the sender falls silent");
      endSender();
    } else {
      diary.note("stream " + uri);
      m_streams->connectTo(uri);
      endSender();
      beat();
      m_sender = std::make_unique<QProcess>();
      m_sender->start(m_wish.sender,
                      {"send", m_home.path() + "/demo/salsa_01_a.bvh", "--to", uri, "--loop", "--quiet"});
      m_watch.forget();  // to begin a program, a large one is copied
    }
  }
  void openFile() {
    if (m_wish.sender.isEmpty()) return;
    const QString file = m_home.path() + one_of(QStringList{"/demo/manifest.json", "/demo/salsa_01_a.bvh",
                                                            "/b.abrazo", "/c.bvh", "/demo/nowhere.h5"});
    diary.note("opens " + file);
    m_window->openFiles({file});
  }

  Wish m_wish;
  std::mt19937 m_random;
  QTemporaryDir m_home;
  std::unique_ptr<app::UserSettings> m_remembered;
  std::unique_ptr<app::MainWindow> m_window;
  app::StreamDesk* m_streams = nullptr;
  std::unique_ptr<QProcess> m_sender;
  QTimer m_beat, m_turns;
  QElapsedTimer m_clock;
  soak::AnswerWatch m_watch{m_wish.watched_s};
  double m_longest = 0, m_longestStarved = 0, m_memoryEarly = 0, m_memoryLast = 0;
  double m_memoryMost = 0, m_sampled = 0;
  int m_unanswered = 0, m_starved = 0, m_windows = 0;
  bool m_isDone = false;
};

/// Nothing outside is opened, whatever link is followed.
class NoLinks : public QObject {
  Q_OBJECT
 public slots:
  void open(const QUrl& url) { diary.note("follows " + url.toString()); }
};

}  // namespace

int main(int argc, char** argv) {
  app::return_freed_memory();
  Wish wish;
  for (int word = 1; word + 1 < argc; word += 2) {
    const std::string_view name = argv[word];
    if (name == "--seed") wish.seed = static_cast<unsigned>(std::strtoul(argv[word + 1], nullptr, 10));
    if (name == "--minutes") wish.minutes = std::strtod(argv[word + 1], nullptr);
    if (name == "--watch") wish.watched_s = std::strtod(argv[word + 1], nullptr);
    if (name == "--sender")
      wish.sender = QFileInfo(QString::fromLocal8Bit(argv[word + 1])).absoluteFilePath();
  }
  std::snprintf(seed_line.data(), seed_line.size(), "seed %u\n", wish.seed);
  void* caller = nullptr;
  ::backtrace(&caller, 1);  // the first call loads a library, which a signal handler cannot do
  for (const int signal : {SIGSEGV, SIGABRT, SIGBUS, SIGFPE, SIGILL}) std::signal(signal, on_crash);
  take_file_limit_for_full_disk();
  QApplication::setAttribute(Qt::AA_DontUseNativeDialogs);
  QApplication application(argc, argv);
  QApplication::setQuitOnLastWindowClosed(false);
  widgets::PlainTextLabels plain_labels;
  NoLinks no_links;
  for (const char* scheme : {"file", "http", "https", "mailto"})
    QDesktopServices::setUrlHandler(scheme, &no_links, "open");
  Monkey monkey(wish);
  return QApplication::exec();
}

#include "monkey.moc"
