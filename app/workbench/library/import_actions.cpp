#include <QAction>
#include <QMenu>

#include "app/workbench/base/file_dialogs.hpp"
#include "app/workbench/library/import_desk.hpp"
#include "app/workbench/shell/actions.hpp"
#include "app/workbench/shell/main_window.hpp"
#include "core/motion/joints/motion_format.hpp"
#include "widgets/common/message_bar.hpp"

namespace abrazo::app {
namespace {

void import_motion(MainWindow& window, ImportDesk& desk) {
  const QStringList files =
      ask_files(&window, window.remembered(), "Import a motion",
                QString("Motions, their skeleton and joint map (%1 *.json);;All files (*)")
                    .arg(QString::fromStdString(motion_file_patterns(true))));
  if (!files.isEmpty()) desk.offer(files);
}

}  // namespace

void add_import_actions(MainWindow& window) {
  auto* desk = new ImportDesk(window);
  QMenu* menu = menu_of(window, "File");
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
