#pragma once

#include <QWidget>
#include <optional>

#include "widgets/common/palette.hpp"

namespace abrazo::widgets {

/// A slim horizontal slider over [0, 1] with a tick at the default, and an optional mark of another value.
class ValueSlider : public QWidget {
  Q_OBJECT
 public:
  explicit ValueSlider(QWidget* parent = nullptr);
  void setColours(const Palette& palette);
  void setPlace(double place);
  double place() const { return m_place; }
  void setDefaultPlace(double place);
  void setMarkedPlace(std::optional<double> place);
  QSize sizeHint() const override { return {120, 20}; }
  /// Middle of the handle, in pixels from the left.
  double handleX() const { return xOf(m_place); }

 signals:
  /// @param gesture  the same for all moves of one drag
  void moved(double place, int gesture);
  /// Steps by key, negative = down. @param gesture the same while a key is held
  void stepped(int steps, int gesture);
  /// @param gesture  that of the double click's first press
  void resetRequested(int gesture);

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
  std::optional<double> m_marked;
  double m_grab = 0;  ///< from the handle's middle to the grabbed point [px]
  int m_gesture = 0;
  bool m_dragging = false;
};

}  // namespace abrazo::widgets
