#pragma once

#include <memory>
#include <span>
#include <vector>

#include "core/library/store/motion_library.hpp"
#include "core/library/store/normalization.hpp"

namespace abrazo {

/// A pair of the library near a query.
struct PoseMatch {
  int pair = -1;
  double distance = 0;  ///< Euclidean distance of the features [m]
};

/// Exact nearest neighbours in the 15-D feature space (kd-tree, paper 3.2.2): the result does not depend on
/// the order of the pairs or the tree. Keeps a copy of the features. A search allocates only in `matches`.
class PoseIndex {
 public:
  /// The tree that narrows a search down before distances in double precision decide.
  enum class Tree {
    Flann,  ///< FLANN's; about 240 bytes per pair, with features
    Own     ///< FeatureTree; about 200
  };

  /// @param features  of every pair of the library
  /// @param pairs the searchable pairs; others are not in the tree
  PoseIndex(std::span<const Features> features, std::span<const int> pairs, Tree tree = Tree::Flann);
  ~PoseIndex();
  PoseIndex(PoseIndex&&) noexcept;
  PoseIndex& operator=(PoseIndex&&) noexcept;

  int size() const;

  /// The `count` nearest pairs (fewer if the index is smaller), nearest first; equal distances by pair
  /// number.
  /// @param[in,out] matches previous content is examined first; it affects only the search time, which halves
  /// with the answer to a nearby query such as the previous frame
  void nearest(const Features& query, int count, std::vector<PoseMatch>& matches) const;

  /// The same, but skips pairs that are left out during the search; also exact.
  /// @param left_out  by pair number
  void nearest_without(const std::vector<bool>& left_out, const Features& query, int count,
                       std::vector<PoseMatch>& matches) const;

 private:
  struct Contents;
  template <typename IsLeftOut>
  void search(const Features& query, int count, const IsLeftOut& is_left_out,
              std::vector<PoseMatch>& matches) const;
  std::unique_ptr<Contents> contents_;
};

/// An index of a library's pairs: FLANN's tree if the library is in memory, FeatureTree if it is mapped.
PoseIndex pose_index_of(const MotionLibrary& library, std::span<const int> pairs);

}  // namespace abrazo
