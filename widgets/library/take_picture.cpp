#include "widgets/library/take_picture.hpp"

#include <QPainter>
#include <algorithm>

#include "core/motion/body/joint_set.hpp"

namespace abrazo::widgets {

QPointF FlatView::at(const Pose& pose, int joint) const {
  return {origin.x() + scale * pose(joint, side), origin.y() - scale * pose(joint, up)};
}

void draw_bones(QPainter& painter, const Pose& pose, const FlatView& view) {
  for (int b = 0; b < bone_count; ++b)
    painter.drawLine(view.at(pose, bone(b).first), view.at(pose, bone(b).second));
}

void draw_pair(QPainter& painter, const QRectF& square, const PairPose& pair, const QColor& active,
               const QColor& passive) {
  const Eigen::RowVector3d low = pair.colwise().minCoeff(), high = pair.colwise().maxCoeff();
  FlatView view;
  view.scale = (square.height() - 6) / std::max({high.y() - low.y(), high.z() - low.z(), 0.1});
  view.origin = {square.center().x() - view.scale * (low.z() + high.z()) / 2,
                 square.bottom() - 3 + view.scale * low.y()};
  for (const bool is_active : {false, true}) {
    painter.setPen(QPen(is_active ? active : passive, 1.6, Qt::SolidLine, Qt::RoundCap));
    draw_bones(painter, is_active ? Pose(pair.topRows<joint_count>()) : Pose(pair.bottomRows<joint_count>()),
               view);
  }
}

}  // namespace abrazo::widgets
