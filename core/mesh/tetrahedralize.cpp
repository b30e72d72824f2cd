#define TETLIBRARY  // TetGen's header declares its library interface under this name only
#include <tetgen.h>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <mutex>
#include <optional>
#include <stdexcept>

#include "core/mesh/interaction_mesh.hpp"
#include "core/motion/body/joint_set.hpp"

namespace abrazo {

namespace {

constexpr double coincidence_m = 1e-3;
constexpr double jitter_m = 1e-5;
constexpr double flatness_m = 1e-6;
constexpr double least_volume =
    1e-13;  ///< of a cube around the pair; far above what rounding makes of a plane
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

using VertexOrder = std::array<int, pair_vertex_count>;

/// Bodies and joints in turn, far apart: points in the order of a limb would make slivers that the next ones
/// take apart again.
constexpr VertexOrder alternating_order() {
  VertexOrder order{};
  for (int n = 0; n < pair_vertex_count; ++n)
    order[static_cast<std::size_t>(n)] = (n % 2) * joint_count + (n / 2 * 7) % joint_count;
  return order;
}

/// The order in which points are inserted: first a large tetrahedron, each corner as far as can be from those
/// before it. Nothing when its volume is so small that TetGen may take all points for one plane: it then
/// frees its memory twice, which ends the process.
std::optional<VertexOrder> insertion_order(const PairPose& centred) {
  VertexOrder order = alternating_order();
  const auto point = [&](std::size_t n) { return Vec3(centred.row(order[n])); };
  const auto put_farthest = [&](std::size_t place, const auto& distance) {
    std::size_t farthest = place;
    for (std::size_t n = place + 1; n < order.size(); ++n)
      if (distance(point(n)) > distance(point(farthest))) farthest = n;
    std::swap(order[place], order[farthest]);
    return distance(point(place));
  };
  put_farthest(0, [](const Vec3& p) { return p.squaredNorm(); });
  const Vec3 first = point(0);
  put_farthest(1, [&](const Vec3& p) { return (p - first).squaredNorm(); });
  const Vec3 along = point(1) - first;
  put_farthest(2, [&](const Vec3& p) { return along.cross(p - first).squaredNorm(); });
  const Vec3 normal = along.cross(point(2) - first);
  const double six_volumes = put_farthest(3, [&](const Vec3& p) { return std::abs(normal.dot(p - first)); });
  const double size = (centred.colwise().maxCoeff() - centred.colwise().minCoeff()).norm();
  if (!(six_volumes > least_volume * size * size * size)) return std::nullopt;
  return order;
}

/// Vertices ascending except the last two, which are ordered for a positive volume: a canonical form.
/// @param t  with a positive volume
MeshTetrahedron canonical(MeshTetrahedron t) {
  bool odd = false;
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = i + 1; j < 4; ++j)
      if (t[j] < t[i]) std::swap(t[i], t[j]), odd = !odd;
  if (odd) std::swap(t[2], t[3]);
  return t;
}

/// Delaunay tetrahedra and nothing else, of points in the order that is given.
tetgenbehavior quiet_delaunay() {
  tetgenbehavior wish;
  wish.quiet = 1;
  wish.no_sort = 1;  // else it shuffles with rand(), which others in the process seed and use as well
  wish.nobound = wish.nofacewritten = 1;
  return wish;
}

/// TetGen's own call. Any thread.
void call_tetgen(tetgenio& in, tetgenio& out) {
  // TetGen's exact predicates use global constants that every call writes, among them filters that depend on
  // the extent of the points: one call at a time.
  static std::mutex turn;
  const std::scoped_lock one_at_a_time(turn);
  static tetgenbehavior wish = quiet_delaunay();
  ::tetrahedralize(&wish, &in, &out);
}

/// None if there is no volume, or points coincide. Always exact: TetGen's symbolic perturbation, by order of
/// insertion, resolves cospherical points. Thread-safe.
std::optional<std::vector<MeshTetrahedron>> delaunay(const PairPose& pair) {
  // Centred, so that pairs far from the origin keep their precision.
  const PairPose centred = pair.rowwise() - pair.colwise().mean();
  const auto order = insertion_order(centred);
  if (!order) return std::nullopt;
  tetgenio in, out;
  in.numberofpoints = pair_vertex_count;
  in.pointlist = new REAL[std::size_t{3} * pair_vertex_count];  // freed by tetgenio
  for (int n = 0; n < pair_vertex_count; ++n)
    Eigen::Map<Eigen::RowVector3d>(in.pointlist + std::ptrdiff_t{3} * n) =
        centred.row((*order)[static_cast<std::size_t>(n)]);
  call_tetgen(in, out);
  std::vector<MeshTetrahedron> tetrahedra(static_cast<std::size_t>(out.numberoftetrahedra));
  std::array<bool, pair_vertex_count> used{};
  const int* corner = out.tetrahedronlist;
  for (MeshTetrahedron& tetrahedron : tetrahedra) {
    for (std::uint8_t& vertex : tetrahedron) {
      vertex = static_cast<std::uint8_t>((*order)[static_cast<std::size_t>(*corner++)]);
      used[vertex] = true;
    }
    tetrahedron = canonical(tetrahedron);
  }
  // A coincident vertex is dropped by TetGen: the result is not the mesh of all joints.
  if (!std::all_of(used.begin(), used.end(), [](bool is_used) { return is_used; })) return std::nullopt;
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
