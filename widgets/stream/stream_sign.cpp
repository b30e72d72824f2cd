#include "widgets/stream/stream_sign.hpp"

#include <QPainter>

namespace abrazo::widgets {

QColor colour_of(StreamMark mark, const Palette& palette) {
  switch (mark) {
    case StreamMark::Off:
      return palette.secondary;
    case StreamMark::Waiting:
      return palette.residual_bones;
    case StreamMark::Good:
      return palette.good;
    case StreamMark::Warning:
      return palette.warning;
    case StreamMark::Bad:
      break;
  }
  return palette.dark ? palette.live.lighter(135) : palette.live;
}

void draw_sign(QPainter& painter, QPointF middle, StreamMark mark, const Palette& palette) {
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  painter.translate(middle);
  const QColor colour = colour_of(mark, palette);
  painter.setPen(QPen(colour, 1.5, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  switch (mark) {
    case StreamMark::Off:
      painter.drawEllipse(QPointF(), 4.5, 4.5);
      break;
    case StreamMark::Waiting:
      painter.drawEllipse(QPointF(), 5.5, 5.5);
      painter.drawPolyline(QPolygonF({{0, -3}, {0, 0}, {2.2, 1.6}}));
      break;
    case StreamMark::Good:
      painter.setBrush(colour);
      painter.drawEllipse(QPointF(), 4.5, 4.5);
      break;
    case StreamMark::Warning:
      painter.drawPolygon(QPolygonF({{0, -5.5}, {6.2, 5}, {-6.2, 5}}));
      painter.drawLine(QPointF(0, -1.8), QPointF(0, 1.2));
      painter.drawPoint(QPointF(0, 3.2));
      break;
    case StreamMark::Bad:
      painter.drawEllipse(QPointF(), 5.8, 5.8);
      painter.drawLine(QPointF(-2.2, -2.2), QPointF(2.2, 2.2));
      painter.drawLine(QPointF(2.2, -2.2), QPointF(-2.2, 2.2));
      break;
  }
  painter.restore();
}

StreamMark mark_of(StreamDiagnosis::Severity severity) {
  switch (severity) {
    case StreamDiagnosis::Severity::Error:
      return StreamMark::Bad;
    case StreamDiagnosis::Severity::Warning:
      return StreamMark::Warning;
    case StreamDiagnosis::Severity::Note:
      break;
  }
  return StreamMark::Off;
}

StreamMark mark_of(LatencyVerdict verdict) {
  switch (verdict) {
    case LatencyVerdict::Good:
      return StreamMark::Good;
    case LatencyVerdict::Warning:
      return StreamMark::Warning;
    case LatencyVerdict::Bad:
      return StreamMark::Bad;
    case LatencyVerdict::None:
      break;
  }
  return StreamMark::Off;
}

}  // namespace abrazo::widgets
