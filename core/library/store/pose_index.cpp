#include "core/library/store/pose_index.hpp"

#include <algorithm>
#include <numeric>
#include <optional>
#include <stdexcept>
#include <string>

#include "core/library/store/feature_tree.hpp"
#include "core/library/store/flann_tree.hpp"

namespace abrazo {

namespace {

bool nearer(const PoseMatch& a, const PoseMatch& b) {
  return a.distance != b.distance ? a.distance < b.distance : a.pair < b.pair;
}

/// Inserts a match among the nearest so far, unless `count` are nearer.
void add_match(const PoseMatch& match, std::size_t count, std::vector<PoseMatch>& nearest) {
  if (nearest.size() == count) {
    if (!nearer(match, nearest.back())) return;
    nearest.pop_back();
  }
  nearest.insert(std::upper_bound(nearest.begin(), nearest.end(), match, nearer), match);
}

}  // namespace

struct PoseIndex::Contents {
  std::vector<int> pairs;            ///< by place, as the tree holds them
  std::vector<Features> features;    ///< by place
  std::vector<std::int32_t> places;  ///< by pair; -1 = not to be found
  FeatureAxes axes;
  std::optional<FlannTree> flann;  ///< one of the two, where axes can tell
  std::optional<FeatureTree> own;

  void take(std::span<const int> numbers, const std::vector<Features>& found,
            const std::vector<std::int32_t>& rows) {
    for (const std::int32_t row : rows) {
      places[static_cast<std::size_t>(numbers[static_cast<std::size_t>(row)])] =
          static_cast<std::int32_t>(pairs.size());
      pairs.push_back(numbers[static_cast<std::size_t>(row)]);
      features.push_back(found[static_cast<std::size_t>(row)]);
    }
  }

  /// All places of the tree.
  void narrow(const Features& query, SearchReach& reach, PlaceJudge& judge) const {
    if (flann && axes.can_tell(query)) return flann->search(axes.of(query), reach, judge);
    if (own && axes.can_tell(query)) return own->search(axes.of(query), reach, judge);
    for (std::size_t place = 0; place < pairs.size(); ++place) judge.look_at(place, reach);
  }
};

PoseIndex::PoseIndex(std::span<const Features> features, std::span<const int> pairs, Tree tree)
    : contents_(std::make_unique<Contents>()) {
  std::vector<Features> found;
  found.reserve(pairs.size());
  for (const int pair : pairs) {
    if (pair < 0 || static_cast<std::size_t>(pair) >= features.size())
      throw std::invalid_argument("no features for pair " + std::to_string(pair));
    found.push_back(features[static_cast<std::size_t>(pair)]);
    if (!found.back().allFinite())
      throw std::invalid_argument("features of pair " + std::to_string(pair) + " are not finite");
  }
  Contents& contents = *contents_;
  contents.places.assign(features.size(), -1);
  contents.pairs.reserve(pairs.size());
  contents.features.reserve(pairs.size());
  contents.axes = FeatureAxes(found);
  if (!contents.axes.can_tell_apart()) {
    std::vector<std::int32_t> rows(found.size());
    std::iota(rows.begin(), rows.end(), 0);
    contents.take(pairs, found, rows);
  } else if (tree == Tree::Flann) {
    contents.take(pairs, found, contents.flann.emplace(contents.axes, found).rows());
  } else {
    contents.take(pairs, found, contents.own.emplace(contents.axes, found).rows());
  }
}

PoseIndex::~PoseIndex() = default;
PoseIndex::PoseIndex(PoseIndex&&) noexcept = default;
PoseIndex& PoseIndex::operator=(PoseIndex&&) noexcept = default;

int PoseIndex::size() const {
  return static_cast<int>(contents_->pairs.size());
}

template <typename IsLeftOut>
void PoseIndex::search(const Features& query, int count, const IsLeftOut& is_left_out,
                       std::vector<PoseMatch>& matches) const {
  if (!query.allFinite()) throw std::invalid_argument("the query's features are not finite");
  const auto wanted = static_cast<std::size_t>(std::clamp(count, 0, size()));
  if (wanted == 0) return matches.clear();

  /// The nearest so far.
  struct Nearest final : PlaceJudge {
    const Contents& contents;
    const Features& query;
    const IsLeftOut& is_left_out;
    std::size_t wanted;
    std::vector<PoseMatch>& matches;

    Nearest(const Contents& all, const Features& asked, const IsLeftOut& without, std::size_t most,
            std::vector<PoseMatch>& found)
        : contents(all), query(asked), is_left_out(without), wanted(most), matches(found) {}

    // The tree only rounds; distances must not depend on it.
    double distance(std::size_t place) const { return (contents.features[place] - query).norm(); }
    void look_at(std::size_t place, SearchReach& reach) override {
      const int pair = contents.pairs[place];
      if (is_left_out(pair)) return;
      add_match({pair, distance(place)}, wanted, matches);
      if (matches.size() == wanted) reach.shrink_to(matches.back().distance);
    }
    void start_again() override { matches.clear(); }

    /// As many pairs as wanted are at least as near as the last of those that `matches` holds.
    void begin_with_matches(SearchReach& reach) {
      std::erase_if(matches, [&](const PoseMatch& match) {
        return match.pair < 0 || static_cast<std::size_t>(match.pair) >= contents.places.size() ||
               contents.places[static_cast<std::size_t>(match.pair)] < 0 || is_left_out(match.pair);
      });
      for (PoseMatch& match : matches)
        match.distance =
            distance(static_cast<std::size_t>(contents.places[static_cast<std::size_t>(match.pair)]));
      std::sort(matches.begin(), matches.end(), nearer);
      const auto same = [](const PoseMatch& a, const PoseMatch& b) { return a.pair == b.pair; };
      matches.erase(std::unique(matches.begin(), matches.end(), same), matches.end());
      if (matches.size() >= wanted) reach.shrink_to(matches[wanted - 1].distance);
      matches.clear();
    }
  };

  SearchReach reach(contents_->axes, query,
                    contents_->flann ? FlannTree::relative_error : FeatureTree::relative_error);
  Nearest nearest(*contents_, query, is_left_out, wanted, matches);
  nearest.begin_with_matches(reach);
  matches.reserve(wanted);
  contents_->narrow(query, reach, nearest);
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

PoseIndex pose_index_of(const MotionLibrary& library, std::span<const int> pairs) {
  const auto& features = library.columns().features;
  return PoseIndex({features.data(), features.size()}, pairs,
                   library.is_mapped() ? PoseIndex::Tree::Own : PoseIndex::Tree::Flann);
}

}  // namespace abrazo
