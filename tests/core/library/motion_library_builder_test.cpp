#include "core/library/build/motion_library_builder.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <mutex>
#include <stdexcept>
#include <thread>

#include "core/mesh/interaction_mesh.hpp"
#include "tests/core/library/synthetic_takes.hpp"
#include "tests/support/bodies.hpp"

namespace abrazo::motion_library_builder_test {
namespace {

using test::circling_take;
using testing::HasSubstr;

MotionLibrary built(std::vector<PairedTake> takes, const LibraryBuildOptions& options = {}) {
  auto library = build_library("test", std::move(takes), options, {});
  if (!library) throw std::runtime_error(library.error().text());
  return std::move(*library);
}

Error refusal(std::vector<PairedTake> takes, const LibraryBuildOptions& options = {}) {
  const auto library = build_library("test", std::move(takes), options, {});
  EXPECT_FALSE(library.ok());
  return library.ok() ? Error{} : library.error();
}

PairedTake with_roles(PairedTake take, std::vector<RoleInterval> roles) {
  take.roles = std::move(roles);
  return take;
}

TEST(MotionLibraryBuilder, KeepsEveryFrameOnceWhenTheActivePerformerIsKnown) {
  const MotionLibrary library = built({with_roles(circling_take("t", 20), {{0, 20, ActivePerformer::A}})});
  ASSERT_EQ(library.pair_count(), 20);
  for (int pair = 0; pair < 20; ++pair) {
    EXPECT_EQ(library.source(pair).frame, static_cast<std::uint32_t>(pair));
    EXPECT_FALSE(library.source(pair).swapped);
    EXPECT_EQ(library.source(pair).annotated, ActivePerformer::A);
  }
}

TEST(MotionLibraryBuilder, DoublesFramesWhoseActivePerformerIsUnknown) {
  const MotionLibrary library = built({circling_take("t", 20)});
  ASSERT_EQ(library.pair_count(), 40);
  EXPECT_GE(library.find_pair("t", 7, false), 0);
  EXPECT_GE(library.find_pair("t", 7, true), 0);
  EXPECT_EQ(library.source(39).annotated, ActivePerformer::Unknown);
}

TEST(MotionLibraryBuilder, SwapsFramesInWhichPerformerBIsActive) {
  const PairedTake take =
      with_roles(circling_take("t", 20), {{0, 5, ActivePerformer::A}, {5, 15, ActivePerformer::B}});
  const MotionLibrary library = built({take});
  EXPECT_EQ(library.pair_count(), 5 + 10 + 2 * 5);
  EXPECT_LT(library.find_pair("t", 7, false), 0);
  const int pair = library.find_pair("t", 7, true);
  ASSERT_GE(pair, 0);
  const RootFrame root = root_frame(take.b.poses[7]);
  EXPECT_EQ(library.root(pair).position, root.position);
  EXPECT_EQ(library.pose(pair).topRows<joint_count>(), to_normalized(take.b.poses[7], root));
  EXPECT_EQ(library.pose(pair).bottomRows<joint_count>(), to_normalized(take.a.poses[7], root));
}

TEST(MotionLibraryBuilder, RowsAreTheNormalizedPairItsFeaturesAndItsMesh) {
  const PairedTake take = with_roles(circling_take("t", 12), {{0, 12, ActivePerformer::A}});
  const MotionLibrary library = built({take});
  for (int pair = 0; pair < library.pair_count(); ++pair) {
    const RootFrame root = root_frame(take.a.poses[static_cast<std::size_t>(pair)]);
    PairPose pose;
    pose << to_normalized(take.a.poses[static_cast<std::size_t>(pair)], root),
        to_normalized(take.b.poses[static_cast<std::size_t>(pair)], root);
    EXPECT_EQ(library.pose(pair), pose);
    EXPECT_EQ(library.features(pair), pose_features(pose.topRows<joint_count>()));
    const InteractionMesh mesh = tetrahedralize(pose);
    EXPECT_THAT(library.edges(pair), testing::ElementsAreArray(mesh.edges));
    EXPECT_THAT(library.tetrahedra(pair), testing::ElementsAreArray(mesh.tetrahedra));
  }
}

TEST(MotionLibraryBuilder, TakesTheHeadingOfTheFrameBeforeWhenHipsSayNothing) {
  PairedTake take = with_roles(circling_take("t", 9), {{0, 9, ActivePerformer::A}});
  Pose& lying = take.a.poses[4];
  lying.row(joints::left_hip) = lying.row(joints::right_hip) + Eigen::RowVector3d(0, 0.2, 0);
  const MotionLibrary every = built({take});
  EXPECT_EQ(every.root(4).heading_rad, every.root(3).heading_rad);
  LibraryBuildOptions thinned;
  thinned.rate_hz = 15;
  const MotionLibrary fourth = built({take}, thinned);
  EXPECT_EQ(fourth.root(1).heading_rad, every.root(4).heading_rad) << "thinning must not change a pair";
}

TEST(MotionLibraryBuilder, ThinsByWholeStrides) {
  LibraryBuildOptions options;
  options.rate_hz = 17;
  const MotionLibrary library =
      built({with_roles(circling_take("t", 20), {{0, 20, ActivePerformer::A}})}, options);
  EXPECT_EQ(library.takes()[0].frame_stride, 4);
  EXPECT_EQ(library.rate_hz(), 15);
  ASSERT_EQ(library.pair_count(), 5);
  EXPECT_EQ(library.source(4).frame, 16U);
}

TEST(MotionLibraryBuilder, TakesTheStrideNearestToTheWantedRate) {
  LibraryBuildOptions options;
  options.rate_hz = 25;  // 60 / 25 = 2.4
  EXPECT_EQ(built({circling_take("t", 20)}, options).takes()[0].frame_stride, 2);
}

TEST(MotionLibraryBuilder, NeverThickens) {
  LibraryBuildOptions options;
  options.rate_hz = 240;
  EXPECT_EQ(built({circling_take("t", 5)}, options).takes()[0].frame_stride, 1);
}

TEST(MotionLibraryBuilder, PerformersWithTheSameBonesAreOneBody) {
  const MotionLibrary library = built({circling_take("t1", 30, 0.8, 1), circling_take("t2", 30, 0.7, 2)});
  ASSERT_EQ(library.bodies().size(), 2U);
  EXPECT_EQ(library.bodies()[0].name, "t1/a");
  EXPECT_EQ(library.bodies()[1].name, "t1/b");
  EXPECT_EQ(library.takes()[1].body_a, 0U);
  EXPECT_EQ(library.takes()[1].body_b, 1U);
}

TEST(MotionLibraryBuilder, GivesTheSameLibraryEveryTime) {
  const auto takes = [] {
    return std::vector<PairedTake>{circling_take("t1", 150), circling_take("t2", 150, 0.5, 2)};
  };
  const MotionLibrary first = built(takes());
  const MotionLibrary second = built(takes());
  EXPECT_EQ(first.columns().edges, second.columns().edges);
  EXPECT_EQ(first.columns().tetrahedron_offsets, second.columns().tetrahedron_offsets);
  EXPECT_EQ(first.columns().tetrahedra, second.columns().tetrahedra);
  EXPECT_TRUE(
      std::equal(first.columns().poses.begin(), first.columns().poses.end(), second.columns().poses.begin()));
  EXPECT_EQ(first.bodies()[0].capsule_radii, second.bodies()[0].capsule_radii);
}

TEST(MotionLibraryBuilder, AllCoresAndSeveralBuildsAtOnceGiveTheMeshesOfOneThread) {
  constexpr int builds = 3;
  std::vector<MotionLibrary> libraries;
  std::mutex guard;
  {
    std::vector<std::jthread> builders;
    for (int build = 0; build < builds; ++build)
      builders.emplace_back([&, build] {
        // At distances from touching to across a hall: filters of one size are wrong for another.
        MotionLibrary library =
            built({circling_take("t", 200, 0.3 * std::pow(10.0, build), static_cast<unsigned>(build))});
        const std::scoped_lock lock(guard);
        libraries.push_back(std::move(library));
      });
  }
  ASSERT_EQ(libraries.size(), static_cast<std::size_t>(builds));
  for (const MotionLibrary& library : libraries)
    for (int pair = 0; pair < library.pair_count(); ++pair) {
      const InteractionMesh alone = tetrahedralize(library.pose(pair));
      ASSERT_TRUE(std::ranges::equal(library.tetrahedra(pair), alone.tetrahedra)) << "pair " << pair;
      ASSERT_TRUE(std::ranges::equal(library.edges(pair), alone.edges)) << "pair " << pair;
    }
}

TEST(MotionLibraryBuilder, LeavesOutExcludedTakes) {
  LibraryBuildOptions options;
  options.excluded_takes = {"t1"};
  const MotionLibrary library = built({circling_take("t1", 5), circling_take("t2", 5)}, options);
  ASSERT_EQ(library.takes().size(), 1U);
  EXPECT_EQ(library.takes()[0].name, "t2");
}

TEST(MotionLibraryBuilder, RefusesToExcludeATakeThatIsNotThere) {
  LibraryBuildOptions options;
  options.excluded_takes = {"t3"};
  EXPECT_THAT(refusal({circling_take("t1", 5), circling_take("t2", 5)}, options).message,
              HasSubstr("no take \"t3\" to exclude; there are t1, t2"));
  options.excluded_takes = {"t1"};
  EXPECT_THAT(refusal({circling_take("t1", 5)}, options).message, HasSubstr("no take is left"));
}

TEST(MotionLibraryBuilder, SaysWhichJointOfWhichFrameIsNotANumber) {
  PairedTake take = circling_take("t", 5);
  take.b.poses[3](joints::Head, 1) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THAT(refusal({take}).text(),
              HasSubstr("take t/b: the position of head at frame 3 is not a finite number"));
}

TEST(MotionLibraryBuilder, SaysWhichJointOfWhichFrameIsTooFarAway) {
  PairedTake take = circling_take("t", 5);
  take.b.poses[3](joints::Head, 1) = 2e6;
  EXPECT_THAT(refusal({take}).text(),
              HasSubstr("take t/b: head at frame 3 is more than 1000 km from the origin; check the unit"));
}

TEST(MotionLibraryBuilder, RefusesTakesThatAreTooShortOrUneven) {
  EXPECT_THAT(refusal({circling_take("t", 1)}).text(), HasSubstr("take t: has 1 frames; at least 2"));
  PairedTake uneven = circling_take("t", 5);
  uneven.b.poses.pop_back();
  EXPECT_THAT(refusal({uneven}).text(), HasSubstr("performer a has 5 frames and b 4"));
}

TEST(MotionLibraryBuilder, RefusesTwoTakesOfOneName) {
  EXPECT_THAT(refusal({circling_take("t", 5), circling_take("t", 5)}).text(),
              HasSubstr("take t: two takes have this name"));
}

TEST(MotionLibraryBuilder, RefusesAnImpossibleRateAndDisorderedIntervals) {
  LibraryBuildOptions options;
  options.rate_hz = -1;
  EXPECT_THAT(refusal({circling_take("t", 5)}, options).message,
              HasSubstr("a rate of -1 Hz is not possible"));
  EXPECT_THAT(
      refusal({with_roles(circling_take("t", 5), {{0, 3, ActivePerformer::A}, {2, 4, ActivePerformer::B}})})
          .message,
      HasSubstr("role 1 [2, 4)"));
}

TEST(MotionLibraryBuilder, ReportsItsProgressInOrderAndToTheEnd) {
  std::vector<double> fractions;
  const auto library =
      build_library("test", {circling_take("t", 200)}, {}, [&](double fraction, std::string_view) {
        fractions.push_back(fraction);
        return true;
      });
  ASSERT_TRUE(library.ok());
  EXPECT_TRUE(std::is_sorted(fractions.begin(), fractions.end()));
  EXPECT_EQ(fractions.back(), 1.0);
}

TEST(MotionLibraryBuilder, StopsWhenAsked) {
  for (const double at : {0.0, 0.3, 1.0}) {
    const auto library = build_library("test", {circling_take("t", 400)}, {},
                                       [&](double fraction, std::string_view) { return fraction < at; });
    ASSERT_FALSE(library.ok());
    EXPECT_EQ(library.error().message, "cancelled");
  }
}

}  // namespace
}  // namespace abrazo::motion_library_builder_test
