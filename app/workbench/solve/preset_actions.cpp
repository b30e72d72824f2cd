#include <QFileInfo>
#include <QInputDialog>
#include <QMenu>
#include <memory>

#include "app/workbench/base/error_words.hpp"
#include "app/workbench/base/file_dialogs.hpp"
#include "app/workbench/base/own_presets.hpp"
#include "app/workbench/shell/actions.hpp"
#include "app/workbench/shell/main_window.hpp"
#include "app/workbench/shell/panel_area.hpp"
#include "core/base/atomic_file.hpp"
#include "core/opening/opened_session.hpp"
#include "widgets/common/message_bar.hpp"
#include "widgets/settings/preset_bar.hpp"
#include "widgets/settings/settings_panel.hpp"

namespace abrazo::app {
namespace {

using widgets::PresetBar;
using widgets::SettingsPanel;
using Store = std::shared_ptr<OwnPresets>;

void show(MainWindow& window, const Store& store) {
  window.settings().presets().setOwn(store->all());
  window.document().put(store->all());
}

/// Shows the stored presets, or why the change failed. @return whether it succeeded
bool settle(MainWindow& window, const Store& store, const Status& done) {
  if (done)
    show(window, store);
  else
    window.messages().showError(words(done.error()));
  return done.ok();
}

/// Does not block, so that the scene keeps running.
void ask_name(MainWindow& window, const QString& title, const QString& proposal,
              const std::function<void(const QString&)>& answered) {
  auto* dialog = new QInputDialog(&window);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setObjectName("presetName");
  dialog->setWindowTitle(title);
  dialog->setLabelText("Name of the preset");
  dialog->setTextValue(proposal);
  QObject::connect(dialog, &QInputDialog::textValueSelected, &window, answered);
  dialog->open();
}

void save_as(MainWindow& window, const Store& store, const QString& name) {
  if (settle(window, store, store->save(name.toStdString(), window.document().settings())))
    window.document().choosePreset(name.trimmed(), true);
}

void rename(MainWindow& window, const Store& store, const QString& from, const QString& to) {
  const PresetChoice& chosen = window.document().live().preset();
  const bool was_chosen =
      chosen.own && chosen.name == from.toStdString() && chosen.settings == window.document().settings();
  if (settle(window, store, store->rename(from.toStdString(), to.toStdString())) && was_chosen)
    window.document().choosePreset(to.trimmed(), true);
}

void export_settings(MainWindow& window) {
  const QString file = ask_new_file(&window, window.remembered(), "Export these settings", "settings.json",
                                    ".json", "Settings (*.json)");
  if (file.isEmpty()) return;
  const Status written =
      write_whole_file(file.toStdString(), readable_settings(window.document().settings()));
  written ? window.messages().showInformation("Settings written to " + file)
          : window.messages().showError(words(written.error()));
}

void import_settings(MainWindow& window) {
  const QString file = ask_file(&window, window.remembered(), "Import settings", "Settings (*.json)");
  if (file.isEmpty()) return;
  const auto settings = read_settings_file(file.toStdString(), window.document().settings());
  if (!settings) return window.messages().showError(words(settings.error()));
  window.document().adopt(*settings, "import of " + QFileInfo(file).fileName());
}

/// A session brings the presets along that were a person's own when it was saved.
void adopt_with(MainWindow& window, const Store& store) {
  QObject::connect(&window.document(), &Document::began, &window.settings(), [&window, store] {
    const auto opened = window.session()->material().project;
    if (!opened || opened->project().presets.empty()) return;
    const auto added = store->adopt(opened->project().presets, "presets of the session");
    if (!added) return window.messages().showError(words(added.error()));
    if (*added == 0) return;
    show(window, store);
    window.messages().showInformation(QString("Presets that came with the session: %1").arg(*added));
  });
}

/// While an older frame is shown, the panel shows its settings.
void follow_frame(MainWindow& window) {
  const auto tell = [&window] {
    const FrameTicker& ticker = window.ticker();
    const bool looks_back = !window.session()->looksElsewhere() && ticker.shown() &&
                            ticker.playback().is_live &&
                            ticker.playback().state != Playback::State::Following;
    window.settings().showFrameSettings(looks_back ? std::optional(ticker.shown()->settings) : std::nullopt);
  };
  QObject::connect(&window.ticker(), &FrameTicker::frameReady, &window.settings(), tell);
  QObject::connect(&window.ticker(), &FrameTicker::playbackChanged, &window.settings(), tell);
}

}  // namespace

void add_preset_actions(MainWindow& window) {
  const auto store =
      std::make_shared<OwnPresets>((window.remembered().folder() + "/presets.json").toStdString());
  settle(window, store, store->read());
  PresetBar& bar = window.settings().presets();
  add_action(window, menu_of(window, "Solve"), "Find a setting…", {}, [&window] {
    window.panels().want("settings", true);
    window.settings().takeFocus();
  });
  const auto ask_save = [&window, store] {
    ask_name(window, "Save settings", "mine",
             [&window, store](const QString& name) { save_as(window, store, name); });
  };
  QObject::connect(&bar, &PresetBar::saveRequested, &window, ask_save);
  QObject::connect(&bar, &PresetBar::overwriteRequested, &window,
                   [&window, store](const QString& name) { save_as(window, store, name); });
  QObject::connect(&bar, &PresetBar::renameRequested, &window, [&window, store](const QString& from) {
    ask_name(window, "Rename preset", from,
             [&window, store, from](const QString& to) { rename(window, store, from, to); });
  });
  QObject::connect(&bar, &PresetBar::removeRequested, &window, [&window, store](const QString& name) {
    settle(window, store, store->remove(name.toStdString()));
  });
  QObject::connect(&bar, &PresetBar::exportRequested, &window, [&window] { export_settings(window); });
  QObject::connect(&bar, &PresetBar::importRequested, &window, [&window] { import_settings(window); });

  QMenu* menu = menu_of(window, "Solve");
  QMenu* own = menu->addMenu("Own presets");
  QObject::connect(own, &QMenu::aboutToShow, &bar, [&bar, own] { bar.fillMenu(*own); });
  add_action(window, menu, "Save settings as preset\u2026", {}, ask_save);
  add_action(window, menu, "Export settings\u2026", {}, [&window] { export_settings(window); });
  add_action(window, menu, "Import settings\u2026", {}, [&window] { import_settings(window); });
  follow_frame(window);
  adopt_with(window, store);
}

}  // namespace abrazo::app
