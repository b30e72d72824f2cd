#include <QAction>
#include <QFileDialog>
#include <QFileInfo>
#include <QMenu>

#include "app/workbench/library/import_desk.hpp"
#include "app/workbench/shell/actions.hpp"
#include "app/workbench/shell/main_window.hpp"
#include "core/motion/joints/motion_format.hpp"
#include "widgets/common/message_bar.hpp"

namespace abrazo::app {
namespace {

void import_motion(MainWindow& window, ImportDesk& desk) {
  const QStringList files = QFileDialog::getOpenFileNames(
      &window, "Import a motion", window.remembered().lastFolder(),
      QString("Motions, their skeleton and joint map (%1 *.json);;All files (*)")
          .arg(QString::fromStdString(motion_file_patterns(true))));
  if (files.isEmpty()) return;
  window.remembered().setLastFolder(QFileInfo(files.front()).absolutePath());
  desk.offer(files);
}

}  // namespace

void add_import_actions(MainWindow& window) {
  auto* desk = new ImportDesk(window);
  QMenu* menu = window.menu("File");
  QAction* const import = add_action(window, menu, "Import motion…", {QKeySequence("Ctrl+Shift+I")},
                                     [&window, desk] { import_motion(window, *desk); });
  QAction* const anew = add_action(window, menu, "Import options of the open motion…", {}, [&window, desk] {
    if (!desk->offerOpenOne())
      window.messages().showInformation(
          "The open input is not a motion file; open one, or import it by File > Import motion");
  });
  QAction* const rules = add_action(window, menu, "Remembered imports…", {}, [desk] { desk->showRules(); });
  for (QAction* action : {import, anew, rules})
    move_before(*menu, action, action_of(window, "file.generated_dance"));
}

}  // namespace abrazo::app
