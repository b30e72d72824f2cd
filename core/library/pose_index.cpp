#include "core/library/pose_index.hpp"

#include <algorithm>
#include <flann/flann.hpp>
#include <limits>
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

/// The nearest rows so far, without those left out: they never narrow the search, so it stays exact.
class NearestWithout : public flann::ResultSet<double> {
 public:
  struct Row {
    double square;
    std::size_t row;
    bool operator<(const Row& other) const { return square < other.square; }
  };

  NearestWithout(const std::vector<bool>& left_out, const std::vector<int>& pairs, std::size_t count,
                 std::vector<Row>& rows)
      : left_out_(left_out), pairs_(pairs), count_(count), rows_(rows) {
    rows_.clear();
  }

  bool full() const override { return rows_.size() >= count_; }
  double worstDist() const override {
    return full() ? rows_.back().square : std::numeric_limits<double>::max();
  }
  void addPoint(double square, std::size_t row) override {
    if (square >= worstDist() || left_out_[static_cast<std::size_t>(pairs_[row])]) return;
    if (full()) rows_.pop_back();
    const Row added{square, row};
    rows_.insert(std::upper_bound(rows_.begin(), rows_.end(), added), added);
  }

 private:
  const std::vector<bool>& left_out_;
  const std::vector<int>& pairs_;
  std::size_t count_;
  std::vector<Row>& rows_;
};

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
  for (std::size_t i = 0; i < static_cast<std::size_t>(found); ++i) matches.push_back(match(rows[i], query));
  std::sort(matches.begin(), matches.end(), nearer);
}

void PoseIndex::nearest_without(const std::vector<bool>& left_out, const Features& query, int count,
                                std::vector<PoseMatch>& matches) const {
  if (!query.allFinite()) throw std::invalid_argument("the query's features are not finite");
  matches.clear();
  const auto wanted = static_cast<std::size_t>(std::clamp(count, 0, size()));
  if (wanted == 0) return;
  thread_local std::vector<NearestWithout::Row> rows;
  NearestWithout nearest(left_out, tree_->pairs, wanted, rows);
  static const flann::SearchParams search = exact_search();
  tree_->tree->findNeighbors(nearest, query.data(), search);
  for (const NearestWithout::Row& row : rows) matches.push_back(match(row.row, query));
  std::sort(matches.begin(), matches.end(), nearer);
}

PoseMatch PoseIndex::match(std::size_t row, const Features& query) const {
  // FLANN sums up squares in another order; distances must not depend on the tree.
  return {tree_->pairs[row], (tree_->features[row] - query).norm()};
}

}  // namespace abrazo
