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
/// kind. A star says that it is not the preset's. One that does not count with the method of selection that
/// is set is greyed and says whose it is.
class SettingRow : public QWidget {
  Q_OBJECT
 public:
  SettingRow(const SettingInfo& info, QWidget* parent = nullptr);
  const SettingInfo& info() const { return m_info; }
  void setColours(const Palette& palette);
  /// @param of_frame  settings that a shown frame was solved under; null when they are of no concern
  void show(const Settings& settings, const Settings& defaults, const Settings* of_frame);

 signals:
  /// @param text     as `set_setting` takes it
  /// @param gesture  equal for all changes of one drag; 0 when the change stands alone
  void changed(const QString& key, const QString& text, int gesture);
  void sweepRequested(const QString& key);

 protected:
  void contextMenuEvent(QContextMenuEvent* event) override;

 private:
  void buildNumber();
  void buildToggle();
  void buildChoice();
  void connectSlider();
  void connectField();
  void name(QWidget& control) const;
  void showTitle(bool changed, const QString& of_frame);
  void showApplies(const Settings& settings);
  QString valueText(double number) const;
  QString key() const;

  const SettingInfo& m_info;
  SliderScale m_scale;
  QLabel* m_title = nullptr;
  ValueSlider* m_slider = nullptr;
  QLineEdit* m_value = nullptr;
  Toggle* m_toggle = nullptr;
  QComboBox* m_choice = nullptr;
  double m_number = 0;  ///< as shown
  QString m_defaultText;
  bool m_changed = false;  ///< not the preset's value
  bool m_applies = true;
  QColor m_mark;
};

}  // namespace abrazo::widgets
