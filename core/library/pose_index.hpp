#pragma once

#include <memory>
#include <span>
#include <vector>

#include "core/library/normalization.hpp"

namespace abrazo {

/// A pair of the library near a query.
struct PoseMatch {
  int pair = -1;
  double distance = 0;  ///< Euclidean distance of the features [m]
};

/// Exact nearest neighbours in the 15-D feature space (kd-tree, paper 3.2.2): the same for every order of the
/// pairs. Keeps its own copy of the features. A search allocates nothing but room in `matches`.
class PoseIndex {
 public:
  /// @param features  of every pair of the library
  /// @param pairs     those to be found; the others are left out of the tree
  PoseIndex(std::span<const Features> features, std::span<const int> pairs);
  ~PoseIndex();
  PoseIndex(PoseIndex&&) noexcept;
  PoseIndex& operator=(PoseIndex&&) noexcept;

  int size() const;

  /// The `count` nearest pairs (fewer if the index is smaller), nearest first; equal distances by pair
  /// number.
  void nearest(const Features& query, int count, std::vector<PoseMatch>& matches) const;

  /// The same among those that are not left out, as exact, without another index: they are passed over while
  /// the tree is searched.
  /// @param left_out  by pair number
  void nearest_without(const std::vector<bool>& left_out, const Features& query, int count,
                       std::vector<PoseMatch>& matches) const;

 private:
  struct Tree;
  template <typename IsLeftOut>
  void search(const Features& query, int count, const IsLeftOut& is_left_out,
              std::vector<PoseMatch>& matches) const;
  std::unique_ptr<Tree> tree_;
};

}  // namespace abrazo
