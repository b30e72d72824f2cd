#include "core/library/feature_tree.hpp"

#include <Eigen/Eigenvalues>

#include <cmath>
#include <numeric>
#include <thread>

namespace abrazo {

namespace {

constexpr std::size_t sample_rows = 16384;     ///< enough for the directions in which poses differ
constexpr std::size_t split_sample_rows = 64;  ///< enough to see along which axis a node is longest
constexpr std::size_t rows_worth_a_thread = 50'000;

std::size_t stride_for(std::size_t rows, std::size_t wanted) {
  return std::max<std::size_t>(1, rows / wanted);
}

}  // namespace

/// Splits rows in halves along the axis where they lie widest apart. Which place a node or a leaf has follows
/// from the numbers of rows alone, so that halves can be built at the same time.
struct FeatureTree::Builder {
  struct Key {
    float value;
    std::int32_t row;
  };

  FeatureTree& tree;
  std::vector<Point> points;  ///< of `features`, on the axes
  std::vector<Key> keys;

  std::size_t leaf_count(std::size_t rows) const { return (rows + leaf_rows - 1) / leaf_rows; }

  int widest_axis(std::size_t begin, std::size_t end) const {
    Point low = points[static_cast<std::size_t>(keys[begin].row)], high = low;
    for (std::size_t i = begin; i < end; i += stride_for(end - begin, split_sample_rows)) {
      const Point& point = points[static_cast<std::size_t>(keys[i].row)];
      low = low.min(point);
      high = high.max(point);
    }
    int axis = 0;
    (high - low).maxCoeff(&axis);
    return axis;
  }

  void build(std::size_t node, std::size_t begin, std::size_t end, int threads) {
    const std::size_t leaves = leaf_count(end - begin);
    if (leaves <= 1) return build_leaf(node, begin, end);
    const int axis = widest_axis(begin, end);
    for (std::size_t i = begin; i < end; ++i)
      keys[i].value = points[static_cast<std::size_t>(keys[i].row)](axis);
    const std::size_t left_leaves = leaves / 2, middle = begin + left_leaves * leaf_rows;
    const auto at = [&](std::size_t i) { return keys.begin() + static_cast<std::ptrdiff_t>(i); };
    // Equal values by row: which rows stand together must not depend on how they were shuffled before.
    std::nth_element(at(begin), at(middle), at(end), [](const Key& a, const Key& b) {
      return a.value != b.value ? a.value < b.value : a.row < b.row;
    });
    const std::size_t left = node + 1, right = node + 2 * left_leaves;
    if (threads > 1 && end - begin > rows_worth_a_thread) {
      const std::jthread other([=, this] { build(left, begin, middle, threads / 2); });
      build(right, middle, end, threads - threads / 2);
    } else {
      build(left, begin, middle, 1);
      build(right, middle, end, 1);
    }
    join(node, left, right);
  }

  void join(std::size_t node, std::size_t left, std::size_t right) {
    Node& joined = tree.nodes_[node];
    joined.low = tree.nodes_[left].low.min(tree.nodes_[right].low);
    joined.high = tree.nodes_[left].high.max(tree.nodes_[right].high);
    joined.right = static_cast<std::int32_t>(right);
  }

  void build_leaf(std::size_t node, std::size_t begin, std::size_t end) {
    const std::size_t number = begin / leaf_rows;
    Leaf& leaf = tree.leaves_[number];
    leaf.setZero();
    Node& holder = tree.nodes_[node];
    holder.leaf = static_cast<std::int32_t>(number);
    holder.low = holder.high = points[static_cast<std::size_t>(keys[begin].row)];
    for (std::size_t i = begin; i < end; ++i) {
      const Point& point = points[static_cast<std::size_t>(keys[i].row)];
      leaf.row(static_cast<Eigen::Index>(i - begin)) = point.head<dimensions - 1>().transpose();
      holder.low = holder.low.min(point);
      holder.high = holder.high.max(point);
      tree.rows_[i] = keys[i].row;
    }
  }
};

FeatureTree::FeatureTree(std::span<const Features> features) {
  if (features.empty()) return;
  const std::size_t stride = stride_for(features.size(), sample_rows);
  std::size_t samples = 0;
  for (std::size_t i = 0; i < features.size(); i += stride, ++samples) centre_ += features[i];
  centre_ /= static_cast<double>(samples);
  Eigen::Matrix<double, 15, 15> spread = Eigen::Matrix<double, 15, 15>::Zero();
  for (std::size_t i = 0; i < features.size(); i += stride)
    spread += (features[i] - centre_) * (features[i] - centre_).transpose();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, 15, 15>> principal(spread);
  // Longest axis first. Features that are no lengths of a body (1e200) have no axes: as they are, then.
  if (principal.info() == Eigen::Success && principal.eigenvectors().allFinite())
    axes_ = principal.eigenvectors().rowwise().reverse().transpose();

  Builder builder{*this, {}, {}};
  builder.points.resize(features.size());
  builder.keys.resize(features.size());
  for (std::size_t i = 0; i < features.size(); ++i) {
    builder.points[i] = on_axes(features[i]);
    if (!builder.points[i].isFinite().all()) {
      // No single precision holds it: nothing is ruled out then, and the asker's distances decide.
      builder.points[i].setZero();
      extent_m_ = std::numeric_limits<double>::infinity();
    }
    builder.keys[i] = {0, static_cast<std::int32_t>(i)};
    extent_m_ = std::max(extent_m_, static_cast<double>(builder.points[i].abs().maxCoeff()));
  }
  rows_.resize(features.size());
  leaves_.resize(builder.leaf_count(features.size()));
  nodes_.resize(2 * leaves_.size() - 1);
  builder.build(0, 0, features.size(), static_cast<int>(std::max(1U, std::thread::hardware_concurrency())));
}

FeatureTree::Point FeatureTree::on_axes(const Features& features) const {
  Point point;
  point.head<15>() = (axes_ * (features - centre_)).cast<float>().array();
  point(15) = 0;
  return point;
}

double FeatureTree::slack_for(const Features& query) const {
  // Each coordinate of both points was rounded to 24 bits, and turned with errors of the double's.
  const double largest = std::max(extent_m_, (query - centre_).cwiseAbs().sum());
  constexpr auto rounding = static_cast<double>(std::numeric_limits<float>::epsilon());
  return 4 * std::sqrt(15.0) * rounding * largest;
}

void FeatureTree::Reach::shrink_to(double distance) {
  constexpr double sum_of_squares_error = 1e-5;  // 15 additions in single precision, tenfold
  const double reached = distance + slack_;
  limit_ = static_cast<float>(reached * reached * (1 + sum_of_squares_error));
}

}  // namespace abrazo
