#include "core/library/store/motion_library_file.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <new>
#include <optional>
#include <stdexcept>

#include "core/base/atomic_file.hpp"
#include "core/base/version.hpp"
#include "core/library/store/library_tables.hpp"

namespace abrazo {

namespace {

namespace fs = std::filesystem;

/// The operating system's own reason is clearer than HDF5's.
std::optional<Error> openable(const fs::path& file, std::ios::openmode mode, const char* what,
                              const fs::path& shown) {
  std::error_code ignored;
  const fs::file_status status = fs::status(file, ignored);
  if (fs::is_directory(status)) return Error{"is a folder; name a file", shown.string()};
  // Opening a pipe would wait for a writer.
  if (fs::exists(status) && !fs::is_regular_file(status))
    return Error{"is a pipe or a device; name a file", shown.string()};
  if (std::fstream(file, mode | std::ios::binary)) return std::nullopt;
  return Error{fmt::format("{}: {}", what, std::strerror(errno)), shown.string()};
}

}  // namespace

std::uint64_t mapped_bytes(const MotionLibrary& library) {
  const auto of = [](const auto&... columns) {
    return (std::uint64_t{0} + ... + (columns.is_view() ? columns.size() * sizeof(columns[0]) : 0));
  };
  const LibraryColumns& c = library.columns();
  return of(c.roots, c.poses, c.features, c.edge_offsets, c.edges, c.tetrahedron_offsets, c.tetrahedra);
}

Status write_library(const MotionLibrary& library, const fs::path& file, const Progress& progress) {
  AtomicFile target(file);
  if (auto refusal = openable(target.partial(), std::ios::out, "cannot be created", file)) return *refusal;
  try {
    const Hdf5Turn turn;
    Hdf5Writer writer(target.partial());
    writer.attribute("format", std::string(library_format_name));
    writer.attribute("format_version", library_format_version);
    writer.attribute("written_by", fmt::format("abrazo {}", version()));
    writer.attribute("name", library.name());
    writer.attribute("rate_hz", library.rate_hz());
    writer.dataset("joints", std::vector<std::string>(joint_names.begin(), joint_names.end()));
    write_descriptions(writer, library.columns());
    if (!report(progress, 0.1, "writing library")) return Error{"cancelled", ""};
    write_pairs(writer, library.columns());
    writer.close();
  } catch (const Hdf5Problem& failure) {
    if (const auto damage = library.damage()) return *damage;  // the data to write is lost
    return Error{failure.what(), file.string()};
  }
  if (const auto damage = library.damage()) return *damage;  // a mapped one may have been read as zeros
  if (!report(progress, 1, "library written")) return Error{"cancelled", ""};
  return target.commit();
}

Result<MotionLibrary> read_library(const fs::path& file, const LibraryReading& reading) {
  if (auto refusal = openable(file, std::ios::in, "cannot be opened", file)) return *refusal;
  try {
    LibraryColumns columns;
    {
      const Hdf5Turn turn;
      columns = read_library_tables(Hdf5Reader(file), reading.largest_in_memory_bytes);
    }
    return MotionLibrary(std::move(columns));
  } catch (const Hdf5Problem& failure) {
    return Error{failure.what(), file.string()};
  } catch (const std::invalid_argument& failure) {
    return Error{std::string("does not fit together: ") + failure.what() + "; build the library again",
                 file.string()};
  } catch (const std::bad_alloc&) {
    return Error{
        "does not fit into the memory that is left; close other programs, or build a smaller library",
        file.string()};
  }
}

}  // namespace abrazo
