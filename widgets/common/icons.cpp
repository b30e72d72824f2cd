#include "widgets/common/icons.hpp"

#include <QCoreApplication>
#include <QHash>
#include <QPainter>
#include <QPainterPath>
#include <QPixmap>

namespace abrazo::widgets {
namespace {

QPainterPath triangle(double x0, double x1) {
  QPainterPath path;
  path.moveTo(x0, 3.2);
  path.lineTo(x1, 8);
  path.lineTo(x0, 12.8);
  path.closeSubpath();
  return path;
}

void bar(QPainter& painter, double x, double width) {
  painter.drawRoundedRect(QRectF(x, 3.2, width, 9.6), 0.6, 0.6);
}

void filled(QPainter& painter, Icon which) {
  painter.setBrush(painter.pen().color());
  switch (which) {
    case Icon::ToStart:
      bar(painter, 3, 1.2);
      painter.drawPath(triangle(13, 6));
      break;
    case Icon::StepBack:
      painter.drawPath(triangle(9, 2.5));
      bar(painter, 11.8, 1.2);
      break;
    case Icon::Play:
      painter.drawPath(triangle(4.2, 13));
      break;
    case Icon::Pause:
      bar(painter, 4, 2.4);
      bar(painter, 9.6, 2.4);
      break;
    case Icon::StepForward:
      bar(painter, 3, 1.2);
      painter.drawPath(triangle(7, 13.5));
      break;
    case Icon::ToEnd:
      painter.drawPath(triangle(3, 10));
      bar(painter, 11.8, 1.2);
      break;
    default:
      break;
  }
}

void lined(QPainter& painter, Icon which) {
  painter.setBrush(Qt::NoBrush);
  switch (which) {
    case Icon::Loop:
    case Icon::Reset:
      painter.drawArc(QRectF(3, 3, 10, 10), 60 * 16, 290 * 16);
      painter.drawPolyline(QPolygonF({{10.2, 0.9}, {10.6, 3.7}, {7.8, 4.4}}));
      break;
    case Icon::Close:
      painter.drawLine(QPointF(4, 4), QPointF(12, 12));
      painter.drawLine(QPointF(12, 4), QPointF(4, 12));
      break;
    case Icon::More:
      for (const double x : {4.0, 8.0, 12.0}) painter.drawPoint(QPointF(x, 8));
      break;
    case Icon::Warning:
      painter.drawPolygon(QPolygonF({{8, 2}, {14.5, 13.5}, {1.5, 13.5}}));
      painter.drawLine(QPointF(8, 6), QPointF(8, 9.6));
      painter.drawPoint(QPointF(8, 11.7));
      break;
    case Icon::Information:
      painter.drawEllipse(QPointF(8, 8), 6, 6);
      painter.drawLine(QPointF(8, 7.4), QPointF(8, 11));
      painter.drawPoint(QPointF(8, 5));
      break;
    case Icon::Lock:
    case Icon::Unlock:
      painter.drawRoundedRect(QRectF(3.5, 7.5, 9, 6), 1, 1);
      painter.drawArc(QRectF(which == Icon::Lock ? 5.2 : 8.2, 2.4, 5.6, 8), 0, 180 * 16);
      break;
    default:
      break;
  }
}

}  // namespace

QIcon painted_icon(const QSize& size, const std::function<void(QPainter&)>& paint) {
  QIcon icon;
  for (const int ratio : {1, 2}) {
    QPixmap picture(size * ratio);
    picture.setDevicePixelRatio(ratio);
    picture.fill(Qt::transparent);
    QPainter painter(&picture);
    painter.setRenderHint(QPainter::Antialiasing);
    paint(painter);
    painter.end();
    icon.addPixmap(picture);
  }
  return icon;
}

QIcon icon(Icon which, const QColor& colour) {
  // One object for each: Qt keeps a picture of every icon object it was asked for, up to 10 MB, and what
  // shows progress asks several times a second.
  static QHash<QPair<int, QRgb>, QIcon> known;
  if (known.isEmpty()) qAddPostRoutine([] { known.clear(); });  // pictures may not outlive the application
  QIcon& found = known[{static_cast<int>(which), colour.rgba()}];
  if (found.isNull())
    found = painted_icon({16, 16}, [&](QPainter& painter) {
      const bool is_filled = which <= Icon::ToEnd;
      painter.setPen(QPen(colour, is_filled ? 0.8 : 1.5, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
      is_filled ? filled(painter, which) : lined(painter, which);
    });
  return found;
}

QIcon program_icon() {
  return QIcon(":/abrazo/icons/abrazo.svg");
}

}  // namespace abrazo::widgets
