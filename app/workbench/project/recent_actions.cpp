#include <QAction>
#include <QMenu>
#include <algorithm>

#include "app/workbench/base/recent_files.hpp"
#include "app/workbench/shell/actions.hpp"
#include "app/workbench/shell/main_window.hpp"
#include "widgets/common/message_bar.hpp"
#include "widgets/common/plain_text.hpp"

namespace abrazo::app {
namespace {

void fill(MainWindow& window, QMenu& menu) {
  menu.clear();
  const QStringList entries = window.remembered().recent();
  for (const RecentEntry& entry : entries) {
    const bool is_missing = !missing_of(entry).isEmpty();
    QAction* action =
        menu.addAction(label_of(entry, entries).replace('&', "&&") + (is_missing ? "  (missing)" : ""));
    action->setToolTip(widgets::plain_tip(files_of(entry).join("\n")));
    QObject::connect(action, &QAction::triggered, &window, [&window, entry] { open_recent(window, entry); });
  }
  if (entries.isEmpty()) menu.addAction("Nothing has been opened yet")->setEnabled(false);
  menu.addSeparator();
  menu.addAction("Remove missing files from the list", &window, [&window] { remove_missing_recent(window); })
      ->setEnabled(
          std::ranges::any_of(entries, [](const auto& entry) { return !missing_of(entry).isEmpty(); }));
  menu.addAction("Clear the list", &window, [&window] { window.remembered().setRecent({}); })
      ->setEnabled(!entries.isEmpty());
}

}  // namespace

void open_recent(MainWindow& window, const QString& entry) {
  const QStringList missing = missing_of(entry);
  if (missing.isEmpty()) return window.openFiles(files_of(entry));
  window.messages().showError(missing.join(", ") +
                              ": no longer exists; open it from where it is now (File > Open), or remove it "
                              "from the list (File > Open recent)");
}

void remove_missing_recent(MainWindow& window) {
  const QStringList before = window.remembered().recent();
  QStringList there;
  for (const RecentEntry& entry : before)
    if (missing_of(entry).isEmpty()) there << entry;
  window.remembered().setRecent(there);
  window.messages().showInformation(
      QString("%1 removed from the list of recent files").arg(before.size() - there.size()));
}

void add_recent_actions(MainWindow& window) {
  QMenu* files = menu_of(window, "File");
  auto* recent = new QMenu("Open recent", files);
  recent->setToolTipsVisible(true);
  files->insertMenu(files->actions().value(1), recent);  // below Open
  fill(window, *recent);
  QObject::connect(recent, &QMenu::aboutToShow, recent, [&window, recent] { fill(window, *recent); });
  QObject::connect(&window, &MainWindow::filesOpened, recent, [&window](const QStringList& opened) {
    window.remembered().setRecent(with_recent(window.remembered().recent(), opened));
  });
}

}  // namespace abrazo::app
