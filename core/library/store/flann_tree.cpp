#include "core/library/store/flann_tree.hpp"

#include <flann/algorithms/kdtree_single_index.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <memory>

namespace abrazo {

namespace {

using Lengths = Eigen::Array<float, 8, 1>;  ///< seven axes, and the norm of the rest

/// A squared distance as a distinct type, because FLANN allocates vectors of it in every search
/// (std::allocator below).
struct FlannSquare {
  template <typename Number = float>
  FlannSquare(Number number = 0)
      : value(static_cast<float>(number)) {}  // NOLINT(google-explicit-constructor)
  operator float() const { return value; }    // NOLINT(google-explicit-constructor)
  FlannSquare& operator+=(FlannSquare more) {
    value += more.value;
    return *this;
  }
  template <typename Archive>
  void serialize(Archive& archive) {  // FLANN could save its index; this is not used
    archive& value;
  }
  float value;
};

/// How far two poses' lengths are apart, for FLANN.
struct LengthsApart {
  using is_kdtree_distance = bool;
  using ElementType = float;
  using ResultType = FlannSquare;

  FlannSquare operator()(const float* a, const float* b, std::size_t, FlannSquare = 0) const {
    return (Eigen::Map<const Lengths>(a) - Eigen::Map<const Lengths>(b)).square().sum();
  }
  FlannSquare accum_dist(float a, float b, int) const { return (a - b) * (a - b); }
};

}  // namespace

}  // namespace abrazo

/// Thread-local memory for the distances of one search; larger requests use the heap. A step of the
/// synthesizer must not wait for allocations of other threads.
template <>
struct std::allocator<abrazo::FlannSquare> {
  using value_type = abrazo::FlannSquare;
  using is_always_equal = std::true_type;
  using propagate_on_container_move_assignment = std::true_type;

  allocator() = default;
  template <typename Other>
  explicit allocator(const std::allocator<Other>&) {}

  value_type* allocate(std::size_t count) {
    Room& room = of_this_thread();
    if (room.is_taken || count > room.squares.size())
      return static_cast<value_type*>(::operator new(count * sizeof(value_type)));
    room.is_taken = true;
    return room.squares.data();
  }
  void deallocate(value_type* squares, std::size_t) {
    Room& room = of_this_thread();
    if (squares == room.squares.data())
      room.is_taken = false;
    else
      ::operator delete(squares);
  }
  [[maybe_unused]] friend bool operator==(const allocator&, const allocator&) { return true; }

 private:
  struct Room {
    std::array<value_type, 16> squares;
    bool is_taken = false;
  };
  static Room& of_this_thread() {
    thread_local Room room;
    return room;
  }
};

namespace abrazo {

namespace {

using FlannIndex = flann::KDTreeSingleIndex<LengthsApart>;

constexpr int flann_leaf_rows = 64;  ///< with 40 it is about as fast
constexpr Eigen::Index long_axes = Lengths::RowsAtCompileTime - 1;
constexpr Eigen::Index short_axes = FeatureAxes::dimensions - long_axes;
/// Visiting a node or row costs as much as scanning about 80 rows: stopping when all rows could have been
/// scanned takes at most about twice as long as the better of the two methods.
constexpr std::size_t rows_per_effort = 80;
/// Nodes after which a search has found its nearest but for little, also where nine of ten are vetoed.
constexpr std::size_t least_effort = 200;

Lengths lengths_of(const FeatureAxes::Point& point) {
  Lengths lengths;
  lengths << point.head<long_axes>(), point.tail<short_axes>().matrix().norm();
  return lengths;
}

/// FLANN's result set: gives the radius and receives visited rows. FLANN sums the contributions of at most
/// about 1200 splits (a split halves the rows, or one of eight coordinates, which have 150 halves), each with
/// three roundings of 6e-8: at most 3e-4 of a squared distance.
class Narrowing final : public flann::ResultSet<FlannSquare> {
 public:
  /// @param rows  of the tree
  /// @param far  squared distance from which on it is better to read all rows
  Narrowing(SearchReach& reach, PlaceJudge& judge, std::size_t rows, float far)
      : reach_(reach), judge_(judge), most_effort_(least_effort + rows / rows_per_effort), far_(far) {}

  bool full() const override { return true; }
  /// Nothing is nearer than less than nothing: so FLANN stops.
  FlannSquare worstDist() const override {
    ++effort_;
    return was_too_much() ? -1.0F : reach_.limit();
  }
  void addPoint(FlannSquare, std::size_t place) override {
    ++effort_;
    judge_.look_at(place, reach_);
  }
  bool was_too_much() const {
    return effort_ > most_effort_ || (effort_ > least_effort && reach_.limit() > far_);
  }

 private:
  SearchReach& reach_;
  PlaceJudge& judge_;
  std::size_t most_effort_;
  float far_;
  mutable std::size_t effort_ = 0;
};

/// The order in which a search without an end comes by the rows: leaf by leaf.
class LeafOrder final : public flann::ResultSet<FlannSquare> {
 public:
  explicit LeafOrder(std::vector<std::int32_t>& rows) : rows_(rows) {}
  bool full() const override { return false; }
  FlannSquare worstDist() const override { return std::numeric_limits<float>::max(); }
  void addPoint(FlannSquare, std::size_t row) override { rows_.push_back(static_cast<std::int32_t>(row)); }

 private:
  std::vector<std::int32_t>& rows_;
};

const flann::SearchParams& exact_search() {
  static const flann::SearchParams params(flann::FLANN_CHECKS_UNLIMITED, 0.0F, false);
  return params;
}

}  // namespace

struct FlannTree::Index {
  static constexpr std::size_t block_rows = 16;
  using Block = Eigen::Array<float, block_rows, Lengths::RowsAtCompileTime>;  ///< rows side by side
  using ShortAxes = Eigen::Array<float, block_rows, short_axes>;

  std::vector<std::int32_t> rows;
  std::unique_ptr<FlannIndex> tree;
  std::vector<Block> blocks;  ///< the same once more, for reading them all
  std::vector<ShortAxes> short_blocks;
  /// Mean square distance of rows from their mean. Who has no row nearer than that has most leaves within
  /// reach.
  float far = 0;

  /// FLANN keeps a copy, leaf by leaf, and uses `lengths` only while building.
  void build_tree(std::vector<Lengths>& lengths) {
    const flann::Matrix<float> matrix(lengths.front().data(), lengths.size(), Lengths::RowsAtCompileTime);
    tree = std::make_unique<FlannIndex>(matrix, flann::KDTreeSingleIndexParams(flann_leaf_rows, true));
    tree->buildIndex();
  }

  void set_row(std::size_t place, const FeatureAxes::Point& point) {
    const auto in_block = static_cast<Eigen::Index>(place % block_rows);
    blocks[place / block_rows].row(in_block) = lengths_of(point).transpose();
    short_blocks[place / block_rows].row(in_block) = point.tail<short_axes>().transpose();
  }

  void read_all(const FeatureAxes::Point& query, SearchReach& reach, PlaceJudge& judge) const;
};

FlannTree::FlannTree(const FeatureAxes& axes, std::span<const Features> features)
    : index_(std::make_unique<Index>()) {
  if (features.empty()) return;
  std::vector<FeatureAxes::Point> points;
  points.reserve(features.size());
  for (const Features& one : features) points.push_back(axes.of(one));
  // Built twice: the second time with rows in the order of the first tree's leaves, so that rows visited
  // together are adjacent.
  std::vector<Lengths> lengths;
  lengths.reserve(points.size());
  for (const FeatureAxes::Point& point : points) lengths.push_back(lengths_of(point));
  index_->build_tree(lengths);
  index_->rows.reserve(points.size());
  LeafOrder order(index_->rows);
  const Lengths centre = Lengths::Zero();
  index_->tree->findNeighbors(order, centre.data(), exact_search());
  index_->blocks.resize((points.size() + Index::block_rows - 1) / Index::block_rows, Index::Block::Zero());
  index_->short_blocks.resize(index_->blocks.size(), Index::ShortAxes::Zero());
  for (std::size_t place = 0; place < points.size(); ++place) {
    const FeatureAxes::Point& point = points[static_cast<std::size_t>(index_->rows[place])];
    lengths[place] = lengths_of(point);
    index_->set_row(place, point);
  }
  index_->build_tree(lengths);
  double squares = 0;
  for (const FeatureAxes::Point& point : points) squares += static_cast<double>(point.square().sum());
  index_->far = static_cast<float>(squares / static_cast<double>(points.size()));
}

FlannTree::~FlannTree() = default;
FlannTree::FlannTree(FlannTree&&) noexcept = default;
FlannTree& FlannTree::operator=(FlannTree&&) noexcept = default;

const std::vector<std::int32_t>& FlannTree::rows() const {
  return index_->rows;
}

void FlannTree::search(const FeatureAxes::Point& query, SearchReach& reach, PlaceJudge& judge) const {
  if (!index_->tree) return;
  const Lengths lengths = lengths_of(query);
  Narrowing narrowing(reach, judge, index_->rows.size(), index_->far);
  index_->tree->findNeighbors(narrowing, lengths.data(), exact_search());
  if (!narrowing.was_too_much()) return;
  judge.start_again();
  index_->read_all(query, reach, judge);
}

void FlannTree::Index::read_all(const FeatureAxes::Point& query, SearchReach& reach,
                                PlaceJudge& judge) const {
  using Squares = Eigen::Array<float, block_rows, 1>;
  const Lengths wanted = lengths_of(query);
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    const Block& block = blocks[b];
    Squares squares = (block.col(0) - wanted(0)).square();
    for (Eigen::Index axis = 1; axis < long_axes; ++axis)
      squares += (block.col(axis) - wanted(axis)).square();
    const Squares least = squares + (block.col(long_axes) - wanted(long_axes)).square();
    if (least.minCoeff() > reach.limit()) continue;
    const ShortAxes& rest = short_blocks[b];
    for (Eigen::Index axis = 0; axis < short_axes; ++axis)
      squares += (rest.col(axis) - query(long_axes + axis)).square();
    const std::size_t first = b * block_rows, held = std::min(block_rows, rows.size() - first);
    for (std::size_t i = 0; i < held; ++i)
      if (!(squares(static_cast<Eigen::Index>(i)) > reach.limit())) judge.look_at(first + i, reach);
  }
}

}  // namespace abrazo
