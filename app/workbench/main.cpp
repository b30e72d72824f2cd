#include <QApplication>
#include <clocale>
#include <cstdio>
#include <memory>

#include "app/workbench/actions/actions.hpp"
#include "app/workbench/command_line.hpp"
#include "app/workbench/main_window.hpp"
#include "app/workbench/project_desk.hpp"
#include "app/workbench/responsiveness.hpp"
#include "app/workbench/unattended.hpp"
#include "app/workbench/user_settings.hpp"
#include "core/base/atomic_file.hpp"
#include "widgets/scene/scene_view.hpp"

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
  widgets::SceneView::prepareApplication();
  QApplication::setAttribute(Qt::AA_ShareOpenGLContexts);
  QApplication::setAttribute(Qt::AA_EnableHighDpiScaling);
  QApplication::setAttribute(Qt::AA_UseHighDpiPixmaps);
  QApplication::setApplicationName("abrazo");
}

void add_actions(app::MainWindow& window) {
  app::add_all_actions(window);
}

}  // namespace

int main(int argc, char** argv) {
  const auto parsed = app::parse_command_line(argc, argv);
  if (const auto* stop = std::get_if<app::ExitStatus>(&parsed)) return stop->code;
  const auto& asked = std::get<app::CommandLine>(parsed);
  const auto settings = asked_settings(asked.settings);
  if (!settings) {
    std::fprintf(stderr, "abrazo-workbench: %s\n", settings.error().text().c_str());
    return asked.settings.front() == '{' ? 2 : 1;  // a wrong word, or a file that cannot be used
  }

  set_up_toolkit();
  QApplication application(argc, argv);
  std::setlocale(LC_NUMERIC, "C");  // QApplication took the user's; numbers in files are not the user's

  app::UserSettings remembered;
  app::MainWindow window(remembered);
  const QString theme = asked.theme.empty() ? remembered.theme() : QString::fromStdString(asked.theme);
  window.setTheme(theme == "light" ? widgets::Theme::Light : widgets::Theme::Dark);
  add_actions(window);
  app::Responsiveness responsiveness;
  app::watch(window, responsiveness);
  window.startWith(*settings);
  if (asked.size.isValid())
    window.resize(asked.size);
  else if (!asked.unattended())
    app::restore_last_layout(window);

  std::unique_ptr<app::Unattended> unattended;
  if (asked.unattended()) {
    // Nobody is there to answer a dialog: two motions, and joints that nobody knows, are refused as by the
    // command line.
    QObject::disconnect(&window, &app::MainWindow::motionsOffered, nullptr, nullptr);
    QObject::disconnect(&window, &app::MainWindow::mappingOffered, nullptr, nullptr);
    unattended = std::make_unique<app::Unattended>(window, asked, responsiveness);
  }
  window.show();
  const QStringList files = asked_files(asked);
  if (!asked.unattended() && !asked.demo && files.isEmpty()) app::welcome_at_start(window);
  if (!asked.unattended()) {
    window.findChild<app::ProjectDesk*>()->setAsks(true);
    app::offer_leftovers(window);
  }
  if (!asked.listen.empty()) app::connect_to_stream(window, QString::fromStdString(asked.listen));
  for (const std::string& uri : asked.send) app::send_partner_to(window, QString::fromStdString(uri));
  files.isEmpty() || asked.demo ? window.openDemo() : window.openFiles(files);
  return QApplication::exec();
}
