#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <mutex>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "core/library/store/column.hpp"

namespace abrazo {

class MappedFile;

/// Thrown by the two classes below. The text can be shown; it does not name the file.
struct Hdf5Problem : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Lock for HDF5, which may be built without thread safety; also silences its output on stderr. Hold it while
/// a file is open.
class Hdf5Turn {
 public:
  Hdf5Turn();
  ~Hdf5Turn();
  Hdf5Turn(const Hdf5Turn&) = delete;
  Hdf5Turn& operator=(const Hdf5Turn&) = delete;

 private:
  std::unique_lock<std::mutex> lock_;
  int (*print_)(std::int64_t, void*) = nullptr;
  void* data_ = nullptr;
};

/// Owns an HDF5 identifier.
class Hdf5Handle {
 public:
  Hdf5Handle(std::int64_t id, int (*closer)(std::int64_t)) : id_(id), closer_(closer) {}
  Hdf5Handle(Hdf5Handle&& other) noexcept : id_(std::exchange(other.id_, -1)), closer_(other.closer_) {}
  Hdf5Handle& operator=(Hdf5Handle&&) = delete;
  ~Hdf5Handle() {
    if (id_ >= 0) closer_(id_);
  }
  std::int64_t id() const { return id_; }
  bool ok() const { return id_ >= 0; }
  /// @return false if buffered data could not be written
  bool close() { return closer_(std::exchange(id_, -1)) >= 0; }

 private:
  std::int64_t id_;
  int (*closer_)(std::int64_t);
};

/// Number types in memory and in the file (always little-endian).
enum class Hdf5Number { Float64, Unsigned64, Unsigned32, Signed32, Unsigned8 };

template <typename Number>
constexpr Hdf5Number hdf5_number() {
  if constexpr (std::is_same_v<Number, double>) return Hdf5Number::Float64;
  if constexpr (std::is_same_v<Number, std::uint64_t>) return Hdf5Number::Unsigned64;
  if constexpr (std::is_same_v<Number, std::uint32_t>) return Hdf5Number::Unsigned32;
  if constexpr (std::is_same_v<Number, int>) return Hdf5Number::Signed32;
  if constexpr (std::is_same_v<Number, std::uint8_t>) return Hdf5Number::Unsigned8;
}

using Hdf5Shape = std::vector<std::uint64_t>;
inline constexpr std::uint64_t any_size = static_cast<std::uint64_t>(-1);

/// Writes tables that can be mapped: contiguous, uncompressed, large ones page-aligned. Equal content gives
/// equal bytes.
class Hdf5Writer {
 public:
  explicit Hdf5Writer(const std::filesystem::path& path);

  void attribute(const char* name, const std::string& text);
  template <typename Number>
  void attribute(const char* name, Number value) {
    attribute(name, hdf5_number<Number>(), &value);
  }
  template <typename Number>
  void dataset(const char* path, const Hdf5Shape& shape, const Number* values) {
    dataset(path, shape, hdf5_number<Number>(), values);
  }
  template <typename Number>
  void dataset(const char* path, const std::vector<Number>& values) {
    dataset(path, {values.size()}, values.data());
  }
  void dataset(const char* path, const std::vector<std::string>& texts);
  void close();

 private:
  void attribute(const char* name, Hdf5Number number, const void* value);
  void attribute(const char* name, std::int64_t memory, std::int64_t stored, const void* value);
  void dataset(const char* path, const Hdf5Shape& shape, Hdf5Number number, const void* values);
  void dataset(const char* path, const Hdf5Shape& shape, std::int64_t memory, std::int64_t stored,
               const void* values);

  Hdf5Handle file_;
};

/// Reads tables of an untrusted or damaged file: shapes, number types and actual sizes are checked before
/// memory is allocated. No table takes more memory than the file has bytes (times eight if small numbers are
/// widened).
class Hdf5Reader {
 public:
  explicit Hdf5Reader(const std::filesystem::path& path);

  bool has_attribute(const char* name) const;
  std::string text_attribute(const char* name) const;
  template <typename Number>
  Number attribute(const char* name) const {
    Number value{};
    attribute(name, hdf5_number<Number>(), &value);
    return value;
  }

  /// A table whose rows are laid out as Row is, e.g. PairPose as 50 x 3 doubles.
  /// @param shape expected shape; the first size may be `any_size`
  template <typename Number, typename Row>
  std::vector<Row> rows(const char* path, const Hdf5Shape& shape) const {
    const Table table = open_table(path, hdf5_number<Number>(), shape);
    std::vector<Row> result(table.rows);
    read(table, path, result.data());
    return result;
  }
  template <typename Number>
  std::vector<Number> column(const char* path, std::uint64_t size = any_size) const {
    return rows<Number, Number>(path, {size});
  }
  std::vector<std::string> texts(const char* path, std::uint64_t size) const;

  /// The same as `rows`, as a view of the mapped file; read into memory if the file has another layout:
  /// chunks, other number types or unaligned data.
  /// @param mapping  null = read
  template <typename Number, typename Row>
  Column<Row> mapped_rows(const char* path, const Hdf5Shape& shape,
                          const std::shared_ptr<const MappedFile>& mapping) const {
    const Table table = open_table(path, hdf5_number<Number>(), shape);
    const void* const place = mapping ? place_in(*mapping, table, sizeof(Row), alignof(Row)) : nullptr;
    if (place != nullptr) return {std::span(static_cast<const Row*>(place), table.rows), mapping};
    std::vector<Row> result(table.rows);
    read(table, path, result.data());
    return result;
  }
  /// Size of a table in the file.
  std::uint64_t stored_bytes(const char* path) const;
  /// Mapping of the open file itself, even if its name now refers to another; null if it cannot be mapped.
  std::shared_ptr<const MappedFile> mapping() const;

 private:
  struct Table {
    Hdf5Handle set;
    Hdf5Number number;
    std::uint64_t rows;
  };

  void attribute(const char* name, Hdf5Number number, void* value) const;
  Hdf5Handle open_set(const char* path) const;
  Table open_table(const char* path, Hdf5Number number, const Hdf5Shape& shape) const;
  static void read(const Table& table, const char* path, void* to);
  static const void* place_in(const MappedFile& mapping, const Table& table, std::size_t row_bytes,
                              std::size_t alignment);

  Hdf5Handle file_;
};

}  // namespace abrazo
