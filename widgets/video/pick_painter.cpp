#include "widgets/video/pick_painter.hpp"

#include <cmath>

#include <QPainter>
#include <QPainterPath>

#include "widgets/common/theme.hpp"

namespace abrazo::widgets {
namespace {

constexpr double arm_px = 7, gap_px = 2, ring_px = 4.5;
constexpr double lens_px = 132, lens_share = 0.55, lens_scale = 9, lens_away = 20;
const QColor shade(0, 0, 0, 190);

/// Open in the middle, so that the picked point is not covered.
void paint_cross(QPainter& painter, const QPointF& at, double arm, const QPen& pen) {
  painter.setPen(pen);
  for (const QPointF& way : {QPointF(1, 0), QPointF(-1, 0), QPointF(0, 1), QPointF(0, -1)})
    painter.drawLine(at + gap_px * way, at + arm * way);
}

QRectF place_of(const Lens& lens, const QRect& view) {
  const double size = std::min(lens_px, lens_share * std::min(view.width(), view.height()));
  QRectF place(lens.at.x() + lens_away, lens.at.y() - lens_away - size, size, size);
  if (place.right() > view.right()) place.moveRight(lens.at.x() - lens_away);
  if (place.top() < view.top())
    place.moveTop(std::min<double>(lens.at.y() + lens_away, view.bottom() - size));
  if (place.left() < view.left()) place.moveLeft(view.left());
  return place;
}

/// At the picture's other end, where it covers nothing that is looked at.
void write_words(QPainter& painter, const QString& words, const QPointF& at, const QRect& view) {
  painter.setFont(interface_font(12));
  const QFontMetricsF metrics(painter.font());
  QRectF pill(0, 0, metrics.horizontalAdvance(words) + 16, metrics.height() + 6);
  pill.moveLeft(view.left() + 6);
  at.y() > view.center().y() ? pill.moveTop(view.top() + 6) : pill.moveBottom(view.bottom() - 6);
  painter.setPen(Qt::NoPen);
  painter.setBrush(shade);
  painter.drawRoundedRect(pill, 5, 5);
  painter.setPen(Qt::white);
  painter.drawText(pill, Qt::AlignCenter, words);
}

QString words_of(const Lens& lens) {
  const QString where = QString("%1, %2").arg(lens.pixel.x(), 0, 'f', 1).arg(lens.pixel.y(), 0, 'f', 1);
  return lens.words.isEmpty() ? where : lens.words + "  " + where;
}

}  // namespace

void paint_pick(QPainter& painter, const PickMark& pick, const PictureFraming& framing,
                const Palette& palette, bool selected) {
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setBrush(Qt::NoBrush);
  const QPointF at(framing.x(pick.pixel.x()), framing.y(pick.pixel.y()));
  const QColor colour = pick.is_outlier ? palette.live.lighter(140)
                        : selected      ? QColor(Qt::white)
                                        : palette.warning;
  if (pick.projected) {
    const QPointF found(framing.x(pick.projected->x()), framing.y(pick.projected->y()));
    painter.setPen(QPen(colour, 1, pick.is_outlier ? Qt::DotLine : Qt::SolidLine));
    painter.drawLine(at, found);
    painter.drawEllipse(found, ring_px, ring_px);
  }
  paint_cross(painter, at, arm_px, QPen(shade, 3.5));
  paint_cross(painter, at, arm_px, QPen(colour, selected ? 2 : 1.3));
  if (selected) {
    painter.setFont(interface_font(11));
    const QPointF place = at + QPointF(arm_px + 3, -4);
    const QString name = QString::fromStdString(pick.name);
    QPainterPath text;
    text.addText(place, painter.font(), name);
    painter.strokePath(text, QPen(shade, 3));
    painter.fillPath(text, Qt::white);
  }
  painter.restore();
}

void paint_lens(QPainter& painter, const Lens& lens, const QRect& view, const Palette& palette) {
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  const QRectF place = place_of(lens, view);
  QPainterPath round;
  round.addEllipse(place);
  painter.setClipPath(round);
  painter.fillRect(place, Qt::black);
  painter.setRenderHint(QPainter::SmoothPixmapTransform, false);
  const PictureFraming frame{lens_scale, place.center().x() - (lens.pixel.x() + 0.5) * lens_scale,
                             place.center().y() - (lens.pixel.y() + 0.5) * lens_scale};
  // Only the visible part of the picture: all of it would be many thousand pixels wide.
  const int reach = static_cast<int>(place.width() / lens_scale / 2) + 2;
  const QRect seen =
      QRect(static_cast<int>(std::lround(lens.pixel.x())) - reach,
            static_cast<int>(std::lround(lens.pixel.y())) - reach, 2 * reach + 1, 2 * reach + 1)
          .intersected(lens.picture.rect());
  painter.drawImage(QRectF(frame.x(seen.left() - 0.5), frame.y(seen.top() - 0.5), seen.width() * lens_scale,
                           seen.height() * lens_scale),
                    lens.picture, seen);
  paint_cross(painter, place.center(), place.width() / 2, QPen(shade, 3));
  paint_cross(painter, place.center(), place.width() / 2, QPen(palette.warning, 1));
  painter.setClipping(false);
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(QColor(255, 255, 255, 160), 1.5));
  painter.drawEllipse(place);
  write_words(painter, words_of(lens), lens.at, view);
  painter.restore();
}

}  // namespace abrazo::widgets
