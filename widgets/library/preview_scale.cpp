#include "widgets/library/preview_scale.hpp"

#include <algorithm>
#include <cmath>

namespace abrazo::widgets {
namespace {

constexpr double least_extent_m = 2.0;  ///< a lone standing figure does not fill everything
constexpr int looked_at = 60;           ///< frames

struct Box {
  Eigen::RowVector3d low = Eigen::RowVector3d::Zero(), high = Eigen::RowVector3d::Zero();
};

Box box_of(const PreviewedClip& a, const PreviewedClip& b, int frame) {
  Box box;
  bool first = true;
  for (const PreviewedClip* one : {&a, &b}) {
    const Pose* pose = one->pose(frame);
    if (!pose) continue;
    const Eigen::RowVector3d low = pose->colwise().minCoeff(), high = pose->colwise().maxCoeff();
    box.low = first ? low : Eigen::RowVector3d(box.low.cwiseMin(low));
    box.high = first ? high : Eigen::RowVector3d(box.high.cwiseMax(high));
    first = false;
  }
  return box;
}

}  // namespace

int PreviewedClip::frames() const {
  return clip ? std::max(0, static_cast<int>(clip->poses.size()) - start) : 0;
}

const Pose* PreviewedClip::pose(int frame) const {
  if (frames() == 0) return nullptr;
  return &clip->poses[static_cast<std::size_t>(start + std::clamp(frame, 0, frames() - 1))];
}

int common_frames(const PreviewedClip& a, const PreviewedClip& b) {
  return a.clip && b.clip ? std::min(a.frames(), b.frames()) : std::max(a.frames(), b.frames());
}

PreviewScale preview_scale(const PreviewedClip& a, const PreviewedClip& b) {
  PreviewScale scale;
  scale.extent_m = least_extent_m;
  double apart_x = 0, apart_z = 0;
  const int frames = common_frames(a, b);
  for (int f = 0; f < frames; f += std::max(1, frames / looked_at)) {
    const Box box = box_of(a, b, f);
    scale.extent_m = std::max(scale.extent_m, (box.high - box.low).maxCoeff());
    if (const Pose* first = a.pose(f), *second = b.pose(f); first && second) {
      apart_x += std::abs((*first)(0, 0) - (*second)(0, 0));
      apart_z += std::abs((*first)(0, 2) - (*second)(0, 2));
    }
  }
  scale.side_axis = apart_z > apart_x ? 2 : 0;
  return scale;
}

Vec3 middle_of(const PreviewedClip& a, const PreviewedClip& b, int frame) {
  const Box box = box_of(a, b, frame);
  return ((box.low + box.high) / 2).transpose();
}

}  // namespace abrazo::widgets
