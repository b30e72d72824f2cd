#pragma once

#include <QWidget>
#include <optional>
#include <vector>

#include "core/synthesis/settings/preset_choice.hpp"
#include "widgets/common/palette.hpp"

class QLabel;
class QLineEdit;
class QScrollArea;

namespace abrazo::widgets {

class PresetBar;
class SectionHeader;
class SettingRow;

/// All settings and their preset. Changes nothing itself: it emits requests, on every move of a drag, and
/// shows what it is given.
class SettingsPanel : public QWidget {
  Q_OBJECT
 public:
  explicit SettingsPanel(QWidget* parent = nullptr);
  void setColours(const Palette& palette);
  PresetBar& presets() { return *m_presets; }
  /// The keyboard goes to the filter.
  void takeFocus();

  /// With room for the settings that are tuned most.
  QSize sizeHint() const override;

 public slots:
  void showSettings(const abrazo::Settings& settings, const abrazo::PresetChoice& choice);
  /// The settings of the shown frame; none if it is the newest one.
  void showFrameSettings(const std::optional<abrazo::Settings>& of_frame);
  /// Shows only settings that match these words.
  void filter(const QString& wanted);

 signals:
  /// @param text in the format of `set_setting`
  /// @param gesture equal for all changes of one drag; 0 = single change
  void entryRequested(const QString& key, const QString& text, int gesture);
  void presetRequested(const QString& name, bool own);
  /// @param what origin of the settings, for the undo list
  void settingsRequested(const abrazo::Settings& settings, const QString& what);
  void sweepRequested(const QString& key);
  /// A motion file is to be chosen for a body. The answer is an entry.
  void fileRequested(const QString& key);

 private:
  void refresh();
  QWidget* filterField();
  QWidget* frameNotice();
  QWidget* rowList();

  Settings m_settings;
  PresetChoice m_choice;
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
