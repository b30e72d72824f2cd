#include <QAction>
#include <QDialog>
#include <QDialogButtonBox>
#include <QDockWidget>
#include <QGuiApplication>
#include <QMenu>
#include <QPointer>
#include <QPushButton>
#include <QScreen>
#include <QShortcut>
#include <QTextBrowser>
#include <algorithm>
#include <array>

#include "app/workbench/keys/help_window.hpp"
#include "app/workbench/keys/key_sheet.hpp"
#include "app/workbench/keys/shortcut_dialog.hpp"
#include "app/workbench/keys/shortcuts.hpp"
#include "app/workbench/shell/actions.hpp"
#include "app/workbench/shell/main_window.hpp"
#include "app/workbench/shell/panel_area.hpp"
#include "core/base/version.hpp"
#include "widgets/common/parts.hpp"
#include "widgets/timeline/timeline_view.hpp"

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

/// The page about the panel that has the keyboard, by its id; empty elsewhere.
QString page_of_focus(MainWindow& window) {
  constexpr std::array<std::array<const char*, 2>, 11> pages = {
      {{"annotation", "guide/annotation.md"},
       {"candidates", "guide/workbench/candidates.md"},
       {"compare", "guide/workbench/compare.md"},
       {"connection", "guide/live.md"},
       {"latency", "guide/live/latency.md"},
       {"library", "guide/workbench/library.md"},
       {"plots", "guide/workbench/plots.md"},
       {"recording", "guide/live/recording.md"},
       {"scene", "guide/workbench/scene.md"},
       {"settings", "guide/workbench/settings.md"},
       {"video", "guide/video.md"}}};
  const QWidget* focus = window.focusWidget();
  if (!focus) return {};
  if (window.timeline().isAncestorOf(focus) || focus == &window.timeline())
    return "guide/workbench/timeline.md";
  for (const auto& [id, page] : pages)
    if (const QDockWidget* dock = window.panels().panel(id); dock && dock->isAncestorOf(focus)) return page;
  return {};
}

}  // namespace

void add_help_actions(MainWindow& window, Shortcuts& shortcuts) {
  QMenu* menu = menu_of(window, "Help");
  add_action(window, menu, "Help", {QKeySequence("F1")},
             [&window, &shortcuts, help = QPointer<HelpWindow>()]() mutable {
               if (!help) help = new HelpWindow(&window);
               if (help->isVisible()) return void(help->close());
               help->showAbout(page_of_focus(window));
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
                "<p>The method: Ho, Chan, Komura and Leung, <i>Interactive partner control in close<br>"
                "interactions for real-time applications</i>, ACM TOMM 9(3), 2013,<br>"
                "<a href='https://doi.org/10.1145/2487268.2487274'>doi:10.1145/2487268.2487274</a></p>"
                "<p>Built with VTK, Qt, Eigen, FLANN, TetGen and OpenCV.</p>"
                "<p>Free software under the "
                "<a href='https://www.gnu.org/licenses/agpl-3.0.html'>GNU Affero General Public License</a>,"
                "<br>version 3 or later. Comes without any warranty.</p>")
            .arg(version()));
    if (!about) return;
    about->findChild<QTextBrowser*>()->setOpenExternalLinks(true);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, about);
    about->layout()->addWidget(buttons);
    QObject::connect(buttons, &QDialogButtonBox::rejected, about, &QDialog::close);
    about->show();
  });
}

}  // namespace abrazo::app
