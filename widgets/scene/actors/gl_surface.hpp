#pragma once

#include <vtkSmartPointer.h>

#include <QElapsedTimer>
#include <QImage>
#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QWidget>
#include <functional>
#include <unordered_set>
#include <vector>

#include "widgets/scene/values/pointer_moves.hpp"

class QPainter;
class vtkGenericOpenGLRenderWindow;
class vtkOpenGLFramebufferObject;
class vtkProp;

namespace abrazo::widgets {

/// Where the scene is shown: drawn off the screen by OpenGL, and painted as a picture like any other widget.
/// A widget with OpenGL in the window would make Qt put the whole window together by OpenGL whenever anything
/// in it changes (decision 0041). Converts pointer events to camera moves itself, because VTK's interactor
/// styles tilt the horizon and grab keys. A program of the graphics driver takes tens of milliseconds to
/// compile, on the processor still more; a first picture is therefore prepared in several turns of the event
/// loop, and shown when it is whole.
class GlSurface : public QWidget {
 public:
  explicit GlSurface(QWidget* parent);
  ~GlSurface() override;
  NavigationStyle style = NavigationStyle::Abrazo;
  Qt::KeyboardModifiers keys;  ///< at the reported event
  std::function<void(QPointF delta, PointerMove move)> dragged;
  std::function<void(double notches)> wheeled;
  /// The pointer is here without a button; outside of the widget after it left.
  std::function<void(QPointF place)> hovered;
  /// The left button is pressed here: true takes the drag that may follow, which is then no camera move and
  /// no click.
  std::function<bool(QPointF place)> taken;
  std::function<void(QPointF place)> pulled;
  std::function<void()> letGo;
  /// Pressed and released at the same position.
  std::function<void(QPointF place)> clicked;
  void setRenderWindow(vtkGenericOpenGLRenderWindow* window);
  /// Called when a requested picture is in the window. @param took_ms  since its request; of
  /// the first, since it could be drawn
  using Shown = std::function<void(double took_ms)>;
  /// Draws with the window's next repaint; several requests give one picture, that of the last.
  void requestPicture(Shown shown = {});
  /// The requested picture, drawn now; in pixels of the screen.
  const QImage& picture();

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent*) override {}
  void mouseMoveEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void leaveEvent(QEvent* event) override;

 private:
  bool makeContext();
  bool start();
  bool prepare();
  std::vector<vtkProp*> uncompiled() const;
  bool hasBuffers();
  void compileNothing();
  void drawOnly(vtkProp* prop, bool smooth);
  void makeCurrent();
  QSize wanted() const;
  void makeRoom(const QSize& pixels);
  void draw();
  void fetch();
  struct Request {
    Shown shown;
    QElapsedTimer since;
  };
  void report(Request& request);
  void paintFirst(QPainter& painter);
  void drawFirst();
  void paintLast(QPainter& painter);

  QOffscreenSurface m_place;
  QOpenGLContext m_context;
  vtkSmartPointer<vtkGenericOpenGLRenderWindow> m_window;
  /// What was drawn once. A driver compiles a program for an object when it draws it for the first time.
  std::unordered_set<vtkProp*> m_compiled;
  /// What a first picture needs before its objects, each in a turn of its own.
  enum class Stage { Nothing, Painted, Connected, Started, HasCompiler, HasBackground, HasSmoothing };
  Stage m_stage = Stage::Nothing;
  /// Size of the window's frame buffers, larger than a picture: with a software renderer new ones take tens
  /// of milliseconds.
  QSize m_room{0, 0};
  std::vector<vtkOpenGLFramebufferObject*> m_smallBuffers;  ///< those that do not have the size of the room
  std::vector<quint32> m_fetched;  ///< as OpenGL gives it: from the bottom, red first
  QImage m_picture;
  bool m_stale = true;
  enum class First { Requested, Due, Drawn, Shown };
  First m_first = First::Requested;
  Request m_firstRequest, m_request;
  bool m_isStarted = false;
  QPointF m_last, m_pressed;
  bool m_isClick = false, m_isTaken = false;
};

}  // namespace abrazo::widgets
