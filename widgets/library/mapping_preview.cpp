#include "widgets/library/mapping_preview.hpp"

#include <QApplication>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <algorithm>
#include <cmath>

#include "core/motion/body/joint_set.hpp"
#include "widgets/common/theme.hpp"

namespace abrazo::widgets {
namespace {
constexpr double grasp_px = 10, radians_per_pixel = 0.01;
}

MappingPreview::MappingPreview(QWidget* parent) : QWidget(parent), m_palette(palette_of(Theme::Dark)) {
  setAccessibleName("Points of the file and the skeleton they give");
  setToolTip(
      "Drag to turn, or use the arrow keys. A click gives the point to the chosen joint, or takes it away");
  setMinimumSize(300, 300);
  setFocusPolicy(Qt::StrongFocus);
}

void MappingPreview::setColours(const Palette& palette) {
  m_palette = palette;
  update();
}

void MappingPreview::show(const MappedFrame& frame) {
  m_frame = frame;
  fit();
  update();
}

void MappingPreview::fit() {
  Vec3 low = Vec3::Constant(1e300), high = -low;
  for (Eigen::Index p = 0; p < m_frame.points.rows(); ++p) {
    if (!m_frame.points.row(p).allFinite()) continue;
    low = low.cwiseMin(m_frame.points.row(p).transpose());
    high = high.cwiseMax(m_frame.points.row(p).transpose());
  }
  if (low.x() > high.x()) return;
  m_middle = (low + high) / 2;
  m_extent = std::max({(high - low).norm(), 1e-9});
}

QPointF MappingPreview::project(const Vec3& place) const {
  const Vec3 from = place - m_middle;
  const double scale = (std::min(width(), height()) - 24) / m_extent;
  const double right = std::cos(m_yaw) * from.x() - std::sin(m_yaw) * from.z();
  return {width() / 2.0 + scale * right, height() / 2.0 - scale * from.y()};
}

QPointF MappingPreview::placeOf(int point) const {
  return project(m_frame.points.row(point).transpose());
}

void MappingPreview::paintSkeleton(QPainter& painter) const {
  painter.setPen(QPen(m_palette.active, 2.5, Qt::SolidLine, Qt::RoundCap));
  const auto known = [this](int joint) { return m_frame.known[static_cast<std::size_t>(joint)]; };
  for (int b = 0; b < bone_count; ++b) {
    const auto [from, to] = bone(b);
    if (known(from) && known(to))
      painter.drawLine(project(m_frame.pose.row(from).transpose()),
                       project(m_frame.pose.row(to).transpose()));
  }
  if (m_frame.joint < 0 || !known(m_frame.joint)) return;
  const QPointF at = project(m_frame.pose.row(m_frame.joint).transpose());
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(m_palette.text, 2));
  painter.drawEllipse(at, 8, 8);
  painter.drawText(at + QPointF(11, -6),
                   QString::fromUtf8(joint_names[static_cast<std::size_t>(m_frame.joint)].data()));
}

void MappingPreview::paintPoints(QPainter& painter) const {
  for (int p = 0; p < static_cast<int>(m_frame.points.rows()); ++p) {
    if (!m_frame.points.row(p).allFinite()) continue;
    const bool chosen = std::count(m_frame.chosen.begin(), m_frame.chosen.end(), p) > 0;
    painter.setPen(QPen(chosen ? m_palette.text : m_palette.panel, 1));
    painter.setBrush(chosen ? m_palette.accent : m_palette.secondary);
    painter.drawEllipse(placeOf(p), chosen ? 5.0 : 3.0, chosen ? 5.0 : 3.0);
  }
}

void MappingPreview::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setFont(interface_font(11));
  painter.setPen(hasFocus() ? QPen(m_palette.accent) : QPen(Qt::NoPen));
  painter.setBrush(mixed(m_palette.raised, m_palette.panel, 0.5));
  painter.drawRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), 5, 5);
  if (m_frame.points.rows() == 0) return;
  paintSkeleton(painter);
  paintPoints(painter);
}

void MappingPreview::mousePressEvent(QMouseEvent* event) {
  m_pressed = event->pos();
  m_yawAtPress = m_yaw;
}

void MappingPreview::mouseMoveEvent(QMouseEvent* event) {
  if ((event->pos() - m_pressed).manhattanLength() < QApplication::startDragDistance()) return;
  m_yaw = m_yawAtPress + radians_per_pixel * (event->pos().x() - m_pressed.x());
  update();
}

void MappingPreview::mouseReleaseEvent(QMouseEvent* event) {
  if ((event->pos() - m_pressed).manhattanLength() >= QApplication::startDragDistance()) return;
  int nearest = -1;
  double distance = grasp_px;
  for (int p = 0; p < static_cast<int>(m_frame.points.rows()); ++p) {
    if (!m_frame.points.row(p).allFinite()) continue;
    const QPointF from = placeOf(p) - event->pos();
    if (const double there = std::hypot(from.x(), from.y()); there < distance) nearest = p, distance = there;
  }
  if (nearest >= 0) emit pointClicked(nearest);
}

void MappingPreview::keyPressEvent(QKeyEvent* event) {
  if (event->key() != Qt::Key_Left && event->key() != Qt::Key_Right) return QWidget::keyPressEvent(event);
  m_yaw += event->key() == Qt::Key_Left ? -0.1 : 0.1;
  update();
}

}  // namespace abrazo::widgets
