#pragma once

#include <QWidget>

#include "core/synthesis/settings/settings.hpp"
#include "widgets/common/palette.hpp"
#include "widgets/settings/slider_scale.hpp"

class QComboBox;
class QLabel;
class QLineEdit;
class QToolButton;

namespace abrazo::widgets {

class Toggle;
class ValueSlider;

/// One setting: symbol, title, a value field, and a slider, switch or list by its type. A star marks a value
/// that differs from the preset. A setting without effect in the present selection method is disabled and
/// names its method.
class SettingRow : public QWidget {
  Q_OBJECT
 public:
  SettingRow(const SettingInfo& info, QWidget* parent = nullptr);
  const SettingInfo& info() const { return m_info; }
  void setColours(const Palette& palette);
  /// @param of_frame settings of the shown frame; null if irrelevant
  void show(const Settings& settings, const Settings& defaults, const Settings* of_frame);

 signals:
  /// @param text in the format of `set_setting`
  /// @param gesture equal for all changes of one drag; 0 = single change
  void changed(const QString& key, const QString& text, int gesture);
  void sweepRequested(const QString& key);
  /// A file is to be chosen as the value.
  void fileRequested(const QString& key);

 protected:
  void contextMenuEvent(QContextMenuEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  void buildNumber();
  void buildToggle();
  void buildChoice();
  void buildBody();
  void connectSlider();
  void connectField();
  void name(QWidget& control) const;
  void showTitle();
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
  QComboBox* m_body = nullptr;
  QToolButton* m_file = nullptr;
  QString m_bodyText;
  double m_number = 0;  ///< shown value
  QString m_defaultText;
  QString m_ofFrame;       ///< the value of the shown frame, if it differs
  bool m_changed = false;  ///< differs from the preset
  bool m_applies = true;
  QColor m_mark;
};

}  // namespace abrazo::widgets
