#include "widgets/common/file_dialog.hpp"

#include <QDateTime>
#include <QFileDialog>
#include <QFileInfo>
#include <QHeaderView>
#include <QLocale>
#include <QRegularExpression>
#include <QTimer>
#include <QTreeView>
#include <algorithm>
#include <array>

namespace abrazo::widgets {
namespace {

constexpr int least_name_letters = 24;

/// Qt's dialog has columns for its own style: with wider margins sizes and dates are cut. Names get the rest.
void widen_columns(QFileDialog& dialog) {
  auto* list = dialog.findChild<QTreeView*>("treeView");
  if (!list || !list->header()) return;  // a dialog of the desktop
  const QFontMetrics font = list->fontMetrics();
  const QString date =
      QLocale().toString(QDateTime(QDate(2028, 12, 28), QTime(20, 58, 58)), QLocale::ShortFormat);
  const std::array<QString, 4> widest = {QString(), "888.88 MiB", "jsonl File", date};
  const int margin = font.horizontalAdvance("mmm");
  int rest = list->viewport()->width();
  for (int column = 1; column < std::min(list->header()->count(), static_cast<int>(widest.size()));
       ++column) {
    const QString& words = widest.at(static_cast<std::size_t>(column));
    const int width = std::max(list->columnWidth(column), font.horizontalAdvance(words) + margin);
    list->setColumnWidth(column, width);
    rest -= list->isColumnHidden(column) ? 0 : width;
  }
  const int least = least_name_letters * font.averageCharWidth();
  list->setColumnWidth(0, std::max(rest, least));
  if (rest < least) dialog.resize(dialog.width() + least - rest, dialog.height());
}

QStringList ask(QFileDialog& dialog, const QString& filter) {
  dialog.setNameFilters(filter.split(";;", Qt::SkipEmptyParts));
  // The columns share the width that the dialog has once it is laid out.
  QTimer::singleShot(0, &dialog, [&dialog] { widen_columns(dialog); });
  return dialog.exec() == QDialog::Accepted ? dialog.selectedFiles() : QStringList();
}

QStringList ask_existing(QWidget* parent, const QString& title, const QString& folder, const QString& filter,
                         QFileDialog::FileMode mode) {
  QFileDialog dialog(parent, title, folder);
  dialog.setFileMode(mode);
  return ask(dialog, filter);
}

}  // namespace

QStringList choose_files(QWidget* parent, const QString& title, const QString& folder,
                         const QString& filter) {
  return ask_existing(parent, title, folder, filter, QFileDialog::ExistingFiles);
}

QString choose_file(QWidget* parent, const QString& title, const QString& folder, const QString& filter) {
  return ask_existing(parent, title, folder, filter, QFileDialog::ExistingFile).value(0);
}

QString choose_folder(QWidget* parent, const QString& title, const QString& folder) {
  QFileDialog dialog(parent, title, folder);
  dialog.setFileMode(QFileDialog::Directory);
  dialog.setOption(QFileDialog::ShowDirsOnly);
  return ask(dialog, {}).value(0);
}

QString choose_new_file(QWidget* parent, const QString& title, const QString& path, const QString& ending,
                        const QString& filter, bool is_asked) {
  const QFileInfo proposed(path);
  const QString folder = proposed.path() == "." ? QString() : proposed.path();  // empty = the last one
  QFileDialog dialog(parent, title, proposed.isDir() ? path : folder);
  dialog.setFileMode(QFileDialog::AnyFile);
  dialog.setAcceptMode(QFileDialog::AcceptSave);
  dialog.setDefaultSuffix(ending);
  QObject::connect(&dialog, &QFileDialog::filterSelected, &dialog, [&dialog, ending](const QString& chosen) {
    const auto own = QRegularExpression(R"(\*(\.\w+))").match(chosen);
    dialog.setDefaultSuffix(own.hasMatch() ? own.captured(1) : ending);
  });
  dialog.setOption(QFileDialog::DontConfirmOverwrite, !is_asked);
  if (!proposed.isDir()) dialog.selectFile(proposed.fileName());
  return ask(dialog, filter).value(0);
}

}  // namespace abrazo::widgets
