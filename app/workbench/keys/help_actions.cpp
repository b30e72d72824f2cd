#include <QAction>
#include <QDialog>
#include <QGuiApplication>
#include <QMenu>
#include <QPointer>
#include <QPushButton>
#include <QScreen>
#include <QShortcut>
#include <QTextBrowser>
#include <algorithm>

#include "app/workbench/keys/help_window.hpp"
#include "app/workbench/keys/key_sheet.hpp"
#include "app/workbench/keys/shortcut_dialog.hpp"
#include "app/workbench/keys/shortcuts.hpp"
#include "app/workbench/shell/actions.hpp"
#include "app/workbench/shell/main_window.hpp"
#include "core/base/version.hpp"
#include "widgets/common/parts.hpp"

namespace abrazo::app {
namespace {

constexpr int column_width = 360;  // of keys

void show_shortcuts(MainWindow& window, Shortcuts& shortcuts) {
  auto* dialog = window.findChild<ShortcutDialog*>();
  if (!dialog) {
    dialog = new ShortcutDialog(shortcuts, &window);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
  }
  dialog->show();
  dialog->raise();
  dialog->activateWindow();
}

/// For the text of a sheet, beside its margins and buttons.
QSize room_on_screen() {
  return QGuiApplication::primaryScreen()->availableSize() * 9 / 10 - QSize(60, 90);
}

QDialog* show_sheet(MainWindow& window, const QString& title, const QString& html) {
  // Whichever window has the keyboard, the key that opened it closes it again.
  if (auto* open = window.findChild<QDialog*>(title)) return open->close(), nullptr;
  auto* dialog = new QDialog(&window);
  dialog->setObjectName(title);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setWindowTitle(title);
  auto* column = widgets::column_in(dialog, {24, 16, 24, 20});
  // A label lays a text of this length out seven times, which takes half a second.
  auto* text = new QTextBrowser(dialog);
  text->setFrameShape(QFrame::NoFrame);
  text->viewport()->setAutoFillBackground(false);
  text->setLineWrapMode(QTextEdit::NoWrap);
  text->document()->setDocumentMargin(0);
  text->setHtml(html);
  text->setAccessibleName(title);
  text->setMinimumSize((text->document()->size().toSize() + QSize(18, 4)).boundedTo(room_on_screen()));
  column->addWidget(text);
  QObject::connect(dialog, &QDialog::finished, &window, [&window] { window.activateWindow(); });
  return dialog;
}

void show_keys(MainWindow& window, Shortcuts& shortcuts) {
  const int columns = std::clamp(room_on_screen().width() / column_width, 2, 4);
  QDialog* dialog = show_sheet(window, "Keys", key_sheet(shortcuts.table(), window.colours(), columns));
  if (!dialog) return;
  QObject::connect(new QShortcut(QKeySequence("?"), dialog), &QShortcut::activated, dialog, &QDialog::close);
  auto* change = new QPushButton("Change keys…", dialog);
  change->setAutoDefault(false);
  dialog->layout()->addWidget(change);
  dialog->layout()->setAlignment(change, Qt::AlignRight);
  QObject::connect(change, &QPushButton::clicked, dialog, [&window, &shortcuts, dialog] {
    dialog->close();
    show_shortcuts(window, shortcuts);
  });
  dialog->show();
  dialog->activateWindow();
}

}  // namespace

void add_help_actions(MainWindow& window, Shortcuts& shortcuts) {
  QMenu* menu = menu_of(window, "Help");
  add_action(window, menu, "Help", {QKeySequence("F1")},
             [&window, &shortcuts, help = QPointer<HelpWindow>()]() mutable {
               if (!help) help = new HelpWindow(&window);
               if (help->isVisible()) return void(help->close());
               help->setKeys(key_sheet(shortcuts.table(), window.colours(), 1));
               help->show();
               help->activateWindow();
             });
  add_action(window, menu, "Keys", {QKeySequence("?")},
             [&window, &shortcuts] { show_keys(window, shortcuts); });
  add_action(window, menu, "Shortcuts…", {}, [&window, &shortcuts] { show_shortcuts(window, shortcuts); });
  add_action(window, menu, "About Abrazo", {}, [&window] {
    QDialog* about = show_sheet(
        window, "About Abrazo",
        QString("<h3>Abrazo %1</h3><p>A workbench for partner control in close interactions.</p>"
                "<p>Free software under the GNU Affero General Public Licence, version 3 or later.<br>"
                "Comes without any warranty.</p>")
            .arg(version()));
    if (about) about->show();
  });
}

}  // namespace abrazo::app
