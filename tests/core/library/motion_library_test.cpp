#include "core/library/store/motion_library.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>

#include "core/library/build/motion_library_builder.hpp"
#include "tests/core/library/synthetic_takes.hpp"

namespace abrazo::motion_library_test {
namespace {

using test::circling_take;

/// Frames 0-9 active A, 10-19 active B, 20-29 active A again, thinned to every second frame; and a doubled
/// second take.
MotionLibrary switching_library() {
  PairedTake first = circling_take("first", 30);
  first.roles = {{0, 10, ActivePerformer::A}, {10, 20, ActivePerformer::B}, {20, 30, ActivePerformer::A}};
  first.labels = {{0, 4, "turn", "", ""}};
  LibraryBuildOptions options;
  options.rate_hz = 30;
  auto library = build_library("test", {first, circling_take("second", 10, 0.9, 4)}, options, {});
  return std::move(library.value());
}

TEST(MotionLibrary, FindsThePairOfAFrame) {
  const MotionLibrary library = switching_library();
  for (int pair = 0; pair < library.pair_count(); ++pair) {
    const PairSource& source = library.source(pair);
    EXPECT_EQ(library.find_pair(library.take_of(pair).name, static_cast<int>(source.frame), source.swapped),
              pair);
  }
  EXPECT_EQ(library.find_pair("first", 3, false), -1) << "thinned away";
  EXPECT_EQ(library.find_pair("first", 12, false), -1) << "B is active";
  EXPECT_EQ(library.find_pair("first", 30, false), -1);
  EXPECT_EQ(library.find_pair("first", -2, false), -1);
  EXPECT_EQ(library.find_pair("third", 0, false), -1);
}

TEST(MotionLibrary, LaterPairsAdvanceByTheStride) {
  const MotionLibrary library = switching_library();
  const int pair = library.find_pair("first", 2, false);
  EXPECT_EQ(library.later_pair(pair, 0), pair);
  EXPECT_EQ(library.later_pair(pair, 3), library.find_pair("first", 8, false));
  EXPECT_EQ(library.later_pair(pair, -1), library.find_pair("first", 0, false));
}

TEST(MotionLibrary, LaterPairsStopAtARoleSwitch) {
  const MotionLibrary library = switching_library();
  const int last_before = library.find_pair("first", 8, false);
  // The next row is frame 20, after the frames in which B is active.
  EXPECT_EQ(library.source(last_before + 1).frame, 20U);
  EXPECT_EQ(library.later_pair(last_before, 1), -1);
  EXPECT_EQ(library.later_pair(library.find_pair("first", 18, true), 1), -1);
}

TEST(MotionLibrary, LaterPairsStopWhereTheOtherPerformerTakesOver) {
  // The row after frame 4 of A is frame 5 of B: the next frame, but the other person.
  PairedTake take = circling_take("t", 10);
  take.roles = {{0, 5, ActivePerformer::A}, {5, 10, ActivePerformer::B}};
  const auto library = build_library("test", {take}, {}, {});
  ASSERT_TRUE(library.ok());
  ASSERT_EQ(library->source(5).frame, 5U);
  EXPECT_EQ(library->later_pair(4, 1), -1);
  EXPECT_EQ(library->later_pair(5, -1), -1);
}

TEST(MotionLibrary, LaterPairsStayInTheirTakeAndRoles) {
  const MotionLibrary library = switching_library();
  EXPECT_EQ(library.later_pair(library.find_pair("first", 28, false), 1), -1);
  EXPECT_EQ(library.later_pair(library.find_pair("second", 8, false), 1), -1);
  EXPECT_EQ(library.later_pair(library.pair_count() - 1, 1), -1);
  EXPECT_EQ(library.later_pair(0, -1), -1);
  EXPECT_EQ(library.later_pair(0, 1 << 30), -1);
}

TEST(MotionLibrary, KnowsTheBodiesOfBothRoles) {
  const MotionLibrary library = switching_library();
  const int straight = library.find_pair("second", 0, false);
  const int swapped = library.find_pair("second", 0, true);
  EXPECT_EQ(library.active_body(straight).name, "first/a");
  EXPECT_EQ(library.passive_body(straight).name, "first/b");
  EXPECT_EQ(library.active_body(swapped).name, "first/b");
  EXPECT_EQ(library.passive_body(swapped).name, "first/a");
  EXPECT_EQ(library.usual_active_body().name, "first/a");
  EXPECT_EQ(library.usual_passive_body().name, "first/b");
}

TEST(MotionLibrary, SaysTheLabelOfAPair) {
  const MotionLibrary library = switching_library();
  EXPECT_EQ(library.label(library.find_pair("first", 2, false)), "turn");
  EXPECT_EQ(library.label(library.find_pair("first", 4, false)), "");
  EXPECT_EQ(library.label(library.find_pair("second", 2, true)), "");
}

class BrokenColumns : public testing::Test {
 protected:
  void expect_refused(const char* message) const {
    try {
      const MotionLibrary library(columns);
      ADD_FAILURE() << "accepted; expected: " << message;
    } catch (const std::invalid_argument& refusal) {
      EXPECT_STREQ(refusal.what(), message);
    }
  }
  LibraryColumns columns = switching_library().columns();
};

TEST_F(BrokenColumns, UnequalLengthsAreRefused) {
  columns.roots.pop_back();
  expect_refused("columns of pairs have different lengths");
}
TEST_F(BrokenColumns, DisorderedPairsAreRefused) {
  std::swap(columns.sources[1], columns.sources[2]);
  expect_refused("pairs are not in the order of their takes, roles and frames");
}
TEST_F(BrokenColumns, UnknownTakesAndBodiesAreRefused) {
  columns.takes[1].body_b = 2;
  expect_refused("a take names a body that does not exist");
  columns.takes[1].body_b = 1;
  columns.sources.back().take = 2;
  expect_refused("a pair names a take that does not exist");
}
TEST_F(BrokenColumns, FramesBeyondTheTakeAreRefused) {
  columns.sources.back().frame = 10;
  expect_refused("a pair names a frame that its take does not have");
}
TEST_F(BrokenColumns, VerticesBeyondTheBodiesAreRefused) {
  columns.edges[5][1] = 50;
  expect_refused("an edge names a vertex that does not exist");
}
TEST_F(BrokenColumns, OffsetsThatDescendAreRefused) {
  std::swap(columns.edge_offsets[1], columns.edge_offsets[2]);
  expect_refused("edge offsets are not ascending from 0 to the number of edges");
}
TEST_F(BrokenColumns, PositionsThatAreNoNumbersAreRefused) {
  columns.poses[3](7, 1) = std::numeric_limits<double>::infinity();
  expect_refused("a position is not a finite number, or too large for one in metres");
}
TEST_F(BrokenColumns, PositionsWhoseSquaresAreNoNumbersAreRefused) {
  columns.poses[3](7, 1) = 1e200;
  expect_refused("a position is not a finite number, or too large for one in metres");
}
TEST_F(BrokenColumns, ATakeOfAnInfiniteRateIsRefused) {
  columns.takes[0].fps = std::numeric_limits<double>::infinity();
  expect_refused("a take has no frame rate, frames or stride");
}
TEST_F(BrokenColumns, NothingAtAllIsRefused) {
  columns = {};
  expect_refused("there are no pairs");
}

TEST(MotionLibrary, TheUsualBodiesOfADoubledLibraryAreTwoPeople) {
  auto library =
      build_library("test", {circling_take("t", 10)}, {}, {});  // roles unknown: each leads as often
  ASSERT_TRUE(library.ok());
  EXPECT_EQ(library->usual_active_body().name, "t/a");
  EXPECT_EQ(library->usual_passive_body().name, "t/b");
}

TEST(MotionLibrary, RefusesAMeshWithAnEdgeTwice) {
  LibraryColumns columns = switching_library().columns();
  columns.edges[1] = columns.edges[0];
  EXPECT_THROW(MotionLibrary{columns}, std::invalid_argument);
}

TEST(MotionLibrary, RefusesABodyWithoutLengths) {
  LibraryColumns columns = switching_library().columns();
  for (const double length : {std::numeric_limits<double>::quiet_NaN(), -0.1, 1e200}) {
    columns.bodies[0].body.bone_lengths[5] = length;
    EXPECT_THROW(MotionLibrary{columns}, std::invalid_argument) << length;
  }
}

TEST(MotionLibrary, AMeshQualityThatThereIsNotIsRefused) {
  LibraryColumns columns = switching_library().columns();
  columns.mesh_quality.back() = 200;
  EXPECT_THROW(MotionLibrary(std::move(columns)), std::invalid_argument);
}

}  // namespace
}  // namespace abrazo::motion_library_test
