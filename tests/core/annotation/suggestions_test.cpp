#include "core/annotation/suggestions.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/annotation/move_examples.hpp"
#include "core/choreography/fight.hpp"
#include "core/choreography/salsa.hpp"
#include "core/library/build/motion_library_builder.hpp"
#include "core/library/takes/manifest.hpp"
#include "tests/support/captured_data.hpp"

namespace abrazo::suggestions_test {
namespace {

MotionLibrary library_of(std::vector<PairedTake> takes) {
  return std::move(*build_library("takes", std::move(takes), {.excluded_takes = {}, .rate_hz = 30}, {}));
}

/// Generated dances, shared by the tests: they are only read.
class Suggestions : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    salsa = library_of(generate_salsa({.seed = 3, .minutes = 1.4, .a = {}, .b = {}}));
    const std::string take = salsa->takes().front().name;
    suggested = *suggest_annotations(*salsa, {.take = take}, {});
  }
  static void TearDownTestSuite() { salsa.reset(); }

  static const LibraryTake& take() { return salsa->takes().front(); }
  static inline std::optional<MotionLibrary> salsa;
  static inline SuggestedTiers suggested;
};

/// Share of the frames for which a suggestion says what the take's labels say.
double agreement(const LibraryTake& take, const std::vector<Suggestion>& suggested) {
  double agreed = 0, all = 0;
  for (const LabelInterval& label : take.labels)
    for (int frame = label.start; frame < label.end; ++frame) {
      ++all;
      for (const Suggestion& one : suggested)
        if (frame / take.fps >= one.start_s && frame / take.fps < one.end_s && one.value == label.label)
          ++agreed;
    }
  return agreed / all;
}

void expect_tiles(const std::vector<Suggestion>& tier, double end_s) {
  ASSERT_FALSE(tier.empty());
  EXPECT_EQ(tier.front().start_s, 0);
  EXPECT_NEAR(tier.back().end_s, end_s, 1e-9);
  for (std::size_t i = 0; i < tier.size(); ++i) {
    EXPECT_LT(tier[i].start_s, tier[i].end_s);
    if (i > 0) {
      EXPECT_EQ(tier[i - 1].end_s, tier[i].start_s);
    }
    EXPECT_GE(tier[i].confidence, 0);
    EXPECT_LE(tier[i].confidence, 1);
    EXPECT_FALSE(tier[i].reason.empty());
  }
}

TEST_F(Suggestions, TileTheTake) {
  expect_tiles(suggested.moves, take().frames / take().fps);
  expect_tiles(suggested.roles, take().frames / take().fps);
}

TEST_F(Suggestions, FindMostMovesOfAGeneratedDance) {
  EXPECT_GT(agreement(take(), suggested.moves), 0.5);
}

TEST_F(Suggestions, FindWhoLeads) {
  ASSERT_EQ(suggested.roles.size(), 1U);
  EXPECT_EQ(suggested.roles.front().value, "a");
}

TEST_F(Suggestions, SayWhy) {
  for (const Suggestion& one : suggested.moves)
    EXPECT_NE(one.reason.find("nearest labelled moves: " + one.value), std::string::npos) << one.reason;
}

TEST_F(Suggestions, DoNotLookAtTheTakesOwnLabels) {
  LibraryColumns columns = salsa->columns();
  for (LabelInterval& label : columns.takes.front().labels) label.label = "something else";
  columns.takes.front().roles = {};
  const MotionLibrary changed(std::move(columns));
  const auto again = suggest_annotations(changed, {.take = take().name}, {});
  ASSERT_TRUE(again);
  EXPECT_EQ(again->moves, suggested.moves);
  EXPECT_EQ(again->roles, suggested.roles);
}

TEST_F(Suggestions, LearnFromTakesWithoutRolesAsWell) {
  const LabelledMoves all = labelled_moves(*salsa, -1);
  LibraryColumns columns = salsa->columns();
  for (std::size_t t = 1; t < columns.takes.size(); ++t) columns.takes[t].roles = {};
  const LabelledMoves some = labelled_moves(MotionLibrary(std::move(columns)), -1);
  EXPECT_TRUE(some.has_roles);
  EXPECT_EQ(some.takes.size(), all.takes.size());
  EXPECT_EQ(some.move_count, all.move_count);
  // A move of nobody's is learned in either order, with its label.
  const CandidateLengths lengths = candidate_lengths(some);
  const auto none_of = [&](const LabelledMoves& moves) {
    const ForestExamples examples = move_examples(moves, lengths);
    return std::count(examples.classes.begin(), examples.classes.end(),
                      static_cast<int>(moves.labels.size()));
  };
  EXPECT_LT(none_of(some), none_of(all));
}

TEST_F(Suggestions, AreOnlyOfWhatWasAskedFor) {
  LibraryColumns columns = salsa->columns();
  for (LibraryTake& take : columns.takes) take.labels = {};
  const auto roles = suggest_annotations(MotionLibrary(columns), {.take = take().name}, {});
  ASSERT_TRUE(roles);
  EXPECT_TRUE(roles->moves.empty()) << "nobody labelled anything";
  expect_tiles(roles->roles, take().frames / take().fps);
}

TEST_F(Suggestions, NeedOtherTakesThatSaySomething) {
  LibraryColumns columns = salsa->columns();
  for (LibraryTake& take : columns.takes) take.labels = {}, take.roles = {};
  const auto none = suggest_annotations(MotionLibrary(columns), {.take = take().name}, {});
  ASSERT_FALSE(none);
  EXPECT_EQ(
      none.error().text(),
      take().name + ": no other take of the library has labels or roles to learn from: annotate one first");
}

TEST_F(Suggestions, NeedATakeOfTheLibrary) {
  const auto none = suggest_annotations(*salsa, {.take = "nobody"}, {});
  ASSERT_FALSE(none);
  EXPECT_EQ(none.error().text(), "nobody: the library has no take of that name");
}

TEST_F(Suggestions, StopWhenAsked) {
  const auto none =
      suggest_annotations(*salsa, {.take = take().name}, [](double, std::string_view) { return false; });
  ASSERT_FALSE(none);
  EXPECT_EQ(none.error().text(), "cancelled");
}

TEST(SuggestionsOfAFight, AreInTheVocabularyOfItsTakes) {
  const MotionLibrary fight = library_of(generate_fight({.minutes = 1.4, .a = {}, .b = {}}));
  const LibraryTake& take = fight.takes().front();
  const auto suggested = suggest_annotations(fight, {.take = take.name}, {});
  ASSERT_TRUE(suggested);
  expect_tiles(suggested->moves, take.frames / take.fps);
  EXPECT_GT(agreement(take, suggested->moves), 0.5);
}

TEST(SuggestionsOfCapturedSalsa, AgreeWithTheLabels) {
  ABRAZO_REQUIRE_CAPTURED_DATA(data);
  const auto labels = data / "labels" / "moves.csv";
  if (!std::filesystem::exists(labels)) GTEST_SKIP() << "move labels of the captured takes not found";
  Manifest manifest;
  for (const std::string number : {"09", "10", "12", "13", "14"}) {
    Manifest::Take take;
    take.name = "salsa_" + number;
    take.fps = 60;
    take.metres_per_unit = 0.0564444;
    take.a = {.motion = data / "cmu_salsa" / ("60_" + number + ".amc"),
              .skeleton = data / "cmu_salsa" / "60.asf"};
    take.b = {.motion = data / "cmu_salsa" / ("61_" + number + ".amc"),
              .skeleton = data / "cmu_salsa" / "61.asf"};
    take.labels = labels;
    take.roles = {{0, 100000, ActivePerformer::A}};
    manifest.takes.push_back(take);
  }
  std::vector<std::string> warnings;
  const auto library = build_library(manifest, {.excluded_takes = {}, .rate_hz = 30}, {}, warnings);
  ASSERT_TRUE(library) << library.error().text();
  const auto suggested = suggest_annotations(*library, {.take = "salsa_10"}, {});
  ASSERT_TRUE(suggested);
  EXPECT_GT(agreement(library->takes()[1], suggested->moves), 0.6);
  EXPECT_EQ(suggested->roles.front().value, "a");
}

}  // namespace
}  // namespace abrazo::suggestions_test
