#include "core/library/motion_library_file.hpp"

#include <fmt/format.h>
#include <hdf5.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <mutex>
#include <stdexcept>
#include <utility>

#include "core/base/atomic_file.hpp"
#include "core/base/version.hpp"

namespace abrazo {

namespace {

namespace fs = std::filesystem;

constexpr const char* format_name = "abrazo motion library";
constexpr int format_version = 1;
constexpr std::size_t longest_text = 1 << 16;  ///< bytes of a name or label; more is a damaged file

// Rows are copied between file and memory as they are.
static_assert(sizeof(PairPose) == 3 * pair_vertex_count * sizeof(double));
static_assert(sizeof(Features) == 15 * sizeof(double));
static_assert(sizeof(RootFrame) == 4 * sizeof(double));
static_assert(sizeof(MeshEdge) == 2 && sizeof(MeshTetrahedron) == 4);

/// HDF5 may be built without locks of its own; one library file is read or written at a time.
std::mutex& hdf5_mutex() {
  static std::mutex mutex;
  return mutex;
}

/// Thrown within this file only.
struct FileProblem : std::runtime_error {
  using std::runtime_error::runtime_error;
};

template <typename... Args>
[[noreturn]] void problem(fmt::format_string<Args...> text, Args&&... args) {
  throw FileProblem(fmt::format(text, std::forward<Args>(args)...));
}

/// An HDF5 identifier that is closed in time.
class Handle {
 public:
  Handle(hid_t id, herr_t (*closer)(hid_t)) : id_(id), closer_(closer) {}
  Handle(Handle&& other) noexcept : id_(std::exchange(other.id_, -1)), closer_(other.closer_) {}
  Handle& operator=(Handle&&) = delete;
  ~Handle() {
    if (id_ >= 0) closer_(id_);
  }
  hid_t id() const { return id_; }
  bool ok() const { return id_ >= 0; }
  /// @return false when the file could not take what was still in memory
  bool close() { return closer_(std::exchange(id_, -1)) >= 0; }

 private:
  hid_t id_;
  herr_t (*closer_)(hid_t);
};

/// HDF5 prints its errors on stderr unless told not to.
class QuietHdf5 {
 public:
  QuietHdf5() {
    H5Eget_auto2(H5E_DEFAULT, &print_, &data_);
    H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
  }
  ~QuietHdf5() { H5Eset_auto2(H5E_DEFAULT, print_, data_); }
  QuietHdf5(const QuietHdf5&) = delete;
  QuietHdf5& operator=(const QuietHdf5&) = delete;

 private:
  H5E_auto2_t print_ = nullptr;
  void* data_ = nullptr;
};

/// What a number is in memory and in the file (little endian everywhere).
template <typename Number>
std::pair<hid_t, hid_t> number_types() {
  if constexpr (std::is_same_v<Number, double>) return {H5T_NATIVE_DOUBLE, H5T_IEEE_F64LE};
  if constexpr (std::is_same_v<Number, std::uint64_t>) return {H5T_NATIVE_UINT64, H5T_STD_U64LE};
  if constexpr (std::is_same_v<Number, std::uint32_t>) return {H5T_NATIVE_UINT32, H5T_STD_U32LE};
  if constexpr (std::is_same_v<Number, int>) return {H5T_NATIVE_INT, H5T_STD_I32LE};
  if constexpr (std::is_same_v<Number, std::uint8_t>) return {H5T_NATIVE_UINT8, H5T_STD_U8LE};
}

Handle text_type(std::size_t bytes) {
  Handle type(H5Tcopy(H5T_C_S1), H5Tclose);
  H5Tset_size(type.id(), std::max<std::size_t>(bytes, 1));
  H5Tset_strpad(type.id(), H5T_STR_NULLPAD);
  H5Tset_cset(type.id(), H5T_CSET_UTF8);
  return type;
}

using Shape = std::vector<hsize_t>;

hsize_t item_count(const Shape& shape) {
  hsize_t count = 1;
  for (const hsize_t size : shape) count *= size;
  return count;
}

// ---- writing ----

class LibraryWriter {
 public:
  explicit LibraryWriter(const fs::path& path)
      : file_(H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT), H5Fclose) {
    if (!file_.ok()) problem("cannot be created as HDF5");
  }

  void attribute(const char* name, const std::string& text) {
    const Handle type = text_type(text.size());
    const std::string padded = text.empty() ? std::string(1, '\0') : text;
    attribute(name, type.id(), type.id(), padded.data());
  }
  template <typename Number>
  void attribute(const char* name, Number value) {
    const auto [memory, stored] = number_types<Number>();
    attribute(name, memory, stored, &value);
  }
  template <typename Number>
  void dataset(const char* path, const Shape& shape, const Number* values) {
    const auto [memory, stored] = number_types<Number>();
    dataset(path, shape, memory, stored, values);
  }
  void dataset(const char* path, const std::vector<std::string>& texts) {
    std::size_t longest = 1;
    for (const std::string& text : texts) longest = std::max(longest, text.size());
    std::string rows(longest * texts.size(), '\0');
    for (std::size_t i = 0; i < texts.size(); ++i)
      std::copy(texts[i].begin(), texts[i].end(), rows.begin() + static_cast<std::ptrdiff_t>(i * longest));
    const Handle type = text_type(longest);
    dataset(path, {texts.size()}, type.id(), type.id(), rows.data());
  }
  void close() {
    if (!file_.close()) problem("could not be written whole; is the disk full?");
  }

 private:
  void attribute(const char* name, hid_t memory, hid_t stored, const void* value) {
    const Handle space(H5Screate(H5S_SCALAR), H5Sclose);
    const Handle attribute(H5Acreate2(file_.id(), name, stored, space.id(), H5P_DEFAULT, H5P_DEFAULT),
                           H5Aclose);
    if (!attribute.ok() || H5Awrite(attribute.id(), memory, value) < 0)
      problem("could not write {}; is the disk full?", name);
  }
  void dataset(const char* path, const Shape& shape, hid_t memory, hid_t stored, const void* values) {
    const Handle links(H5Pcreate(H5P_LINK_CREATE), H5Pclose);
    H5Pset_create_intermediate_group(links.id(), 1);
    const Handle creation(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
    H5Pset_obj_track_times(creation.id(), false);  // the same library gives the same bytes
    const Handle space(H5Screate_simple(static_cast<int>(shape.size()), shape.data(), nullptr), H5Sclose);
    const Handle set(H5Dcreate2(file_.id(), path, stored, space.id(), links.id(), creation.id(), H5P_DEFAULT),
                     H5Dclose);
    const bool written = set.ok() && (item_count(shape) == 0 ||
                                      H5Dwrite(set.id(), memory, H5S_ALL, H5S_ALL, H5P_DEFAULT, values) >= 0);
    if (!written) problem("could not write {}; is the disk full?", path);
  }

  Handle file_;
};

/// One field of every item, as a column.
template <typename Items, typename Field>
auto column(const Items& items, Field field) {
  std::vector<std::decay_t<decltype(field(items.front()))>> values;
  values.reserve(items.size());
  for (const auto& item : items) values.push_back(field(item));
  return values;
}

template <typename Number>
void write_column(LibraryWriter& writer, const char* path, const std::vector<Number>& values) {
  writer.dataset(path, {values.size()}, values.data());
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

void write_takes(LibraryWriter& writer, const std::vector<LibraryTake>& takes) {
  writer.dataset("takes/name", column(takes, [](const auto& t) { return t.name; }));
  write_column(writer, "takes/fps", column(takes, [](const auto& t) { return t.fps; }));
  write_column(writer, "takes/frames", column(takes, [](const auto& t) { return t.frames; }));
  write_column(writer, "takes/frame_stride", column(takes, [](const auto& t) { return t.frame_stride; }));
  write_column(writer, "takes/body_a", column(takes, [](const auto& t) { return t.body_a; }));
  write_column(writer, "takes/body_b", column(takes, [](const auto& t) { return t.body_b; }));
  const auto roles = all_intervals(takes, &LibraryTake::roles);
  write_column(writer, "roles/take", column(roles, [](const auto& r) { return r.take; }));
  write_column(writer, "roles/start", column(roles, [](const auto& r) { return r.interval.start; }));
  write_column(writer, "roles/end", column(roles, [](const auto& r) { return r.interval.end; }));
  write_column(writer, "roles/active",
               column(roles, [](const auto& r) { return static_cast<std::uint8_t>(r.interval.active); }));
  const auto labels = all_intervals(takes, &LibraryTake::labels);
  write_column(writer, "labels/take", column(labels, [](const auto& l) { return l.take; }));
  write_column(writer, "labels/start", column(labels, [](const auto& l) { return l.interval.start; }));
  write_column(writer, "labels/end", column(labels, [](const auto& l) { return l.interval.end; }));
  writer.dataset("labels/label", column(labels, [](const auto& l) { return l.interval.label; }));
  writer.dataset("labels/detail", column(labels, [](const auto& l) { return l.interval.detail; }));
  writer.dataset("labels/confidence", column(labels, [](const auto& l) { return l.interval.confidence; }));
}

void write_bodies(LibraryWriter& writer, const std::vector<LibraryBody>& bodies) {
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
  write_column(writer, "bodies/toe_rest_height",
               column(bodies, [](const auto& b) { return b.body.toe_rest_height; }));
}

void write_pairs(LibraryWriter& writer, const LibraryColumns& columns) {
  const hsize_t pairs = columns.sources.size();
  std::vector<std::uint32_t> sources;
  for (const PairSource& s : columns.sources)
    sources.insert(sources.end(),
                   {s.take, s.frame, std::uint32_t{s.swapped}, static_cast<std::uint32_t>(s.annotated)});
  writer.dataset("pairs/source", {pairs, 4}, sources.data());
  writer.dataset("pairs/root", {pairs, 4}, columns.roots.front().position.data());
  writer.dataset("pairs/pose", {pairs, pair_vertex_count, 3}, columns.poses.front().data());
  writer.dataset("pairs/features", {pairs, 15}, columns.features.front().data());
  write_column(writer, "meshes/quality", columns.mesh_quality);
  write_column(writer, "meshes/edge_offset", columns.edge_offsets);
  write_column(writer, "meshes/tetrahedron_offset", columns.tetrahedron_offsets);
  writer.dataset("meshes/edges", {columns.edges.size(), 2},
                 columns.edges.empty() ? nullptr : columns.edges.front().data());
  writer.dataset("meshes/tetrahedra", {columns.tetrahedra.size(), 4},
                 columns.tetrahedra.empty() ? nullptr : columns.tetrahedra.front().data());
}

// ---- reading ----

constexpr hsize_t any = static_cast<hsize_t>(-1);

std::string shape_text(const Shape& shape) {
  std::string text;
  for (const hsize_t size : shape)
    text += (text.empty() ? "" : " x ") + (size == any ? std::string("n") : std::to_string(size));
  return text;
}

class LibraryReader {
 public:
  explicit LibraryReader(const fs::path& path) : file_(open(path)) {}

  std::string text_attribute(const char* name) const {
    if (H5Aexists(file_.id(), name) <= 0)
      problem("is HDF5 but not an Abrazo motion library: it has no attribute {}", name);
    const Handle attribute(H5Aopen(file_.id(), name, H5P_DEFAULT), H5Aclose);
    const Handle stored(H5Aget_type(attribute.id()), H5Tclose);
    const std::size_t bytes = text_size(stored, name);
    std::string text(bytes, '\0');
    if (H5Aread(attribute.id(), stored.id(), text.data()) < 0)
      problem("attribute {} cannot be read; the file is damaged", name);
    return text.substr(0, text.find('\0'));
  }
  template <typename Number>
  Number attribute(const char* name) const {
    const Handle attribute(H5Aopen(file_.id(), name, H5P_DEFAULT), H5Aclose);
    Number value{};
    const Handle space(attribute.ok() ? H5Aget_space(attribute.id()) : -1, H5Sclose);
    if (!space.ok() || H5Sget_simple_extent_npoints(space.id()) != 1 ||
        H5Aread(attribute.id(), number_types<Number>().first, &value) < 0)
      problem("attribute {} is missing or not a number", name);
    return value;
  }

  /// A table whose rows are laid out as Row is, e.g. PairPose as 50 x 3 doubles.
  /// @param shape  as it must be, the first size may be `any`
  template <typename Number, typename Row>
  std::vector<Row> rows(const char* path, const Shape& shape) const {
    const Handle set = open_set(path);
    const Handle stored(H5Dget_type(set.id()), H5Tclose);
    constexpr bool wants_real = std::is_floating_point_v<Number>;
    if (H5Tget_class(stored.id()) != (wants_real ? H5T_FLOAT : H5T_INTEGER))
      problem("{} does not hold {} numbers", path, wants_real ? "real" : "whole");
    const hsize_t count = checked_rows(set, stored, path, shape);
    std::vector<Row> result(count);
    read(set, number_types<Number>().first, result.data(), count, path);
    return result;
  }
  template <typename Number>
  std::vector<Number> column(const char* path, hsize_t size = any) const {
    return rows<Number, Number>(path, {size});
  }

  std::vector<std::string> texts(const char* path, hsize_t size) const {
    const Handle set = open_set(path);
    const Handle stored(H5Dget_type(set.id()), H5Tclose);
    const std::size_t bytes = text_size(stored, path);
    const hsize_t count = checked_rows(set, stored, path, {size});
    std::string all(bytes * count, '\0');
    read(set, stored.id(), all.data(), count, path);
    std::vector<std::string> result;
    for (hsize_t i = 0; i < count; ++i)
      result.emplace_back(all.c_str() + i * bytes, ::strnlen(all.c_str() + i * bytes, bytes));
    return result;
  }

 private:
  static Handle open(const fs::path& path) {
    const Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
    H5Pset_file_locking(access.id(), false, true);  // only read, and also from disks that know no locks
    if (H5Fis_hdf5(path.c_str()) <= 0)
      problem("is not an HDF5 file; give a library that `abrazo library build` wrote");
    Handle file(H5Fopen(path.c_str(), H5F_ACC_RDONLY, access.id()), H5Fclose);
    if (!file.ok()) problem("is cut short or damaged; copy or build it again");
    return file;
  }
  Handle open_set(const char* path) const {
    Handle set(H5Dopen2(file_.id(), path, H5P_DEFAULT), H5Dclose);
    if (!set.ok()) problem("{} is missing or damaged; build the library again", path);
    return set;
  }
  static std::size_t text_size(const Handle& stored, const char* name) {
    const std::size_t bytes = stored.ok() ? H5Tget_size(stored.id()) : 0;
    if (bytes == 0 || H5Tget_class(stored.id()) != H5T_STRING || H5Tis_variable_str(stored.id()) > 0)
      problem("{} does not hold text of a fixed length", name);
    if (bytes > longest_text)
      problem("{} holds text of {} bytes; at most {} are allowed", name, bytes, longest_text);
    return bytes;
  }
  /// Number of rows, after making sure that they have the wanted shape and are in the file: nothing is
  /// allocated for sizes that a damaged file only claims.
  static hsize_t checked_rows(const Handle& set, const Handle& stored, const char* path,
                              const Shape& wanted) {
    const Handle space(H5Dget_space(set.id()), H5Sclose);
    const int rank = H5Sget_simple_extent_ndims(space.id());
    Shape found(static_cast<std::size_t>(std::max(rank, 0)));
    if (rank > 0) H5Sget_simple_extent_dims(space.id(), found.data(), nullptr);
    bool fits = found.size() == wanted.size();
    for (std::size_t i = 0; fits && i < wanted.size(); ++i) fits = wanted[i] == any || wanted[i] == found[i];
    if (!fits)
      problem("{} is {}, expected {}", path, found.empty() ? "one value" : shape_text(found),
              shape_text(wanted));
    const hsize_t in_file = H5Dget_storage_size(set.id()) / H5Tget_size(stored.id());
    if (in_file / std::max<hsize_t>(1, item_count(found) / std::max<hsize_t>(1, found[0])) < found[0])
      problem("{} says it is {} but the file holds only {} values of it", path, shape_text(found), in_file);
    return found[0];
  }
  static void read(const Handle& set, hid_t memory, void* to, hsize_t count, const char* path) {
    if (count > 0 && H5Dread(set.id(), memory, H5S_ALL, H5S_ALL, H5P_DEFAULT, to) < 0)
      problem("{} cannot be read; the file is cut short or damaged", path);
  }

  Handle file_;
};

ActivePerformer performer(std::uint32_t code, const char* path) {
  if (code > static_cast<std::uint32_t>(ActivePerformer::Unknown))
    problem("{} holds {}; expected 0 (a), 1 (b) or 2 (unknown)", path, code);
  return static_cast<ActivePerformer>(code);
}

LibraryTake& take_at(LibraryColumns& columns, std::uint32_t take, const char* path) {
  if (take >= columns.takes.size())
    problem("{} names take {}, there are {}", path, take, columns.takes.size());
  return columns.takes[take];
}

void read_takes(const LibraryReader& reader, LibraryColumns& columns) {
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
        .labels.push_back({label_starts[i], label_ends[i], labels[i], details[i], confidences[i]});
}

void read_bodies(const LibraryReader& reader, LibraryColumns& columns) {
  using Bones = std::array<double, bone_count>;
  using PseudoBones = std::array<double, pseudo_bones.size()>;
  const auto lengths = reader.rows<double, Bones>("bodies/bone_lengths", {any, bone_count});
  const auto pseudo_lengths =
      reader.rows<double, PseudoBones>("bodies/pseudo_lengths", {lengths.size(), pseudo_bones.size()});
  const auto radii = reader.rows<double, Bones>("bodies/capsule_radii", {lengths.size(), bone_count});
  const auto toe_heights = reader.column<double>("bodies/toe_rest_height", lengths.size());
  const auto names = reader.texts("bodies/name", lengths.size());
  for (std::size_t b = 0; b < lengths.size(); ++b)
    columns.bodies.push_back({names[b], {lengths[b], pseudo_lengths[b], toe_heights[b]}, radii[b]});
}

void read_pairs(const LibraryReader& reader, LibraryColumns& columns) {
  const auto sources = reader.rows<std::uint32_t, std::array<std::uint32_t, 4>>("pairs/source", {any, 4});
  const hsize_t pairs = sources.size();
  columns.sources.reserve(pairs);
  for (const auto& [take, frame, swapped, annotated] : sources) {
    if (swapped > 1) problem("pairs/source says swapped = {}; expected 0 or 1", swapped);
    columns.sources.push_back({take, frame, swapped == 1, performer(annotated, "pairs/source")});
  }
  columns.roots = reader.rows<double, RootFrame>("pairs/root", {pairs, 4});
  columns.poses = reader.rows<double, PairPose>("pairs/pose", {pairs, pair_vertex_count, 3});
  columns.features = reader.rows<double, Features>("pairs/features", {pairs, 15});
  columns.mesh_quality = reader.column<std::uint8_t>("meshes/quality", pairs);
  columns.edge_offsets = reader.column<std::uint64_t>("meshes/edge_offset", pairs + 1);
  columns.tetrahedron_offsets = reader.column<std::uint64_t>("meshes/tetrahedron_offset", pairs + 1);
  columns.edges = reader.rows<std::uint8_t, MeshEdge>("meshes/edges", {any, 2});
  columns.tetrahedra = reader.rows<std::uint8_t, MeshTetrahedron>("meshes/tetrahedra", {any, 4});
}

LibraryColumns read_columns(const fs::path& file) {
  const LibraryReader reader(file);
  if (reader.text_attribute("format") != format_name) problem("is HDF5 but not an Abrazo motion library");
  const int found = reader.attribute<int>("format_version");
  if (found > format_version)
    problem("has format version {}, this program reads up to {}; it was written by {}: update this program",
            found, format_version, reader.text_attribute("written_by"));
  if (found < 1) problem("has format version {}, which never existed", found);
  LibraryColumns columns;
  columns.name = reader.text_attribute("name");
  columns.rate_hz = reader.attribute<double>("rate_hz");
  read_takes(reader, columns);
  read_bodies(reader, columns);
  read_pairs(reader, columns);
  return columns;
}

/// The operating system's own reason is clearer than HDF5's.
std::optional<Error> openable(const fs::path& file, std::ios::openmode mode, const char* what,
                              const fs::path& shown) {
  std::error_code ignored;
  if (fs::is_directory(file, ignored)) return Error{"is a folder; name a file", shown.string()};
  if (std::fstream(file, mode | std::ios::binary)) return std::nullopt;
  return Error{fmt::format("{}: {}", what, std::strerror(errno)), shown.string()};
}

}  // namespace

Status write_library(const MotionLibrary& library, const fs::path& file, const Progress& progress) {
  AtomicFile target(file);
  if (auto refusal = openable(target.partial(), std::ios::out, "cannot be created", file)) return *refusal;
  try {
    const std::lock_guard lock(hdf5_mutex());
    const QuietHdf5 quiet;
    LibraryWriter writer(target.partial());
    writer.attribute("format", std::string(format_name));
    writer.attribute("format_version", format_version);
    writer.attribute("written_by", fmt::format("abrazo {}", version()));
    writer.attribute("name", library.name());
    writer.attribute("rate_hz", library.rate_hz());
    writer.dataset("joints", std::vector<std::string>(joint_names.begin(), joint_names.end()));
    write_takes(writer, library.takes());
    write_bodies(writer, library.bodies());
    if (!report(progress, 0.1, "writing library")) return Error{"cancelled", ""};
    write_pairs(writer, library.columns());
    writer.close();
  } catch (const FileProblem& failure) {
    return Error{failure.what(), file.string()};
  }
  if (!report(progress, 1, "library written")) return Error{"cancelled", ""};
  return target.commit();
}

Result<MotionLibrary> read_library(const fs::path& file) {
  if (auto refusal = openable(file, std::ios::in, "cannot be opened", file)) return *refusal;
  try {
    LibraryColumns columns;
    {
      const std::lock_guard lock(hdf5_mutex());
      const QuietHdf5 quiet;
      columns = read_columns(file);
    }
    return MotionLibrary(std::move(columns));
  } catch (const FileProblem& failure) {
    return Error{failure.what(), file.string()};
  } catch (const std::invalid_argument& failure) {
    return Error{std::string("does not fit together: ") + failure.what() + "; build the library again",
                 file.string()};
  }
}

}  // namespace abrazo
