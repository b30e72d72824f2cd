#include <QAction>
#include <QDateTime>
#include <QDir>
#include <QFileInfo>
#include <QMenu>
#include <QMessageBox>
#include <QRegularExpression>
#include <QSettings>
#include <array>

#include "app/workbench/export/export_desk.hpp"
#include "app/workbench/export/export_dialog.hpp"
#include "app/workbench/shell/actions.hpp"
#include "app/workbench/shell/main_window.hpp"
#include "widgets/common/file_dialog.hpp"
#include "widgets/common/message_bar.hpp"

namespace abrazo::app {
namespace {

/// What was chosen last lies beside the settings of the window.
QSettings last_choices(const MainWindow& window) {
  return {window.remembered().folder() + "/export.ini", QSettings::IniFormat};
}

QString proposed_name(const ExportRequest& request) {
  static constexpr std::array<const char*, 4> names = {"motion", "mesh", "labels", "trace"};
  const QString of = request.plots ? "plots"
                     : !request.library_take.isEmpty()
                         ? request.library_take
                         : names.at(static_cast<std::size_t>(request.wish.content));
  // A take's name may be malicious and lead to another folder.
  return QString(of).replace(QRegularExpression("[/\\\\:\\x00-\\x1f]"), "_") + "-" +
         QDateTime::currentDateTime().toString("yyyyMMdd-HHmmss") +
         QString::fromStdString(request.wish.output);
}

QString ask_file(MainWindow& window, ExportDialog& dialog, const ExportRequest& request) {
  const QString ending = QString::fromStdString(request.wish.output);
  const QString last = window.remembered().lastFolder();
  const QDir folder(last.isEmpty() ? QDir::homePath() : last);
  // The typed name is not always the one of the files that are written: may_replace asks.
  return widgets::choose_new_file(&dialog, "Export", folder.filePath(proposed_name(request)), ending,
                                  QString("%1 (*%2);;All files (*)").arg(ending.mid(1).toUpper(), ending),
                                  false);
}

/// Asks about files that exist already. Those of the frames of a series follow its name.
bool may_replace(ExportDialog& dialog, const ExportRequest& request, const QString& file) {
  ExportWish wish = request.wish;
  wish.output = file.toStdString();
  QStringList replaced;
  for (const std::string& each : wish.files())
    if (const QFileInfo info(QString::fromStdString(each)); info.exists()) replaced << info.fileName();
  if (replaced.isEmpty()) return true;
  QMessageBox box(QMessageBox::NoIcon, "Export", "Replace " + replaced.join(", ") + "?",
                  QMessageBox::Yes | QMessageBox::No, &dialog);
  box.setDefaultButton(QMessageBox::No);
  return box.exec() == QMessageBox::Yes;
}

void start(MainWindow& window, ExportDialog& dialog, ExportDesk& desk) {
  QString file = ask_file(window, dialog, dialog.request());
  if (file.isEmpty()) return;
  dialog.chooseTypeOf(file);
  if (!dialog.canExport()) return;  // not as that type: the dialog says why
  const ExportRequest request = dialog.request();
  const QString ending = QString::fromStdString(request.wish.output);
  if (!file.endsWith(ending, Qt::CaseInsensitive)) file += ending;
  if (!may_replace(dialog, request, file)) return;
  window.remembered().setLastFolder(QFileInfo(file).absolutePath());
  last_choices(window).setValue("choices", dialog.choices());
  dialog.hide();
  desk.write(request, file);
}

}  // namespace

void add_export_actions(MainWindow& window, std::function<RecordedTakes()> takes) {
  auto* desk = new ExportDesk(window, std::move(takes));
  auto* dialog = new ExportDialog(&window);
  QMenu* menu = menu_of(window, "File");
  const auto show = [&window, dialog, desk](bool labels) {
    if (!window.session()) return window.messages().showInformation("Nothing is open yet");
    dialog->offer(desk->offer());
    dialog->setFolder(window.remembered().lastFolder());
    dialog->restore(last_choices(window).value("choices").toStringList());
    if (labels) dialog->chooseLabels(QString::fromStdString(window.document().subject()));
    dialog->show();
    dialog->activateWindow();
  };
  QAction* open = add_action(window, menu, "Export…", {}, [show] { show(false); });
  QMenu* annotation = menu_of(window, "Annotation");
  QAction* labels = add_action(window, annotation, "Export labels…", {}, [show] { show(true); });
  if (QAction* import = action_of(window, "annotation.import_labels")) {
    move_before(*annotation, labels, import);
    move_before(*annotation, import, labels);
  }
  move_before(*menu, open, action_of(window, "file.save_picture_of_the_window"));
  QObject::connect(dialog, &ExportDialog::exportRequested, dialog,
                   [&window, dialog, desk] { start(window, *dialog, *desk); });
  QObject::connect(dialog, &ExportDialog::videoRequested, dialog, [&window, dialog] {
    dialog->hide();
    if (QAction* render = action_of(window, "file.render_range")) render->trigger();
  });
}

}  // namespace abrazo::app
