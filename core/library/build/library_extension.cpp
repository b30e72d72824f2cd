#include "core/library/build/library_extension.hpp"

#include <algorithm>
#include <utility>

#include "core/library/store/library_bodies.hpp"

namespace abrazo {

namespace {

template <typename Rows>
void append(Rows& to, const Rows& from) {
  to.insert(to.end(), from.begin(), from.end());
}

void append_offsets(Column<std::uint64_t>& to, const Column<std::uint64_t>& from) {
  const std::uint64_t base = to.back();
  for (std::size_t i = 1; i < from.size(); ++i) to.push_back(base + from[i]);
}

/// The body of a performer in the larger library; when it is new there, with the radii found in the take.
std::uint32_t settle_body(LibraryColumns& columns, const LibraryColumns& added, std::uint32_t in_added,
                          const Body& body, const std::string& name) {
  const std::size_t before = columns.bodies.size();
  const std::uint32_t at = find_or_add_body(columns.bodies, body, name);
  if (columns.bodies.size() > before) columns.bodies[at].capsule_radii = added.bodies[in_added].capsule_radii;
  return at;
}

void append_pairs(LibraryColumns& columns, const LibraryColumns& added) {
  const auto take = static_cast<std::uint32_t>(columns.takes.size() - 1);
  for (PairSource source : added.sources) {
    source.take = take;
    columns.sources.push_back(source);
  }
  append(columns.roots, added.roots);
  append(columns.poses, added.poses);
  append(columns.features, added.features);
  append_offsets(columns.edge_offsets, added.edge_offsets);
  append(columns.edges, added.edges);
  append_offsets(columns.tetrahedron_offsets, added.tetrahedron_offsets);
  append(columns.tetrahedra, added.tetrahedra);
  append(columns.mesh_quality, added.mesh_quality);
}

}  // namespace

Result<MotionLibrary> extend_library(const MotionLibrary& library, PairedTake take,
                                     const LibraryBuildOptions& options, const Progress& progress) {
  if (library.find_take(take.name) >= 0)
    return Error{"the library has a take of this name already; give another name", "take " + take.name};
  if (library.columns().roles_exchanged)
    return Error{"its roles are exchanged; extend the library itself", library.name()};
  LibraryBuildOptions of_take = options;
  of_take.excluded_takes.clear();
  const Body body_a = body_of(std::span<const Pose>(take.a.poses)),
             body_b = body_of(std::span<const Pose>(take.b.poses));
  std::vector<PairedTake> takes;
  takes.push_back(std::move(take));
  const auto alone = build_library(library.name(), std::move(takes), of_take, progress);
  if (!alone) return alone.error();
  const LibraryColumns& added = alone->columns();
  LibraryColumns columns = library.columns();
  LibraryTake entry = added.takes.front();
  const std::uint32_t a = entry.body_a, b = entry.body_b;
  entry.body_a = settle_body(columns, added, a, body_a, entry.name + "/a");
  entry.body_b = settle_body(columns, added, b, body_b, entry.name + "/b");
  columns.takes.push_back(std::move(entry));
  columns.rate_hz = std::max(columns.rate_hz, added.rate_hz);
  append_pairs(columns, added);
  if (const auto damage = library.damage()) return *damage;  // a mapped one may have been read as zeros
  return MotionLibrary(std::move(columns));
}

}  // namespace abrazo
