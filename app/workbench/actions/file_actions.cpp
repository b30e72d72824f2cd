#include <QAction>
#include <QDateTime>
#include <QFileDialog>
#include <QFileInfo>
#include <QMenu>
#include <QSaveFile>
#include <QScreen>
#include <QStandardPaths>

#include "app/workbench/actions/actions.hpp"
#include "app/workbench/main_window.hpp"
#include "widgets/common/message_bar.hpp"
#include "widgets/scene/scene_view.hpp"

namespace abrazo::app {
namespace {

void choose_files(MainWindow& window) {
  const QStringList files =
      QFileDialog::getOpenFileNames(&window, "Open", window.remembered().lastFolder(),
                                    "All that Abrazo opens (*.bvh *.amc *.asf *.h5 *.json);;Motions "
                                    "(*.bvh *.amc *.asf);;Libraries (*.h5 *.json);;All files (*)");
  if (files.isEmpty()) return;
  window.remembered().setLastFolder(QFileInfo(files.front()).absolutePath());
  window.openFiles(files);
}

void take_screenshot(MainWindow& window) {
  QString folder = QStandardPaths::writableLocation(QStandardPaths::PicturesLocation);
  if (folder.isEmpty() || !QFileInfo(folder).isDir()) folder = window.remembered().folder();
  const QString file =
      folder + "/abrazo-" + QDateTime::currentDateTime().toString("yyyyMMdd-HHmmss-zzz") + ".png";
  const QString trouble = save_screenshot(window, file);
  trouble.isEmpty() ? window.messages().showInformation("Picture written to " + file)
                    : window.messages().showError(trouble);
}

}  // namespace

QAction* add_action(MainWindow& window, QMenu* menu, const QString& text,
                    std::initializer_list<QKeySequence> keys, std::function<void()> act) {
  auto* action = new QAction(text, &window);
  action->setShortcuts(QList<QKeySequence>(keys));
  action->setShortcutContext(Qt::WindowShortcut);
  QObject::connect(action, &QAction::triggered, &window, std::move(act));
  menu->addAction(action);
  window.addAction(action);
  return action;
}

QString save_screenshot(MainWindow& window, const QString& file) {
  QSaveFile target(file);
  if (!target.open(QIODevice::WriteOnly))
    return file + ": cannot be written (" + target.errorString() + "); choose another folder";
  window.scene().renderSharp();
  if (!window.grab().toImage().save(&target, "PNG") || !target.commit())
    return file + ": cannot be written (" + target.errorString() + "); check that the disk is not full";
  return {};
}

void add_file_actions(MainWindow& window) {
  QMenu* menu = window.menu("File");
  add_action(window, menu, "Open…", {QKeySequence("Ctrl+O")}, [&window] { choose_files(window); });
  add_action(window, menu, "Generated dance", {}, [&window] { window.openDemo(); });
  menu->addSeparator();
  add_action(window, menu, "Save picture of the window", {QKeySequence("F12")},
             [&window] { take_screenshot(window); });
  menu->addSeparator();
  add_action(window, menu, "Quit", {QKeySequence("Ctrl+Q")}, [&window] { window.close(); });
}

}  // namespace abrazo::app
