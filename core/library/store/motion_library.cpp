#include "core/library/store/motion_library.hpp"

#include <algorithm>
#include <map>
#include <tuple>

#include "core/library/store/library_checks.hpp"
#include "core/library/store/row_guard.hpp"

namespace abrazo {

namespace {

template <typename Item>
std::span<const Item> row(const Column<Item>& items, const Column<std::uint64_t>& offsets, int pair) {
  const auto begin = offsets[static_cast<std::size_t>(pair)];
  return {items.data() + begin, offsets[static_cast<std::size_t>(pair) + 1] - begin};
}

}  // namespace

MotionLibrary::MotionLibrary(LibraryColumns columns) : columns_(std::move(columns)) {
  check_columns(columns_);
  if (columns_.mapping) guard_ = std::make_shared<const RowGuard>(columns_);
  // Counted as couples: in a doubled library every performer is active and passive equally often.
  std::vector<std::array<int, 2>> pairs_of_take(columns_.takes.size());
  for (const PairSource& source : columns_.sources) ++pairs_of_take[source.take][source.swapped ? 1 : 0];
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> couples;
  for (std::size_t t = 0; t < columns_.takes.size(); ++t)
    for (const bool swapped : {false, true}) {
      const LibraryTake& take = columns_.takes[t];
      const bool b_first = swapped != columns_.roles_exchanged;
      couples[b_first ? std::pair(take.body_b, take.body_a) : std::pair(take.body_a, take.body_b)] +=
          pairs_of_take[t][swapped ? 1 : 0];
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
  return guard_ ? guard_->edges(columns_, pair) : row(columns_.edges, columns_.edge_offsets, pair);
}

std::span<const MeshTetrahedron> MotionLibrary::tetrahedra(int pair) const {
  return guard_ ? guard_->tetrahedra(columns_, pair)
                : row(columns_.tetrahedra, columns_.tetrahedron_offsets, pair);
}

const PairPose& MotionLibrary::guarded_pose(int pair) const {
  return guard_->pose(columns_, pair);
}

std::optional<Error> MotionLibrary::damage() const {
  return guard_ ? guard_->damage(columns_.name) : columns_.damage;
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
