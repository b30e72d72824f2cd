#include "core/library/store/library_checks.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <stdexcept>
#include <tuple>

#include "core/base/parallel.hpp"

namespace abrazo {

namespace {

constexpr std::size_t rows_at_once = 1024;

void require(bool holds, const char* what) {
  if (!holds) throw std::invalid_argument(what);
}

/// Whether all rows hold, looked at from every core.
template <typename Holds>
bool all_rows(std::size_t count, const Holds& holds) {
  std::atomic<bool> all = true;
  for_each_row(count, rows_at_once, {}, {}, [&](std::size_t row) {
    if (!holds(row)) all = false;
  });
  return all;
}

bool is_plausible(const LibraryBody& body) {
  const auto length = [](double l) { return l >= 0 && l < farthest_m; };
  return std::all_of(body.body.bone_lengths.begin(), body.body.bone_lengths.end(), length) &&
         std::all_of(body.body.pseudo_lengths.begin(), body.body.pseudo_lengths.end(), length) &&
         std::all_of(body.capsule_radii.begin(), body.capsule_radii.end(), length) &&
         std::abs(body.body.toe_rest_height) < farthest_m;
}

template <typename Interval>
bool in_order(const std::vector<Interval>& intervals) {
  return std::adjacent_find(intervals.begin(), intervals.end(), [](const Interval& a, const Interval& b) {
           return b.start < a.end;
         }) == intervals.end();
}

void check_takes(const LibraryColumns& columns) {
  for (const LibraryTake& take : columns.takes) {
    require(take.body_a < columns.bodies.size() && take.body_b < columns.bodies.size(),
            "a take names a body that does not exist");
    require(in_order(take.roles) && in_order(take.labels),
            "roles or labels of a take overlap or are out of order");
    require(take.fps > 0 && std::isfinite(take.fps) && take.frames >= 0 && take.frame_stride >= 1,
            "a take has no frame rate, frames or stride");
  }
}

void check_sources(const LibraryColumns& columns) {
  const auto& sources = columns.sources;
  for (std::size_t i = 0; i < sources.size(); ++i) {
    require(sources[i].take < columns.takes.size(), "a pair names a take that does not exist");
    require(sources[i].frame < static_cast<std::uint32_t>(columns.takes[sources[i].take].frames),
            "a pair names a frame that its take does not have");
    require(i == 0 || order_of(sources[i - 1]) < order_of(sources[i]),
            "pairs are not in the order of their takes, roles and frames");
  }
}

/// Sums of squares are NaN or infinite where one of the numbers is.
template <typename Positions>
bool is_nearer(const Positions& positions, double reach_m) {
  return positions.squaredNorm() < reach_m * reach_m;
}

void check_positions(const LibraryColumns& columns) {
  const std::size_t pairs = columns.sources.size();
  // About the other body's root a pair may lie up to eight times as far.
  const double reach_m = columns.roles_exchanged ? 10 * farthest_m : farthest_m;
  require((columns.poses.is_view() ||
           all_rows(pairs, [&](std::size_t pair) { return is_nearer(columns.poses[pair], reach_m); })) &&
              all_rows(pairs, [&](std::size_t pair) { return is_nearer(columns.features[pair], reach_m); }),
          "a position is not a finite number, or too large for one in metres");
  require(std::all_of(columns.roots.begin(), columns.roots.end(),
                      [&](const RootFrame& root) {
                        return is_nearer(root.position, reach_m) && std::isfinite(root.heading_rad);
                      }),
          "a root is not finite, or too far away");
}

void check_offsets(const Column<std::uint64_t>& offsets, std::size_t pairs, std::size_t total,
                   const char* what) {
  require(offsets.size() == pairs + 1 && offsets.front() == 0 && offsets.back() == total, what);
  require(std::is_sorted(offsets.begin(), offsets.end()), what);
}

template <typename Item>
std::span<const Item> row(const Column<Item>& items, const Column<std::uint64_t>& offsets, std::size_t pair) {
  return {items.data() + offsets[pair], offsets[pair + 1] - offsets[pair]};
}

void check_meshes(const LibraryColumns& columns) {
  const std::size_t pairs = columns.sources.size();
  check_offsets(columns.edge_offsets, pairs, columns.edges.size(),
                "edge offsets are not ascending from 0 to the number of edges");
  check_offsets(columns.tetrahedron_offsets, pairs, columns.tetrahedra.size(),
                "tetrahedron offsets are not ascending from 0 to the number of tetrahedra");
  if (!columns.edges.is_view()) {
    require(all_rows(columns.edges.size(),
                     [&](std::size_t e) { return columns.edges[e][1] < pair_vertex_count; }),
            "an edge names a vertex that does not exist");
    require(all_rows(pairs,
                     [&](std::size_t pair) {
                       return is_in_order(row(columns.edges, columns.edge_offsets, pair));
                     }),
            "the edges of a mesh are not in order, or one stands twice");
  }
  if (!columns.tetrahedra.is_view())
    require(all_rows(pairs,
                     [&](std::size_t pair) {
                       return names_vertices(row(columns.tetrahedra, columns.tetrahedron_offsets, pair));
                     }),
            "a tetrahedron names a vertex that does not exist");
  require(std::all_of(columns.mesh_quality.begin(), columns.mesh_quality.end(),
                      [](std::uint8_t q) {
                        return q <= static_cast<std::uint8_t>(InteractionMesh::Quality::NearestNeighbours);
                      }),
          "a mesh quality is unknown");
}

}  // namespace

bool is_within_reach(const PairPose& pose) {
  return is_nearer(pose, farthest_m);
}

bool is_in_order(std::span<const MeshEdge> edges) {
  // Read as one number each, so that the comparison of neighbours needs no branch.
  bool holds = true;
  unsigned before = 0;
  for (const MeshEdge& edge : edges) {
    const unsigned place = 256U * edge[0] + edge[1];
    holds &= edge[0] < edge[1] && edge[1] < pair_vertex_count && place > before;
    before = place;
  }
  return holds;
}

bool names_vertices(std::span<const MeshTetrahedron> tetrahedra) {
  bool holds = true;
  for (const MeshTetrahedron& tetrahedron : tetrahedra)
    for (const std::uint8_t vertex : tetrahedron) holds &= vertex < pair_vertex_count;
  return holds;
}

void check_columns(const LibraryColumns& columns) {
  const std::size_t pairs = columns.sources.size();
  require(!columns.bodies.empty() && pairs > 0, "there are no pairs");
  require(std::all_of(columns.bodies.begin(), columns.bodies.end(), is_plausible),
          "a body has a length that is no length");
  require(columns.rate_hz > 0 && std::isfinite(columns.rate_hz), "the library has no rate");
  require(columns.roots.size() == pairs && columns.poses.size() == pairs &&
              columns.features.size() == pairs && columns.mesh_quality.size() == pairs,
          "columns of pairs have different lengths");
  check_takes(columns);
  check_sources(columns);
  check_positions(columns);
  check_meshes(columns);
}

}  // namespace abrazo
