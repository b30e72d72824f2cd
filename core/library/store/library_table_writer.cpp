#include <cstdint>
#include <vector>

#include "core/library/store/library_tables.hpp"

namespace abrazo {

namespace {

/// One field of every item, as a column.
template <typename Items, typename Field>
auto column(const Items& items, Field field) {
  std::vector<std::decay_t<decltype(field(items.front()))>> values;
  values.reserve(items.size());
  for (const auto& item : items) values.push_back(field(item));
  return values;
}

/// An interval together with the take it belongs to: one table for all takes.
template <typename Interval>
struct OfTake {
  std::uint32_t take;
  Interval interval;
};

template <typename Interval>
std::vector<OfTake<Interval>> all_intervals(const std::vector<LibraryTake>& takes,
                                            std::vector<Interval> LibraryTake::*intervals) {
  std::vector<OfTake<Interval>> all;
  for (std::uint32_t t = 0; t < takes.size(); ++t)
    for (const Interval& interval : takes[t].*intervals) all.push_back({t, interval});
  return all;
}

void write_takes(Hdf5Writer& writer, const std::vector<LibraryTake>& takes) {
  writer.dataset("takes/name", column(takes, [](const auto& t) { return t.name; }));
  writer.dataset("takes/fps", column(takes, [](const auto& t) { return t.fps; }));
  writer.dataset("takes/frames", column(takes, [](const auto& t) { return t.frames; }));
  writer.dataset("takes/frame_stride", column(takes, [](const auto& t) { return t.frame_stride; }));
  writer.dataset("takes/body_a", column(takes, [](const auto& t) { return t.body_a; }));
  writer.dataset("takes/body_b", column(takes, [](const auto& t) { return t.body_b; }));
  const auto roles = all_intervals(takes, &LibraryTake::roles);
  writer.dataset("roles/take", column(roles, [](const auto& r) { return r.take; }));
  writer.dataset("roles/start", column(roles, [](const auto& r) { return r.interval.start; }));
  writer.dataset("roles/end", column(roles, [](const auto& r) { return r.interval.end; }));
  writer.dataset("roles/active",
                 column(roles, [](const auto& r) { return static_cast<std::uint8_t>(r.interval.active); }));
  const auto labels = all_intervals(takes, &LibraryTake::labels);
  writer.dataset("labels/take", column(labels, [](const auto& l) { return l.take; }));
  writer.dataset("labels/start", column(labels, [](const auto& l) { return l.interval.start; }));
  writer.dataset("labels/end", column(labels, [](const auto& l) { return l.interval.end; }));
  writer.dataset("labels/label", column(labels, [](const auto& l) { return l.interval.label; }));
  writer.dataset("labels/detail", column(labels, [](const auto& l) { return l.interval.detail; }));
  writer.dataset("labels/confidence", column(labels, [](const auto& l) { return l.interval.confidence; }));
}

void write_bodies(Hdf5Writer& writer, const std::vector<LibraryBody>& bodies) {
  const auto rows = [&](const char* path, const auto& array_of) {
    std::vector<double> values;
    for (const LibraryBody& body : bodies)
      values.insert(values.end(), array_of(body).begin(), array_of(body).end());
    writer.dataset(path, {bodies.size(), values.size() / bodies.size()}, values.data());
  };
  writer.dataset("bodies/name", column(bodies, [](const auto& b) { return b.name; }));
  rows(
      "bodies/bone_lengths", [](const auto& b) -> const auto& { return b.body.bone_lengths; });
  rows(
      "bodies/pseudo_lengths", [](const auto& b) -> const auto& { return b.body.pseudo_lengths; });
  rows(
      "bodies/capsule_radii", [](const auto& b) -> const auto& { return b.capsule_radii; });
  writer.dataset("bodies/toe_rest_height",
                 column(bodies, [](const auto& b) { return b.body.toe_rest_height; }));
}

}  // namespace

void write_descriptions(Hdf5Writer& writer, const LibraryColumns& columns) {
  write_takes(writer, columns.takes);
  write_bodies(writer, columns.bodies);
}

void write_pairs(Hdf5Writer& writer, const LibraryColumns& columns) {
  const std::uint64_t pairs = columns.sources.size();
  std::vector<std::uint32_t> sources;
  for (const PairSource& s : columns.sources)
    sources.insert(sources.end(),
                   {s.take, s.frame, std::uint32_t{s.swapped}, static_cast<std::uint32_t>(s.annotated)});
  writer.dataset("pairs/source", {pairs, 4}, sources.data());
  writer.dataset("pairs/root", {pairs, 4}, columns.roots.front().position.data());
  writer.dataset("pairs/pose", {pairs, pair_vertex_count, 3}, columns.poses.front().data());
  writer.dataset("pairs/features", {pairs, 15}, columns.features.front().data());
  writer.dataset("meshes/quality", columns.mesh_quality);
  writer.dataset("meshes/edge_offset", {pairs + 1}, columns.edge_offsets.data());
  writer.dataset("meshes/tetrahedron_offset", {pairs + 1}, columns.tetrahedron_offsets.data());
  writer.dataset("meshes/edges", {columns.edges.size(), 2},
                 columns.edges.empty() ? nullptr : columns.edges.front().data());
  writer.dataset("meshes/tetrahedra", {columns.tetrahedra.size(), 4},
                 columns.tetrahedra.empty() ? nullptr : columns.tetrahedra.front().data());
}

}  // namespace abrazo
