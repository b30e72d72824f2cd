#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

namespace abrazo::bench {

inline constexpr int feature_count = 15;

struct Neighbour {
  double square = 0;  ///< squared distance [m^2]
  int row = -1;
};

/// The others' nearest neighbours. Plain numbers: they are compiled for this very processor, which must not
/// touch types of the library.
class OtherSearch {
 public:
  virtual ~OtherSearch() = default;
  /// @param query  15 numbers  @param[out] found  `count` nearest, nearest first
  virtual void nearest(const double* query, int count, std::vector<Neighbour>& found) = 0;
};

/// Every distance, vectorised: features by column in blocks that stay in the first cache, the best so far in
/// a heap of `count`. In single precision distances are off by 1e-7 m and more: half the memory to read.
/// @param features  n x 15, row by row
std::unique_ptr<OtherSearch> brute_force_double(std::span<const double> features);
std::unique_ptr<OtherSearch> brute_force_single(std::span<const double> features);

/// nanoflann's kd-tree, double precision.
std::unique_ptr<OtherSearch> nanoflann_search(std::span<const double> features, int leaf_size);

}  // namespace abrazo::bench
