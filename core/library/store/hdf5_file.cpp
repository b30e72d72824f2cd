#include "core/library/store/hdf5_file.hpp"

#include <fmt/format.h>
#include <hdf5.h>
#include <sys/stat.h>

#include <algorithm>
#include <cstring>

#include "core/base/mapped_file.hpp"

namespace abrazo {

namespace {

namespace fs = std::filesystem;

static_assert(std::is_same_v<hid_t, std::int64_t> && std::is_same_v<herr_t, int>);

constexpr std::size_t longest_text = 1 << 16;  ///< bytes of a name or label; more is a damaged file
/// Tables from this size on start on a page of memory: a row of poses then lies as memory wants it, and rows
/// of one table share no page with those of another.
constexpr hsize_t paged_from_bytes = 4096, page_bytes = 4096;

std::mutex& hdf5_mutex() {
  static std::mutex mutex;
  return mutex;
}

template <typename... Args>
[[noreturn]] void problem(fmt::format_string<Args...> text, Args&&... args) {
  throw Hdf5Problem(fmt::format(text, std::forward<Args>(args)...));
}

hid_t in_memory(Hdf5Number number) {
  switch (number) {
    case Hdf5Number::Float64:
      return H5T_NATIVE_DOUBLE;
    case Hdf5Number::Unsigned64:
      return H5T_NATIVE_UINT64;
    case Hdf5Number::Unsigned32:
      return H5T_NATIVE_UINT32;
    case Hdf5Number::Signed32:
      return H5T_NATIVE_INT;
    case Hdf5Number::Unsigned8:
      break;
  }
  return H5T_NATIVE_UINT8;
}

hid_t in_file(Hdf5Number number) {
  switch (number) {
    case Hdf5Number::Float64:
      return H5T_IEEE_F64LE;
    case Hdf5Number::Unsigned64:
      return H5T_STD_U64LE;
    case Hdf5Number::Unsigned32:
      return H5T_STD_U32LE;
    case Hdf5Number::Signed32:
      return H5T_STD_I32LE;
    case Hdf5Number::Unsigned8:
      break;
  }
  return H5T_STD_U8LE;
}

Hdf5Handle text_type(std::size_t bytes) {
  Hdf5Handle type(H5Tcopy(H5T_C_S1), H5Tclose);
  H5Tset_size(type.id(), std::max<std::size_t>(bytes, 1));
  H5Tset_strpad(type.id(), H5T_STR_NULLPAD);
  H5Tset_cset(type.id(), H5T_CSET_UTF8);
  return type;
}

std::uint64_t item_count(const Hdf5Shape& shape) {
  std::uint64_t count = 1;
  for (const std::uint64_t size : shape) count *= size;
  return count;
}

std::vector<hsize_t> sizes(const Hdf5Shape& shape) {
  return {shape.begin(), shape.end()};
}

std::string shape_text(const Hdf5Shape& shape) {
  std::string text;
  for (const std::uint64_t size : shape)
    text += (text.empty() ? "" : " x ") + (size == any_size ? std::string("n") : std::to_string(size));
  return text;
}

Hdf5Shape shape_of(const Hdf5Handle& set) {
  const Hdf5Handle space(H5Dget_space(set.id()), H5Sclose);
  const int rank = H5Sget_simple_extent_ndims(space.id());
  std::vector<hsize_t> found(static_cast<std::size_t>(std::max(rank, 0)));
  if (rank > 0) H5Sget_simple_extent_dims(space.id(), found.data(), nullptr);
  return {found.begin(), found.end()};
}

Hdf5Handle create(const fs::path& path) {
  const Hdf5Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
  H5Pset_alignment(access.id(), paged_from_bytes, page_bytes);
  return {H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, access.id()), H5Fclose};
}

/// HDF5 1.10 aborts the program if a message is marked as shared but the file has no table of shared
/// messages.
void refuse_shared_descriptions(const Hdf5Handle& file, const std::string& path) {
#if H5_VERSION_GE(1, 12, 0)  // since then what only HDF5's own files have is asked for by another name
  H5O_native_info_t object;
  const herr_t told =
      H5Oget_native_info_by_name(file.id(), path.c_str(), &object, H5O_NATIVE_INFO_HDR, H5P_DEFAULT);
#else
  H5O_info_t object;
  const herr_t told = H5Oget_info_by_name2(file.id(), path.c_str(), &object, H5O_INFO_HDR, H5P_DEFAULT);
#endif
  if (told < 0) problem("{} is damaged; build the library again", path);
  if (object.hdr.mesg.shared != 0)
    problem("{} has parts of its description elsewhere; a library holds its own tables: build it again",
            path);
}

/// A link could lead to any file of the user. Groups on the path are checked first, because a query behind a
/// link would follow it.
void refuse_links(const Hdf5Handle& file, std::string_view path) {
  for (std::size_t end = 0; end < path.size();) {
    end = std::min(path.find('/', end + 1), path.size());
    const std::string part(path.substr(0, end));
    H5L_info_t link;
    if (H5Lget_info(file.id(), part.c_str(), &link, H5P_DEFAULT) < 0) return;  // missing: reported on opening
    if (link.type != H5L_TYPE_HARD)
      problem("{} is a link to another place; a library holds its own tables: build it again", part);
    refuse_shared_descriptions(file, part);
  }
}

Hdf5Handle open(const fs::path& path) {
  const Hdf5Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
  H5Pset_file_locking(access.id(), false, true);  // only read, and also from disks that know no locks
  if (H5Fis_hdf5(path.c_str()) <= 0)
    problem("is not an HDF5 file; give a library that `abrazo library build` wrote");
  Hdf5Handle file(H5Fopen(path.c_str(), H5F_ACC_RDONLY, access.id()), H5Fclose);
  if (!file.ok()) problem("is cut short or damaged; copy or build it again");
  refuse_shared_descriptions(file, "/");
  return file;
}

std::size_t text_size(const Hdf5Handle& stored, const char* name) {
  const std::size_t bytes = stored.ok() ? H5Tget_size(stored.id()) : 0;
  if (bytes == 0 || H5Tget_class(stored.id()) != H5T_STRING || H5Tis_variable_str(stored.id()) > 0)
    problem("{} does not hold text of a fixed length", name);
  if (bytes > longest_text)
    problem("{} holds text of {} bytes; at most {} are allowed", name, bytes, longest_text);
  return bytes;
}

/// Of the file that a table is in, as the operating system has it: the file's own words are not to be
/// trusted.
std::uint64_t bytes_of_file(const Hdf5Handle& set) {
  const Hdf5Handle file(H5Iget_file_id(set.id()), H5Fclose);
  void* descriptor = nullptr;
  struct stat status = {};
  if (H5Fget_vfd_handle(file.id(), H5P_DEFAULT, &descriptor) < 0 || descriptor == nullptr ||
      fstat(*static_cast<const int*>(descriptor), &status) != 0)
    return 0;
  return static_cast<std::uint64_t>(std::max<off_t>(0, status.st_size));
}

/// What the table takes in the file; at most what the file has.
std::uint64_t bytes_stored(const Hdf5Handle& set, const char* path) {
  const std::uint64_t claimed = H5Dget_storage_size(set.id()), there = bytes_of_file(set);
  if (claimed > there)
    problem("{} claims {} bytes but the file has {}; it is cut short or damaged, copy or build it again",
            path, claimed, there);
  return claimed;
}

/// Number of rows, after making sure that they have the wanted shape and are in the file: nothing is
/// allocated for sizes that a damaged file only claims.
std::uint64_t checked_rows(const Hdf5Handle& set, const Hdf5Handle& stored, const char* path,
                           const Hdf5Shape& wanted) {
  const Hdf5Shape found = shape_of(set);
  bool fits = found.size() == wanted.size();
  for (std::size_t i = 0; fits && i < wanted.size(); ++i)
    fits = wanted[i] == any_size || wanted[i] == found[i];
  if (!fits)
    problem("{} is {}, expected {}", path, found.empty() ? "one value" : shape_text(found),
            shape_text(wanted));
  const std::size_t bytes = H5Tget_size(stored.id());
  if (bytes == 0) problem("{} holds numbers of no size; the file is damaged, copy or build it again", path);
  const std::uint64_t values = bytes_stored(set, path) / bytes;
  const std::uint64_t values_of_row = item_count(found) / std::max<std::uint64_t>(1, found[0]);
  if (values / std::max<std::uint64_t>(1, values_of_row) < found[0])
    problem("{} says it is {} but the file holds only {} values of it", path, shape_text(found), values);
  return found[0];
}

void read_all(const Hdf5Handle& set, std::int64_t memory, std::uint64_t rows, const char* path, void* to) {
  if (rows > 0 && H5Dread(set.id(), memory, H5S_ALL, H5S_ALL, H5P_DEFAULT, to) < 0)
    problem("{} cannot be read; the file is cut short or damaged", path);
}

}  // namespace

Hdf5Turn::Hdf5Turn() : lock_(hdf5_mutex()) {
  // What could not be written for want of space cannot be closed either; when the program ends HDF5 would try
  // once more and crash.
  [[maybe_unused]] static const auto asked = H5dont_atexit();
  H5Eget_auto2(H5E_DEFAULT, &print_, &data_);
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
}

Hdf5Turn::~Hdf5Turn() {
  H5Eset_auto2(H5E_DEFAULT, print_, data_);
}

// ---- writing ----

Hdf5Writer::Hdf5Writer(const fs::path& path) : file_(create(path)) {
  if (!file_.ok()) problem("cannot be created as HDF5");
}

void Hdf5Writer::attribute(const char* name, const std::string& text) {
  const Hdf5Handle type = text_type(text.size());
  const std::string padded = text.empty() ? std::string(1, '\0') : text;
  attribute(name, type.id(), type.id(), padded.data());
}

void Hdf5Writer::attribute(const char* name, Hdf5Number number, const void* value) {
  attribute(name, in_memory(number), in_file(number), value);
}

void Hdf5Writer::attribute(const char* name, std::int64_t memory, std::int64_t stored, const void* value) {
  const Hdf5Handle space(H5Screate(H5S_SCALAR), H5Sclose);
  const Hdf5Handle attribute(H5Acreate2(file_.id(), name, stored, space.id(), H5P_DEFAULT, H5P_DEFAULT),
                             H5Aclose);
  if (!attribute.ok() || H5Awrite(attribute.id(), memory, value) < 0)
    problem("could not write {}; is the disk full?", name);
}

void Hdf5Writer::dataset(const char* path, const std::vector<std::string>& texts) {
  std::size_t longest = 1;
  for (const std::string& text : texts) longest = std::max(longest, text.size());
  std::string rows(longest * texts.size(), '\0');
  for (std::size_t i = 0; i < texts.size(); ++i)
    std::copy(texts[i].begin(), texts[i].end(), rows.begin() + static_cast<std::ptrdiff_t>(i * longest));
  const Hdf5Handle type = text_type(longest);
  dataset(path, {texts.size()}, type.id(), type.id(), rows.data());
}

void Hdf5Writer::dataset(const char* path, const Hdf5Shape& shape, Hdf5Number number, const void* values) {
  dataset(path, shape, in_memory(number), in_file(number), values);
}

void Hdf5Writer::dataset(const char* path, const Hdf5Shape& shape, std::int64_t memory, std::int64_t stored,
                         const void* values) {
  const Hdf5Handle links(H5Pcreate(H5P_LINK_CREATE), H5Pclose);
  H5Pset_create_intermediate_group(links.id(), 1);
  const Hdf5Handle creation(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
  H5Pset_obj_track_times(creation.id(), false);  // the same library gives the same bytes
  const std::vector<hsize_t> size = sizes(shape);
  const Hdf5Handle space(H5Screate_simple(static_cast<int>(size.size()), size.data(), nullptr), H5Sclose);
  const Hdf5Handle set(
      H5Dcreate2(file_.id(), path, stored, space.id(), links.id(), creation.id(), H5P_DEFAULT), H5Dclose);
  const bool written = set.ok() && (item_count(shape) == 0 ||
                                    H5Dwrite(set.id(), memory, H5S_ALL, H5S_ALL, H5P_DEFAULT, values) >= 0);
  if (!written) problem("could not write {}; is the disk full?", path);
}

void Hdf5Writer::close() {
  if (!file_.close()) problem("could not be written whole; is the disk full?");
}

// ---- reading ----

Hdf5Reader::Hdf5Reader(const fs::path& path) : file_(open(path)) {}

bool Hdf5Reader::has_attribute(const char* name) const {
  return H5Aexists(file_.id(), name) > 0;
}

std::string Hdf5Reader::text_attribute(const char* name) const {
  const Hdf5Handle attribute(H5Aopen(file_.id(), name, H5P_DEFAULT), H5Aclose);
  if (!attribute.ok()) problem("attribute {} is missing", name);
  const Hdf5Handle stored(H5Aget_type(attribute.id()), H5Tclose);
  std::string text(text_size(stored, name), '\0');
  if (H5Aread(attribute.id(), stored.id(), text.data()) < 0)
    problem("attribute {} cannot be read; the file is damaged", name);
  return text.substr(0, text.find('\0'));
}

void Hdf5Reader::attribute(const char* name, Hdf5Number number, void* value) const {
  const Hdf5Handle attribute(H5Aopen(file_.id(), name, H5P_DEFAULT), H5Aclose);
  const Hdf5Handle space(attribute.ok() ? H5Aget_space(attribute.id()) : -1, H5Sclose);
  if (!space.ok() || H5Sget_simple_extent_npoints(space.id()) != 1 ||
      H5Aread(attribute.id(), in_memory(number), value) < 0)
    problem("attribute {} is missing or not a number", name);
}

std::vector<std::string> Hdf5Reader::texts(const char* path, std::uint64_t size) const {
  const Hdf5Handle set = open_set(path);
  const Hdf5Handle stored(H5Dget_type(set.id()), H5Tclose);
  const std::size_t bytes = text_size(stored, path);
  const std::uint64_t count = checked_rows(set, stored, path, {size});
  std::string all(bytes * count, '\0');
  read_all(set, stored.id(), count, path, all.data());
  std::vector<std::string> result;
  for (std::uint64_t i = 0; i < count; ++i)
    result.emplace_back(all.c_str() + i * bytes, ::strnlen(all.c_str() + i * bytes, bytes));
  return result;
}

Hdf5Handle Hdf5Reader::open_set(const char* path) const {
  refuse_links(file_, path);
  Hdf5Handle set(H5Dopen2(file_.id(), path, H5P_DEFAULT), H5Dclose);
  if (!set.ok()) problem("{} is missing or damaged; build the library again", path);
  const Hdf5Handle creation(H5Dget_create_plist(set.id()), H5Pclose);
  if (H5Pget_external_count(creation.id()) > 0 || H5Pget_layout(creation.id()) == H5D_VIRTUAL)
    problem("{} is kept in other files; a library holds its own tables: build it again", path);
  if (H5Pget_nfilters(creation.id()) > 0)
    problem("{} is compressed; `h5repack -l CONTI -f NONE` writes the file as it should be", path);
  return set;
}

Hdf5Reader::Table Hdf5Reader::open_table(const char* path, Hdf5Number number, const Hdf5Shape& shape) const {
  Hdf5Handle set = open_set(path);
  const Hdf5Handle stored(H5Dget_type(set.id()), H5Tclose);
  const bool wants_real = number == Hdf5Number::Float64;
  if (H5Tget_class(stored.id()) != (wants_real ? H5T_FLOAT : H5T_INTEGER))
    problem("{} does not hold {} numbers", path, wants_real ? "real" : "whole");
  const std::uint64_t rows = checked_rows(set, stored, path, shape);
  return {std::move(set), number, rows};
}

void Hdf5Reader::read(const Table& table, const char* path, void* to) {
  read_all(table.set, in_memory(table.number), table.rows, path, to);
}

const void* Hdf5Reader::place_in(const MappedFile& mapping, const Table& table, std::size_t row_bytes,
                                 std::size_t alignment) {
  const Hdf5Handle stored(H5Dget_type(table.set.id()), H5Tclose);
  if (H5Tequal(stored.id(), in_file(table.number)) <= 0 ||
      H5Tequal(stored.id(), in_memory(table.number)) <= 0)
    return nullptr;
  const haddr_t offset = H5Dget_offset(table.set.id());  // undefined for chunks
  if (offset == HADDR_UNDEF || offset % alignment != 0 || table.rows == 0) return nullptr;
  const std::span<const std::byte> bytes = mapping.bytes();
  if (offset > bytes.size() || (bytes.size() - offset) / row_bytes < table.rows) return nullptr;
  return bytes.data() + offset;
}

std::uint64_t Hdf5Reader::stored_bytes(const char* path) const {
  return bytes_stored(open_set(path), path);
}

std::shared_ptr<const MappedFile> Hdf5Reader::mapping() const {
  void* descriptor = nullptr;
  if (H5Fget_vfd_handle(file_.id(), H5P_DEFAULT, &descriptor) < 0 || descriptor == nullptr) return nullptr;
  const auto mapped = MappedFile::map(*static_cast<const int*>(descriptor), "library");
  return mapped ? *mapped : nullptr;
}

}  // namespace abrazo
