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

/// A cross where it was picked, and a line to the ring where the camera has it.
void paint_pick(QPainter& painter, const PickMark& pick, const PictureFraming& framing,
                const Palette& palette, bool selected);

/// What is under the pointer, magnified so that a tenth of a pixel is visible.
struct Lens {
  const QImage& picture;
  Pixel pixel;
  QPointF at;     ///< the pointer, in the view
  QString words;  ///< what is being picked
};
/// Beside the pointer, where there is room for it.
void paint_lens(QPainter& painter, const Lens& lens, const QRect& view, const Palette& palette);

}  // namespace abrazo::widgets
