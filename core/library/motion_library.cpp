#include "core/library/motion_library.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>
#include <tuple>

namespace abrazo {

namespace {

void require(bool holds, const char* what) {
  if (!holds) throw std::invalid_argument(what);
}

auto order_of(const PairSource& source) {
  return std::tuple(source.take, source.swapped, source.frame);
}

void check_offsets(const std::vector<std::uint64_t>& offsets, std::size_t pairs, std::size_t total,
                   const char* what) {
  require(offsets.size() == pairs + 1 && offsets.front() == 0 && offsets.back() == total, what);
  require(std::is_sorted(offsets.begin(), offsets.end()), what);
}

template <std::size_t n>
bool name_vertices(const std::vector<std::array<std::uint8_t, n>>& items) {
  return std::all_of(items.begin(), items.end(), [](const auto& item) {
    return std::all_of(item.begin(), item.end(),
                       [](std::uint8_t vertex) { return vertex < pair_vertex_count; });
  });
}

/// Edges of each pair smaller vertex first, ascending, none twice: what the solver's tables of neighbours
/// rely on.
bool edges_in_order(const LibraryColumns& columns) {
  for (std::size_t pair = 0; pair + 1 < columns.edge_offsets.size(); ++pair)
    for (std::uint64_t e = columns.edge_offsets[pair]; e < columns.edge_offsets[pair + 1]; ++e) {
      if (columns.edges[e][0] >= columns.edges[e][1]) return false;
      if (e > columns.edge_offsets[pair] && !(columns.edges[e - 1] < columns.edges[e])) return false;
    }
  return true;
}

bool is_plausible(const LibraryBody& body) {
  const auto length = [](double l) { return std::isfinite(l) && l >= 0; };
  return std::all_of(body.body.bone_lengths.begin(), body.body.bone_lengths.end(), length) &&
         std::all_of(body.body.pseudo_lengths.begin(), body.body.pseudo_lengths.end(), length) &&
         std::all_of(body.capsule_radii.begin(), body.capsule_radii.end(), length) &&
         std::isfinite(body.body.toe_rest_height);
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
    require(take.fps > 0 && take.frames >= 0 && take.frame_stride >= 1,
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

void check_poses(const LibraryColumns& columns) {
  require(std::all_of(columns.poses.begin(), columns.poses.end(),
                      [](const PairPose& pose) { return pose.allFinite(); }) &&
              std::all_of(columns.features.begin(), columns.features.end(),
                          [](const Features& f) { return f.allFinite(); }),
          "a position is not a finite number");
  require(std::all_of(columns.roots.begin(), columns.roots.end(),
                      [](const RootFrame& root) {
                        return root.position.allFinite() && std::isfinite(root.heading_rad);
                      }),
          "a root is not finite");
}

void check_meshes(const LibraryColumns& columns) {
  const std::size_t pairs = columns.sources.size();
  check_offsets(columns.edge_offsets, pairs, columns.edges.size(),
                "edge offsets are not ascending from 0 to the number of edges");
  check_offsets(columns.tetrahedron_offsets, pairs, columns.tetrahedra.size(),
                "tetrahedron offsets are not ascending from 0 to the number of tetrahedra");
  require(name_vertices(columns.edges), "an edge names a vertex that does not exist");
  require(edges_in_order(columns), "the edges of a mesh are not in order, or one stands twice");
  require(name_vertices(columns.tetrahedra), "a tetrahedron names a vertex that does not exist");
  require(std::all_of(columns.mesh_quality.begin(), columns.mesh_quality.end(),
                      [](std::uint8_t q) {
                        return q <= static_cast<std::uint8_t>(InteractionMesh::Quality::NearestNeighbours);
                      }),
          "a mesh quality is unknown");
}

void check(const LibraryColumns& columns) {
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
  check_poses(columns);
  check_meshes(columns);
}

template <typename Item>
std::span<const Item> row(const std::vector<Item>& items, const std::vector<std::uint64_t>& offsets,
                          int pair) {
  const auto begin = offsets[static_cast<std::size_t>(pair)];
  return std::span(items).subspan(begin, offsets[static_cast<std::size_t>(pair) + 1] - begin);
}

}  // namespace

MotionLibrary::MotionLibrary(LibraryColumns columns) : columns_(std::move(columns)) {
  check(columns_);
  // Counted as couples: in a doubled library every performer is active and passive equally often.
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> couples;
  for (const PairSource& source : columns_.sources) {
    const LibraryTake& take = columns_.takes[source.take];
    const bool b_first = source.swapped != columns_.roles_exchanged;
    ++couples[b_first ? std::pair(take.body_b, take.body_a) : std::pair(take.body_a, take.body_b)];
  }
  // Of equally frequent ones that of the first pair, with its performer A active.
  const LibraryTake& first = columns_.takes[columns_.sources.front().take];
  auto usual = columns_.roles_exchanged ? std::pair(first.body_b, first.body_a)
                                        : std::pair(first.body_a, first.body_b);
  for (const auto& [couple, count] : couples)
    if (count > couples[usual]) usual = couple;
  std::tie(usual_active_, usual_passive_) = usual;
}

std::span<const MeshEdge> MotionLibrary::edges(int pair) const {
  return row(columns_.edges, columns_.edge_offsets, pair);
}

std::span<const MeshTetrahedron> MotionLibrary::tetrahedra(int pair) const {
  return row(columns_.tetrahedra, columns_.tetrahedron_offsets, pair);
}

const LibraryBody& MotionLibrary::active_body(int pair) const {
  const bool is_b = source(pair).swapped != columns_.roles_exchanged;
  return columns_.bodies[is_b ? take_of(pair).body_b : take_of(pair).body_a];
}

const LibraryBody& MotionLibrary::passive_body(int pair) const {
  const bool is_a = source(pair).swapped != columns_.roles_exchanged;
  return columns_.bodies[is_a ? take_of(pair).body_a : take_of(pair).body_b];
}

std::string_view MotionLibrary::label(int pair) const {
  return label_at(take_of(pair).labels, static_cast<int>(source(pair).frame));
}

PairPose MotionLibrary::pair_in_world(int pair, const RootFrame& user_root, bool user_is_passive) const {
  RootFrame placed = user_root;
  placed.position.y() = root(pair).position.y();
  const PairPose& recorded = pose(pair);
  if (!user_is_passive)
    return recorded * placed.rotation().transpose() +
           placed.position.transpose().replicate<pair_vertex_count, 1>();
  const RootFrame passive = root_frame(recorded.bottomRows<joint_count>());
  placed.position.y() += passive.position.y();
  PairPose world;
  world.topRows<joint_count>() = to_world(to_normalized(recorded.topRows<joint_count>(), passive), placed);
  world.bottomRows<joint_count>() =
      to_world(to_normalized(recorded.bottomRows<joint_count>(), passive), placed);
  return world;
}

int MotionLibrary::later_pair(int pair, int steps) const {
  const long long later = static_cast<long long>(pair) + steps;
  if (later < 0 || later >= pair_count()) return -1;
  const PairSource& from = source(pair);
  const PairSource& to = source(static_cast<int>(later));
  if (to.take != from.take || to.swapped != from.swapped) return -1;
  // Frames ascend by at least the stride, so any gap makes the difference larger than this.
  const long long expected = static_cast<long long>(steps) * take_of(pair).frame_stride;
  return static_cast<long long>(to.frame) - from.frame == expected ? static_cast<int>(later) : -1;
}

int MotionLibrary::find_pair(std::string_view take, int frame, bool swapped) const {
  const int index = find_take(take);
  if (index < 0 || frame < 0) return -1;
  const PairSource wanted{static_cast<std::uint32_t>(index), static_cast<std::uint32_t>(frame), swapped};
  const auto found =
      std::lower_bound(columns_.sources.begin(), columns_.sources.end(), wanted,
                       [](const PairSource& a, const PairSource& b) { return order_of(a) < order_of(b); });
  if (found == columns_.sources.end() || order_of(*found) != order_of(wanted)) return -1;
  return static_cast<int>(found - columns_.sources.begin());
}

int MotionLibrary::find_take(std::string_view name) const {
  for (std::size_t i = 0; i < columns_.takes.size(); ++i)
    if (columns_.takes[i].name == name) return static_cast<int>(i);
  return -1;
}

}  // namespace abrazo
