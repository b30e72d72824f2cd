#pragma once

#include <QWidget>

#include "core/synthesis/settings.hpp"
#include "widgets/common/palette.hpp"
#include "widgets/settings/slider_scale.hpp"

class QComboBox;
class QLabel;
class QLineEdit;

namespace abrazo::widgets {

class Toggle;
class ValueSlider;

/// One setting: its symbol and title, its value to type into, and a slider, switch or list according to its
/// kind.
class SettingRow : public QWidget {
  Q_OBJECT
 public:
  SettingRow(const SettingInfo& info, QWidget* parent = nullptr);
  const SettingInfo& info() const { return m_info; }
  void setColours(const Palette& palette);
  void show(const Settings& settings, const Settings& defaults);

 signals:
  /// @param text     as `set_setting` takes it
  /// @param gesture  equal for all changes of one drag; 0 when the change stands alone
  void changed(const QString& key, const QString& text, int gesture);

 private:
  void buildNumber();
  void buildToggle();
  void buildChoice();
  QLabel* titleLabel();

  const SettingInfo& m_info;
  SliderScale m_scale;
  ValueSlider* m_slider = nullptr;
  QLineEdit* m_value = nullptr;
  Toggle* m_toggle = nullptr;
  QComboBox* m_choice = nullptr;
  QString m_defaultText;
};

}  // namespace abrazo::widgets
