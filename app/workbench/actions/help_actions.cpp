#include <QAction>
#include <QDialog>
#include <QLabel>
#include <QMenu>
#include <QShortcut>
#include <QVBoxLayout>

#include "app/workbench/actions/actions.hpp"
#include "app/workbench/main_window.hpp"
#include "core/base/version.hpp"

namespace abrazo::app {
namespace {

QString key_rows(MainWindow& window, const QString& menu) {
  QString rows;
  for (const QAction* action : window.menu(menu)->actions()) {
    if (action->shortcuts().isEmpty()) continue;
    QStringList keys;
    for (const QKeySequence& key : action->shortcuts())
      keys << key.toString(QKeySequence::NativeText).toHtmlEscaped();
    rows += QString("<tr><td><b>%1</b>&nbsp;&nbsp;&nbsp;</td><td>%2</td></tr>")
                .arg(keys.join(", "), action->text().toHtmlEscaped());
  }
  return QString("<p style='color:%1'>%2</p><table cellspacing=3>%3</table>")
      .arg(window.colours().secondary.name(), menu.toUpper(), rows);
}

/// Read off the actions themselves, so that it cannot be out of date.
QString key_sheet(MainWindow& window) {
  const QString mouse =
      QString(
          "<p style='color:%1'>SCENE</p><table cellspacing=3>"
          "<tr><td><b>drag</b>&nbsp;&nbsp;&nbsp;</td><td>Turn (left or middle button)</td></tr>"
          "<tr><td><b>Shift + middle, right</b>&nbsp;&nbsp;&nbsp;</td><td>Move</td></tr>"
          "<tr><td><b>wheel</b></td><td>Nearer, farther</td></tr></table>"
          "<p style='color:%1'>TIMELINE</p><table cellspacing=3>"
          "<tr><td><b>drag</b>&nbsp;&nbsp;&nbsp;</td><td>Go to a time; what comes in goes on being "
          "solved</td></tr>"
          "<tr><td><b>wheel</b></td><td>Shorter or longer span</td></tr></table>")
          .arg(window.colours().secondary.name());
  return "<table><tr><td>" + key_rows(window, "Play") + "</td><td width=36></td><td>" +
         key_rows(window, "View") + key_rows(window, "File") + key_rows(window, "Edit") +
         key_rows(window, "Solve") + "</td><td width=36></td><td>" + mouse + "</td></tr></table>";
}

void show_sheet(MainWindow& window, const QString& title, const QString& html) {
  // Whichever window has the keyboard, F1 closes it again.
  if (auto* open = window.findChild<QDialog*>(title)) return static_cast<void>(open->close());
  auto* dialog = new QDialog(&window);
  dialog->setObjectName(title);
  QObject::connect(new QShortcut(QKeySequence("F1"), dialog), &QShortcut::activated, dialog, &QDialog::close);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setWindowTitle(title);
  auto* column = new QVBoxLayout(dialog);
  column->setContentsMargins(24, 16, 24, 20);
  auto* text = new QLabel(html, dialog);
  text->setTextFormat(Qt::RichText);
  column->addWidget(text);
  QObject::connect(dialog, &QDialog::finished, &window, [&window] { window.activateWindow(); });
  dialog->show();
  dialog->activateWindow();
}

}  // namespace

void add_help_actions(MainWindow& window) {
  QMenu* menu = window.menu("Help");
  add_action(window, menu, "Keys", {QKeySequence("F1"), QKeySequence("?")},
             [&window] { show_sheet(window, "Keys", key_sheet(window)); });
  add_action(window, menu, "About Abrazo", {}, [&window] {
    show_sheet(window, "About Abrazo",
               QString("<h3>Abrazo %1</h3><p>A workbench for partner control in close interactions.</p>"
                       "<p>Free software under the GNU Affero General Public Licence, version 3 or later.<br>"
                       "Comes without any warranty.</p>")
                   .arg(version()));
  });
}

}  // namespace abrazo::app
