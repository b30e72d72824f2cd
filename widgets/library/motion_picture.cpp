#include "widgets/library/motion_picture.hpp"

#include <QApplication>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <cmath>

#include "core/motion/body/joint_set.hpp"
#include "widgets/common/qt_versions.hpp"
#include "widgets/common/theme.hpp"
#include "widgets/common/utf8.hpp"

namespace abrazo::widgets {
namespace {

constexpr double grasp_px = 10, radians_per_pixel = 0.01;
constexpr double looks_down_rad = 0.16;
constexpr double camera_distance = 3.2;  ///< in sizes of what is shown
constexpr int grid_lines = 8;            ///< to each side
constexpr double limb_m = 0.085, head_m = 0.11;

}  // namespace

MotionPicture::MotionPicture(QWidget* parent) : QWidget(parent), m_palette(palette_of(Theme::Dark)) {
  setAccessibleName("Points of the file and the skeleton they give");
  setMinimumSize(260, 260);
  setFocusPolicy(Qt::StrongFocus);
}

void MotionPicture::setColours(const Palette& palette) {
  m_palette = palette;
  update();
}

void MotionPicture::setSpace(const PicturedSpace& space) {
  m_space = space;
  update();
}

void MotionPicture::show(const PicturedFrame& frame) {
  m_frame = frame;
  m_nothing.clear();
  Eigen::RowVector3d sum = Eigen::RowVector3d::Zero();
  int seen = 0;
  for (Eigen::Index p = 0; p < frame.points.rows(); ++p)
    if (frame.points.row(p).allFinite()) sum += frame.points.row(p), ++seen;
  if (seen > 0) m_ground = Vec3(sum.x() / seen, m_space.ground, sum.z() / seen);
  update();
}

void MotionPicture::showNothing(const QString& why) {
  m_frame = {};
  m_nothing = why;
  update();
}

void MotionPicture::setNames(bool on) {
  m_hasNames = on;
  update();
}

Vec3 MotionPicture::middle() const {
  return {m_ground.x(), (m_space.ground + m_space.high.y()) / 2, m_ground.z()};
}

double MotionPicture::pixelsPerUnit() const {
  const double size = std::max({m_space.high.y() - m_space.ground, m_space.high.x() - m_space.low.x(), 1e-9});
  return 0.78 * std::min(width(), height()) / size;
}

/// Seen from a little above, in perspective.
QPointF MotionPicture::project(const Vec3& place) const {
  const Vec3 from = (place - middle()) * pixelsPerUnit();
  const double right = std::cos(m_yaw) * from.x() - std::sin(m_yaw) * from.z();
  const double nearer = std::sin(m_yaw) * from.x() + std::cos(m_yaw) * from.z();
  const double up = std::cos(looks_down_rad) * from.y() - std::sin(looks_down_rad) * nearer;
  const double towards = std::cos(looks_down_rad) * nearer + std::sin(looks_down_rad) * from.y();
  const double far_px = camera_distance * std::min(width(), height());
  const double scale = far_px / std::max(far_px - towards, 0.2 * far_px);
  return {width() / 2.0 + scale * right, height() / 2.0 - scale * up};
}

QPointF MotionPicture::placeOf(int point) const {
  return project(m_frame.points.row(point).transpose());
}

/// Lines at whole multiples of the spacing, so that the ground passes below a person who moves.
void MotionPicture::paintGround(QPainter& painter) const {
  const double step = m_space.grid;
  if (!(step > 0)) return;
  const double x = std::round(m_ground.x() / step) * step, z = std::round(m_ground.z() / step) * step;
  const double reach = grid_lines * step;
  for (int line = -grid_lines; line <= grid_lines; ++line) {
    QColor colour = m_palette.grid;
    colour.setAlphaF(colour_part(double{colour.alphaF()} * (1 - 0.8 * std::abs(line) / grid_lines)));
    painter.setPen(QPen(colour, 1));
    const double off = line * step;
    painter.drawLine(project({x - reach, m_space.ground, z + off}),
                     project({x + reach, m_space.ground, z + off}));
    painter.drawLine(project({x + off, m_space.ground, z - reach}),
                     project({x + off, m_space.ground, z + reach}));
  }
}

void MotionPicture::paintHeight(QPainter& painter) const {
  if (!(m_space.height > 0)) return;
  const double x = std::min(width() - 64.0, width() / 2.0 + 0.36 * pixelsPerUnit() * m_space.height + 30);
  const double bottom = project(m_ground).y(), top = project(m_ground + Vec3(0, m_space.height, 0)).y();
  painter.setPen(QPen(m_palette.secondary, 1.5));
  painter.drawLine(QPointF(x, bottom), QPointF(x, top));
  for (const double end : {bottom, top}) painter.drawLine(QPointF(x - 7, end), QPointF(x + 7, end));
  painter.setPen(m_palette.text);
  painter.drawText(QPointF(x + 10, (bottom + top) / 2), m_space.height_words);
}

void MotionPicture::paintSkeleton(QPainter& painter) const {
  const auto known = [this](int joint) { return m_frame.known[static_cast<std::size_t>(joint)]; };
  const auto at = [this](int joint) { return project(m_frame.pose.row(joint).transpose()); };
  const double limb = m_frame.is_body ? std::max(2.5, limb_m * pixelsPerUnit()) : 2.5;
  painter.setPen(QPen(m_palette.active, limb, Qt::SolidLine, Qt::RoundCap));
  for (int b = 0; b < bone_count; ++b) {
    const auto [from, to] = bone(b);
    if (known(from) && known(to)) painter.drawLine(at(from), at(to));
  }
  if (m_frame.is_body && known(joints::Head)) {
    painter.setPen(Qt::NoPen);
    painter.setBrush(m_palette.active);
    const double head = head_m * pixelsPerUnit();
    painter.drawEllipse(at(joints::Head), head, head);
  }
  if (m_frame.joint < 0 || !known(m_frame.joint)) return;
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(m_palette.text, 2));
  painter.drawEllipse(at(m_frame.joint), 8, 8);
}

void MotionPicture::paintPoints(QPainter& painter) const {
  for (int p = 0; p < static_cast<int>(m_frame.points.rows()); ++p) {
    if (!m_frame.points.row(p).allFinite()) continue;
    const bool chosen = std::count(m_frame.chosen.begin(), m_frame.chosen.end(), p) > 0;
    painter.setPen(QPen(chosen ? m_palette.text : m_palette.panel, 1));
    painter.setBrush(chosen ? m_palette.accent : m_frame.is_body ? QColor(Qt::white) : m_palette.secondary);
    const double size = chosen ? 5.0 : 3.0;
    painter.drawEllipse(placeOf(p), size, size);
  }
}

/// Chosen points first, then in the order of the file, where they find room beside their point.
void MotionPicture::paintNames(QPainter& painter) {
  m_namesDrawn = 0;
  if (!m_hasNames) return;
  std::vector<int> order = m_frame.chosen;
  for (int p = 0; p < static_cast<int>(m_frame.points.rows()); ++p)
    if (std::count(order.begin(), order.end(), p) == 0) order.push_back(p);
  painter.setFont(interface_font(10));
  const QFontMetricsF metrics(painter.font());
  std::vector<QRectF> taken;
  for (const int p : order) {
    if (p >= static_cast<int>(m_frame.names.size()) || m_frame.names[static_cast<std::size_t>(p)].empty() ||
        !m_frame.points.row(p).allFinite())
      continue;
    const QString name = text(m_frame.names[static_cast<std::size_t>(p)]);
    const double wide = metrics.horizontalAdvance(name), high = metrics.height();
    const QPointF at = placeOf(p);
    for (const double left : {at.x() + 7, at.x() - 7 - wide}) {
      const QRectF box(left, at.y() - high / 2, wide, high);
      if (!QRectF(rect()).contains(box) ||
          std::any_of(taken.begin(), taken.end(), [&box](const QRectF& one) { return one.intersects(box); }))
        continue;
      taken.push_back(box);
      const bool chosen = std::count(m_frame.chosen.begin(), m_frame.chosen.end(), p) > 0;
      QPainterPath letters;
      letters.addText(QPointF(left, at.y() + metrics.ascent() / 2 - 1), painter.font(), name);
      painter.strokePath(letters, QPen(m_palette.scene_bottom, 3));
      painter.fillPath(letters, chosen ? m_palette.text : m_palette.secondary);
      ++m_namesDrawn;
      break;
    }
  }
}

void MotionPicture::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setFont(interface_font(11));
  QLinearGradient air(0, 0, 0, height());
  air.setColorAt(0, m_palette.scene_top);
  air.setColorAt(1, m_palette.scene_bottom);
  painter.setPen(hasFocus() ? QPen(m_palette.accent) : QPen(Qt::NoPen));
  painter.setBrush(air);
  painter.drawRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), 5, 5);
  if (m_frame.points.rows() == 0) {
    painter.setPen(m_palette.secondary);
    painter.drawText(rect().adjusted(24, 24, -24, -24), Qt::AlignCenter | Qt::TextWordWrap, m_nothing);
    return;
  }
  paintGround(painter);
  paintSkeleton(painter);
  paintPoints(painter);
  paintNames(painter);
  paintHeight(painter);
}

void MotionPicture::mousePressEvent(QMouseEvent* event) {
  m_pressed = event->pos();
  m_yawAtPress = m_yaw;
}

void MotionPicture::mouseMoveEvent(QMouseEvent* event) {
  if ((event->pos() - m_pressed).manhattanLength() < QApplication::startDragDistance()) return;
  m_yaw = m_yawAtPress + radians_per_pixel * (event->pos().x() - m_pressed.x());
  update();
}

void MotionPicture::mouseReleaseEvent(QMouseEvent* event) {
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

void MotionPicture::keyPressEvent(QKeyEvent* event) {
  if (event->key() != Qt::Key_Left && event->key() != Qt::Key_Right) return QWidget::keyPressEvent(event);
  m_yaw += event->key() == Qt::Key_Left ? -0.1 : 0.1;
  update();
}

}  // namespace abrazo::widgets
