#include "widgets/scene/actors/gl_surface.hpp"

#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkOpenGLFramebufferObject.h>
#include <vtkOpenGLState.h>

#include <QMouseEvent>
#include <QOpenGLContext>
#include <QOpenGLExtraFunctions>

namespace abrazo::widgets {
namespace {

constexpr double click_px = 4;  // a hand that only clicks still moves a little

PointerButtons pressed_in(const QMouseEvent& event) {
  const auto button = [&event](Qt::MouseButton which) { return event.buttons().testFlag(which); };
  const auto key = [&event](Qt::KeyboardModifier which) { return event.modifiers().testFlag(which); };
  return {button(Qt::LeftButton), button(Qt::MiddleButton), button(Qt::RightButton),
          key(Qt::ShiftModifier), key(Qt::ControlModifier), key(Qt::AltModifier)};
}

}  // namespace

GlSurface::GlSurface(QWidget* parent) : QVTKOpenGLNativeWidget(parent) {
  setMouseTracking(true);
}

void GlSurface::requestPicture() {
  m_stale = true;
  update();
}

void GlSurface::paintGL() {
  if (!RenderWindow) return;
  const QSize pixels = size() * devicePixelRatioF();
  if (m_stale || pixels != m_drawnSize) RenderWindow->Render();
  m_stale = false;
  m_drawnSize = pixels;
  makeCurrent();  // listeners of the end of a picture may have changed the context
  auto* gl = context()->extraFunctions();
  vtkOpenGLState& state = *RenderWindow->GetState();
  vtkOpenGLFramebufferObject& drawn = *RenderWindow->GetRenderFramebuffer();
  state.PushFramebufferBindings();
  drawn.Bind(GL_READ_FRAMEBUFFER);
  drawn.ActivateReadBuffer(0);
  gl->glBindFramebuffer(GL_DRAW_FRAMEBUFFER, defaultFramebufferObject());
  state.vtkglDisable(GL_SCISSOR_TEST);
  const int width = pixels.width(), height = pixels.height();
  gl->glBlitFramebuffer(0, 0, width, height, 0, 0, width, height, GL_COLOR_BUFFER_BIT, GL_NEAREST);
  state.PopFramebufferBindings();
}

void GlSurface::mousePressEvent(QMouseEvent* event) {
  m_last = m_pressed = event->localPos();
  m_isClick = event->button() == Qt::LeftButton;
}

void GlSurface::mouseReleaseEvent(QMouseEvent* event) {
  keys = event->modifiers();
  if (m_isClick && event->button() == Qt::LeftButton) clicked(event->localPos());
  m_isClick = false;
}

void GlSurface::mouseMoveEvent(QMouseEvent* event) {
  if (event->buttons() == Qt::NoButton) return hovered(event->localPos());
  if (m_isClick && (event->localPos() - m_pressed).manhattanLength() < click_px) return;
  m_isClick = false;
  const QPointF delta = event->localPos() - m_last;
  m_last = event->localPos();
  keys = event->modifiers();
  if (const PointerMove move = pointer_move(style, pressed_in(*event)); move != PointerMove::None)
    dragged(delta, move);
}

void GlSurface::wheelEvent(QWheelEvent* event) {
  keys = event->modifiers();
  wheeled(event->angleDelta().y() / 120.0);
}

void GlSurface::leaveEvent(QEvent*) {
  hovered({-1e6, -1e6});
}

}  // namespace abrazo::widgets
