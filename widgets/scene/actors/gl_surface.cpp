#include "widgets/scene/actors/gl_surface.hpp"

#include <vtkActor.h>
#include <vtkCommand.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkOpenGLFramebufferObject.h>
#include <vtkOpenGLPolyDataMapper.h>
#include <vtkOpenGLState.h>
#include <vtkOpenGLVertexBufferObject.h>
#include <vtkProp.h>
#include <vtkPropCollection.h>
#include <vtkRenderer.h>
#include <vtkRendererCollection.h>

#include <QMouseEvent>
#include <QOpenGLExtraFunctions>
#include <QOpenGLShaderProgram>
#include <QPainter>
#include <QSurfaceFormat>
#include <QTimer>
#include <algorithm>
#include <optional>
#include <utility>

#include "widgets/scene/actors/empty_culler.hpp"

namespace abrazo::widgets {
namespace {

constexpr double click_px = 4;  // a hand that only clicks still moves a little
constexpr int room_step_px = 128;

PointerButtons pressed_in(const QMouseEvent& event) {
  const auto button = [&event](Qt::MouseButton which) { return event.buttons().testFlag(which); };
  const auto key = [&event](Qt::KeyboardModifier which) { return event.modifiers().testFlag(which); };
  return {button(Qt::LeftButton), button(Qt::MiddleButton), button(Qt::RightButton),
          key(Qt::ShiftModifier), key(Qt::ControlModifier), key(Qt::AltModifier)};
}

std::vector<vtkRenderer*> layers_of(vtkRenderWindow& window) {
  std::vector<vtkRenderer*> layers;
  vtkRendererCollection& all = *window.GetRenderers();
  all.InitTraversal();
  while (vtkRenderer* layer = all.GetNextItem()) layers.push_back(layer);
  return layers;
}

std::vector<vtkProp*> shown_props(vtkRenderWindow& window) {
  std::vector<vtkProp*> props;
  for (vtkRenderer* layer : layers_of(window)) {
    vtkPropCollection& all = *layer->GetViewProps();
    all.InitTraversal();
    while (vtkProp* prop = all.GetNextProp())
      if (prop->GetVisibility() != 0) props.push_back(prop);
  }
  return props;
}

/// Width or height of the room for pictures: what is there if it is large enough, and not much too large.
int room_for(int wanted_px, int there_px) {
  const bool is_kept = wanted_px <= there_px && there_px <= 2 * wanted_px + room_step_px;
  return is_kept ? there_px : (wanted_px + room_step_px - 1) / room_step_px * room_step_px;
}

/// Layers draw without smoothed edges while this exists.
class WithoutSmoothing {
 public:
  explicit WithoutSmoothing(std::vector<vtkRenderer*> layers) : m_layers(std::move(layers)) {
    for (vtkRenderer* layer : m_layers) {
      m_smoothed.push_back(layer->GetUseFXAA());
      layer->SetUseFXAA(false);
    }
  }
  ~WithoutSmoothing() {
    for (std::size_t i = 0; i < m_layers.size(); ++i) m_layers[i]->SetUseFXAA(m_smoothed[i]);
  }
  WithoutSmoothing(const WithoutSmoothing&) = delete;
  WithoutSmoothing& operator=(const WithoutSmoothing&) = delete;

 private:
  std::vector<vtkRenderer*> m_layers;
  std::vector<bool> m_smoothed;
};

/// By default VTK computes the range of all points with every upload, to move those far from the origin near
/// it. These are floats already, so that it would bring no digits back, and they change with every picture.
void upload_as_they_are(vtkProp& prop) {
  auto* actor = vtkActor::SafeDownCast(&prop);
  if (auto* mapper = actor ? vtkOpenGLPolyDataMapper::SafeDownCast(actor->GetMapper()) : nullptr)
    mapper->SetVBOShiftScaleMethod(vtkOpenGLVertexBufferObject::DISABLE_SHIFT_SCALE);
}

}  // namespace

GlSurface::GlSurface(QWidget* parent) : QWidget(parent) {
  setMouseTracking(true);
  setAttribute(Qt::WA_OpaquePaintEvent);
  QSurfaceFormat format;
  format.setRenderableType(QSurfaceFormat::OpenGL);
  format.setVersion(3, 2);  // what VTK needs
  format.setProfile(QSurfaceFormat::CoreProfile);
  m_context.setFormat(format);
  m_place.setFormat(format);
}

GlSurface::~GlSurface() {
  if (!m_window) return;
  if (m_context.isValid()) m_window->Finalize();
  m_window->RemoveAllObservers();
  m_window->SetReadyForRendering(false);
}

void GlSurface::setRenderWindow(vtkGenericOpenGLRenderWindow* window) {
  m_window = window;
  m_window->SetOwnContext(false);
  m_window->SetSwapBuffers(false);
  m_window->SetFrameBlitModeToNoBlit();  // the picture is fetched from where it was drawn
  m_window->SetForceMaximumHardwareLineWidth(1);
  m_window->AddObserver(vtkCommand::WindowMakeCurrentEvent, this, &GlSurface::makeCurrent);
}

void GlSurface::makeCurrent() {
  m_window->SetIsCurrent(m_context.makeCurrent(&m_place));
}

/// @return whether there is OpenGL
bool GlSurface::makeContext() {
  if (m_context.isValid()) return true;
  m_place.create();
  return m_context.create();
}

/// @return whether there is OpenGL
bool GlSurface::start() {
  if (m_isStarted) return true;
  if (!makeContext() || !m_context.makeCurrent(&m_place)) return false;
  m_isStarted = true;
  m_window->SetReadyForRendering(true);
  m_window->SetIsCurrent(true);
  m_window->OpenGLInitContext();
  m_window->SetMapped(true);
  return true;
}

void GlSurface::requestPicture(Shown shown) {
  m_stale = true;
  m_request.shown = std::move(shown);
  m_request.since.start();
  update();
}

/// What is shown and was never drawn.
std::vector<vtkProp*> GlSurface::uncompiled() const {
  std::vector<vtkProp*> props = shown_props(*m_window);
  std::erase_if(props,
                [this](vtkProp* prop) { return m_compiled.contains(prop) || !draws_something(*prop); });
  return props;
}

/// Draws a part of what is shown for the first time.
/// @return whether the picture can be drawn without a long wait
bool GlSurface::prepare() {
  constexpr qint64 enough_ms = 12;
  QElapsedTimer clock;
  clock.start();
  const QSize pixels = wanted();
  if (!m_window || pixels.isEmpty()) return true;
  makeRoom(pixels);
  switch (m_stage) {
    case Stage::Nothing:  // the window itself is painted for the first time, too
      m_stage = Stage::Painted;
      return false;
    case Stage::Painted:  // goes on between two paints: see paintEvent
      return false;
    case Stage::Connected:
      if (!start()) return true;  // without OpenGL there is nothing to wait for
      m_stage = Stage::Started;
      return false;
    case Stage::Started:
      compileNothing();
      m_stage = Stage::HasCompiler;
      return false;
    case Stage::HasCompiler:
      if (!hasBuffers()) return false;
      drawOnly(nullptr, false);
      m_stage = Stage::HasBackground;
      return false;
    case Stage::HasBackground:
      if (!hasBuffers()) return false;
      drawOnly(nullptr, true);
      m_stage = Stage::HasSmoothing;
      return false;
    case Stage::HasSmoothing:
      break;
  }
  std::vector<vtkProp*> rest = uncompiled();
  if (rest.empty()) return true;
  for (; !rest.empty() && clock.elapsed() < enough_ms; rest.pop_back()) drawOnly(rest.back(), false);
  return false;
}

/// Frame buffers of the size of the room are made one at a time.
/// @return whether they all were there
bool GlSurface::hasBuffers() {
  if (m_smallBuffers.empty()) return true;
  makeCurrent();
  if (!m_window->GetRenderFramebuffer()->GetFBOIndex()) {  // small ones at first
    m_window->SetSize(1, 1);
    const std::vector<vtkRenderer*> layers = layers_of(*m_window);
    for (vtkRenderer* layer : layers) layer->DrawOff();
    m_window->Render();
    for (vtkRenderer* layer : layers) layer->DrawOn();
    m_window->SetSize(m_room.width(), m_room.height());
  }
  vtkOpenGLState& state = *m_window->GetState();
  state.PushFramebufferBindings();
  m_smallBuffers.back()->Resize(m_room.width(), m_room.height());
  state.PopFramebufferBindings();
  m_smallBuffers.pop_back();
  return false;
}

/// A driver starts its compiler with the first program.
void GlSurface::compileNothing() {
  makeCurrent();
  QOpenGLShaderProgram program;
  program.addShaderFromSourceCode(QOpenGLShader::Vertex,
                                  "#version 150\nvoid main() { gl_Position = vec4(0.0); }\n");
  program.addShaderFromSourceCode(QOpenGLShader::Fragment,
                                  "#version 150\nout vec4 colour;\nvoid main() { colour = vec4(0.0); }\n");
  program.link();
}

/// Into the place where pictures are drawn, from which it is not fetched. @param prop  null: the background
void GlSurface::drawOnly(vtkProp* prop, bool smooth) {
  const std::vector<vtkProp*> props = shown_props(*m_window);
  if (prop) upload_as_they_are(*prop);
  std::optional<WithoutSmoothing> rough;
  if (!smooth) rough.emplace(layers_of(*m_window));
  for (vtkProp* other : props) other->SetVisibility(other == prop);
  m_window->Render();
  for (vtkProp* other : props) other->SetVisibility(1);
  if (prop) m_compiled.insert(prop);
}

const QImage& GlSurface::picture() {
  if (m_stale || m_picture.size() != wanted()) draw();
  return m_picture;
}

QSize GlSurface::wanted() const {
  return size() * devicePixelRatioF();
}

/// Has the layers draw into a corner of a room for pictures that is large enough.
void GlSurface::makeRoom(const QSize& pixels) {
  const QSize room(room_for(pixels.width(), m_room.width()), room_for(pixels.height(), m_room.height()));
  if (room != m_room) {
    m_smallBuffers = {m_window->GetDisplayFramebuffer(), m_window->GetRenderFramebuffer()};
    m_stage = std::min(m_stage, Stage::HasBackground);  // smoothing has a buffer of its own
    m_room = room;
  }
  m_window->SetSize(room.width(), room.height());  // without a context it would size nothing
  for (vtkRenderer* layer : layers_of(*m_window))
    layer->SetViewport(0, 0, static_cast<double>(pixels.width()) / room.width(),
                       static_cast<double>(pixels.height()) / room.height());
}

void GlSurface::draw() {
  m_stale = false;
  const QSize pixels = wanted();
  if (m_picture.size() != pixels) {
    m_picture = QImage(pixels, QImage::Format_RGB32);
    m_picture.fill(palette().color(QPalette::Window));
  }
  if (pixels.isEmpty() || !m_window || !start()) return;
  makeRoom(pixels);
  for (vtkProp* prop : uncompiled()) {
    upload_as_they_are(*prop);
    m_compiled.insert(prop);
  }
  m_stage = Stage::HasSmoothing;
  m_smallBuffers.clear();  // VTK makes what is missing
  m_window->Render();
  makeCurrent();  // listeners of the end of a picture may have changed the context
  fetch();
  m_picture.setDevicePixelRatio(devicePixelRatioF());
}

void GlSurface::fetch() {
  const int width = m_picture.width(), height = m_picture.height();
  const auto size = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  if (m_fetched.size() < size) m_fetched.resize(size);
  auto* gl = m_context.extraFunctions();
  vtkOpenGLState& state = *m_window->GetState();
  vtkOpenGLFramebufferObject& drawn = *m_window->GetRenderFramebuffer();
  state.PushFramebufferBindings();
  drawn.Bind(GL_READ_FRAMEBUFFER);
  drawn.ActivateReadBuffer(0);
  gl->glPixelStorei(GL_PACK_ALIGNMENT, 4);
  gl->glReadPixels(0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, m_fetched.data());
  state.PopFramebufferBindings();
  const quint32* from = m_fetched.data();
  for (int row = height - 1; row >= 0; --row, from += width) {
    auto* to = reinterpret_cast<quint32*>(m_picture.scanLine(row));
    for (int column = 0; column < width; ++column) {
      const quint32 colour = from[column];
      to[column] = 0xff000000U | (colour & 0xffU) << 16 | (colour & 0xff00U) | (colour >> 16 & 0xffU);
    }
  }
}

void GlSurface::paintEvent(QPaintEvent*) {
  const bool is_requested = m_stale;
  QPainter painter(this);
  // Whoever grabs the widget does not wait. On the screen it is painted into an image of the whole window.
  QPoint corner;
  const QPaintDevice* target = redirected(&corner);
  const bool is_grabbed = target && target->devType() == QInternal::Pixmap;
  if (is_requested && !is_grabbed && !prepare()) {
    paintLast(painter);
    return QTimer::singleShot(1, this, [this] {  // at 0 only when there is nothing else to do
      if (m_stage == Stage::Painted) {
        // The display starts its own OpenGL then, and a paint that ends with this would wait for it.
        makeContext();
        m_stage = Stage::Connected;
      }
      update();
    });
  }
  if (is_requested && !is_grabbed && m_first != First::Shown) return paintFirst(painter);
  painter.drawImage(0, 0, picture());
  if (is_requested) report(m_request);
}

/// To be told when the window has the picture. The next one may have been requested by then.
void GlSurface::report(Request& request) {
  if (!request.shown) return;
  QTimer::singleShot(0, this, [shown = std::exchange(request.shown, {}), since = request.since] {
    shown(static_cast<double>(since.nsecsElapsed()) * 1e-6);
  });
}

/// When the first picture can be drawn the whole window is often painted, too, and both together would be a
/// long wait. It is therefore drawn in a turn between two paints.
void GlSurface::paintFirst(QPainter& painter) {
  if (m_first == First::Drawn && m_picture.size() == wanted()) {
    painter.drawImage(0, 0, m_picture);  // older than what is requested by now, but it is here
    m_first = First::Shown;
    report(m_firstRequest);
    return QTimer::singleShot(0, this, [this] {
      m_stale = true;
      update();
    });
  }
  paintLast(painter);
  if (m_first == First::Due) return;
  m_first = First::Due;
  QTimer::singleShot(1, this, [this] {
    drawFirst();
    m_stale = true;
    m_first = First::Drawn;
    update();
  });
}

/// Without smoothed edges, which would nearly double its time. They are smooth in the next picture.
void GlSurface::drawFirst() {
  m_firstRequest.shown = std::exchange(m_request.shown, {});
  m_firstRequest.since.start();  // it was requested before all that had to be prepared
  if (!m_window) return;
  const WithoutSmoothing rough(layers_of(*m_window));
  draw();
}

/// The picture before, in the middle: it may have another size.
void GlSurface::paintLast(QPainter& painter) {
  QRectF place(QPointF(), QSizeF(m_picture.size()) / m_picture.devicePixelRatio());
  place.moveCenter(QRectF(rect()).center());
  if (!place.contains(rect())) painter.fillRect(rect(), palette().color(QPalette::Window));
  painter.drawImage(place.topLeft(), m_picture);
}

void GlSurface::mousePressEvent(QMouseEvent* event) {
  if (m_isTaken) return;  // a second button does not end a drag that was taken
  m_last = m_pressed = event->localPos();
  m_isClick = event->button() == Qt::LeftButton;
  m_isTaken = m_isClick && event->modifiers() == Qt::NoModifier && taken && taken(event->localPos());
  if (m_isTaken) m_isClick = false;
}

void GlSurface::mouseReleaseEvent(QMouseEvent* event) {
  keys = event->modifiers();
  if (m_isTaken && event->button() == Qt::LeftButton) {
    m_isTaken = false;
    letGo();
  }
  if (m_isClick && event->button() == Qt::LeftButton) clicked(event->localPos());
  m_isClick = false;
}

void GlSurface::mouseMoveEvent(QMouseEvent* event) {
  if (event->buttons() == Qt::NoButton) return hovered(event->localPos());
  if (m_isTaken) return pulled(event->localPos());
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
