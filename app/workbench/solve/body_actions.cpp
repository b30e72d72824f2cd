#include "app/workbench/base/file_dialogs.hpp"
#include "app/workbench/shell/actions.hpp"
#include "app/workbench/shell/main_window.hpp"
#include "core/motion/joints/motion_format.hpp"
#include "widgets/settings/settings_panel.hpp"

namespace abrazo::app {

/// A file as the value of a body in the settings.
void add_body_actions(MainWindow& window) {
  QObject::connect(
      &window.settings(), &widgets::SettingsPanel::fileRequested, &window, [&window](const QString& key) {
        const QString file = ask_file(
            &window, window.remembered(), "A motion file of one person",
            QString("Motions (%1);;All files (*)").arg(QString::fromStdString(motion_file_patterns(true))));
        if (!file.isEmpty()) window.document().changeSetting(key, file);
      });
}

}  // namespace abrazo::app
