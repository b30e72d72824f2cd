#include <QAction>
#include <QMenu>

#include "app/workbench/base/recent_files.hpp"
#include "app/workbench/shell/actions.hpp"
#include "app/workbench/shell/main_window.hpp"
#include "app/workbench/shell/panel_area.hpp"
#include "app/workbench/start/welcome_page.hpp"
#include "core/opening/generated_set.hpp"
#include "widgets/common/message_bar.hpp"
#include "widgets/scene/view/scene_view.hpp"

namespace abrazo::app {
namespace {

constexpr int most_shown = 5;
constexpr int least_width = 1270;  // of the window, so that the scene beside the page still shows the pair

void show_recent(const MainWindow& window, WelcomePage& page) {
  const QStringList entries = window.remembered().recent().mid(0, most_shown);
  QStringList labels, tips;
  for (const RecentEntry& entry : entries) {
    labels << label_of(entry, entries);
    tips << files_of(entry).join("\n");
  }
  page.setRecent(labels, tips);
}

/// What other parts of the program offer to begin with, by the ids of their actions.
void add_starts(MainWindow& window, WelcomePage& page) {
  for (const char* id : {"file.open", "file.generated_dance", "file.generated_fight", "library.build_library",
                         "live.connect_to_a_stream"}) {
    QAction* action = action_of(window, id);
    if (!action) continue;
    page.addStart(action->text(), action->shortcut().toString(QKeySequence::NativeText),
                  [action] { action->trigger(); });
  }
}

/// Beside the page there is still a scene.
bool has_room_for(const WelcomePage& page, MainWindow& window) {
  return window.width() >= page.minimumWidth() + window.scene().minimumWidth();
}

}  // namespace

void add_welcome_actions(MainWindow& window) {
  QMenu* files = menu_of(window, "File");
  QAction* fight =
      add_action(window, files, "Generated fight", {}, [&window] { window.openMaterial(generated_fight); });
  if (QAction* dance = action_of(window, "file.generated_dance")) {
    files->removeAction(fight);
    files->insertAction(dance, fight);
    files->removeAction(dance);
    files->insertAction(fight, dance);
  }
  auto* page = new WelcomePage;
  page->hide();
  window.colour(page);
  page->setShownAtStart(window.remembered().welcome());
  add_starts(window, *page);
  show_recent(window, *page);
  window.addBesideScene(page);
  QAction* show = add_action(window, menu_of(window, "Help"), "Welcome", {}, [] {});
  show->setCheckable(true);
  QObject::connect(show, &QAction::toggled, page, [page, show, &window](bool on) {
    page->setVisible(on);
    if (on && !has_room_for(*page, window))
      window.messages().showInformation("The welcome page needs a wider window");
    window.panels().leaveRoomBeside(on ? page->minimumWidth() : 0);
    if (on)
      page->setFocus();
    else
      window.scene().setFocus();
    show->setChecked(on);
  });
  QObject::connect(&window, &MainWindow::panelsArranged, page, [page, show, &window] {
    page->setVisible(show->isChecked() && has_room_for(*page, window));
  });
  QObject::connect(&window.document(), &Document::began, page,
                   [&window, page] { page->showAbout(window.session()->material().is_generated); });
  QObject::connect(page, &WelcomePage::closeRequested, show, [show] { show->setChecked(false); });
  QObject::connect(page, &WelcomePage::shownAtStartChanged, page,
                   [&window](bool on) { window.remembered().setWelcome(on); });
  QObject::connect(page, &WelcomePage::recentChosen, page,
                   [&window](int which) { open_recent(window, window.remembered().recent().value(which)); });
  QObject::connect(&window, &MainWindow::filesOpened, page, [&window, page, show] {
    show_recent(window, *page);
    show->setChecked(false);  // the work has begun
  });
}

void welcome_at_start(MainWindow& window) {
  QAction* show = action_of(window, "help.welcome");
  if (show && window.remembered().welcome() && window.width() >= least_width) show->setChecked(true);
}

}  // namespace abrazo::app
