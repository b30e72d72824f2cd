#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_vertex_base_with_info_3.h>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>

#include "core/mesh/interaction_mesh.hpp"
#include "core/motion/joint_set.hpp"

namespace abrazo {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Vertex = CGAL::Triangulation_vertex_base_with_info_3<int, Kernel>;
// The cell without a place for its circumcentre, which nobody asks for.
using Cell = CGAL::Triangulation_cell_base_3<Kernel>;
using Delaunay = CGAL::Delaunay_triangulation_3<Kernel, CGAL::Triangulation_data_structure_3<Vertex, Cell>>;

constexpr double coincidence_m = 1e-3;
constexpr double jitter_m = 1e-5;
constexpr double flatness_m = 1e-6;
constexpr int fallback_neighbours = 8;

/// Displacement that depends on the vertex alone, so that equal input gives equal meshes.
Vec3 jitter_of(int vertex) {
  // Multiples of the golden ratio and its relatives fill the cube evenly (a Kronecker sequence).
  const double n = vertex + 1;
  const auto spread = [n](double irrational) {
    return 2.0 * (n * irrational - std::floor(n * irrational)) - 1.0;
  };
  return jitter_m * Vec3(spread(0.8191725133961645), spread(0.6710436067037893), spread(0.5497004779019703));
}

bool has_coincident_points(const PairPose& pair) {
  for (int i = 0; i < pair_vertex_count; ++i)
    for (int j = i + 1; j < pair_vertex_count; ++j)
      if ((pair.row(i) - pair.row(j)).squaredNorm() < coincidence_m * coincidence_m) return true;
  return false;
}

/// All points in a plane, on a line or in one place, to within what a mesh should be made of.
bool is_flat(const PairPose& pair) {
  const PairPose centred = pair.rowwise() - pair.colwise().mean();
  const Eigen::Matrix3d spread = centred.transpose() * centred;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(spread, Eigen::EigenvaluesOnly);
  return axes.eigenvalues()(0) < flatness_m * flatness_m * pair_vertex_count;
}

PairPose jittered(const PairPose& pair) {
  PairPose moved = pair;
  for (int v = 0; v < pair_vertex_count; ++v) moved.row(v) += jitter_of(v).transpose();
  return moved;
}

/// Bodies and joints in turn, far apart: points in the order of a limb would make slivers that the next ones
/// take apart again, half as fast.
constexpr int insertion_order(int n) {
  return (n % 2) * joint_count + (n / 2 * 7) % joint_count;
}

/// Vertices ascending but for the last two, which stand so that the volume is positive: however a
/// tetrahedron was found, it reads the same.
MeshTetrahedron canonical(MeshTetrahedron t) {
  bool odd = false;
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = i + 1; j < 4; ++j)
      if (t[j] < t[i]) std::swap(t[i], t[j]), odd = !odd;
  if (odd) std::swap(t[2], t[3]);
  return t;
}

/// Nothing when there is no volume, or points are one. Exact in every case: points on one sphere are told
/// apart by CGAL's symbolic perturbation. Any thread.
std::optional<std::vector<MeshTetrahedron>> delaunay(const PairPose& pair) {
  thread_local Delaunay triangulation;  // keeps its memory from pair to pair
  triangulation.clear();
  // Centred, so that pairs far from the origin keep their precision.
  const Eigen::RowVector3d centre = pair.colwise().mean();
  Delaunay::Cell_handle near_last;
  for (int n = 0; n < pair_vertex_count; ++n) {
    const int v = insertion_order(n);
    const Eigen::RowVector3d point = pair.row(v) - centre;
    const auto inserted = triangulation.insert({point.x(), point.y(), point.z()}, near_last);
    inserted->info() = v;
    near_last = inserted->cell();
  }
  // A vertex that stands where another stands is not a vertex of its own: not the mesh of all joints.
  if (triangulation.dimension() < 3 ||
      triangulation.number_of_vertices() != static_cast<std::size_t>(pair_vertex_count))
    return std::nullopt;
  std::vector<MeshTetrahedron> tetrahedra;
  tetrahedra.reserve(triangulation.number_of_cells());
  for (const auto cell : triangulation.finite_cell_handles()) {
    MeshTetrahedron tetrahedron;
    for (int corner = 0; corner < 4; ++corner)
      tetrahedron[static_cast<std::size_t>(corner)] = static_cast<std::uint8_t>(cell->vertex(corner)->info());
    tetrahedra.push_back(canonical(tetrahedron));
  }
  std::sort(tetrahedra.begin(), tetrahedra.end());
  return tetrahedra;
}

class EdgeSet {
 public:
  void add(int a, int b) {
    if (a != b) present_[index(std::min(a, b), std::max(a, b))] = true;
  }
  std::vector<MeshEdge> list() const {
    std::vector<MeshEdge> edges;
    for (int a = 0; a < pair_vertex_count; ++a)
      for (int b = a + 1; b < pair_vertex_count; ++b)
        if (present_[index(a, b)])
          edges.push_back({static_cast<std::uint8_t>(a), static_cast<std::uint8_t>(b)});
    return edges;
  }

 private:
  static std::size_t index(int a, int b) { return static_cast<std::size_t>(a * pair_vertex_count + b); }
  std::array<bool, static_cast<std::size_t>(pair_vertex_count* pair_vertex_count)> present_{};
};

void add_nearest_neighbours(const PairPose& pair, EdgeSet& edges) {
  for (int v = 0; v < pair_vertex_count; ++v) {
    std::array<std::pair<double, int>, pair_vertex_count> others;
    for (int other = 0; other < pair_vertex_count; ++other)
      others[static_cast<std::size_t>(other)] = {(pair.row(v) - pair.row(other)).squaredNorm(), other};
    others[static_cast<std::size_t>(v)].first = std::numeric_limits<double>::infinity();
    std::partial_sort(others.begin(), others.begin() + fallback_neighbours, others.end());
    for (int n = 0; n < fallback_neighbours; ++n) edges.add(v, others[static_cast<std::size_t>(n)].second);
  }
}

}  // namespace

InteractionMesh tetrahedralize(const PairPose& pair) {
  if (!pair.allFinite()) throw std::invalid_argument("a joint's position is not finite");
  InteractionMesh mesh;
  std::optional<std::vector<MeshTetrahedron>> tetrahedra;
  if (!has_coincident_points(pair) && !is_flat(pair)) tetrahedra = delaunay(pair);
  if (!tetrahedra) {
    mesh.quality = InteractionMesh::Quality::Jittered;
    tetrahedra = delaunay(jittered(pair));
  }
  EdgeSet edges;
  if (tetrahedra) {
    mesh.tetrahedra = std::move(*tetrahedra);
    for (const MeshTetrahedron& t : mesh.tetrahedra)
      for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t j = i + 1; j < 4; ++j) edges.add(t[i], t[j]);
  } else {
    mesh.quality = InteractionMesh::Quality::NearestNeighbours;
    add_nearest_neighbours(pair, edges);
  }
  for (int b = 0; b < bone_count; ++b) {
    edges.add(bone(b).first, bone(b).second);
    edges.add(bone(b).first + joint_count, bone(b).second + joint_count);
  }
  mesh.edges = edges.list();
  return mesh;
}

double six_volumes(const PairPose& pair, const MeshTetrahedron& t) {
  const Vec3 a = pair.row(t[0]);
  return (Vec3(pair.row(t[1])) - a).cross(Vec3(pair.row(t[2])) - a).dot(Vec3(pair.row(t[3])) - a);
}

}  // namespace abrazo
