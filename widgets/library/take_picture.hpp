#pragma once

#include <QColor>
#include <QRectF>

#include "core/base/positions.hpp"

class QPainter;

namespace abrazo::widgets {

/// Parallel projection of the bones of one body along an axis.
/// @param side coordinate to the right; @param up coordinate upwards; rows of `pose` are the 25 joints
/// @param scale pixels per metre; @param origin position of (0, 0)
struct FlatView {
  int side = 2;
  int up = 1;
  double scale = 20;
  QPointF origin;
  QPointF at(const Pose& pose, int joint) const;
};
void draw_bones(QPainter& painter, const Pose& pose, const FlatView& view);

/// Both bodies of a pair from the side of the active one, filling a square.
void draw_pair(QPainter& painter, const QRectF& square, const PairPose& pair, const QColor& active,
               const QColor& passive);

}  // namespace abrazo::widgets
