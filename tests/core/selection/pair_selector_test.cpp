#include "core/selection/pair_selector.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <numeric>
#include <random>

#include "tests/support/bodies.hpp"
#include "tests/support/libraries.hpp"

namespace abrazo::pair_selector_test {
namespace {

std::vector<int> all_pairs(const MotionLibrary& library) {
  std::vector<int> pairs(static_cast<std::size_t>(library.pair_count()));
  std::iota(pairs.begin(), pairs.end(), 0);
  return pairs;
}

SelectionQuery query_at(const Pose& user) {
  SelectionQuery query;
  query.root = root_frame(user);
  query.normalized = to_normalized(user, query.root);
  query.features = pose_features(query.normalized);
  return query;
}

/// Of its first take the frames 20..59 are a turn, the rest has no label.
std::shared_ptr<const MotionLibrary> labelled_library() {
  LibraryColumns columns = test::small_library()->columns();
  columns.takes[0].labels = {{20, 60, "turn", "", ""}};
  columns.takes[1].labels = {};
  return std::make_shared<const MotionLibrary>(std::move(columns));
}

std::size_t pairs_where(const MotionLibrary& library, const std::function<bool(int)>& holds) {
  const std::vector<int> pairs = all_pairs(library);
  return static_cast<std::size_t>(std::count_if(pairs.begin(), pairs.end(), holds));
}

/// Eq. 7 summed joint by joint, as printed.
double equation_7(const SelectionQuery& query, const MotionLibrary& library, int pair) {
  const RootFrame& root = query.root;
  double sum = 0;
  for (int l = 0; l < joint_count; ++l) {
    const Vec3 p_active = library.pose(pair).row(l);
    const Vec3 p_passive = library.pose(pair).row(l + joint_count);
    const Vec3 r_in(root.position.x(), library.root(pair).position.y(), root.position.z());
    const Vec3 world_active = root.rotation() * p_active + r_in;
    const Vec3 world_passive = root.rotation() * p_passive + r_in;
    sum += (Vec3(query.normalized.row(l)) - p_active).squaredNorm();
    if (!query.has_prediction) continue;
    sum += query.alpha * ((Vec3(query.predicted.row(l)) - world_active).squaredNorm() +
                          (Vec3(query.predicted.row(l + joint_count)) - world_passive).squaredNorm());
  }
  return sum;
}

TEST(PairSelector, CandidatesAreTheNearestByBruteForce) {
  const auto library = test::small_library();
  PairSelector selector(library, all_pairs(*library));
  std::mt19937 random(1);
  std::vector<Candidate> candidates;
  for (int trial = 0; trial < 50; ++trial) {
    const SelectionQuery query = query_at(test::shaken(test::standing_pose(), 0.1, random));
    selector.select(query, candidates);
    std::vector<double> distances;
    for (int pair = 0; pair < library->pair_count(); ++pair)
      distances.push_back((library->features(pair) - query.features).norm());
    std::sort(distances.begin(), distances.end());
    ASSERT_EQ(candidates.size(), 10U);
    for (std::size_t c = 0; c < candidates.size(); ++c)
      EXPECT_NEAR(candidates[c].feature_distance, distances[c], 1e-12);
  }
}

TEST(PairSelector, EveryCostIsEquation7AndTheCheapestIsSelected) {
  const auto library = test::small_library();
  PairSelector selector(library, all_pairs(*library));
  std::mt19937 random(2);
  std::vector<Candidate> candidates;
  for (const bool has_prediction : {false, true}) {
    SelectionQuery query =
        query_at(test::moved(test::shaken(test::standing_pose(), 0.05, random), 1.1, Vec3(4, 0, -3)));
    query.has_prediction = has_prediction;
    query.predicted = library->pair_in_world(40, query.root);
    const int selected = selector.select(query, candidates);
    for (std::size_t c = 0; c < candidates.size(); ++c) {
      EXPECT_NEAR(candidates[c].cost.total, equation_7(query, *library, candidates[c].pair), 1e-9);
      EXPECT_GE(candidates[c].cost.total, candidates[static_cast<std::size_t>(selected)].cost.total);
    }
  }
}

TEST(PairSelector, TheRecordedPoseItselfIsFoundAtDistanceZero) {
  const auto library = test::small_library();
  PairSelector selector(library, all_pairs(*library));
  const int pair = 77;
  const Pose user = library->pair_in_world(pair, {Vec3(5, library->root(pair).position.y(), 1), 2.0})
                        .topRows<joint_count>();
  std::vector<Candidate> candidates;
  const int selected = selector.select(query_at(user), candidates);
  EXPECT_EQ(candidates[static_cast<std::size_t>(selected)].pair, pair);
  EXPECT_NEAR(candidates.front().feature_distance, 0, 1e-9);
}

TEST(PairSelector, OnlyGivenPairsAreCandidates) {
  const auto library = test::small_library();
  std::vector<int> second_take;
  for (const int pair : all_pairs(*library))
    if (library->take_of(pair).name == "second") second_take.push_back(pair);
  PairSelector selector(library, second_take);
  SelectionQuery query = query_at(test::standing_pose());
  query.current_pair = 10;  // of the first take
  query.continuations = 3;
  std::vector<Candidate> candidates;
  selector.select(query, candidates);
  for (const Candidate& candidate : candidates) EXPECT_EQ(library->take_of(candidate.pair).name, "second");
}

TEST(PairSelector, SuccessorsOfTheCurrentSourceJoinOnceAndInOrder) {
  const auto library = test::small_library();
  PairSelector selector(library, all_pairs(*library));
  SelectionQuery query = query_at(test::moved(test::standing_pose(), 0, Vec3::Zero()));
  query.neighbours = 3;
  query.current_pair = 100;
  query.expected_advance = 4;
  query.continuations = 3;
  std::vector<Candidate> candidates;
  selector.select(query, candidates);
  std::vector<int> continued;
  for (const Candidate& candidate : candidates)
    if (candidate.continuation) continued.push_back(candidate.pair);
  std::sort(continued.begin(), continued.end());
  EXPECT_EQ(continued, (std::vector<int>{104, 108, 112}));
  EXPECT_TRUE(std::is_sorted(
      candidates.begin(), candidates.end(),
      [](const Candidate& a, const Candidate& b) { return a.feature_distance < b.feature_distance; }));
}

TEST(PairSelector, AtTheEndOfATakeNothingContinues) {
  const auto library = test::small_library();
  PairSelector selector(library, all_pairs(*library));
  SelectionQuery query = query_at(test::standing_pose());
  query.current_pair = 179;  // last of the first take
  query.continuations = 3;
  std::vector<Candidate> candidates;
  selector.select(query, candidates);
  EXPECT_EQ(candidates.size(), 10U);
}

TEST(PairSelector, WithoutVetoedPairsTheNextNearestTakeTheirPlaces) {
  const auto library = test::small_library();
  PairSelector selector(library, all_pairs(*library));
  const SelectionQuery query = query_at(test::standing_pose());
  std::vector<Candidate> before, after, brute;
  SelectionQuery wide = query;
  wide.neighbours = 13;
  selector.select(wide, brute);
  selector.select(query, before);
  selector.set_vetoes({{before[0].pair, before[4].pair, before[9].pair}, {}, {}});
  selector.select(query, after);
  std::erase_if(brute, [&](const Candidate& c) { return selector.pairs().is_vetoed(c.pair); });
  ASSERT_EQ(after.size(), 10U);
  for (std::size_t c = 0; c < after.size(); ++c) EXPECT_EQ(after[c].pair, brute[c].pair);
}

TEST(PairSelector, AVetoOfATakeOrALabelLeavesOutAllItsPairs) {
  const auto library = labelled_library();
  PairSelector selector(library, all_pairs(*library));
  SelectionQuery query = query_at(test::standing_pose());
  query.neighbours = library->pair_count();
  std::vector<Candidate> candidates;
  selector.set_vetoes({{}, {"first"}, {}});
  selector.select(query, candidates);
  EXPECT_EQ(candidates.size(),
            pairs_where(*library, [&](int p) { return library->take_of(p).name != "first"; }));
  selector.set_vetoes({{}, {}, {"turn"}});
  selector.select(query, candidates);
  EXPECT_EQ(candidates.size(), pairs_where(*library, [&](int p) { return library->label(p) != "turn"; }));
  selector.set_vetoes({{}, {}, {""}});
  selector.select(query, candidates);
  EXPECT_EQ(candidates.size(), pairs_where(*library, [&](int p) { return !library->label(p).empty(); }));
  selector.set_vetoes({{-1, 1 << 20}, {"third"}, {"jump"}});
  selector.select(query, candidates);
  EXPECT_EQ(candidates.size(), static_cast<std::size_t>(library->pair_count()))
      << "names the library does not have veto nothing";
}

TEST(PairSelector, AVetoedSuccessorDoesNotHideTheOnesAfterIt) {
  const auto library = test::small_library();
  PairSelector selector(library, all_pairs(*library));
  selector.set_vetoes({{104}, {}, {}});
  SelectionQuery query = query_at(test::moved(test::standing_pose(), 0, Vec3::Zero()));
  query.neighbours = 3;
  query.current_pair = 100;
  query.expected_advance = 4;
  query.continuations = 3;
  std::vector<Candidate> candidates;
  selector.select(query, candidates);
  std::vector<int> continued;
  for (const Candidate& candidate : candidates)
    if (candidate.continuation) continued.push_back(candidate.pair);
  std::sort(continued.begin(), continued.end());
  EXPECT_EQ(continued, (std::vector<int>{108, 112}));
}

TEST(PairSelector, WithEverythingVetoedThereIsNothingToSelectUntilAVetoIsLifted) {
  const auto library = test::small_library();
  PairSelector selector(library, all_pairs(*library));
  SelectionQuery query = query_at(test::standing_pose());
  query.current_pair = 10;
  query.continuations = 3;
  std::vector<Candidate> candidates;
  selector.set_vetoes({{}, {"first", "second"}, {}});
  EXPECT_TRUE(selector.pairs().all_vetoed());
  EXPECT_EQ(selector.select(query, candidates), -1);
  EXPECT_TRUE(candidates.empty());
  selector.set_vetoes({});
  EXPECT_FALSE(selector.pairs().all_vetoed());
  EXPECT_GE(selector.select(query, candidates), 0);
}

TEST(PairInWorld, KeepsTheRecordedHeightAndTakesTheUsersPlaceAndHeading) {
  const auto library = test::small_library();
  const PairPose world = library->pair_in_world(5, {Vec3(2, 77, -1), 0.9});
  const RootFrame root = root_frame(world.topRows<joint_count>());
  EXPECT_NEAR(root.position.x(), 2, 1e-12);
  EXPECT_NEAR(root.position.z(), -1, 1e-12);
  EXPECT_NEAR(root.position.y(), library->root(5).position.y(), 1e-12);
  EXPECT_NEAR(root.heading_rad, 0.9, 1e-9);
}

}  // namespace
}  // namespace abrazo::pair_selector_test
