#include "widgets/video/overlay_painter.hpp"

#include <QPainter>
#include <QPainterPath>

namespace abrazo::widgets {
namespace {

using Part = OverlayLine::Part;

constexpr double bone_px = 2.6, rim_px = 1.2, mesh_px = 0.9, within_px = 0.6, joint_px = 2.2;
const QColor rim(0, 0, 0, 150);  // keeps a line readable over any picture

QPainterPath path_of(const VideoOverlay& overlay, Part part, const PictureFraming& framing) {
  QPainterPath path;
  for (const OverlayLine& line : overlay.lines) {
    if (line.part != part) continue;
    path.moveTo(framing.x(line.points.front().x()), framing.y(line.points.front().y()));
    for (std::size_t i = 1; i < line.points.size(); ++i)
      path.lineTo(framing.x(line.points[i].x()), framing.y(line.points[i].y()));
  }
  return path;
}

QPen pen(const QColor& colour, double width, Qt::PenStyle style = Qt::SolidLine) {
  QPen made(colour, width, style, Qt::FlatCap, Qt::RoundJoin);
  if (style != Qt::SolidLine) made.setDashPattern({2.6, 1.5});
  return made;
}

void paint_body(QPainter& painter, const QPainterPath& path, const QColor& colour, Qt::PenStyle style,
                double size) {
  if (path.isEmpty()) return;
  painter.setPen(pen(rim, (bone_px + 2 * rim_px) * size));
  painter.drawPath(path);
  painter.setPen(pen(colour, bone_px * size, style));
  painter.drawPath(path);
}

void paint_joints(QPainter& painter, const VideoOverlay& overlay, const PictureFraming& framing,
                  double size) {
  painter.setPen(pen(rim, rim_px * size));
  painter.setBrush(Qt::white);
  for (const auto& joint : overlay.joints)
    if (joint)
      painter.drawEllipse(QPointF(framing.x(joint->x()), framing.y(joint->y())), joint_px * size,
                          joint_px * size);
  painter.setBrush(Qt::NoBrush);
}

}  // namespace

void paint_overlay(QPainter& painter, const VideoOverlay& overlay, const PictureFraming& framing,
                   const Palette& palette, const OverlayLook& look) {
  if (overlay.empty() || look.opacity <= 0) return;
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setOpacity(look.opacity);
  painter.setBrush(Qt::NoBrush);
  const double size = look.thickness;
  painter.setPen(pen(QColor(255, 255, 255, 120), within_px * size));
  painter.drawPath(path_of(overlay, Part::WithinBody, framing));
  painter.setPen(pen(QColor(255, 255, 255, 200), mesh_px * size));
  painter.drawPath(path_of(overlay, Part::BetweenBodies, framing));
  paint_body(painter, path_of(overlay, Part::Passive, framing), palette.passive, Qt::DashLine, size);
  paint_body(painter, path_of(overlay, Part::Active, framing), palette.active, Qt::SolidLine, size);
  paint_joints(painter, overlay, framing, size);
  painter.restore();
}

}  // namespace abrazo::widgets
