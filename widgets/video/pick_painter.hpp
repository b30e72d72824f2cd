#pragma once

#include <QImage>
#include <QPointF>
#include <QRect>
#include <QString>

#include "widgets/common/palette.hpp"
#include "widgets/video/pick_mark.hpp"
#include "widgets/video/picture_framing.hpp"

class QPainter;

namespace abrazo::widgets {

/// A cross at the picked position, and a line to a ring at the projected one.
void paint_pick(QPainter& painter, const PickMark& pick, const PictureFraming& framing,
                const Palette& palette, bool selected);

/// A magnifier at the pointer that shows a tenth of a pixel.
struct Lens {
  const QImage& picture;
  Pixel pixel;
  QPointF at;     ///< the pointer, in the view
  QString words;  ///< the joint to pick
};
/// Paints the magnifier beside the pointer, where there is room.
void paint_lens(QPainter& painter, const Lens& lens, const QRect& view, const Palette& palette);

}  // namespace abrazo::widgets
