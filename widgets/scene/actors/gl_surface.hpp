#pragma once

#include <QVTKOpenGLNativeWidget.h>

#include <functional>

#include "widgets/scene/values/pointer_moves.hpp"

namespace abrazo::widgets {

/// The OpenGL surface. Converts pointer events to camera moves itself, because VTK's interactor styles tilt
/// the horizon and grab keys. Copies VTK's frame buffer directly: the base class uses a second buffer with
/// depth and an alpha pass, a quarter of the cost of a picture with a software renderer.
class GlSurface : public QVTKOpenGLNativeWidget {
 public:
  explicit GlSurface(QWidget* parent);
  NavigationStyle style = NavigationStyle::Abrazo;
  Qt::KeyboardModifiers keys;  ///< at the reported event
  std::function<void(QPointF delta, PointerMove move)> dragged;
  std::function<void(double notches)> wheeled;
  /// The pointer is here without a button; outside of the widget after it left.
  std::function<void(QPointF place)> hovered;
  /// Pressed and released at the same position.
  std::function<void(QPointF place)> clicked;

  /// Draws with the window's next repaint; several requests give one picture.
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
