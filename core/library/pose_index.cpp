#include "core/library/pose_index.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>

#include "core/library/feature_tree.hpp"

namespace abrazo {

namespace {

bool nearer(const PoseMatch& a, const PoseMatch& b) {
  return a.distance != b.distance ? a.distance < b.distance : a.pair < b.pair;
}

/// Puts a match in its place among the nearest so far, unless `count` are nearer.
void add_match(const PoseMatch& match, std::size_t count, std::vector<PoseMatch>& nearest) {
  if (nearest.size() == count) {
    if (!nearer(match, nearest.back())) return;
    nearest.pop_back();
  }
  nearest.insert(std::upper_bound(nearest.begin(), nearest.end(), match, nearer), match);
}

}  // namespace

struct PoseIndex::Tree {
  FeatureTree tree;
  std::vector<int> pairs;          ///< in the order of the tree's places
  std::vector<Features> features;  ///< of `pairs`, in their order
};

PoseIndex::PoseIndex(std::span<const Features> features, std::span<const int> pairs)
    : tree_(std::make_unique<Tree>()) {
  std::vector<Features> found;
  found.reserve(pairs.size());
  for (const int pair : pairs) {
    if (pair < 0 || static_cast<std::size_t>(pair) >= features.size())
      throw std::invalid_argument("no features for pair " + std::to_string(pair));
    found.push_back(features[static_cast<std::size_t>(pair)]);
    if (!found.back().allFinite())
      throw std::invalid_argument("features of pair " + std::to_string(pair) + " are not finite");
  }
  tree_->tree = FeatureTree(found);
  tree_->pairs.reserve(pairs.size());
  tree_->features.reserve(pairs.size());
  for (const std::int32_t row : tree_->tree.rows()) {
    tree_->pairs.push_back(pairs[static_cast<std::size_t>(row)]);
    tree_->features.push_back(found[static_cast<std::size_t>(row)]);
  }
}

PoseIndex::~PoseIndex() = default;
PoseIndex::PoseIndex(PoseIndex&&) noexcept = default;
PoseIndex& PoseIndex::operator=(PoseIndex&&) noexcept = default;

int PoseIndex::size() const {
  return static_cast<int>(tree_->pairs.size());
}

template <typename IsLeftOut>
void PoseIndex::search(const Features& query, int count, const IsLeftOut& is_left_out,
                       std::vector<PoseMatch>& matches) const {
  if (!query.allFinite()) throw std::invalid_argument("the query's features are not finite");
  matches.clear();
  const auto wanted = static_cast<std::size_t>(std::clamp(count, 0, size()));
  if (wanted == 0) return;
  matches.reserve(wanted);
  tree_->tree.search(query, [&](std::size_t place, FeatureTree::Reach& reach) {
    const int pair = tree_->pairs[place];
    if (is_left_out(pair)) return;
    // The tree only rounds; distances must not depend on it.
    add_match({pair, (tree_->features[place] - query).norm()}, wanted, matches);
    if (matches.size() == wanted) reach.shrink_to(matches.back().distance);
  });
}

void PoseIndex::nearest(const Features& query, int count, std::vector<PoseMatch>& matches) const {
  search(
      query, count, [](int) { return false; }, matches);
}

void PoseIndex::nearest_without(const std::vector<bool>& left_out, const Features& query, int count,
                                std::vector<PoseMatch>& matches) const {
  search(
      query, count, [&](int pair) { return left_out[static_cast<std::size_t>(pair)]; }, matches);
}

}  // namespace abrazo
