// Tetrahedralising recorded pairs: ours (TetGen, with an order of its own and all that a degenerate pose
// needs) against TetGen called as its manual does and against CGAL, on the same poses: the same tetrahedra.
#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_vertex_base_with_info_3.h>
#include <benchmark/benchmark.h>
#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "core/mesh/interaction_mesh.hpp"
#include "tests/bench/bench_data.hpp"
#include "tests/bench/bench_main.hpp"
#include "tests/bench/tetgen_mesh.hpp"

namespace {

using namespace abrazo;

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Vertex = CGAL::Triangulation_vertex_base_with_info_3<std::uint8_t, Kernel>;
using Cell = CGAL::Delaunay_triangulation_cell_base_3<Kernel>;
using Delaunay = CGAL::Delaunay_triangulation_3<Kernel, CGAL::Triangulation_data_structure_3<Vertex, Cell>>;

constexpr int pose_count = 500;
constexpr double flat_m3 = 1e-15;

const std::vector<PairPose>& poses() {
  static const std::vector<PairPose> all = bench::spread_pairs(*bench::bench_data().library, pose_count);
  return all;
}

std::array<std::pair<Kernel::Point_3, std::uint8_t>, pair_vertex_count> points_of(const PairPose& pose) {
  std::array<std::pair<Kernel::Point_3, std::uint8_t>, pair_vertex_count> points;
  for (int v = 0; v < pair_vertex_count; ++v)
    points[static_cast<std::size_t>(v)] = {Kernel::Point_3(pose(v, 0), pose(v, 1), pose(v, 2)),
                                           static_cast<std::uint8_t>(v)};
  return points;
}

std::vector<MeshTetrahedron> tetrahedra_of(const Delaunay& delaunay) {
  std::vector<MeshTetrahedron> tetrahedra;
  tetrahedra.reserve(delaunay.number_of_cells());
  for (const auto& cell : delaunay.finite_cell_handles())
    tetrahedra.push_back(
        {cell->vertex(0)->info(), cell->vertex(1)->info(), cell->vertex(2)->info(), cell->vertex(3)->info()});
  return tetrahedra;
}

/// As CGAL's manual does it: the whole range at once, put in order along a space-filling curve.
std::vector<MeshTetrahedron> cgal_tetrahedra(const PairPose& pose) {
  const auto points = points_of(pose);
  return tetrahedra_of(Delaunay(points.begin(), points.end()));
}

/// As fast as CGAL is here: bodies in turn and joints far apart, each found from the one before, in memory
/// that is kept from pair to pair.
std::vector<MeshTetrahedron> cgal_tetrahedra_in_kept_memory(const PairPose& pose) {
  thread_local Delaunay delaunay;
  delaunay.clear();
  const auto points = points_of(pose);
  Delaunay::Cell_handle near_last;
  for (std::size_t n = 0; n < points.size(); ++n) {
    const auto& [point, number] = points[n % 2 * joint_count + n / 2 * 7 % joint_count];
    const auto inserted = delaunay.insert(point, near_last);
    inserted->info() = number;
    near_last = inserted->cell();
  }
  return tetrahedra_of(delaunay);
}

/// Without those that are flat: where joints lie in a plane it is rounding that makes them, or not.
std::set<MeshTetrahedron> as_set(const PairPose& pose, const std::vector<MeshTetrahedron>& tetrahedra) {
  std::set<MeshTetrahedron> solid;
  for (MeshTetrahedron corners : tetrahedra) {
    if (std::abs(six_volumes(pose, corners)) < flat_m3) continue;
    std::sort(corners.begin(), corners.end());
    solid.insert(corners);
  }
  return solid;
}

/// Poses that have other tetrahedra than ours; where joints are in one place ours moves them apart, and so
/// has tetrahedra of its own.
struct Differences {
  double differ = 0, compared = 0;
};
template <typename Way>
Differences differences(const Way& way) {
  Differences found;
  for (const PairPose& pose : poses()) {
    const InteractionMesh ours = tetrahedralize(pose);
    if (ours.quality != InteractionMesh::Quality::Exact) continue;
    ++found.compared;
    found.differ += as_set(pose, way(pose)) != as_set(pose, ours.tetrahedra);
  }
  return found;
}

template <typename Way>
void run(benchmark::State& state, const Way& way) {
  const auto& all = poses();
  std::size_t at = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(way(all[at]));
    if (++at == all.size()) at = 0;
  }
}

void mesh_ours(benchmark::State& state) {
  run(state, tetrahedralize);
}
template <typename Way>
void run_other(benchmark::State& state, const Way& way) {
  run(state, way);
  if (state.thread_index() != 0) return;
  static const Differences known = differences(way);  // one for each `Way`
  state.counters["compared"] = known.compared;
  if (known.differ > 0)
    state.SkipWithError(
        fmt::format("{} of {} poses have other tetrahedra", known.differ, known.compared).c_str());
}

struct Cgal {
  std::vector<MeshTetrahedron> operator()(const PairPose& pose) const { return cgal_tetrahedra(pose); }
};
struct CgalInKeptMemory {
  std::vector<MeshTetrahedron> operator()(const PairPose& pose) const {
    return cgal_tetrahedra_in_kept_memory(pose);
  }
};
struct Tetgen {
  std::vector<MeshTetrahedron> operator()(const PairPose& pose) const {
    return bench::tetgen_tetrahedra(pose);
  }
};

void mesh_cgal(benchmark::State& state) {
  run_other(state, Cgal());
}
void mesh_cgal_kept(benchmark::State& state) {
  run_other(state, CgalInKeptMemory());
}
void mesh_tetgen(benchmark::State& state) {
  run_other(state, Tetgen());
}

BENCHMARK(mesh_ours)->Name("mesh/ours")->Threads(1)->Threads(2)->UseRealTime()->Unit(benchmark::kMicrosecond);
BENCHMARK(mesh_cgal)->Name("mesh/cgal")->Threads(1)->Threads(2)->UseRealTime()->Unit(benchmark::kMicrosecond);
BENCHMARK(mesh_cgal_kept)
    ->Name("mesh/cgal in kept memory")
    ->Threads(1)
    ->Threads(2)
    ->UseRealTime()
    ->Unit(benchmark::kMicrosecond);
BENCHMARK(mesh_tetgen)->Name("mesh/tetgen")->Threads(1)->UseRealTime()->Unit(benchmark::kMicrosecond);

}  // namespace

int main(int argc, char** argv) {
  return abrazo::bench::run_benchmarks(argc, argv);
}
