#include "core/library/pose_index.hpp"

#include <algorithm>
#include <flann/flann.hpp>
#include <stdexcept>

namespace abrazo {

namespace {

using FlannTree = flann::KDTreeSingleIndex<flann::L2<double>>;
constexpr int leaf_size = 12;  ///< 10 to 15 answer fastest on dance poses

flann::SearchParams exact_search() {
  flann::SearchParams params(flann::FLANN_CHECKS_UNLIMITED, 0.0F, false);
  params.use_heap = flann::FLANN_True;
  params.cores = 1;
  return params;
}

bool nearer(const PoseMatch& a, const PoseMatch& b) {
  return a.distance != b.distance ? a.distance < b.distance : a.pair < b.pair;
}

}  // namespace

struct PoseIndex::Tree {
  std::vector<int> pairs;
  std::vector<Features> features;   ///< of `pairs`, in their order
  std::unique_ptr<FlannTree> tree;  ///< null when there is nothing to find
};

PoseIndex::PoseIndex(std::span<const Features> features, std::span<const int> pairs)
    : tree_(std::make_unique<Tree>()) {
  tree_->pairs.assign(pairs.begin(), pairs.end());
  tree_->features.reserve(pairs.size());
  for (const int pair : pairs) {
    if (pair < 0 || static_cast<std::size_t>(pair) >= features.size())
      throw std::invalid_argument("no features for pair " + std::to_string(pair));
    tree_->features.push_back(features[static_cast<std::size_t>(pair)]);
    if (!tree_->features.back().allFinite())
      throw std::invalid_argument("features of pair " + std::to_string(pair) + " are not finite");
  }
  if (pairs.empty()) return;
  const flann::Matrix<double> rows(tree_->features.front().data(), tree_->features.size(),
                                   Features::RowsAtCompileTime);
  tree_->tree = std::make_unique<FlannTree>(rows, flann::KDTreeSingleIndexParams(leaf_size));
  tree_->tree->buildIndex();
}

PoseIndex::~PoseIndex() = default;
PoseIndex::PoseIndex(PoseIndex&&) noexcept = default;
PoseIndex& PoseIndex::operator=(PoseIndex&&) noexcept = default;

int PoseIndex::size() const {
  return static_cast<int>(tree_->pairs.size());
}

void PoseIndex::nearest(const Features& query, int count, std::vector<PoseMatch>& matches) const {
  if (!query.allFinite()) throw std::invalid_argument("the query's features are not finite");
  matches.clear();
  const auto wanted = static_cast<std::size_t>(std::clamp(count, 0, size()));
  if (wanted == 0) return;
  static const flann::SearchParams search = exact_search();
  thread_local std::vector<std::size_t> rows;
  thread_local std::vector<double> squares;
  rows.resize(std::max(rows.size(), wanted));
  squares.resize(std::max(squares.size(), wanted));
  Features copy = query;  // FLANN takes what it only reads by a pointer to non-const
  const flann::Matrix<double> queries(copy.data(), 1, Features::RowsAtCompileTime);
  flann::Matrix<std::size_t> row_matrix(rows.data(), 1, wanted);
  flann::Matrix<double> square_matrix(squares.data(), 1, wanted);
  const int found = tree_->tree->knnSearch(queries, row_matrix, square_matrix, wanted, search);
  for (std::size_t i = 0; i < static_cast<std::size_t>(found); ++i) {
    // FLANN sums up squares in another order; distances must not depend on the tree.
    matches.push_back({tree_->pairs[rows[i]], (tree_->features[rows[i]] - query).norm()});
  }
  std::sort(matches.begin(), matches.end(), nearer);
}

}  // namespace abrazo
