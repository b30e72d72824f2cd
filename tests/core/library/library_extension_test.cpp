#include "core/library/build/library_extension.hpp"

#include <gtest/gtest.h>

#include "tests/support/libraries.hpp"

namespace abrazo::library_extension_test {
namespace {

/// A take of performers whose bones no one else has.
PairedTake take_of_size(const std::string& name, unsigned seed, double size) {
  PairedTake take = test::swinging_take(name, 60, seed);
  for (Pose& pose : take.a.poses) pose *= size;
  for (Pose& pose : take.b.poses) pose *= size;
  return take;
}

MotionLibrary built(std::vector<PairedTake> takes, const LibraryBuildOptions& options = {}) {
  return std::move(*build_library("l", std::move(takes), options, {}));
}

void expect_same_pairs(const LibraryColumns& a, const LibraryColumns& b) {
  ASSERT_EQ(a.sources.size(), b.sources.size());
  for (std::size_t i = 0; i < a.sources.size(); ++i) {
    ASSERT_EQ(a.sources[i].take, b.sources[i].take);
    ASSERT_EQ(a.sources[i].frame, b.sources[i].frame);
    ASSERT_EQ(a.sources[i].swapped, b.sources[i].swapped);
    ASSERT_EQ(a.sources[i].annotated, b.sources[i].annotated);
    ASSERT_EQ(a.roots[i].position, b.roots[i].position);
    ASSERT_EQ(a.roots[i].heading_rad, b.roots[i].heading_rad);
    ASSERT_EQ(a.poses[i], b.poses[i]);
    ASSERT_EQ(a.features[i], b.features[i]);
  }
  EXPECT_EQ(a.edge_offsets, b.edge_offsets);
  EXPECT_EQ(a.edges, b.edges);
  EXPECT_EQ(a.tetrahedron_offsets, b.tetrahedron_offsets);
  EXPECT_EQ(a.tetrahedra, b.tetrahedra);
  EXPECT_EQ(a.mesh_quality, b.mesh_quality);
  EXPECT_EQ(a.rate_hz, b.rate_hz);
  EXPECT_EQ(a.name, b.name);
}

void expect_same_bodies(const LibraryColumns& a, const LibraryColumns& b, bool with_radii) {
  ASSERT_EQ(a.bodies.size(), b.bodies.size());
  for (std::size_t i = 0; i < a.bodies.size(); ++i) {
    EXPECT_EQ(a.bodies[i].name, b.bodies[i].name);
    EXPECT_EQ(a.bodies[i].body.bone_lengths, b.bodies[i].body.bone_lengths);
    EXPECT_EQ(a.bodies[i].body.pseudo_lengths, b.bodies[i].body.pseudo_lengths);
    EXPECT_EQ(a.bodies[i].body.toe_rest_height, b.bodies[i].body.toe_rest_height);
    if (with_radii) {
      EXPECT_EQ(a.bodies[i].capsule_radii, b.bodies[i].capsule_radii);
    }
  }
  for (std::size_t t = 0; t < a.takes.size(); ++t) {
    EXPECT_EQ(a.takes[t].body_a, b.takes[t].body_a);
    EXPECT_EQ(a.takes[t].body_b, b.takes[t].body_b);
  }
}

TEST(LibraryExtension, WithNewPerformersIsTheSameToTheBitAsBuildingWithTheTake) {
  PairedTake added = take_of_size("new", 3, 1.05);
  added.roles.clear();
  const MotionLibrary extended =
      *extend_library(built({take_of_size("one", 1, 1), take_of_size("two", 2, 1)}), added, {}, {});
  const MotionLibrary rebuilt = built({take_of_size("one", 1, 1), take_of_size("two", 2, 1), added});
  expect_same_pairs(extended.columns(), rebuilt.columns());
  expect_same_bodies(extended.columns(), rebuilt.columns(), true);
  ASSERT_EQ(extended.takes().size(), 3U);
  EXPECT_EQ(extended.takes()[2].name, "new");
  EXPECT_EQ(extended.takes()[2].labels.size(), 2U);
}

TEST(LibraryExtension, KnownPerformersKeepTheirRadii) {
  const MotionLibrary before = built({take_of_size("one", 1, 1)});
  const MotionLibrary extended = *extend_library(before, take_of_size("two", 2, 1), {}, {});
  const MotionLibrary rebuilt = built({take_of_size("one", 1, 1), take_of_size("two", 2, 1)});
  expect_same_pairs(extended.columns(), rebuilt.columns());
  expect_same_bodies(extended.columns(), rebuilt.columns(), false);
  for (std::size_t i = 0; i < before.bodies().size(); ++i)
    EXPECT_EQ(extended.bodies()[i].capsule_radii, before.bodies()[i].capsule_radii);
}

TEST(LibraryExtension, IsThinnedAndDoubledLikeTheLibrary) {
  LibraryBuildOptions options;
  options.rate_hz = 30;
  options.both_roles = true;
  const PairedTake added = take_of_size("new", 3, 1.05);
  const MotionLibrary extended =
      *extend_library(built({take_of_size("one", 1, 1)}, options), added, options, {});
  const MotionLibrary rebuilt = built({take_of_size("one", 1, 1), added}, options);
  expect_same_pairs(extended.columns(), rebuilt.columns());
  expect_same_bodies(extended.columns(), rebuilt.columns(), true);
}

TEST(LibraryExtension, RefusesATakeOfAKnownNameAndABrokenOne) {
  const MotionLibrary library = built({take_of_size("one", 1, 1)});
  const auto again = extend_library(library, take_of_size("one", 2, 1), {}, {});
  ASSERT_FALSE(again);
  EXPECT_NE(again.error().text().find("give another name"), std::string::npos);
  PairedTake broken = take_of_size("two", 2, 1);
  broken.b.poses.pop_back();
  EXPECT_FALSE(extend_library(library, broken, {}, {}));
  EXPECT_FALSE(extend_library(library, PairedTake{}, {}, {}));
}

}  // namespace
}  // namespace abrazo::library_extension_test
