#pragma once

#include <QVTKOpenGLNativeWidget.h>

#include <functional>

#include "widgets/scene/values/pointer_moves.hpp"

namespace abrazo::widgets {

/// The OpenGL surface. Turns the pointer into camera moves itself: VTK's own styles tilt the horizon and grab
/// keys. Copies the picture from where VTK drew it: the base class goes by way of a second buffer with its
/// depth and a pass for alpha, a quarter of what a picture costs a software renderer.
class GlSurface : public QVTKOpenGLNativeWidget {
 public:
  explicit GlSurface(QWidget* parent);
  NavigationStyle style = NavigationStyle::Abrazo;
  Qt::KeyboardModifiers keys;  ///< that were held at the reported event
  std::function<void(QPointF delta, PointerMove move)> dragged;
  std::function<void(double notches)> wheeled;
  /// The pointer rests or moves here without a button; outside of the widget once it has left.
  std::function<void(QPointF place)> hovered;
  /// Pressed and let go at the same place.
  std::function<void(QPointF place)> clicked;

  /// Draws with the window's next repaint: several requests until then are one picture.
  void requestPicture();

 protected:
  void paintGL() override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent*) override {}
  void mouseMoveEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void leaveEvent(QEvent* event) override;

 private:
  bool m_stale = true;
  QSize m_drawnSize;
  QPointF m_last, m_pressed;
  bool m_isClick = false;
};

}  // namespace abrazo::widgets
