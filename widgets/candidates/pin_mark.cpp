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

}  // namespace abrazo::widgets
