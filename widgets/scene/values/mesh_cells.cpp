#include "widgets/scene/values/mesh_cells.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numeric>

namespace abrazo::widgets {
namespace {

/// Height over the largest face [m].
double thickness(const PairPose& pair, const MeshTetrahedron& cell) {
  double largest = 0;  // twice the area
  for (const auto& face : cell_faces) {
    const auto corner = [&](std::size_t i) {
      return Vec3(pair.row(cell[static_cast<std::size_t>(face[i])]).transpose());
    };
    largest = std::max(largest, (corner(1) - corner(0)).cross(corner(2) - corner(0)).norm());
  }
  return largest > 0 ? std::abs(six_volumes(pair, cell)) / largest : 0;
}

}  // namespace

CellVolume cell_volume(const PairPose& result, const PairPose& reference, const MeshTetrahedron& cell) {
  const double now = six_volumes(result, cell), before = six_volumes(reference, cell);
  CellVolume volume;
  volume.volume_m3 = std::abs(now) / 6;
  volume.reference_m3 = std::abs(before) / 6;
  volume.is_flat = thickness(reference, cell) < flat_m;
  if (volume.is_flat) return volume;
  volume.ratio = now / before;
  volume.is_inverted = volume.ratio <= 0;
  return volume;
}

std::vector<CellVolume> cell_volumes(const FrameResult& frame) {
  std::vector<CellVolume> cells;
  cells.reserve(frame.tetrahedra.size());
  for (const MeshTetrahedron& cell : frame.tetrahedra)
    cells.push_back(cell_volume(frame.result, frame.selected_pair, cell));
  return cells;
}

int inverted_count(std::span<const CellVolume> cells) {
  return static_cast<int>(
      std::count_if(cells.begin(), cells.end(), [](const CellVolume& c) { return c.is_inverted; }));
}

bool joins_bodies(const MeshTetrahedron& cell) {
  const auto first = std::count_if(cell.begin(), cell.end(), [](auto v) { return v < joint_count; });
  return first != 0 && first != 4;
}

double typical_doublings(std::span<const CellVolume> cells) {
  std::vector<double> sizes;
  for (const CellVolume& cell : cells)
    if (!cell.is_flat && !cell.is_inverted) sizes.push_back(std::abs(std::log2(cell.ratio)));
  if (sizes.empty()) return 0;
  const auto place = static_cast<std::ptrdiff_t>(0.9 * static_cast<double>(sizes.size() - 1));
  std::nth_element(sizes.begin(), sizes.begin() + place, sizes.end());
  return sizes[static_cast<std::size_t>(place)];
}

std::vector<double> spread_cells(const PairPose& pair, std::span<const MeshTetrahedron> cells, double apart,
                                 double shrink) {
  Vec3 middle = pair.colwise().mean().transpose();
  middle.y() = pair.col(1).minCoeff();  // upwards only: the floor hides what is below it
  std::vector<double> corners;
  corners.reserve(12 * cells.size());
  for (const MeshTetrahedron& cell : cells) {
    Vec3 centre = Vec3::Zero();
    for (const auto vertex : cell) centre += 0.25 * pair.row(vertex).transpose();
    const Vec3 moved = centre + apart * (centre - middle);
    for (const auto vertex : cell) {
      const Vec3 corner = moved + (1 - shrink) * (pair.row(vertex).transpose() - centre);
      corners.insert(corners.end(), {corner.x(), corner.y(), corner.z()});
    }
  }
  return corners;
}

std::vector<int> faces_back_to_front(std::span<const double> corners, const Vec3& eye,
                                     const Vec3& direction) {
  const std::size_t cells = corners.size() / 12;
  std::vector<double> depths(4 * cells);
  for (std::size_t face = 0; face < depths.size(); ++face) {
    Vec3 sum = Vec3::Zero();
    for (const int corner : cell_faces[face % 4])
      sum += Vec3(corners.data() + 12 * (face / 4) + 3 * static_cast<std::size_t>(corner));
    depths[face] = (sum / 3 - eye).dot(direction);
  }
  std::vector<int> order(depths.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(), [&depths](int a, int b) {
    return depths[static_cast<std::size_t>(a)] > depths[static_cast<std::size_t>(b)];
  });
  return order;
}

}  // namespace abrazo::widgets
