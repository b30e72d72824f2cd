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

/// Exact nearest neighbours in the 15-D feature space (kd-tree, paper 3.2.2): the same for every order of the
/// pairs, whichever tree narrows the search. Keeps its own copy of the features. A search allocates nothing
/// but room in `matches`.
class PoseIndex {
 public:
  /// Who narrows a search down before distances in double precision decide.
  enum class Tree {
    Flann,  ///< FLANN's; some 240 bytes for each pair, features included
    Own     ///< ours; some 200
  };

  /// @param features  of every pair of the library
  /// @param pairs     those to be found; the others are left out of the tree
  PoseIndex(std::span<const Features> features, std::span<const int> pairs, Tree tree = Tree::Flann);
  ~PoseIndex();
  PoseIndex(PoseIndex&&) noexcept;
  PoseIndex& operator=(PoseIndex&&) noexcept;

  int size() const;

  /// The `count` nearest pairs (fewer if the index is smaller), nearest first; equal distances by pair
  /// number.
  /// @param[in,out] matches  what it holds before is looked at first and changes nothing but how long the
  /// search takes: with the answer to a query nearby, such as the frame before, half as long
  void nearest(const Features& query, int count, std::vector<PoseMatch>& matches) const;

  /// The same among those that are not left out, as exact, without another index: they are passed over while
  /// the tree is searched.
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

/// Of a library's pairs, with the tree that fits: FLANN's where the library is in memory, our own where it is
/// mapped because it does not fit.
PoseIndex pose_index_of(const MotionLibrary& library, std::span<const int> pairs);

}  // namespace abrazo
