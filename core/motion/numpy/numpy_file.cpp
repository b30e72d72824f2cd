#include "core/motion/numpy/numpy_file.hpp"

#include <algorithm>
#include <cmath>

#include "core/base/available_memory.hpp"
#include "core/base/limits.hpp"
#include "core/motion/joints/performers.hpp"

namespace abrazo {

Result<NumpyFile> NumpyFile::open(std::string_view bytes, std::string_view where) {
  NumpyFile file;
  file.bytes_ = bytes;
  file.where_ = where;
  if (!bytes.starts_with("PK")) {
    auto layout = parse_npy_header(bytes.substr(0, npy_header_most), where);
    if (!layout) return layout.error();
    file.arrays_.push_back({"", std::move(*layout)});
    return file;
  }
  auto archive = ZipArchive::open(bytes, where);
  if (!archive) return archive.error();
  file.archive_ = std::move(*archive);
  for (const ZipEntry& entry : file.archive_->entries()) {
    if (!entry.name.ends_with(".npy")) continue;
    StoredArray array{entry.name.substr(0, entry.name.size() - 4), {}, &entry};
    const auto head = file.archive_->beginning_of(entry, npy_header_most);
    if (!head) return head.error();
    auto layout = parse_npy_header(*head, file.place(array));
    if (layout)
      array.layout = std::move(*layout);
    else
      array.trouble = layout.error();
    file.arrays_.push_back(std::move(array));
  }
  if (file.arrays_.empty())
    return Error{"holds no arrays; expected positions (frames, joints, 3) in a .npy inside", file.where_};
  return file;
}

std::string NumpyFile::listed(std::size_t most) const {
  std::vector<std::string> names;
  for (const StoredArray& array : arrays_) names.push_back(array.described());
  return some_of(names, most);
}

Result<std::string> NumpyFile::content_of(const StoredArray& array) const {
  if (array.trouble) return *array.trouble;
  const std::uint64_t needed = array.layout.bytes();
  const std::uint64_t there = array.entry ? array.entry->size : bytes_.size();
  if (there < needed)
    return Error{"announces " + array.layout.shape_text() + " elements of " +
                     std::to_string(array.layout.item_bytes) + " bytes and holds " +
                     std::to_string(there - std::min<std::uint64_t>(there, array.layout.header_bytes)) +
                     " bytes of them; it is cut off, or its header is damaged",
                 place(array)};
  const std::uint64_t most = array.layout.is_number() ? limits::numpy_numbers : limits::numpy_texts;
  if (array.layout.count() > most)
    return Error{"has the shape " + array.layout.shape_text() + ", " + std::to_string(array.layout.count()) +
                     (array.layout.is_number() ? " numbers" : " texts") + "; up to " + std::to_string(most) +
                     " are read. Write fewer frames at once",
                 place(array)};
  if (there > limits::npy_file_bytes)
    return Error{"takes " + std::to_string(there >> 20U) + " MiB; arrays of up to " +
                     std::to_string(limits::npy_file_bytes >> 20U) + " MiB are read",
                 place(array)};
  // What is inflated, and the doubles that come of it.
  const std::uint64_t free = available_memory_bytes(), wanted = there + array.layout.count() * sizeof(double);
  if (wanted > free / 2)
    return Error{"would take " + std::to_string(wanted >> 20U) + " MiB, and " + std::to_string(free >> 20U) +
                     " MiB of memory are free; write fewer frames at once",
                 place(array)};
  if (!array.entry) return std::string(bytes_);
  return archive_->content_of(*array.entry);
}

Result<std::optional<double>> number_in(const NumpyFile& file, std::initializer_list<std::string_view> names,
                                        std::string_view what) {
  const StoredArray* array = file.find(names);
  if (!array) return std::optional<double>();
  const Error expected{"expected " + std::string(what) + ": one number above 0", file.place(*array)};
  if (array->trouble) return *array->trouble;
  if (!array->layout.is_number() || array->layout.count() != 1) return expected;
  const auto content = file.content_of(*array);
  if (!content) return content.error();
  const double value = NpyArray(array->layout, *content).number(0);
  if (!std::isfinite(value) || value <= 0) return expected;
  return std::optional<double>(value);
}

Result<std::vector<std::string>> texts_in(const NumpyFile& file, const StoredArray& array) {
  const auto content = file.content_of(array);
  if (!content) return content.error();
  const NpyArray texts(array.layout, *content);
  std::vector<std::string> values;
  for (std::uint64_t i = 0; i < array.layout.count(); ++i) values.push_back(texts.text(i));
  return values;
}

}  // namespace abrazo
