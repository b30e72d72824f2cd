#pragma once

#include <QUndoCommand>
#include <QWidget>
#include <vector>

#include "core/session/command.hpp"
#include "core/synthesis/settings.hpp"
#include "widgets/common/palette.hpp"

class QToolButton;
class QUndoStack;

namespace abrazo::widgets {

class SectionHeader;
class SettingRow;

/// Every setting, live: a change goes out at once as the whole value. One drag of a slider is one step of
/// undo.
class SettingsPanel : public QWidget {
  Q_OBJECT
 public:
  /// @param undo  outlives the panel
  SettingsPanel(QUndoStack& undo, QWidget* parent = nullptr);
  const Settings& settings() const { return m_settings; }
  void setColours(const Palette& palette);

 public slots:
  /// Shows these without asking for anything and without a step of undo.
  void showSettings(const abrazo::Settings& settings);
  /// As a click on a preset's button.
  void choosePreset(const QString& name);
  /// As an entry into a setting's field.
  void change(const QString& key, const QString& text, int gesture = 0);

 signals:
  void commandRequested(const abrazo::Command& command);
  void mistaken(const QString& message);  ///< an entry that cannot be used, and why

 private:
  friend class ChangeSettings;
  void apply(const Settings& settings);
  void push(const Settings& next, const QString& what, const QString& key, int gesture);
  QWidget* presetButtons();
  QWidget* rowList();

  QUndoStack& m_undo;
  Settings m_settings;
  Settings m_presetSettings;  ///< of the preset chosen last: where the ticks are
  QString m_preset;
  std::vector<QToolButton*> m_presets;
  std::vector<SettingRow*> m_rows;
  std::vector<SectionHeader*> m_heads;
};

}  // namespace abrazo::widgets
