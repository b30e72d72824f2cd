#include <QAction>
#include <QClipboard>
#include <QDateTime>
#include <QDesktopServices>
#include <QDir>
#include <QFileInfo>
#include <QGuiApplication>
#include <QImage>
#include <QMenu>
#include <QSaveFile>
#include <QStandardPaths>
#include <QUrl>

#include "app/workbench/base/file_dialogs.hpp"
#include "app/workbench/shell/actions.hpp"
#include "app/workbench/shell/main_window.hpp"
#include "app/workbench/shell/scene_picture.hpp"
#include "core/motion/joints/motion_format.hpp"
#include "widgets/common/message_bar.hpp"
#include "widgets/common/offer_bar.hpp"
#include "widgets/scene/view/scene_view.hpp"

namespace abrazo::app {
namespace {

void choose_files(MainWindow& window) {
  const QStringList files =
      ask_files(&window, window.remembered(), "Open",
                QString("All files that Abrazo opens (%1 *.h5 *.json *.abrazo *.eaf);;Motions "
                        "(%1);;Libraries (*.h5 *.json);;Sessions (*.abrazo);;All files (*)")
                    .arg(QString::fromStdString(motion_file_patterns(true))));
  if (!files.isEmpty()) window.openFiles(files);
}

QString picture_file() {
  QString folder = QStandardPaths::writableLocation(QStandardPaths::PicturesLocation);
  if (folder.isEmpty() || !QDir().mkpath(folder)) folder = QDir::homePath();
  return folder + "/abrazo-" + QDateTime::currentDateTime().toString("yyyyMMdd-HHmmss-zzz") + ".png";
}

void tell_picture(MainWindow& window, widgets::OfferBar& bar, const QString& file, const QString& trouble) {
  if (!trouble.isEmpty()) return window.messages().showErrorOf("picture", trouble);
  const QString text = "Picture written to " + file;
  window.messages().succeed("picture", text, true);
  bar.offer(text, "Show in folder",
            [file] { QDesktopServices::openUrl(QUrl::fromLocalFile(QFileInfo(file).absolutePath())); });
}

/// Whole or not at all. @return what went wrong, or nothing
QString write_picture(const QImage& picture, const QString& file) {
  QSaveFile target(file);
  if (!target.open(QIODevice::WriteOnly))
    return file + ": cannot be written (" + target.errorString() + "); choose another folder";
  if (!picture.save(&target, "PNG") || !target.commit())
    return file + ": cannot be written (" + target.errorString() + "); check that the disk is not full";
  return {};
}

QImage picture_of(MainWindow& window) {
  window.scene().renderSharp();
  return window.grab().toImage();
}

void add_pictures(MainWindow& window, QMenu* menu) {
  auto* bar = new widgets::OfferBar;
  bar->setObjectName("picture written");
  window.colour(bar);
  window.addBelowMessages(bar);
  add_action(window, menu, "Save picture of the window", {QKeySequence("F12")}, [&window, bar] {
    const QString file = picture_file();
    tell_picture(window, *bar, file, save_screenshot(window, file));
  });
  add_action(window, menu, "Save picture of the scene, without background", {QKeySequence("Shift+F12")},
             [&window, bar] {
               const QString file = picture_file();
               tell_picture(window, *bar, file, write_picture(transparent_picture(window.scene()), file));
             });
  add_action(window, menu, "Copy picture of the scene", {QKeySequence("Ctrl+Shift+C")}, [&window] {
    QGuiApplication::clipboard()->setImage(window.scene().picture());
    window.messages().showInformation("The picture is on the clipboard");
  });
  add_action(window, menu, "Copy picture of the window", {}, [&window] {
    QGuiApplication::clipboard()->setImage(picture_of(window));
    window.messages().showInformation("The picture is on the clipboard");
  });
}

}  // namespace

QString save_screenshot(MainWindow& window, const QString& file) {
  return write_picture(picture_of(window), file);
}

void add_file_actions(MainWindow& window, RenderDialog& dialog) {
  QMenu* menu = menu_of(window, "File");
  add_action(window, menu, "Open…", {QKeySequence("Ctrl+O")}, [&window] { choose_files(window); });
  add_action(window, menu, "Generated dance", {}, [&window] { window.openDemo(); });
  menu->addSeparator();
  add_pictures(window, menu);
  add_recording_actions(window, dialog);
  menu->addSeparator();
  add_action(window, menu, "Quit", {QKeySequence("Ctrl+Q")}, [&window] { window.close(); });
}

}  // namespace abrazo::app
