#pragma once

#include <QAbstractButton>

#include "widgets/common/palette.hpp"

namespace abrazo::widgets {

/// An on/off switch. The space bar toggles it.
class Toggle : public QAbstractButton {
  Q_OBJECT
 public:
  explicit Toggle(QWidget* parent = nullptr);
  void setColours(const Palette& palette);
  void setOn(bool on) { setChecked(on); }
  bool isOn() const { return isChecked(); }
  QSize sizeHint() const override { return {34, 20}; }

 protected:
  void paintEvent(QPaintEvent* event) override;
  bool event(QEvent* event) override;

 private:
  Palette m_palette;
};

}  // namespace abrazo::widgets
