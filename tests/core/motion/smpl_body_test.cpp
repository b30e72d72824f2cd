// SMPL parameters with a made-up body model. tests/python/smpl_body_check.py compares whole motions with
// NumPy.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numbers>

#include "core/base/limits.hpp"
#include "core/motion/numpy/numpy_file.hpp"
#include "core/motion/numpy/numpy_reader.hpp"
#include "core/motion/numpy/smpl_body.hpp"
#include "tests/core/motion/motion_fixtures.hpp"
#include "tests/core/motion/numpy_fixtures.hpp"

namespace abrazo::smpl_body_test {
namespace {

using test::NpyBytes;
using test::place;
using ::testing::HasSubstr;

constexpr std::uint64_t chain_joints = 24;

using Arrays = std::map<std::string, std::string>;

std::string npz(const Arrays& arrays) {
  std::vector<ZipContent> files;
  for (const auto& [name, bytes] : arrays) files.push_back({name + ".npy", bytes});
  return write_zip(files).value();
}

std::string numbers(const std::vector<std::uint64_t>& shape, const std::vector<double>& values) {
  return NpyBytes{"<f8", false, shape}.of(values);
}

/// A chain up the Y axis, 10 cm a joint, each a vertex of its own; one shape moves the last joint along X.
Arrays chain_model() {
  std::vector<double> tree(2 * chain_joints), regressor(chain_joints * chain_joints),
      vertices(3 * chain_joints), shapes(3 * chain_joints);
  for (std::size_t j = 0; j < chain_joints; ++j) {
    tree[j] = j == 0 ? 4294967295.0 : static_cast<double>(j - 1);
    tree[chain_joints + j] = static_cast<double>(j);
    regressor[j * chain_joints + j] = 1;
    vertices[3 * j + 1] = 0.1 * static_cast<double>(j);
  }
  shapes[3 * (chain_joints - 1)] = 0.02;
  return {{"kintree_table", numbers({2, chain_joints}, tree)},
          {"J_regressor", numbers({chain_joints, chain_joints}, regressor)},
          {"v_template", numbers({chain_joints, 3}, vertices)},
          {"shapedirs", numbers({chain_joints, 3, 1}, shapes)}};
}

/// One frame; joint 1 turns by a right angle about Z.
Arrays bent_motion() {
  std::vector<double> poses(3 * chain_joints);
  poses[5] = std::numbers::pi / 2;
  return {{"poses", numbers({1, 3 * chain_joints}, poses)},
          {"trans", numbers({1, 3}, {1, 2, 3})},
          {"betas", numbers({1}, {0.5})}};
}

Result<std::vector<NamedMotion>> read(const std::string& motion, const std::string& model) {
  return read_numpy(motion, std::nullopt, "dance.npz", {model, "body.npz"});
}
std::string refusal(const std::string& motion, const std::string& model) {
  const auto motions = read(motion, model);
  return motions ? "was read" : motions.error().text();
}
std::string with(Arrays arrays, const std::string& name, const std::string& bytes) {
  arrays[name] = bytes;
  return npz(arrays);
}
std::string without(Arrays arrays, const std::string& name) {
  arrays.erase(name);
  return npz(arrays);
}

TEST(SmplBody, JointsFollowFromTheBodyAsThePoseBendsIt) {
  const auto motions = read(npz(bent_motion()), npz(chain_model()));
  ASSERT_TRUE(motions) << motions.error().text();
  const NamedMotion& motion = motions->front();
  ASSERT_EQ(motion.frames.size(), 1U);
  test::expect_near(place(motion, 0, "Pelvis"), {1, 2, 3}, 1e-12);
  // Behind joint 1 the chain runs along -X: joint 23 at 2.2 m, and its shape 0.5 * 2 cm along Y.
  const Positions& frame = motion.frames[0];
  test::expect_near(frame.row(23).transpose(), {1 - 2.2, 2 + 0.1 + 0.01, 3}, 1e-12);
}

TEST(SmplBody, IsRefusedWhereTheBodyModelIsNone) {
  const std::string motion = npz(bent_motion());
  EXPECT_THAT(refusal(motion, "\x80\x02}q\x01(U\tJ_regressor"),  // a pickle, as the makers distribute it
              HasSubstr("body.npz: "));
  EXPECT_THAT(refusal(motion, ""), HasSubstr("body.npz: "));
  const std::string model = npz(chain_model());
  EXPECT_THAT(refusal(motion, model.substr(0, model.size() / 2)), HasSubstr("body.npz"));
}

TEST(SmplBody, SaysWhichArrayOfTheBodyModelIsWrong) {
  const std::string motion = npz(bent_motion());
  EXPECT_THAT(refusal(motion, without(chain_model(), "shapedirs")),
              HasSubstr("body.npz: has no array shapedirs (24, 3, shapes); it has"));
  EXPECT_THAT(refusal(motion, with(chain_model(), "v_template", numbers({8, 3}, std::vector<double>(24)))),
              HasSubstr("v_template: has the shape (8, 3); expected (24, 3)"));
  std::vector<double> round(2 * chain_joints, 5);
  EXPECT_THAT(refusal(motion, with(chain_model(), "kintree_table", numbers({2, chain_joints}, round))),
              HasSubstr("kintree_table: joint 1 has a parent that is no joint before it"));
  round.assign(2 * chain_joints, 0.5);
  EXPECT_THAT(refusal(motion, with(chain_model(), "kintree_table", numbers({2, chain_joints}, round))),
              HasSubstr("kintree_table: joint 1 has a parent that is no joint before it"));
  std::vector<double> nowhere(3 * chain_joints, std::nan(""));
  EXPECT_THAT(refusal(motion, with(chain_model(), "v_template", numbers({chain_joints, 3}, nowhere))),
              HasSubstr("has places of joints that are no numbers"));
}

TEST(SmplBody, SaysWhatOfTheMotionDoesNotFit) {
  const std::string model = npz(chain_model());
  EXPECT_THAT(refusal(with(bent_motion(), "poses", numbers({1, 66}, std::vector<double>(66))), model),
              HasSubstr("angles of 22 joints, and the body model has 24"));
  EXPECT_THAT(refusal(with(bent_motion(), "trans", numbers({2, 3}, std::vector<double>(6))), model),
              HasSubstr("trans: has the shape (2, 3); expected (1, 3)"));
  EXPECT_THAT(refusal(with(bent_motion(), "betas", numbers({3}, {0, 0, 0})), model),
              HasSubstr("has 1 shapes, and the motion 3 betas"));
  EXPECT_THAT(refusal(npz(chain_model()), model), HasSubstr("holds no parameters of an SMPL body"));
}

TEST(SmplBody, OfMoreThanAnyBodyModelHasIsRefusedBeforeAnythingIsComputed) {
  const std::string motion = npz(bent_motion());
  const auto zeros = [](std::vector<std::uint64_t> shape) {
    std::uint64_t count = 1;
    for (const std::uint64_t extent : shape) count *= extent;
    return NpyBytes{"|i1", false, shape}.of(std::vector<double>(count));
  };
  EXPECT_THAT(refusal(motion, with(chain_model(), "J_regressor", zeros({56, 24}))),
              HasSubstr("J_regressor: has the shape (56, 24); body models of up to 55 joints are read"));
  EXPECT_THAT(refusal(motion, with(chain_model(), "J_regressor", zeros({24, limits::body_vertices + 1}))),
              HasSubstr("up to 20000 vertices"));
  EXPECT_THAT(refusal(motion, with(chain_model(), "J_regressor", zeros({24, limits::body_vertices}))),
              HasSubstr("v_template: has the shape (24, 3)"))
      << "which has fewer";
  EXPECT_THAT(refusal(motion, with(chain_model(), "shapedirs", zeros({24, 3, limits::body_shapes + 1}))),
              HasSubstr("up to 1000 shapes"));
  EXPECT_EQ(refusal(motion, with(chain_model(), "shapedirs", zeros({24, 3, limits::body_shapes}))),
            "was read");
}

TEST(SmplBody, AnglesOfAnotherNumberOfJointsAreRefused) {
  const auto parts = [](std::uint64_t width) {
    return npz({{"root_orient", numbers({1, 3}, {0, 0, 0})},
                {"pose_body", numbers({1, width}, std::vector<double>(width))},
                {"trans", numbers({1, 3}, {1, 2, 3})}});
  };
  const std::string model = npz(chain_model());
  EXPECT_EQ(refusal(parts(63), model), "was read");
  EXPECT_EQ(refusal(parts(69), model), "was read");
  EXPECT_THAT(refusal(parts(60), model), HasSubstr("pose_body: has angles of 60 columns; expected 63"));
}

}  // namespace
}  // namespace abrazo::smpl_body_test
