#pragma once

#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.hpp"
#include "core/motion/numpy/npy_array.hpp"
#include "core/motion/numpy/zip_archive.hpp"

namespace abrazo {

/// An array of the file. Arrays of a .npz are inflated only when they are used.
struct StoredArray {
  std::string name;  ///< empty in a .npy
  NpyLayout layout;
  const ZipEntry* entry = nullptr;
  std::optional<Error> trouble = {};  ///< why its elements cannot be read

  bool is_positions() const {
    return !trouble && layout.is_number() && layout.shape.size() == 3 && layout.shape[2] == 3;
  }
  std::string described() const {
    return (name.empty() ? "" : name + " ") + (trouble ? "(cannot be read)" : layout.shape_text());
  }
};

/// The arrays of a .npy or .npz file. The bytes must outlive it.
class NumpyFile {
 public:
  static Result<NumpyFile> open(std::string_view bytes, std::string_view where);

  const std::vector<StoredArray>& arrays() const { return arrays_; }
  const std::string& where() const { return where_; }
  const StoredArray* find(std::initializer_list<std::string_view> names) const {
    for (const std::string_view name : names)
      for (const StoredArray& array : arrays_)
        if (array.name == name) return &array;
    return nullptr;
  }
  bool has(std::string_view name) const { return find({name}) != nullptr; }
  std::string place(const StoredArray& array) const {
    return array.name.empty() ? where_ : where_ + ": " + array.name;
  }
  /// The bytes of the whole .npy; an Error if elements are missing.
  Result<std::string> content_of(const StoredArray& array) const;
  std::string listed(std::size_t most) const;

 private:
  std::string_view bytes_;
  std::string where_;
  std::optional<ZipArchive> archive_;
  std::vector<StoredArray> arrays_;
};

/// A positive number under one of these names; empty if there is none. @param what  for the Error
Result<std::optional<double>> number_in(const NumpyFile& file, std::initializer_list<std::string_view> names,
                                        std::string_view what);
Result<std::vector<std::string>> texts_in(const NumpyFile& file, const StoredArray& array);

}  // namespace abrazo
