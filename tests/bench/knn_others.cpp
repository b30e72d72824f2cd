// Compiled for this very processor (see CMakeLists.txt).
#include "tests/bench/knn_others.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <nanoflann.hpp>

namespace abrazo::bench {

namespace {

bool nearer(const Neighbour& a, const Neighbour& b) {
  return a.square != b.square ? a.square < b.square : a.row < b.row;
}

template <typename Number>
class BruteForce : public OtherSearch {
 public:
  explicit BruteForce(std::span<const double> features) : count_(features.size() / feature_count) {
    const std::size_t blocks = (count_ + block - 1) / block;
    columns_.assign(blocks * block * feature_count, Number(1e15));
    for (std::size_t row = 0; row < count_; ++row)
      for (std::size_t f = 0; f < feature_count; ++f)
        columns_[(row / block * feature_count + f) * block + row % block] =
            static_cast<Number>(features[row * feature_count + f]);
  }

  void nearest(const double* query, int count, std::vector<Neighbour>& found) override {
    found.clear();
    const auto wanted = std::min(static_cast<std::size_t>(count), count_);
    Number limit = std::numeric_limits<Number>::max();
    for (std::size_t first = 0; first < count_; first += block) {
      distances(query, first);
      const std::size_t rows = std::min(block, count_ - first);
      for (std::size_t part = 0; part < rows; part += lane_group) {
        // Most groups have nobody near: one vectorised minimum tells.
        Number least = squares_[part];
        for (std::size_t i = 1; i < lane_group; ++i) least = std::min(least, squares_[part + i]);
        if (!(least < limit)) continue;
        for (std::size_t i = part; i < std::min(part + lane_group, rows); ++i) {
          if (!(squares_[i] < limit)) continue;
          found.push_back({static_cast<double>(squares_[i]), static_cast<int>(first + i)});
          std::push_heap(found.begin(), found.end(), nearer);
          if (found.size() > wanted) {
            std::pop_heap(found.begin(), found.end(), nearer);
            found.pop_back();
          }
          if (found.size() == wanted) limit = static_cast<Number>(found.front().square);
        }
      }
    }
    std::sort_heap(found.begin(), found.end(), nearer);
  }

 private:
  static constexpr std::size_t block = 512;
  static constexpr std::size_t lane_group = 32;

  void distances(const double* query, std::size_t first) {
    const Number* column = columns_.data() + first * feature_count;
    Number* const squares = squares_.data();
    std::fill_n(squares, block, Number(0));
    for (std::size_t f = 0; f < feature_count; ++f, column += block) {
      const auto wanted = static_cast<Number>(query[f]);
      for (std::size_t i = 0; i < block; ++i) {
        const Number apart = column[i] - wanted;
        squares[i] += apart * apart;
      }
    }
  }

  std::size_t count_;
  std::vector<Number> columns_;
  alignas(64) std::array<Number, block> squares_;
};

/// Rows as nanoflann asks for them.
struct Rows {
  std::vector<double> features;
  std::size_t kdtree_get_point_count() const { return features.size() / feature_count; }
  double kdtree_get_pt(std::size_t row, std::size_t dimension) const {
    return features[row * feature_count + dimension];
  }
  template <typename Box>
  bool kdtree_get_bbox(Box&) const {
    return false;
  }
};

class NanoflannSearch : public OtherSearch {
 public:
  NanoflannSearch(std::span<const double> features, int leaf_size)
      : rows_{{features.begin(), features.end()}},
        tree_(feature_count, rows_,
              nanoflann::KDTreeSingleIndexAdaptorParams(static_cast<std::size_t>(leaf_size))) {}

  void nearest(const double* query, int count, std::vector<Neighbour>& found) override {
    const auto wanted = static_cast<std::size_t>(count);
    numbers_.resize(wanted);
    squares_.resize(wanted);
    const std::size_t size = tree_.knnSearch(query, wanted, numbers_.data(), squares_.data());
    found.clear();
    for (std::size_t i = 0; i < size; ++i) found.push_back({squares_[i], static_cast<int>(numbers_[i])});
  }

 private:
  using Tree = nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<double, Rows>, Rows,
                                                   feature_count, std::uint32_t>;
  Rows rows_;
  Tree tree_;
  std::vector<std::uint32_t> numbers_;
  std::vector<double> squares_;
};

}  // namespace

std::unique_ptr<OtherSearch> brute_force_double(std::span<const double> features) {
  return std::make_unique<BruteForce<double>>(features);
}

std::unique_ptr<OtherSearch> brute_force_single(std::span<const double> features) {
  return std::make_unique<BruteForce<float>>(features);
}

std::unique_ptr<OtherSearch> nanoflann_search(std::span<const double> features, int leaf_size) {
  return std::make_unique<NanoflannSearch>(features, leaf_size);
}

}  // namespace abrazo::bench
