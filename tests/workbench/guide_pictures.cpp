// The pictures of the guide, and every panel and dialog by itself, made by the program. See docs/images/make.
//   guide_pictures OUT THEME [FILE...]   THEME is dark or light; QT_SCALE_FACTOR=2 gives them twice as fine

#include <sched.h>

#include <QAction>
#include <QApplication>
#include <QDialog>
#include <QDir>
#include <QDockWidget>
#include <QElapsedTimer>
#include <QMenu>
#include <QProcess>
#include <QPushButton>
#include <QTemporaryDir>
#include <QThread>
#include <QTimer>
#include <algorithm>
#include <array>
#include <clocale>
#include <cstdio>

#include "app/workbench/labels/annotation_desk.hpp"
#include "app/workbench/library/retarget_desk.hpp"
#include "app/workbench/library/retarget_preview.hpp"
#include "app/workbench/library/retarget_preview_desk.hpp"
#include "app/workbench/shell/actions.hpp"
#include "app/workbench/shell/main_window.hpp"
#include "app/workbench/shell/panel_area.hpp"
#include "app/workbench/stream/stream_desk.hpp"
#include "core/base/atomic_file.hpp"
#include "core/choreography/salsa.hpp"
#include "core/motion/bvh/bvh.hpp"
#include "widgets/common/qt_versions.hpp"
#include "widgets/scene/view/scene_view.hpp"
#include "widgets/settings/body_box.hpp"
#include "widgets/settings/settings_panel.hpp"

namespace abrazo::app {
namespace {

constexpr QSize window_size(1600, 1000), tall_window_size(1600, 1500);
constexpr double intent_shown_s = 17;
constexpr double shown_time_s = 30;  ///< of the session, where the cursor is parked
constexpr double compared_from_s = 20;
constexpr double previewed_s = 6;  ///< of the take on other bodies
constexpr double live_rate_hz = 120;
constexpr int patience_ms = 180'000;

template <typename Condition>
bool until(Condition reached, int patience) {
  QElapsedTimer clock;
  clock.start();
  while (!reached()) {
    if (clock.elapsed() >= patience) return false;
    QApplication::processEvents(QEventLoop::AllEvents, 20);
    QThread::msleep(5);
  }
  return true;
}

void wait(int milliseconds) {
  (void)until([] { return false; }, milliseconds);
}

class Pictures {
 public:
  Pictures(MainWindow& window, QDir folder) : m_window(window), m_folder(std::move(folder)) {}

  void save(QWidget& what, const QString& name) {
    const QString file = m_folder.filePath(name + ".png");
    const bool written = what.grab().save(file);
    std::printf("%s%s\n", qPrintable(file), written ? "" : ": could not be written");
    m_complete = m_complete && written;
  }

  void window(const QString& name) {
    wait(300);
    m_window.scene().renderSharp();
    save(m_window, name);
  }

  /// Every panel there is, by itself, in the place it has when it is shown, with room for all of it.
  void panels() {
    m_window.resize(tall_window_size);
    for (QDockWidget* dock : m_window.panels().panels()) {
      const bool before = m_window.panels().isWanted(dock->objectName());
      m_window.panels().want(dock->objectName(), true);
      dock->raise();
      wait(400);
      save(*dock, "panel-" + dock->objectName());
      m_window.panels().want(dock->objectName(), before);
    }
    m_window.resize(window_size);
  }

  void trigger(const QString& action) {
    if (QAction* found = of_text(action)) found->trigger();
  }

  bool hasDialog() const {
    const QWidgetList all = QApplication::topLevelWidgets();
    return std::any_of(all.begin(), all.end(), [this](const QWidget* top) {
      return top != &m_window && top->isVisible() && qobject_cast<const QDialog*>(top);
    });
  }

  /// What is open beside the window.
  void saveDialogs(const QString& name) {
    for (QWidget* top : QApplication::topLevelWidgets()) {
      if (top == &m_window || !top->isVisible() || !qobject_cast<QDialog*>(top)) continue;
      save(*top, name);
      top->close();
    }
  }

  /// What an action of the menus opens, modal or not.
  /// @param button  of it, by object name, that is pressed `seconds` before the picture; empty for none
  void dialog(const QString& action, const QString& name, const QString& button = {}, int seconds = 0) {
    QAction* found = of_text(action);
    if (!found) return;
    if (!button.isEmpty())
      QTimer::singleShot(500, &m_window, [this, button] {
        if (auto* pressed = m_window.findChild<QPushButton*>(button)) pressed->click();
      });
    QTimer::singleShot(700 + 1000 * seconds, Qt::PreciseTimer, &m_window,
                       [this, name] { saveDialogs(name); });
    found->trigger();
    wait(1200 + 1000 * seconds);
  }

  /// A picture that cannot be made.
  void miss(const QString& why) {
    std::printf("%s\n", qPrintable(why));
    m_complete = false;
  }

  bool complete() const { return m_complete; }

 private:
  /// The last one: a menu's title comes before its entries.
  QAction* of_text(const QString& text) {
    QAction* found = nullptr;
    for (QAction* each : m_window.findChildren<QAction*>())
      if (each->text() == text) found = each;
    if (!found) miss(text + ": there is no such action");
    return found;
  }

  MainWindow& m_window;
  QDir m_folder;
  bool m_complete = true;
};

/// Two generated couples as files, as a person would drop them.
QStringList written_couples(const QDir& folder) {
  QStringList files;
  ChoreographyOptions dance;
  dance.minutes = 0.5;
  for (const PairedTake& take : generate_salsa(dance)) {
    for (const auto& [clip, role] : {std::pair(&take.a, "leader"), std::pair(&take.b, "follower")}) {
      const QString file = folder.filePath(QString("%1_%2.bvh").arg(QString::fromStdString(take.name), role));
      const auto text = write_bvh(std::span(clip, 1));
      if (text && write_whole_file(file.toStdString(), *text)) files << file;
    }
  }
  return files;
}

/// A motion of two performers, which opens the import panel.
QStringList motion_of_two(const QDir& folder) {
  ChoreographyOptions dance;
  dance.minutes = 0.2;
  const PairedTake take = generate_salsa(dance).front();
  const QString file = folder.filePath("two_dancers.bvh");
  const std::array clips = {take.a, take.b};
  const auto text = write_bvh(clips);
  if (!text || !write_whole_file(file.toStdString(), *text)) return {};
  return {file};
}

/// The mesh cut open, with the plane's handles and the figures of what is shown.
void cut(MainWindow& window, Pictures& pictures) {
  pictures.trigger("Cut");
  widgets::SceneOptions options = window.scene().options();
  options.cut_in_world = true;
  window.scene().setOptions(options);
  wait(1500);
  pictures.window("cut");
  pictures.dialog("Figures of the selection…", "figures", {}, 2);
  pictures.trigger("Cut");
}

/// A frozen, B other settings: what a comparison has to show.
void compare(MainWindow& window) {
  for (QAction* action : window.actions())
    if (action->text() == "Freeze the settings as A") action->trigger();
  window.document().changeSetting("velocity-weight", "0.4");
}

/// A take half annotated: its second half is only suggested.
void annotate(MainWindow& window, Pictures& pictures) {
  auto& desk = *window.findChild<AnnotationDesk*>();
  desk.showSubject(desk.library()->takes().front().name);
  Annotations next = window.document().annotations();
  const AnnotationTier moves = *next.first_of(TierKind::Move);
  const double middle_s = desk.range().last_s / 2;
  std::vector<Suggestion> suggested;
  for (const Annotation& each : moves.annotations)
    if (each.start_s > middle_s && next.remove(each.id))
      suggested.push_back({0, moves.id, each.start_s, each.end_s, each.value, 0.8, ""});
  next.suggest(std::span(&moves.id, 1), suggested);
  window.document().changeAnnotations(next, "show");
  window.document().selectLabel(next.tier(moves.id)->annotations.back().id);
  window.ticker().seek(middle_s);
  wait(2000);
  pictures.window("annotation");
  desk.showSubject("");
}

/// `abrazo send`, as tests/soak/soak starts it: a process of its own, like a suit on another machine. A timer
/// of this one would wait while the window draws. Where the user may ask for it, it does not wait for the
/// processor.
class Sender : public QProcess {
 public:
  ~Sender() override {
    terminate();
    (void)waitForFinished();
  }

 protected:
  void setupChildProcess() override {
    const sched_param first{1};
    (void)sched_setscheduler(0, SCHED_FIFO, &first);
  }
};

/// The take that plays the user, sent as VMC packets to the window itself; the partner is sent back.
void live(MainWindow& window, const QDir& folder, Pictures& pictures) {
  const QString address = "vmc://127.0.0.1:39539", file = folder.filePath("user.bvh");
  const auto text = write_bvh(std::span(&window.session()->material().input, 1));
  auto& streams = *window.findChild<StreamDesk*>();
  streams.connectTo(address);
  if (!text || !write_whole_file(file.toStdString(), *text) || !window.session()->engine().receiver())
    return pictures.miss("live: the user's motion cannot be written, or the port is in use");
  send_partner_to(window, streams, "vmc://127.0.0.1:39540?framing=t-last");
  Sender sender;
  sender.setProcessChannelMode(QProcess::ForwardedErrorChannel);
  sender.start(QCoreApplication::applicationDirPath() + "/abrazo",
               {"send", file, "--metres-per-unit", "1", "--to", address, "--rate",
                QString::number(live_rate_hz), "--loop", "--quiet"});
  if (!sender.waitForStarted()) return pictures.miss("live: abrazo, which sends the stream, does not start");
  window.panels().want("connection", true);
  window.panels().panel("connection")->raise();
  window.panels().want("latency", true);
  window.panels().panel("latency")->raise();
  wait(8000);
  pictures.window("live");
  window.resize(tall_window_size);
  wait(1000);
  pictures.save(*window.panels().panel("connection"), "connection");
  pictures.save(*window.panels().panel("latency"), "latency");
  window.resize(window_size);
  for (const char* panel : {"connection", "latency"}) window.panels().want(panel, false);
  for (QAction* action : window.actions())
    if (action->text() == "Disconnect") action->trigger();
}

/// Two takes on a taller leader, to a folder whose name is not one of this machine.
void retarget(MainWindow& window, const QDir& home, Pictures& pictures) {
  auto& desk = *window.findChild<RetargetDesk*>();
  const QString before = QDir::currentPath();
  if (!home.mkpath("dances") || !QDir::setCurrent(home.path())) return;
  desk.open();
  RetargetDialog& dialog = desk.dialog();
  dialog.setFolder("dances");
  QStringList chosen;
  for (const LibraryTake& take : window.session()->material().library->takes())
    if (chosen.size() < 2) chosen << QString::fromStdString(take.name);
  dialog.chooseTakes(chosen);
  for (auto* body : dialog.findChildren<widgets::BodyBox*>())
    if (body->accessibleName().startsWith("Leader")) body->setEditText("scale:1.15");
  const RetargetPreviewDesk& computing = desk.preview();
  (void)until([&] { return computing.shown().recorded && !computing.isComputing(); }, patience_ms);
  FrameTicker& ticker = dialog.preview().ticker();
  ticker.pause();
  ticker.seek(previewed_s);
  wait(1500);  // the camera comes to rest
  dialog.preview().scene().renderSharp();
  pictures.saveDialogs("retarget");
  QDir::setCurrent(before);
}

int make_pictures(const QString& out, widgets::Theme theme, const QStringList& files) {
  QTemporaryDir home;
  qputenv("ABRAZO_HOME", home.path().toUtf8());
  UserSettings remembered;
  MainWindow window(remembered);
  window.setPlaysAsLive(true);
  window.setTheme(theme);
  add_all_actions(window);
  window.document().putSettings(preset("responsive").value());
  window.resize(window_size);
  window.show();
  files.isEmpty() ? window.openDemo() : window.openFiles(files);
  const auto solved = [&window] {
    return window.session() && window.session()->history().span().last_s > shown_time_s + 2;
  };
  const auto intent_seen = [&window] {
    return window.session() && window.session()->history().span().last_s > intent_shown_s;
  };
  const auto under_way = [&window] {
    return window.session() && window.session()->history().span().last_s > compared_from_s;
  };
  Pictures pictures(window, QDir(QDir(out).absolutePath()));
  if (QDir().mkpath(out) && until(intent_seen, patience_ms)) pictures.window("intent");
  if (until(under_way, patience_ms)) compare(window);
  if (!until(solved, patience_ms)) {
    std::printf("%s: the folder cannot be made, or nothing was solved\n", qPrintable(out));
    return 1;
  }
  window.ticker().seek(shown_time_s);
  wait(3000);  // until the comparison at the cursor is there
  pictures.window("workbench");
  cut(window, pictures);
  pictures.panels();
  annotate(window, pictures);
  live(window, QDir(home.path()), pictures);
  pictures.dialog("Keys", "keys");
  pictures.dialog("Shortcuts…", "shortcuts");
  pictures.dialog("Sweep two settings…", "sweep", "startSweep", 40);
  retarget(window, QDir(home.path()), pictures);
  window.openFiles(written_couples(QDir(home.path())));
  (void)until([&pictures] { return pictures.hasDialog(); }, patience_ms);
  wait(3000);
  pictures.saveDialogs("build");
  pictures.dialog("Help", "help", {}, 2);
  window.openFiles(motion_of_two(QDir(home.path())));
  (void)until([&pictures] { return pictures.hasDialog(); }, patience_ms);
  wait(3000);
  pictures.saveDialogs("import");
  return pictures.complete() ? 0 : 1;
}

}  // namespace
}  // namespace abrazo::app

int main(int argc, char** argv) {
  abrazo::widgets::use_small_pixels();
  QApplication application(argc, argv);
  std::setlocale(LC_NUMERIC, "C");
  const QStringList words = QApplication::arguments();
  if (words.size() < 3 || (words[2] != "dark" && words[2] != "light")) {
    std::printf("usage: guide_pictures OUT dark|light [FILE...]\n");
    return 2;
  }
  return abrazo::app::make_pictures(
      words[1], words[2] == "light" ? abrazo::widgets::Theme::Light : abrazo::widgets::Theme::Dark,
      words.mid(3));
}
