#pragma once

#include <QWidget>

#include "widgets/common/palette.hpp"

namespace abrazo::widgets {

/// A slim horizontal slider over [0, 1] with a tick at the default.
class ValueSlider : public QWidget {
  Q_OBJECT
 public:
  explicit ValueSlider(QWidget* parent = nullptr);
  void setColours(const Palette& palette);
  void setPlace(double place);
  double place() const { return m_place; }
  void setDefaultPlace(double place);
  QSize sizeHint() const override { return {120, 20}; }

 signals:
  /// @param gesture  the same for all moves of one drag
  void moved(double place, int gesture);
  void resetRequested();

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  bool event(QEvent* event) override;

 private:
  void dragTo(double x);
  double xOf(double place) const;

  Palette m_palette;
  double m_place = 0;
  double m_default = 0;
  int m_gesture = 0;
  bool m_dragging = false;
};

/// An on/off switch.
class Toggle : public QWidget {
  Q_OBJECT
 public:
  explicit Toggle(QWidget* parent = nullptr);
  void setColours(const Palette& palette);
  void setOn(bool on);
  bool isOn() const { return m_on; }

 signals:
  void toggled(bool on);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;

 private:
  Palette m_palette;
  bool m_on = false;
};

}  // namespace abrazo::widgets
