#pragma once

#include <QWidget>
#include <optional>
#include <vector>

#include "core/session/frames/command.hpp"
#include "core/synthesis/settings.hpp"
#include "widgets/common/palette.hpp"
#include "widgets/settings/preset_choice.hpp"

class QLabel;
class QLineEdit;
class QScrollArea;
class QUndoStack;

namespace abrazo::widgets {

class PresetBar;
class SectionHeader;
class SettingRow;

/// Every setting, live: a change is sent immediately, as the complete value. One drag of a slider is one step
/// of undo.
class SettingsPanel : public QWidget {
  Q_OBJECT
 public:
  /// @param undo  outlives the panel
  SettingsPanel(QUndoStack& undo, QWidget* parent = nullptr);
  const Settings& settings() const { return m_settings; }
  const PresetChoice& choice() const { return m_choice; }
  void setColours(const Palette& palette);
  PresetBar& presets() { return *m_presets; }
  void setOwnPresets(std::vector<OwnPreset> own);

 public slots:
  /// Shows these without asking for anything and without a step of undo.
  void showSettings(const abrazo::Settings& settings);
  /// As a click on a preset's button.
  void choosePreset(const QString& name);
  void chooseOwnPreset(const QString& name);
  /// These settings, from wherever, as one step of undo.
  void adopt(const abrazo::Settings& settings, const QString& what);
  /// As an entry into a setting's field.
  void change(const QString& key, const QString& text, int gesture = 0);
  /// The settings that the shown frame was solved under; nothing when it is the newest one.
  void showFrameSettings(const std::optional<abrazo::Settings>& of_frame);
  /// Only the settings whose words these are.
  void filter(const QString& wanted);

 signals:
  void commandRequested(const abrazo::Command& command);
  void sweepRequested(const QString& key);
  void mistaken(const QString& message);  ///< an entry that cannot be used, and why

 private:
  friend class ChangeSettings;
  struct State {
    Settings settings;
    PresetChoice choice;
  };
  void apply(const State& state);
  void push(const State& next, const QString& what, const QString& key, int gesture);
  void refresh();
  QWidget* filterField();
  QWidget* frameNotice();
  QWidget* rowList();

  QUndoStack& m_undo;
  Settings m_settings;
  PresetChoice m_choice;
  std::vector<OwnPreset> m_own;
  std::optional<Settings> m_ofFrame;
  PresetBar* m_presets;
  QLineEdit* m_filter = nullptr;
  QWidget* m_notice = nullptr;
  QLabel* m_noticeText = nullptr;
  QLabel* m_noMatch = nullptr;
  std::vector<SettingRow*> m_rows;
  std::vector<SectionHeader*> m_heads;
  struct Group {
    SectionHeader* head;
    std::vector<SettingRow*> rows;
  };
  std::vector<Group> m_groups;
};

}  // namespace abrazo::widgets
