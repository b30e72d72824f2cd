#pragma once

#include <cmath>
#include <vector>

#include "core/motion/body/joint_set.hpp"

namespace abrazo::widgets {

/// Ends of the lines of another run's body, three numbers per point, two points per line: bones solid, or cut
/// into dashes of about 3 cm. A bone has a dash at either end, so that joints are visible.
inline std::vector<double> bone_strokes(const PairPose& pair, int first_vertex, bool dashed) {
  constexpr double period_m = 0.05;
  constexpr double dash_share = 0.6;
  std::vector<double> ends;
  for (int b = 0; b < bone_count; ++b) {
    const Vec3 from = pair.row(first_vertex + bone(b).first);
    const Vec3 along = Vec3(pair.row(first_vertex + bone(b).second)) - from;
    const int gaps = dashed ? static_cast<int>(std::lround(along.norm() / period_m)) : 0;
    // Alternating dashes and gaps, the last a dash: (gaps + 1) d + gaps g = 1 with d : g fixed.
    const double dash = dash_share / (gaps + dash_share), step = 1 / (gaps + dash_share);
    for (int d = 0; d <= gaps; ++d)
      for (const double share : {d * step, d * step + dash}) {
        const Vec3 point = from + share * along;
        ends.insert(ends.end(), {point.x(), point.y(), point.z()});
      }
  }
  return ends;
}

/// Lines between the same joints of two bodies that differ by at least a minimum distance.
inline std::vector<double> difference_strokes(const PairPose& a, const PairPose& b, int first_vertex,
                                              double least_m) {
  std::vector<double> ends;
  for (int v = first_vertex; v < first_vertex + joint_count; ++v) {
    if ((a.row(v) - b.row(v)).norm() < least_m) continue;
    for (const PairPose* pair : {&a, &b})
      for (int axis = 0; axis < 3; ++axis) ends.push_back((*pair)(v, axis));
  }
  return ends;
}

}  // namespace abrazo::widgets
