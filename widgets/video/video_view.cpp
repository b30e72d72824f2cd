#include "widgets/video/video_view.hpp"

#include <QKeyEvent>
#include <QMenu>
#include <QMouseEvent>
#include <QPainter>
#include <QWheelEvent>
#include <cmath>

#include "widgets/common/theme.hpp"
#include "widgets/video/pick_painter.hpp"

namespace abrazo::widgets {
namespace {

constexpr double reach_px = 4;        // of the pointer, to a pick
constexpr double fine_px = 0.1;       // of the picture: a press of an arrow key
constexpr double squares_from = 2.5;  // screen pixels per picture pixel, from where pixels may be squares
constexpr double wheel_factor = 1.0015;
constexpr double step_factor = 1.25;

bool is_arrow(int key) {
  return key == Qt::Key_Left || key == Qt::Key_Right || key == Qt::Key_Up || key == Qt::Key_Down;
}

}  // namespace

VideoView::VideoView(QWidget* parent) : QWidget(parent), m_palette(palette_of(Theme::Dark)) {
  setFocusPolicy(Qt::StrongFocus);
  setMouseTracking(true);
  setAttribute(Qt::WA_OpaquePaintEvent);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
  setNotice("No video");
}

void VideoView::setColours(const Palette& palette) {
  m_palette = palette;
  update();
}

void VideoView::showPicture(VideoFramePtr picture) {
  if (picture == m_picture) return;
  m_picture = std::move(picture);
  m_scaled = {};
  m_image = m_picture ? QImage(m_picture->rgb.data(), m_picture->width, m_picture->height,
                               3 * m_picture->width, QImage::Format_RGB888)
                      : QImage();
  describe();
  update();
}

void VideoView::showOverlay(VideoOverlay overlay) {
  if (overlay.empty() && m_overlay.empty()) return;
  m_overlay = std::move(overlay);
  update();
}

void VideoView::setOpacity(double opacity) {
  m_look.opacity = opacity;
  update();
}

void VideoView::setNotice(const QString& text) {
  if (text == m_notice) return;
  m_notice = text;
  describe();
  update();
}

void VideoView::describe() {
  setAccessibleName("Reference video");
  setAccessibleDescription(!m_notice.isEmpty() ? m_notice
                           : m_picture         ? QString("picture %1").arg(m_picture->index + 1)
                                               : QString());
}

void VideoView::setSmooth(bool on) {
  m_smooth = on;
  update();
}

PictureSize VideoView::pictureSize() const {
  if (!m_picture) return {};
  return {static_cast<double>(m_picture->width), static_cast<double>(m_picture->height)};
}

PictureFraming VideoView::framing() const {
  return widgets::framing(pictureSize(), viewSize(), m_zoom);
}

void VideoView::setZoom(const PictureZoom& zoom) {
  m_zoom = zoom;
  m_scaled = {};
  update();
}

void VideoView::zoomBy(double factor) {
  const QPointF about = m_pointer.value_or(QPointF(width() / 2.0, height() / 2.0));
  setZoom(zoomed(pictureSize(), viewSize(), m_zoom, factor, about.x(), about.y()));
}

void VideoView::zoomToPixels() {
  zoomBy(1 / (framing().scale * devicePixelRatioF()));
}

void VideoView::setPicking(const QString& joint) {
  if (joint == m_joint) return;  // a drag continues while the picks are updated
  m_joint = joint;
  m_placing = false;
  m_dragged = -1;
  setCursor(isPicking() ? Qt::CrossCursor : Qt::ArrowCursor);
  update();
}

void VideoView::setPicks(std::vector<PickMark> picks) {
  m_picks = std::move(picks);
  if (m_selected >= static_cast<int>(m_picks.size())) m_selected = -1;
  update();
}

void VideoView::selectPick(int index) {
  if (index != m_selected) ++m_gesture;
  m_selected = index;
  update();
}

int VideoView::pickAt(const QPointF& place) const {
  const PictureFraming frame = framing();
  int nearest = -1;
  double best = reach_px;
  for (std::size_t i = 0; i < m_picks.size(); ++i) {
    if (!m_picks[i].is_here) continue;
    const double apart =
        std::hypot(frame.x(m_picks[i].pixel.x()) - place.x(), frame.y(m_picks[i].pixel.y()) - place.y());
    if (apart >= best) continue;
    best = apart;
    nearest = static_cast<int>(i);
  }
  return nearest;
}

Pixel VideoView::held(const Pixel& pixel) const {
  const PictureSize size = pictureSize();
  return {std::clamp(pixel.x(), -0.5, size.width - 0.5), std::clamp(pixel.y(), -0.5, size.height - 0.5)};
}

void VideoView::nudge(double dx, double dy) {
  if (m_selected < 0) return;
  const Pixel to = held(m_picks[static_cast<std::size_t>(m_selected)].pixel + Pixel(dx, dy));
  emit pickMoved(m_selected, to, m_gesture);
}

/// Of the keys that the window has other uses for.
bool VideoView::keeps(int key, Qt::KeyboardModifiers held) const {
  if (held & (Qt::ControlModifier | Qt::AltModifier | Qt::MetaModifier)) return false;
  if (key == Qt::Key_Comma || key == Qt::Key_Period || key == Qt::Key_Plus || key == Qt::Key_Minus)
    return true;
  if (!isPicking()) return false;
  return is_arrow(key) || key == Qt::Key_Delete || key == Qt::Key_Backspace || key == Qt::Key_Escape;
}

bool VideoView::event(QEvent* event) {
  if (event->type() == QEvent::ShortcutOverride) {
    const auto* key = static_cast<QKeyEvent*>(event);
    if (keeps(key->key(), key->modifiers())) {
      event->accept();
      return true;
    }
  }
  return QWidget::event(event);
}

void VideoView::keyPressEvent(QKeyEvent* event) {
  if (!keeps(event->key(), event->modifiers())) return QWidget::keyPressEvent(event);
  const double fine = event->modifiers() & Qt::ShiftModifier ? 10 * fine_px : fine_px;
  switch (event->key()) {
    case Qt::Key_Comma:
      return emit stepRequested(-1);
    case Qt::Key_Period:
      return emit stepRequested(1);
    case Qt::Key_Plus:
      return zoomBy(step_factor);
    case Qt::Key_Minus:
      return zoomBy(1 / step_factor);
    case Qt::Key_Left:
      return nudge(-fine, 0);
    case Qt::Key_Right:
      return nudge(fine, 0);
    case Qt::Key_Up:
      return nudge(0, -fine);
    case Qt::Key_Down:
      return nudge(0, fine);
    case Qt::Key_Escape:
      return emit pickingEndRequested();
    default:
      if (m_selected >= 0) emit pickRemoveRequested(m_selected);
  }
}

void VideoView::mousePressEvent(QMouseEvent* event) {
  m_pointer = event->localPos();
  if (event->button() == Qt::LeftButton && isPicking() && m_picture) {
    ++m_gesture;
    m_dragged = pickAt(event->localPos());
    m_placing = m_dragged < 0;
    if (m_dragged >= 0) emit pickSelected(m_dragged);
  } else if (event->button() != Qt::RightButton) {
    m_panFrom = event->localPos();
  }
  update();
}

void VideoView::mouseMoveEvent(QMouseEvent* event) {
  const QPointF before = m_pointer.value_or(event->localPos());
  m_pointer = event->localPos();
  if (m_panFrom) {
    const QPointF by = *m_pointer - before;
    setZoom(panned(pictureSize(), viewSize(), m_zoom, by.x(), by.y()));
  }
  if (m_dragged >= 0)
    emit pickMoved(m_dragged, held(framing().to_picture(m_pointer->x(), m_pointer->y())), m_gesture);
  if (isPicking()) update();
}

void VideoView::mouseReleaseEvent(QMouseEvent* event) {
  m_pointer = event->localPos();
  m_panFrom.reset();
  m_dragged = -1;
  if (!std::exchange(m_placing, false)) return update();
  const Pixel pixel = framing().to_picture(m_pointer->x(), m_pointer->y());
  if (pixel == held(pixel)) emit picked(pixel);  // beside the picture is a change of mind
}

void VideoView::mouseDoubleClickEvent(QMouseEvent* event) {
  if (isPicking()) return mousePressEvent(event);
  m_zoom.is_fitted() ? zoomToPixels() : setZoom({});
}

void VideoView::wheelEvent(QWheelEvent* event) {
  if (!m_picture) return event->ignore();
  m_pointer = event->position();
  zoomBy(std::pow(wheel_factor, event->angleDelta().y()));
  event->accept();
}

void VideoView::leaveEvent(QEvent*) {
  m_pointer.reset();
  update();
}

void VideoView::contextMenuEvent(QContextMenuEvent* event) {
  QMenu menu(this);
  menu.addAction("Whole picture", this, [this] { setZoom({}); });
  menu.addAction("Actual size: one pixel of the video for each of the screen", this,
                 &VideoView::zoomToPixels);
  QAction* smooth = menu.addAction("Smooth pixels", this, &VideoView::setSmooth);
  smooth->setCheckable(true);
  smooth->setChecked(m_smooth);
  menu.exec(event->globalPos());
}

void VideoView::paintPicture(QPainter& painter) {
  const PictureFraming frame = framing();
  const double device = frame.scale * devicePixelRatioF();
  const QRectF place(frame.left, frame.top, m_image.width() * frame.scale, m_image.height() * frame.scale);
  if (device < 1) {  // averaged: picked out pixels would flicker
    const QSize size = (place.size() * devicePixelRatioF()).toSize();
    if (m_scaled.size() != size)
      m_scaled = m_image.scaled(size, Qt::IgnoreAspectRatio, Qt::SmoothTransformation)
                     .convertToFormat(QImage::Format_RGB32);
    return painter.drawImage(place, m_scaled);
  }
  painter.setRenderHint(QPainter::SmoothPixmapTransform, device < squares_from || m_smooth);
  painter.drawImage(place, m_image);
}

void VideoView::paintPicks(QPainter& painter) const {
  const PictureFraming frame = framing();
  for (std::size_t i = 0; i < m_picks.size(); ++i)
    if (m_picks[i].is_here && (isPicking() || static_cast<int>(i) == m_selected))
      paint_pick(painter, m_picks[i], frame, m_palette, static_cast<int>(i) == m_selected);
}

void VideoView::paintLens(QPainter& painter) {
  if (!isPicking() || !m_pointer || !m_picture || m_panFrom) return;
  const QPointF at = *m_pointer;
  const Pixel pixel = framing().to_picture(at.x(), at.y());
  paint_lens(painter, {m_image, pixel, at, m_dragged >= 0 ? QString() : m_joint}, rect(), m_palette);
}

void VideoView::paintNotice(QPainter& painter) const {
  if (m_notice.isEmpty()) return;
  if (m_picture) painter.fillRect(rect(), QColor(0, 0, 0, 150));
  painter.setFont(interface_font(13));
  painter.setPen(QColor(0xd7, 0xdb, 0xe3));
  painter.drawText(rect().adjusted(16, 8, -16, -8), Qt::AlignCenter | Qt::TextWordWrap, m_notice);
}

void VideoView::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.fillRect(rect(), QColor(0x0c, 0x0d, 0x10));  // as films are letterboxed, in either theme
  if (m_picture) {
    paintPicture(painter);
    paint_overlay(painter, m_overlay, framing(), palette_of(Theme::Dark), m_look);
    paintPicks(painter);
  }
  paintNotice(painter);
  paintLens(painter);
  if (hasFocus()) {
    painter.setPen(m_palette.accent);
    painter.setBrush(Qt::NoBrush);
    painter.drawRect(rect().adjusted(0, 0, -1, -1));
  }
  emit painted();
}

}  // namespace abrazo::widgets
