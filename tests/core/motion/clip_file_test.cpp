#include "core/motion/files/clip_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "core/base/atomic_file.hpp"
#include "core/base/text.hpp"
#include "core/motion/bvh/bvh.hpp"
#include "core/motion/files/import_clip.hpp"
#include "tests/support/bodies.hpp"
#include "tests/support/libraries.hpp"

namespace abrazo::clip_file_test {
namespace {

using ::testing::HasSubstr;

std::vector<Clip> couple() {
  auto take = test::swinging_take("dance", 90, 1);
  take.a.name = "active";
  take.b.name = "passive";
  return {take.a, take.b};
}

std::vector<Clip> read_back(const std::string& bvh, std::optional<double> unit = {},
                            std::optional<UpAxis> up = {}) {
  const auto motions = read_bvh(bvh, "pair.bvh");
  EXPECT_TRUE(motions) << motions.error().text();
  std::vector<Clip> clips;
  for (const NamedMotion& motion : *motions) {
    ImportOptions options;
    options.metres_per_unit = unit;
    options.up_axis = up;
    auto imported = import_clip(motion, options);
    EXPECT_TRUE(imported) << imported.error().text();
    clips.push_back(imported->clip);
  }
  return clips;
}

/// Largest distance of a joint [m], but for a common shift in height: an import puts the feet on the floor.
double distance(const Clip& a, const Clip& b) {
  EXPECT_EQ(a.poses.size(), b.poses.size());
  EXPECT_NEAR(a.fps, b.fps, 1e-6);
  const double shift = a.poses.front()(0, 1) - b.poses.front()(0, 1);
  double most = 0;
  for (std::size_t f = 0; f < std::min(a.poses.size(), b.poses.size()); ++f) {
    Pose difference = a.poses[f] - b.poses[f];
    difference.col(1).array() -= shift;
    most = std::max(most, difference.rowwise().norm().maxCoeff());
  }
  return most;
}

TEST(ClipFile, ABvhReadAndWrittenAgainMeansTheSame) {
  const auto once = read_back(*clip_file_content("a.bvh", couple()), 1.0, UpAxis::Y);
  ASSERT_EQ(once.size(), 2U);
  EXPECT_EQ(once[0].name, "active");
  EXPECT_EQ(once[1].name, "passive");
  for (std::size_t c = 0; c < 2; ++c) EXPECT_LT(distance(couple()[c], once[c]), 1e-3);
  const auto twice = read_back(*clip_file_content("a.bvh", once), 1.0, UpAxis::Y);
  for (std::size_t c = 0; c < 2; ++c) EXPECT_LT(distance(once[c], twice[c]), 1e-5) << "six digits";
}

TEST(ClipFile, UnitAndAxisOfABvhAreOnlyAnotherWayToSayIt) {
  const auto metres = read_back(*clip_file_content("a.bvh", couple()), 1.0, UpAxis::Y);
  const auto centimetres =
      read_back(*clip_file_content("a.bvh", couple(), {100, UpAxis::Y}), 0.01, UpAxis::Y);
  const auto z_up = read_back(*clip_file_content("a.bvh", couple(), {100, UpAxis::Z}), 0.01, UpAxis::Z);
  for (std::size_t c = 0; c < 2; ++c) {
    EXPECT_LT(distance(metres[c], centimetres[c]), 1e-5);
    EXPECT_LT(distance(metres[c], z_up[c]), 1e-3);
  }
}

TEST(ClipFile, ACsvHasTheUnitAndAxisThatWereAskedFor) {
  const auto row = [](const ClipFileSpace& space) {
    const std::vector<Clip> clips = couple();
    const std::string text = *clip_file_content("a.csv", std::span(clips).first(1), space);
    const auto fields = split_fields(split_lines(text)[1], ',');
    return Vec3(*parse_number(fields[2]), *parse_number(fields[3]), *parse_number(fields[4]));
  };
  const Vec3 root = couple()[0].poses[0].row(0).transpose();
  EXPECT_EQ(row({}), root);
  EXPECT_EQ(row({100, UpAxis::Y}), 100 * root);
  EXPECT_EQ(row({1, UpAxis::Z}), Vec3(root.x(), -root.z(), root.y())) << "y goes to the back";
}

TEST(ClipFile, WhatATypeCannotHoldIsRefused) {
  EXPECT_THAT(check_clip_file("a.fbx").error().message, HasSubstr(".bvh, .glb, .csv, .npz or .npy"));
  EXPECT_THAT(check_clip_file("a.glb", {100, UpAxis::Y}).error().message, HasSubstr("metres with Y up"));
  EXPECT_TRUE(check_clip_file("a.glb"));
  EXPECT_FALSE(clip_file_content("a.glb", couple(), {1, UpAxis::Z}));
}

}  // namespace
}  // namespace abrazo::clip_file_test
