#include "core/selection/intent_model.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "core/library/build/motion_library_builder.hpp"
#include "tests/core/selection/user_motions.hpp"
#include "tests/support/libraries.hpp"

namespace abrazo::intent_model_test {
namespace {

using Library = std::shared_ptr<const MotionLibrary>;
using Model = std::shared_ptr<const IntentModel>;
using Reading = IntentModel::Reading;

const Library& small() {
  static const Library library = test::small_library();
  return library;
}

const Model& model() {
  static const Model learned = IntentModel::learn(small(), test::all_pairs(*small()));
  return learned;
}

const std::vector<Pose>& first_leader() {
  static const std::vector<Pose> poses = test::swinging_take("first", 180, 1).a.poses;
  return poses;
}

Reading read(const IntentModel& by, const MotionHistory& history) {
  Reading reading = by.make_reading();
  by.read(history, reading);
  return reading;
}

std::size_t best_landing(const Reading& reading) {
  return static_cast<std::size_t>(std::min_element(reading.partner_m.begin(), reading.partner_m.end()) -
                                  reading.partner_m.begin());
}

Library without_labels() {
  LibraryColumns columns = small()->columns();
  for (LibraryTake& take : columns.takes) take.labels.clear();
  return std::make_shared<const MotionLibrary>(std::move(columns));
}

Library one_pair() {
  std::vector<PairedTake> takes;
  takes.push_back(test::swinging_take("only", 2, 3));
  LibraryBuildOptions options;
  options.rate_hz = 30;
  return std::make_shared<const MotionLibrary>(
      std::move(*build_library("one", std::move(takes), options, {})));
}

/// Long enough that learning reports more often than once.
Library long_library() {
  std::vector<PairedTake> takes;
  for (unsigned seed = 1; seed <= 3; ++seed)
    takes.push_back(test::swinging_take("take " + std::to_string(seed), 700, seed));
  LibraryBuildOptions options;
  options.rate_hz = 15;
  return std::make_shared<const MotionLibrary>(
      std::move(*build_library("long", std::move(takes), options, {})));
}

TEST(IntentModel, AUserWhoRepeatsARecordedLeaderIsExpectedTheRecordedPartner) {
  for (const auto& [name, frames, seed] : {std::tuple{"first", 180, 1U}, std::tuple{"second", 150, 2U}}) {
    const std::vector<Pose> leader = test::swinging_take(name, frames, seed).a.poses;
    for (int frame = 60; frame < frames; frame += 7) {
      const Reading reading = read(*model(), test::history_at(leader, frame));
      const std::size_t best = best_landing(reading);
      const int pair = model()->landings()[best];
      EXPECT_EQ(small()->take_of(pair).name, name) << frame;
      EXPECT_NEAR(static_cast<int>(small()->source(pair).frame), frame, 12) << name;
      EXPECT_LT(reading.partner_m[best], 0.03) << name << ' ' << frame;
      const float mean = std::accumulate(reading.partner_m.begin(), reading.partner_m.end(), 0.0F) /
                         static_cast<float>(reading.partner_m.size());
      EXPECT_GT(mean, 4 * reading.partner_m[best]) << name << ' ' << frame;
    }
  }
}

TEST(IntentModel, ItsMovesSumToOneAndTheRecordedOneIsLikeliest) {
  for (int frame = 10; frame < 180; frame += 5) {
    const Reading reading = read(*model(), test::history_at(first_leader(), frame));
    ASSERT_EQ(reading.moves.size(), 2U);
    EXPECT_NEAR(reading.moves[0] + reading.moves[1], 1, 1e-5);
    EXPECT_GT(std::min(reading.moves[0], reading.moves[1]), 0);
    if (std::abs(frame - 90) < 10) continue;  // the label changes there
    const std::size_t recorded =
        small()->label(small()->find_pair("first", frame, false)) == "open_hold" ? 0 : 1;
    EXPECT_GT(reading.moves[recorded], 0.6F) << frame;
  }
  EXPECT_EQ(model()->labels(), (std::vector<std::string>{"open_hold", "turn"}));
}

TEST(IntentModel, AUserLikeNobodyRecordedIsExpectedWhatIsUsual) {
  MotionHistory far_from_all;
  for (int frame = 0; frame < 150; ++frame) {
    const Pose pose = 5 * first_leader()[static_cast<std::size_t>(frame)];
    far_from_all.add(pose, root_frame(pose), 1.0 / 60);
  }
  const Reading reading = read(*model(), far_from_all);
  for (const float likeness : reading.kernel) EXPECT_LT(likeness, 1e-6);
  EXPECT_NEAR(reading.moves[0], 0.5, 0.05) << "half of each";
  EXPECT_GT(reading.spread_m, 0.05) << "it could be any of them";
}

TEST(IntentModel, ALandingIsReadLikeAnyOtherPair) {
  Reading reading = read(*model(), test::history_at(first_leader(), 100));
  for (std::size_t l = 0; l < model()->landings().size(); ++l) {
    const IntentModel::PairReading of_pair = model()->read_pair(model()->landings()[l], reading);
    EXPECT_NEAR(of_pair.partner_m, reading.partner_m[l], 1e-4) << l;
    EXPECT_NEAR(of_pair.leader_kernel, model()->leader_kernel(l, reading), 1e-4) << l;
    EXPECT_EQ(of_pair.label, model()->label_of_landing(l)) << l;
    EXPECT_EQ(model()->labels()[static_cast<std::size_t>(of_pair.label)],
              small()->label(model()->landings()[l]));
  }
}

TEST(IntentModel, TheLeadersKernelIsGreatestWhereTheUserRepeatsHim) {
  const int frame = 120;
  Reading reading = read(*model(), test::history_at(first_leader(), frame));
  const int there = small()->find_pair("first", frame, false);
  EXPECT_GT(model()->read_pair(there, reading).leader_kernel, 0.98F);
  EXPECT_LT(model()->read_pair(small()->find_pair("second", frame, false), reading).leader_kernel, 0.5F);
}

TEST(IntentModel, NothingIsLearnedOfPairsThatMayNotBeSelected) {
  const std::vector<int> first = test::pairs_of_take(*small(), "first");
  LibraryColumns columns = small()->columns();
  std::vector<PairPose> poses(columns.poses.begin(), columns.poses.end());
  for (int pair = 0; pair < small()->pair_count(); ++pair)
    if (small()->take_of(pair).name == "second")
      poses[static_cast<std::size_t>(pair)].rowwise() += Eigen::RowVector3d(1, 2, 3);
  columns.poses = std::move(poses);
  columns.takes[1].labels = {{0, 150, "never", "", ""}};
  const auto other = std::make_shared<const MotionLibrary>(std::move(columns));
  const Model of_one = IntentModel::learn(small(), first), of_other = IntentModel::learn(other, first);
  EXPECT_LT(of_one->example_count(), model()->example_count());
  EXPECT_EQ(of_other->labels(), of_one->labels());
  for (const int landing : of_other->landings()) EXPECT_EQ(other->take_of(landing).name, "first");
  for (const BeliefBlock& block : of_other->blocks()) EXPECT_EQ(block.take, 0U);
  const MotionHistory user = test::history_at(test::swinging_take("user", 150, 17).a.poses, 140);
  EXPECT_EQ(read(*of_other, user).expected, read(*of_one, user).expected);
  EXPECT_EQ(read(*of_other, user).partner_m, read(*of_one, user).partner_m);
}

TEST(IntentModel, WithoutLabelsTheOnlyMoveIsNone) {
  const Library library = without_labels();
  const Model learned = IntentModel::learn(library, test::all_pairs(*library));
  EXPECT_EQ(learned->labels(), std::vector<std::string>{""});
  const Reading reading = read(*learned, test::history_at(first_leader(), 100));
  EXPECT_EQ(reading.moves, std::vector<float>{1});
}

TEST(IntentModel, OfASinglePairExpectsItsPartner) {
  const Library library = one_pair();
  ASSERT_EQ(library->pair_count(), 1);
  const Model learned = IntentModel::learn(library, test::all_pairs(*library));
  EXPECT_EQ(learned->landings(), std::vector<int>{0});
  EXPECT_EQ(learned->blocks().size(), 1U);
  for (const int frame : {0, 100}) {
    Reading reading = read(*learned, test::history_at(first_leader(), frame));
    EXPECT_EQ(reading.moves, std::vector<float>{1});
    EXPECT_NEAR(reading.partner_m[0], 0, 1e-6);
    EXPECT_NEAR(learned->read_pair(0, reading).partner_m, 0, 1e-6);
  }
}

/// Blocks of a take follow one another without a hole, from its first recorded frame to behind its last, and
/// each is half a second but for the last.
void expect_tiles(const IntentModel& of) {
  const MotionLibrary& library = *of.library();
  std::size_t block = 0;
  for (int pair = 0; pair < library.pair_count(); ++pair) {
    const PairSource& source = library.source(pair);
    const auto frame = static_cast<int>(source.frame);
    const auto holds = [&](const BeliefBlock& b) {
      return b.take == source.take && b.swapped == source.swapped && b.begin_frame <= frame &&
             frame < b.end_frame;
    };
    if (!holds(of.blocks()[block])) {
      ASSERT_LT(block + 1, of.blocks().size()) << "pair " << pair << " is in no block";
      ++block;
    }
    ASSERT_TRUE(holds(of.blocks()[block])) << "pair " << pair;
  }
  EXPECT_EQ(block + 1, of.blocks().size()) << "every block has pairs";
  for (std::size_t b = 0; b < of.blocks().size(); ++b) {
    const BeliefBlock& one = of.blocks()[b];
    const LibraryTake& take = library.takes()[one.take];
    EXPECT_LE(one.end_frame, take.frames);
    EXPECT_LE(one.end_frame - one.begin_frame, 0.6 * take.fps) << b;
    if (b + 1 == of.blocks().size() || of.blocks()[b + 1].take != one.take ||
        of.blocks()[b + 1].swapped != one.swapped || of.blocks()[b + 1].begin_frame != one.end_frame)
      continue;
    EXPECT_NEAR(one.end_frame - one.begin_frame, 0.5 * take.fps, 1) << b;
  }
  for (std::size_t l = 0; l < of.landings().size(); ++l) {
    const PairSource& source = library.source(of.landings()[l]);
    const BeliefBlock& in = of.blocks()[static_cast<std::size_t>(of.block_of_landing(l))];
    EXPECT_EQ(in.take, source.take);
    EXPECT_EQ(in.swapped, source.swapped);
    EXPECT_GE(static_cast<int>(source.frame), in.begin_frame);
    EXPECT_LT(static_cast<int>(source.frame), in.end_frame);
  }
}

TEST(IntentModel, BlocksTileTheTakes) {
  expect_tiles(*model());
  const Library spread = long_library();
  expect_tiles(*IntentModel::learn(spread, test::all_pairs(*spread)));
  // Two leaders who change, so that what each leads has gaps; an odd number of frames, another rate.
  PairedTake take = test::swinging_take("changing", 247, 3);
  take.a.fps = take.b.fps = take.fps = 50;
  take.roles = {{0, 61, ActivePerformer::A}, {61, 133, ActivePerformer::B}, {133, 247, ActivePerformer::A}};
  std::vector<PairedTake> takes;
  takes.push_back(take);
  const auto changing =
      std::make_shared<const MotionLibrary>(std::move(*build_library("changing", std::move(takes), {}, {})));
  expect_tiles(*IntentModel::learn(changing, test::all_pairs(*changing)));
}

TEST(IntentModel, LearnedAgainReadsTheSameBits) {
  const Model again = IntentModel::learn(small(), test::all_pairs(*small()));
  EXPECT_EQ(again->blocks(), model()->blocks());
  for (const int frame : {0, 50, 150}) {
    const MotionHistory history = test::history_at(first_leader(), frame);
    const Reading one = read(*model(), history), other = read(*again, history);
    EXPECT_EQ(one.expected, other.expected);
    EXPECT_EQ(one.partner_m, other.partner_m);
    EXPECT_EQ(one.moves, other.moves);
  }
}

TEST(IntentModel, WhatWasReadBeforeDoesNotMatter) {
  Reading used = read(*model(), test::history_at(first_leader(), 40));
  model()->read(test::history_at(first_leader(), 150), used);
  EXPECT_EQ(used.partner_m, read(*model(), test::history_at(first_leader(), 150)).partner_m);
}

TEST(IntentModel, CancelledThereIsNone) {
  const Library library = long_library();
  const std::vector<int> pairs = test::all_pairs(*library);
  int reports = 0;
  double last = 0;
  ASSERT_TRUE(IntentModel::learn(library, pairs, [&](double fraction, std::string_view) {
    EXPECT_GE(fraction, 0);
    EXPECT_LE(fraction, 1);
    EXPECT_GE(fraction, last);
    last = fraction;
    return ++reports, true;
  }));
  ASSERT_GT(reports, 3) << "the library must be long enough to test anything";
  for (const int after : {0, reports / 2, reports - 2}) {
    int left = after;
    bool stopped = false;
    const Model learned = IntentModel::learn(library, pairs, [&](double, std::string_view) {
      stopped = stopped || left-- <= 0;
      return !stopped;
    });
    EXPECT_EQ(learned == nullptr, stopped) << "stopped after " << after << " reports";
  }
}

/// Takes of one pair each.
Library of_single_pairs(std::size_t count) {
  const LibraryColumns& from = small()->columns();
  LibraryColumns columns;
  columns.bodies = from.bodies;
  std::vector<RootFrame> roots;
  std::vector<PairPose> poses;
  std::vector<Features> features;
  for (std::size_t i = 0; i < count; ++i) {
    LibraryTake take;
    take.name = "take " + std::to_string(i);
    take.frames = 1;
    columns.takes.push_back(take);
    columns.sources.push_back({static_cast<std::uint32_t>(i), 0, false, ActivePerformer::A});
    const std::size_t pair = i % from.sources.size();
    roots.push_back(from.roots[pair]);
    poses.push_back(from.poses[pair]);
    features.push_back(from.features[pair]);
  }
  columns.roots = std::move(roots);
  columns.poses = std::move(poses);
  columns.features = std::move(features);
  columns.edge_offsets = std::vector<std::uint64_t>(count + 1, 0);
  columns.tetrahedron_offsets = std::vector<std::uint64_t>(count + 1, 0);
  columns.mesh_quality.assign(count, 0);
  return std::make_shared<const MotionLibrary>(std::move(columns));
}

TEST(IntentModel, HoweverManyTakesThereAreExamplesAndLandingsAreBounded) {
  const Library library = of_single_pairs(17'000);
  const Model model = IntentModel::learn(library, test::all_pairs(*library));
  EXPECT_EQ(model->example_count(), 4096);
  EXPECT_EQ(model->landings().size(), 16'384U);
}

TEST(IntentModel, ARateThatNobodyRecordsAtIsLearnedAsAnyOther) {
  LibraryColumns columns = small()->columns();
  for (LibraryTake& take : columns.takes) take.fps = 1e12;
  const auto library = std::make_shared<const MotionLibrary>(std::move(columns));
  const Model model = IntentModel::learn(library, test::all_pairs(*library));
  Reading reading = read(*model, test::history_at(first_leader(), 100));
  EXPECT_TRUE(std::isfinite(model->read_pair(50, reading).partner_m));
}

TEST(IntentModel, EveryMoveCanBeChangedTo) {
  LibraryColumns columns = small()->columns();
  columns.takes[0].labels = {{0, 50, "long", "", ""}, {50, 51, "short", "", ""}, {51, 100, "long", "", ""}};
  const auto library = std::make_shared<const MotionLibrary>(std::move(columns));
  const Model model = IntentModel::learn(library, test::all_pairs(*library));
  const auto& landings = model->landings();
  EXPECT_TRUE(std::any_of(landings.begin(), landings.end(),
                          [&](int pair) { return library->label(pair) == "short"; }));
}

}  // namespace
}  // namespace abrazo::intent_model_test
