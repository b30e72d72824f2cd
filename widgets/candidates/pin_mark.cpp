#include "widgets/candidates/pin_mark.hpp"

#include <QPainter>

namespace abrazo::widgets {

void draw_pin(QPainter& painter, const QPointF& middle, const QColor& colour, bool filled) {
  painter.save();
  painter.setPen(QPen(colour, 1.3, Qt::SolidLine, Qt::RoundCap));
  painter.setBrush(filled ? QBrush(colour) : Qt::NoBrush);
  painter.drawEllipse(middle + QPointF(0, -1.8), 2.9, 2.9);
  painter.drawLine(middle + QPointF(0, 1.3), middle + QPointF(0, 5));
  painter.restore();
}

void draw_veto(QPainter& painter, const QPointF& middle, const QColor& colour) {
  painter.save();
  painter.setPen(QPen(colour, 1.3, Qt::SolidLine, Qt::RoundCap));
  painter.setBrush(Qt::NoBrush);
  painter.drawEllipse(middle, 3.8, 3.8);
  painter.drawLine(middle + QPointF(-2.6, 2.6), middle + QPointF(2.6, -2.6));
  painter.restore();
}

void draw_meant(QPainter& painter, const QPointF& middle, const QColor& colour, bool out) {
  painter.save();
  painter.setPen(QPen(colour, 1.3, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  painter.setBrush(Qt::NoBrush);
  painter.drawPolygon(
      QPolygonF({middle + QPointF(-4.3, -4), middle + QPointF(4.3, -4), middle + QPointF(4.3, 2),
                 middle + QPointF(0.5, 2), middle + QPointF(-1.8, 4.6), middle + QPointF(-1.8, 2),
                 middle + QPointF(-4.3, 2)}));
  if (out) painter.drawLine(middle + QPointF(-4.6, 4.6), middle + QPointF(4.6, -5.6));
  painter.restore();
}

void draw_continuation(QPainter& painter, const QPointF& middle, const QColor& colour) {
  painter.save();
  painter.setPen(QPen(colour, 1.3, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  painter.setBrush(Qt::NoBrush);
  painter.drawLine(middle + QPointF(-4, 0), middle + QPointF(3.6, 0));
  painter.drawPolyline(
      QPolygonF({middle + QPointF(0.8, -3), middle + QPointF(4, 0), middle + QPointF(0.8, 3)}));
  painter.restore();
}

}  // namespace abrazo::widgets
