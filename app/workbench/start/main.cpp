#include <QApplication>
#include <clocale>
#include <cstdio>
#include <future>
#include <memory>
#include <optional>

#include "app/workbench/base/user_settings.hpp"
#include "app/workbench/project/project_desk.hpp"
#include "app/workbench/shell/actions.hpp"
#include "app/workbench/shell/layouts.hpp"
#include "app/workbench/shell/main_window.hpp"
#include "app/workbench/start/allocation.hpp"
#include "app/workbench/start/command_line.hpp"
#include "app/workbench/start/responsiveness.hpp"
#include "app/workbench/start/start_times.hpp"
#include "app/workbench/start/status_lines.hpp"
#include "app/workbench/start/termination.hpp"
#include "app/workbench/start/unattended.hpp"
#include "app/workbench/stream/stream_desk.hpp"
#include "core/base/atomic_file.hpp"
#include "core/base/file_limit.hpp"
#include "core/opening/generated_set.hpp"
#include "widgets/common/icons.hpp"
#include "widgets/common/plain_text.hpp"
#include "widgets/common/qt_versions.hpp"
#include "widgets/scene/view/scene_view.hpp"

using namespace abrazo;

namespace {

/// Of --settings: a file, or the object itself.
Result<Settings> asked_settings(const std::string& text) {
  const Settings start = preset("responsive").value();
  if (text.empty()) return start;
  if (text.front() == '{') return parse_settings(text, start, "--settings");
  const auto content = read_whole_file(text);
  if (!content) return content.error();
  return parse_settings(*content, start, text);
}

QStringList asked_files(const app::CommandLine& asked) {
  QStringList files;
  if (!asked.library.empty()) files << QString::fromStdString(asked.library);
  if (!asked.session.empty()) files << QString::fromStdString(asked.session);
  for (const std::string& file : asked.files) files << QString::fromStdString(file);
  return files;
}

void set_up_toolkit() {
  widgets::use_small_pixels();
  QApplication::setApplicationName("abrazo");
  QGuiApplication::setDesktopFileName("abrazo");  // what a Wayland desktop finds the icon by
}

/// The dance that opens when nothing is named, generated while toolkit and window come up.
app::MainWindow::MakeMaterial dance_begun_early() {
  auto dance = std::make_shared<std::future<Result<Material>>>(
      std::async(std::launch::async, [] { return generated_dance({}); }));
  return [dance](const Progress&) { return dance->get(); };
}

void write_line(const std::string& line) {
  std::fputs(line.c_str(), stdout);
  std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
  app::return_freed_memory();
  const auto parsed = app::parse_command_line(argc, argv);
  if (const auto* stop = std::get_if<app::ExitStatus>(&parsed)) return stop->code;
  const auto& asked = std::get<app::CommandLine>(parsed);
  const auto settings = asked_settings(asked.settings);
  if (!settings) {
    std::fprintf(stderr, "abrazo-workbench: %s\n", settings.error().text().c_str());
    return asked.settings.front() == '{' ? 2 : 1;  // a wrong word, or a file that cannot be used
  }

  app::StartTimes start;
  start.reached("libraries loaded");
  const QStringList files = asked_files(asked);
  app::MainWindow::MakeMaterial dance;
  if (files.isEmpty() || asked.demo) dance = dance_begun_early();
  take_file_limit_for_full_disk();
  set_up_toolkit();
  QApplication application(argc, argv);
  widgets::PlainTextLabels plain_labels;
  start.reached("toolkit ready");
  std::setlocale(LC_NUMERIC, "C");  // QApplication took the user's; numbers in files are not the user's
  QApplication::setWindowIcon(widgets::program_icon());

  app::UserSettings remembered;
  app::MainWindow window(remembered);
  const QString theme = asked.theme.empty() ? remembered.theme() : QString::fromStdString(asked.theme);
  window.setTheme(theme == "light" ? widgets::Theme::Light : widgets::Theme::Dark);
  const app::Rooms rooms = app::add_all_actions(window);
  start.reached("window built");
  start.follow(window.document(), window.ticker(), window.scene());
  app::Responsiveness responsiveness;
  app::watch(window, window.document(), responsiveness);
  std::optional<app::StatusLines> status;
  if (asked.status_every_s > 0)
    status.emplace(window.document(), window.scene(), responsiveness, asked.status_every_s, write_line);
  window.document().putSettings(*settings);
  // What is sent somewhere, and what is measured, is played in real time.
  window.setPlaysAsLive(asked.listen.empty() && (!asked.send.empty() || asked.smoke_frames > 0));
  if (asked.size.isValid())
    window.resize(asked.size);
  else if (!asked.unattended())
    app::restore_last_layout(window, rooms.layouts);

  std::unique_ptr<app::Unattended> unattended;
  if (asked.unattended()) {
    // No user can answer dialogs: two motions, and unknown joints, are refused as by the
    // command line, and doubts are reported.
    QObject::disconnect(&window, &app::MainWindow::motionsOffered, nullptr, nullptr);
    QObject::disconnect(&window, &app::MainWindow::mappingOffered, nullptr, nullptr);
    QObject::disconnect(&window, &app::MainWindow::importOffered, nullptr, nullptr);
    unattended = std::make_unique<app::Unattended>(window, asked, responsiveness, start);
  }
  const app::Termination termination;
  app::close_when_told(window, rooms.project, termination);
  window.show();
  start.reached("window shown");
  if (!asked.unattended() && !asked.demo && files.isEmpty()) app::welcome_at_start(window);
  if (!asked.unattended()) {
    rooms.project.setAsks(true);
    rooms.layouts.setFollowsWork(true);
    app::offer_leftovers(window, rooms.leftovers);
  }
  if (!asked.listen.empty()) rooms.streams.connectTo(QString::fromStdString(asked.listen));
  for (const std::string& uri : asked.send)
    app::send_partner_to(window, rooms.streams, QString::fromStdString(uri));
  if (dance)
    window.openMaterial(std::move(dance));
  else
    window.openFiles(files);
  return QApplication::exec();
}
