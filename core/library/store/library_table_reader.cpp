#include <fmt/format.h>

#include <array>
#include <cstdint>
#include <string>

#include "core/base/mapped_file.hpp"
#include "core/library/store/library_tables.hpp"

namespace abrazo {

namespace {

template <typename... Args>
[[noreturn]] void table_problem(fmt::format_string<Args...> text, Args&&... args) {
  throw Hdf5Problem(fmt::format(text, std::forward<Args>(args)...));
}

ActivePerformer performer(std::uint32_t code, const char* path) {
  if (code > static_cast<std::uint32_t>(ActivePerformer::Unknown))
    table_problem("{} holds {}; expected 0 (a), 1 (b) or 2 (unknown)", path, code);
  return static_cast<ActivePerformer>(code);
}

LibraryTake& take_at(LibraryColumns& columns, std::uint32_t take, const char* path) {
  if (take >= columns.takes.size())
    table_problem("{} names take {}, there are {}", path, take, columns.takes.size());
  return columns.takes[take];
}

void read_takes(const Hdf5Reader& reader, LibraryColumns& columns) {
  const auto fps = reader.column<double>("takes/fps");
  const auto names = reader.texts("takes/name", fps.size());
  const auto frames = reader.column<int>("takes/frames", fps.size());
  const auto strides = reader.column<int>("takes/frame_stride", fps.size());
  const auto bodies_a = reader.column<std::uint32_t>("takes/body_a", fps.size());
  const auto bodies_b = reader.column<std::uint32_t>("takes/body_b", fps.size());
  for (std::size_t t = 0; t < fps.size(); ++t)
    columns.takes.push_back({names[t], fps[t], frames[t], strides[t], bodies_a[t], bodies_b[t], {}, {}});
  const auto role_takes = reader.column<std::uint32_t>("roles/take");
  const auto role_starts = reader.column<int>("roles/start", role_takes.size());
  const auto role_ends = reader.column<int>("roles/end", role_takes.size());
  const auto role_active = reader.column<std::uint8_t>("roles/active", role_takes.size());
  for (std::size_t i = 0; i < role_takes.size(); ++i)
    take_at(columns, role_takes[i], "roles/take")
        .roles.push_back({role_starts[i], role_ends[i], performer(role_active[i], "roles/active")});
  const auto label_takes = reader.column<std::uint32_t>("labels/take");
  const auto label_starts = reader.column<int>("labels/start", label_takes.size());
  const auto label_ends = reader.column<int>("labels/end", label_takes.size());
  const auto labels = reader.texts("labels/label", label_takes.size());
  const auto details = reader.texts("labels/detail", label_takes.size());
  const auto confidences = reader.texts("labels/confidence", label_takes.size());
  for (std::size_t i = 0; i < label_takes.size(); ++i)
    take_at(columns, label_takes[i], "labels/take")
        .labels.push_back({.start = label_starts[i],
                           .end = label_ends[i],
                           .label = labels[i],
                           .detail = details[i],
                           .confidence = confidences[i]});
}

void read_bodies(const Hdf5Reader& reader, LibraryColumns& columns) {
  using Bones = std::array<double, bone_count>;
  using PseudoBones = std::array<double, pseudo_bones.size()>;
  const auto lengths = reader.rows<double, Bones>("bodies/bone_lengths", {any_size, bone_count});
  const auto pseudo_lengths =
      reader.rows<double, PseudoBones>("bodies/pseudo_lengths", {lengths.size(), pseudo_bones.size()});
  const auto radii = reader.rows<double, Bones>("bodies/capsule_radii", {lengths.size(), bone_count});
  const auto toe_heights = reader.column<double>("bodies/toe_rest_height", lengths.size());
  const auto names = reader.texts("bodies/name", lengths.size());
  for (std::size_t b = 0; b < lengths.size(); ++b)
    columns.bodies.push_back({names[b], {lengths[b], pseudo_lengths[b], toe_heights[b]}, radii[b]});
}

void read_pairs(const Hdf5Reader& reader, LibraryColumns& columns) {
  const auto sources =
      reader.rows<std::uint32_t, std::array<std::uint32_t, 4>>("pairs/source", {any_size, 4});
  const std::uint64_t pairs = sources.size();
  columns.sources.reserve(pairs);
  for (const auto& [take, frame, swapped, annotated] : sources) {
    if (swapped > 1) table_problem("pairs/source says swapped = {}; expected 0 or 1", swapped);
    columns.sources.push_back({take, frame, swapped == 1, performer(annotated, "pairs/source")});
  }
  columns.mesh_quality = reader.column<std::uint8_t>("meshes/quality", pairs);
  const auto& mapping = columns.mapping;
  columns.roots = reader.mapped_rows<double, RootFrame>("pairs/root", {pairs, 4}, mapping);
  columns.poses = reader.mapped_rows<double, PairPose>("pairs/pose", {pairs, pair_vertex_count, 3}, mapping);
  columns.features = reader.mapped_rows<double, Features>("pairs/features", {pairs, 15}, mapping);
  columns.edge_offsets =
      reader.mapped_rows<std::uint64_t, std::uint64_t>("meshes/edge_offset", {pairs + 1}, mapping);
  columns.tetrahedron_offsets =
      reader.mapped_rows<std::uint64_t, std::uint64_t>("meshes/tetrahedron_offset", {pairs + 1}, mapping);
  columns.edges = reader.mapped_rows<std::uint8_t, MeshEdge>("meshes/edges", {any_size, 2}, mapping);
  columns.tetrahedra =
      reader.mapped_rows<std::uint8_t, MeshTetrahedron>("meshes/tetrahedra", {any_size, 4}, mapping);
}

std::uint64_t bytes_of_pairs(const Hdf5Reader& reader) {
  return reader.stored_bytes("pairs/pose") + reader.stored_bytes("meshes/edges") +
         reader.stored_bytes("meshes/tetrahedra");
}

}  // namespace

LibraryColumns read_library_tables(const Hdf5Reader& reader, std::uint64_t largest_in_memory_bytes) {
  if (!reader.has_attribute("format"))
    table_problem("is HDF5 but not an Abrazo motion library: it has no attribute format");
  if (reader.text_attribute("format") != library_format_name)
    table_problem("is HDF5 but not an Abrazo motion library");
  const int found = reader.attribute<int>("format_version");
  if (found > library_format_version)
    table_problem(
        "has format version {}, this program reads up to {}; it was written by {}: update this program",
        found, library_format_version, reader.text_attribute("written_by"));
  if (found < 1) table_problem("has format version {}, which never existed", found);
  LibraryColumns columns;
  columns.name = reader.text_attribute("name");
  columns.rate_hz = reader.attribute<double>("rate_hz");
  if (bytes_of_pairs(reader) > largest_in_memory_bytes) columns.mapping = reader.mapping();
  read_takes(reader, columns);
  read_bodies(reader, columns);
  read_pairs(reader, columns);
  return columns;
}

}  // namespace abrazo
