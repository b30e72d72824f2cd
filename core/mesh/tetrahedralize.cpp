#define TETLIBRARY  // TetGen's header declares its library interface under this name only
#include <tetgen.h>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <mutex>
#include <optional>

#include "core/mesh/interaction_mesh.hpp"
#include "core/motion/joint_set.hpp"

namespace abrazo {

namespace {

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

/// All points in a plane, on a line or in one place, as far as TetGen is concerned: it stops the process at
/// some of these.
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

/// Nothing when TetGen finds no volume.
std::optional<std::vector<MeshTetrahedron>> delaunay(const PairPose& pair) {
  // TetGen's exact predicates live in globals that a call initialises: one call at a time.
  static std::mutex one_at_a_time;
  const std::scoped_lock lock(one_at_a_time);

  // Centred, so that pairs far from the origin keep their precision.
  const Eigen::RowVector3d centre = pair.colwise().mean();
  tetgenio in;
  tetgenio out;
  in.firstnumber = 0;
  in.numberofpoints = pair_vertex_count;
  in.pointlist = new REAL[3 * pair_vertex_count];  // freed by tetgenio
  for (int v = 0; v < pair_vertex_count; ++v)
    for (int axis = 0; axis < 3; ++axis) in.pointlist[3 * v + axis] = pair(v, axis) - centre(axis);
  try {
    std::array<char, 2> quiet = {'Q', '\0'};
    ::tetrahedralize(quiet.data(), &in, &out);
  } catch (...) {  // TetGen throws an int
    return std::nullopt;
  }
  if (out.numberoftetrahedra == 0 || out.numberofcorners < 4) return std::nullopt;
  std::vector<MeshTetrahedron> tetrahedra(static_cast<std::size_t>(out.numberoftetrahedra));
  std::array<bool, pair_vertex_count> used{};
  for (int t = 0; t < out.numberoftetrahedra; ++t)
    for (int corner = 0; corner < 4; ++corner) {
      const int vertex = out.tetrahedronlist[t * out.numberofcorners + corner];
      if (vertex < 0 || vertex >= pair_vertex_count) return std::nullopt;
      tetrahedra[static_cast<std::size_t>(t)][static_cast<std::size_t>(corner)] =
          static_cast<std::uint8_t>(vertex);
      used[static_cast<std::size_t>(vertex)] = true;
    }
  // A vertex without a tetrahedron was merged away: not the mesh of all joints.
  if (!std::all_of(used.begin(), used.end(), [](bool is_used) { return is_used; })) return std::nullopt;
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
    others[static_cast<std::size_t>(v)].first = INFINITY;
    std::partial_sort(others.begin(), others.begin() + fallback_neighbours, others.end());
    for (int n = 0; n < fallback_neighbours; ++n) edges.add(v, others[static_cast<std::size_t>(n)].second);
  }
}

}  // namespace

InteractionMesh tetrahedralize(const PairPose& pair) {
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
