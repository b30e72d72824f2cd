#include "tests/support/cgal_mesh.hpp"

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_vertex_base_with_info_3.h>

#include <algorithm>
#include <array>
#include <map>

namespace abrazo::test {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Vertex = CGAL::Triangulation_vertex_base_with_info_3<std::uint8_t, Kernel>;
using Cell = CGAL::Delaunay_triangulation_cell_base_3<Kernel>;
using Delaunay = CGAL::Delaunay_triangulation_3<Kernel, CGAL::Triangulation_data_structure_3<Vertex, Cell>>;

/// About the mean, as the engine takes them: rounding must not make other points.
std::array<Kernel::Point_3, pair_vertex_count> points_of(const PairPose& pair) {
  const PairPose centred = pair.rowwise() - pair.colwise().mean();
  std::array<Kernel::Point_3, pair_vertex_count> points;
  for (int v = 0; v < pair_vertex_count; ++v)
    points[static_cast<std::size_t>(v)] = {centred(v, 0), centred(v, 1), centred(v, 2)};
  return points;
}

}  // namespace

std::vector<MeshTetrahedron> in_ascending_order(std::vector<MeshTetrahedron> tetrahedra) {
  for (MeshTetrahedron& one : tetrahedra) std::sort(one.begin(), one.end());
  std::sort(tetrahedra.begin(), tetrahedra.end());
  return tetrahedra;
}

std::vector<MeshTetrahedron> cgal_tetrahedra(const PairPose& pair) {
  Delaunay delaunay;
  std::uint8_t number = 0;
  for (const Kernel::Point_3& point : points_of(pair)) delaunay.insert(point)->info() = number++;
  std::vector<MeshTetrahedron> tetrahedra;
  for (const auto cell : delaunay.finite_cell_handles())
    tetrahedra.push_back(
        {cell->vertex(0)->info(), cell->vertex(1)->info(), cell->vertex(2)->info(), cell->vertex(3)->info()});
  return in_ascending_order(std::move(tetrahedra));
}

bool is_delaunay(const PairPose& pair, const std::vector<MeshTetrahedron>& tetrahedra) {
  const auto points = points_of(pair);
  const auto at = [&](std::uint8_t vertex) { return points[vertex]; };
  // Faces meet in twos but for those of the hull, which have all points on one side.
  std::map<std::array<std::uint8_t, 3>, int> faces;
  for (const MeshTetrahedron& t : tetrahedra) {
    if (CGAL::orientation(at(t[0]), at(t[1]), at(t[2]), at(t[3])) != CGAL::POSITIVE) return false;
    for (const Kernel::Point_3& point : points)
      if (CGAL::side_of_oriented_sphere(at(t[0]), at(t[1]), at(t[2]), at(t[3]), point) ==
          CGAL::ON_POSITIVE_SIDE)
        return false;
    for (std::size_t left_out = 0; left_out < 4; ++left_out) {
      std::array<std::uint8_t, 3> face{};
      std::copy_if(t.begin(), t.end(), face.begin(), [&](std::uint8_t v) { return v != t[left_out]; });
      std::sort(face.begin(), face.end());
      ++faces[face];
    }
  }
  return std::all_of(faces.begin(), faces.end(), [&](const auto& counted) {
    const auto& [face, count] = counted;
    if (count == 2) return true;
    bool above = false, below = false;
    for (const Kernel::Point_3& point : points) {
      const auto side = CGAL::orientation(at(face[0]), at(face[1]), at(face[2]), point);
      above = above || side == CGAL::POSITIVE;
      below = below || side == CGAL::NEGATIVE;
    }
    return count == 1 && !(above && below);
  });
}

}  // namespace abrazo::test
