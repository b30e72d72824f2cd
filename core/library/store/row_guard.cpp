#include "core/library/store/row_guard.hpp"

#include <fmt/format.h>

#include <stdexcept>

#include "core/base/mapped_file.hpp"
#include "core/library/store/library_checks.hpp"

namespace abrazo {

namespace {

constexpr std::size_t most_edges = pair_vertex_count * (pair_vertex_count - 1) / 2;

/// The items of a pair; nothing when its offsets do not lie within them.
template <typename Item>
std::optional<std::span<const Item>> row(const Column<Item>& items, const Column<std::uint64_t>& offsets,
                                         int pair, std::size_t most) {
  const std::uint64_t begin = offsets[static_cast<std::size_t>(pair)],
                      end = offsets[static_cast<std::size_t>(pair) + 1];
  if (begin > end || end > items.size() || end - begin > most) return std::nullopt;
  return std::span<const Item>(items.data() + begin, end - begin);
}

}  // namespace

RowGuard::RowGuard(const LibraryColumns& columns)
    : mapping_(columns.mapping), first_pose_(columns.poses.front()) {
  const auto edges = row(columns.edges, columns.edge_offsets, 0, most_edges);
  const auto tetrahedra = row(columns.tetrahedra, columns.tetrahedron_offsets, 0, most_tetrahedra);
  if (edges) first_edges_.assign(edges->begin(), edges->end());
  if (tetrahedra) first_tetrahedra_.assign(tetrahedra->begin(), tetrahedra->end());
  if (!edges || !tetrahedra || !is_within_reach(first_pose_) || !is_in_order(first_edges_) ||
      !names_vertices(first_tetrahedra_) || mapping_->lost_pages())
    throw std::invalid_argument("the first pair's pose or mesh is damaged");
}

const PairPose& RowGuard::pose(const LibraryColumns& columns, int pair) const {
  const PairPose& found = columns.poses[static_cast<std::size_t>(pair)];
  if (is_within_reach(found) && !mapping_->lost_pages()) return found;
  remember(pair);
  return first_pose_;
}

std::span<const MeshEdge> RowGuard::edges(const LibraryColumns& columns, int pair) const {
  const auto found = row(columns.edges, columns.edge_offsets, pair, most_edges);
  if (found && is_in_order(*found) && !mapping_->lost_pages()) return *found;
  remember(pair);
  return first_edges_;
}

std::span<const MeshTetrahedron> RowGuard::tetrahedra(const LibraryColumns& columns, int pair) const {
  const auto found = row(columns.tetrahedra, columns.tetrahedron_offsets, pair, most_tetrahedra);
  if (found && names_vertices(*found) && !mapping_->lost_pages()) return *found;
  remember(pair);
  return first_tetrahedra_;
}

void RowGuard::remember(int pair) const {
  int none = -1;
  damaged_pair_.compare_exchange_strong(none, pair);
}

std::optional<Error> RowGuard::damage(const std::string& library_name) const {
  const int pair = damaged_pair_;
  if (mapping_->lost_pages())
    return Error{
        "the library's file was cut short while in use, or its disk fails; build or copy it again and "
        "open it",
        library_name};
  if (mapping_->was_changed())
    return Error{
        "another program wrote to the library's file while it was in use; open it again, or build it again",
        library_name};
  if (pair < 0) return std::nullopt;
  return Error{fmt::format("pair {} is damaged in the library's file, or another program writes to it; build "
                           "or copy it again and open it",
                           pair),
               library_name};
}

}  // namespace abrazo
