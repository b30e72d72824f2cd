#pragma once

#include <bit>
#include <cstdint>
#include <cstdio>
#include <string>
#include <vector>

#include "core/base/positions.hpp"
#include "core/motion/joints/joint_order.hpp"
#include "core/motion/numpy/zip_archive.hpp"

namespace abrazo::test {

/// A .npy of any of the layouts that NumPy writes, byte by byte.
struct NpyBytes {
  std::string type = "<f8";
  bool column_order = false;
  std::vector<std::uint64_t> shape;
  int version = 1;

  /// @param values  in C order, whatever the file's is
  std::string of(const std::vector<double>& values) const {
    std::string dimensions;
    for (const std::uint64_t length : shape) dimensions += std::to_string(length) + ",";
    std::string header = "{'descr': '" + type + "', 'fortran_order': " + (column_order ? "True" : "False") +
                         ", 'shape': (" + dimensions + "), }\n";
    std::string file = "\x93NUMPY";
    file += static_cast<char>(version);
    file += '\0';
    for (int byte = 0; byte < (version == 1 ? 2 : 4); ++byte)
      file += static_cast<char>(header.size() >> (8 * byte) & 0xffU);
    file += header;
    for (std::size_t i = 0; i < values.size(); ++i) file += bytes_of(values[column_order ? c_index(i) : i]);
    return file;
  }

 private:
  /// Of the i-th element in the file.
  std::size_t c_index(std::size_t i) const {
    std::size_t index = 0;
    for (const std::uint64_t length : shape) {
      index = index * length + i % length;
      i /= length;
    }
    return index;
  }
  std::string bytes_of(double value) const {
    std::string bytes;
    const bool is_double = type.back() == '8';
    const std::uint64_t bits = type[1] == 'i' ? static_cast<std::uint64_t>(static_cast<std::int64_t>(value))
                               : is_double    ? std::bit_cast<std::uint64_t>(value)
                                              : std::bit_cast<std::uint32_t>(static_cast<float>(value));
    const int count = type.back() - '0';
    for (int byte = 0; byte < count; ++byte) {
      const int place = type[0] == '>' ? count - 1 - byte : byte;
      bytes += static_cast<char>(bits >> (8 * place) & 0xffU);
    }
    return bytes;
  }
};

/// Positions of one body in the order of a file.
inline std::vector<double> in_c_order(const std::vector<Pose>& poses) {
  std::vector<double> values;
  for (const Pose& pose : poses)
    for (int j = 0; j < joint_count; ++j)
      for (int axis = 0; axis < 3; ++axis) values.push_back(pose(j, axis));
  return values;
}

}  // namespace abrazo::test
