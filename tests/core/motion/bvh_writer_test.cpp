#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include "core/base/text.hpp"
#include "core/motion/body/body.hpp"
#include "core/motion/bvh/bvh.hpp"
#include "core/motion/files/import_clip.hpp"
#include "tests/core/motion/motion_fixtures.hpp"
#include "tests/support/bodies.hpp"
#include "tests/support/captured_data.hpp"

namespace abrazo::bvh_writer_test {
namespace {

using ::testing::HasSubstr;

/// As told: metres, Y up; nothing to guess, nothing to move.
std::vector<Clip> read_back(const std::string& text, double metres_per_unit = 1.0) {
  const auto motions = read_bvh(text, "written.bvh");
  if (!motions) {
    ADD_FAILURE() << motions.error().text();
    return {};
  }
  ImportOptions options;
  options.metres_per_unit = metres_per_unit;
  options.up_axis = UpAxis::Y;
  std::vector<Clip> clips;
  for (const NamedMotion& motion : *motions) {
    EXPECT_TRUE(motion.warnings.empty()) << motion.warnings.front().detail;
    const auto imported = import_clip(motion, options);
    if (!imported) {
      ADD_FAILURE() << imported.error().text();
      return {};
    }
    EXPECT_EQ(imported->report.joint_map, "cmu");
    EXPECT_EQ(imported->report.floor_shift_m, 0.0);
    clips.push_back(imported->clip);
  }
  return clips;
}

double largest_error_m(const Clip& written, const Clip& read) {
  if (written.poses.size() != read.poses.size()) return 1e9;
  double largest = 0;
  for (std::size_t f = 0; f < written.poses.size(); ++f)
    largest = std::max(largest, (written.poses[f] - read.poses[f]).rowwise().norm().maxCoeff());
  return largest;
}

/// A body of constant bone lengths whose every bone points anywhere, pelvis rigid: the hardest poses there
/// are.
Clip random_poses(int frames, unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  const Body body = body_of(test::standing_pose());
  Clip clip{"random", 60.0, {}};
  for (int f = 0; f < frames; ++f) {
    const Eigen::Matrix3d pelvis =
        Eigen::Quaterniond(normal(random), normal(random), normal(random), normal(random))
            .normalized()
            .toRotationMatrix();
    Pose pose = test::standing_pose();
    for (int j = 1; j < joint_count; ++j) {
      const int parent = joint_parents[static_cast<std::size_t>(j)];
      Vec3 bone_vector = Vec3(normal(random), normal(random), normal(random)).normalized() *
                         body.bone_lengths[static_cast<std::size_t>(j - 1)];
      if (j == joints::left_hip || j == joints::right_hip)
        bone_vector = pelvis * (test::standing_pose().row(j) - test::standing_pose().row(0)).transpose();
      pose.row(j) = pose.row(parent) + bone_vector.transpose();
    }
    pose.col(1).array() += 0.04 - std::min(pose(joints::left_toe_base, 1), pose(joints::right_toe_base, 1));
    clip.poses.push_back(pose);
  }
  return clip;
}

TEST(BvhWriter, WritesTheStandingPose) {
  const Clip clip{"stand", 60.0, std::vector<Pose>(3, test::standing_pose())};
  const auto text = write_bvh(std::vector<Clip>{clip});
  ASSERT_TRUE(text);
  const auto clips = read_back(*text);
  ASSERT_EQ(clips.size(), 1u);
  EXPECT_EQ(clips[0].fps, 60.0);
  EXPECT_LT(largest_error_m(clip, clips[0]), 1e-5);
}

TEST(BvhWriter, AimsEveryBoneByItself) {
  const Clip clip = random_poses(300, 5);
  const auto text = write_bvh(std::vector<Clip>{clip});
  ASSERT_TRUE(text);
  // Six digits of metres and degrees leave some micrometres at the end of the longest chain.
  EXPECT_LT(largest_error_m(clip, read_back(*text).at(0)), 1e-5);
}

TEST(BvhWriter, SurvivesBonesThatPointAgainstTheirRestDirection) {
  Clip clip{"handstand", 60.0, {}};
  Pose upside_down = test::standing_pose();
  upside_down.col(1) *= -1;
  upside_down.col(0) *= -1;
  upside_down.col(1).array() += 1.7;
  Pose folded =
      test::standing_pose();  // the forearm straight back along the upper arm, the shin along the thigh
  folded.row(joints::left_wrist) = folded.row(joints::left_elbow) +
                                   0.9 * (folded.row(joints::left_shoulder) - folded.row(joints::left_elbow));
  folded.row(joints::left_ankle) =
      folded.row(joints::left_knee) + (folded.row(joints::left_hip) - folded.row(joints::left_knee));
  for (const Pose& pose : {upside_down, folded}) {
    Clip still{"still", 60.0, std::vector<Pose>(2, pose)};
    ASSERT_TRUE(write_bvh(std::vector<Clip>{still}));
    const auto motions = read_bvh(write_bvh(std::vector<Clip>{still}).value(), "still.bvh");
    ASSERT_TRUE(motions);
    const auto binding = bind_joints(builtin_joint_maps()[0], motions->front().points);
    EXPECT_LT((binding.joints_of(motions->front().frames[0]) - pose).rowwise().norm().maxCoeff(), 1e-5);
  }
}

TEST(BvhWriter, WritesAPelvisThatIsAStraightLine) {
  Pose pose = test::standing_pose();
  pose.row(joints::left_hip) = pose.row(0) + Eigen::RowVector3d(0.1, 0, 0);
  pose.row(joints::right_hip) = pose.row(0) - Eigen::RowVector3d(0.1, 0, 0);
  Clip clip{"line", 60.0, {}};
  for (int f = 0; f < 20; ++f) clip.poses.push_back(test::moved(pose, 0.3 * f, Vec3(0, 0, 0.1 * f)));
  EXPECT_LT(largest_error_m(clip, read_back(write_bvh(std::vector<Clip>{clip}).value()).at(0)), 1e-5);
}

/// Largest change of one of the root's angles from one frame to the next [deg].
double largest_root_step(const std::string& text) {
  const auto lines = split_lines(text);
  auto line = std::find_if(lines.begin(), lines.end(),
                           [](std::string_view l) { return l.starts_with("Frame Time"); });
  double largest = 0;
  std::vector<double> before;
  for (++line; line != lines.end(); ++line) {
    const auto words = split_words(*line);
    std::vector<double> angles;
    for (std::size_t i = 3; i < 6; ++i) angles.push_back(parse_number(words[i]).value());
    for (std::size_t i = 0; i < before.size(); ++i)
      largest = std::max(largest, std::abs(angles[i] - before[i]));
    before = angles;
  }
  return largest;
}

Eigen::Matrix3d about(const Vec3& axis, double degrees) {
  return Eigen::AngleAxisd(degrees * std::numbers::pi / 180, axis).toRotationMatrix();
}

/// A body whose pelvis goes through `turn(step)`, one degree or so per step.
template <typename Turn>
Clip tumbling(int steps, const Turn& turn) {
  // The root stands 8 cm above and 1 cm behind the middle of the hips; this puts it straight above.
  const Eigen::Matrix3d upright = Eigen::AngleAxisd(std::atan2(0.01, 0.08), Vec3::UnitX()).toRotationMatrix();
  Clip clip{"tumble", 60.0, {}};
  for (int step = 0; step <= steps; ++step) {
    Pose pose = test::standing_pose() * (turn(step) * upright).transpose();
    pose.col(1).array() += 0.04 - std::min(pose(joints::left_toe_base, 1), pose(joints::right_toe_base, 1));
    clip.poses.push_back(pose);
  }
  return clip;
}

TEST(BvhWriter, KeepsAnglesContinuousWhereAxesAlign) {
  const Vec3 x = Vec3::UnitX(), y = Vec3::UnitY(), z = Vec3::UnitZ();
  // At x = 90 degrees z and y turn about the same axis. The body tumbles one and a half times through that
  // pole; near it, where the other angles run 1 / cos x times as fast (3.4); and it stops there and spins.
  const Clip through =
      tumbling(540, [&](int step) { return Eigen::Matrix3d(about(z, 30) * about(x, step)); });
  const Clip near = tumbling(540, [&](int step) { return Eigen::Matrix3d(about(x, step) * about(z, 17)); });
  const Clip spinning = tumbling(180, [&](int step) {
    return Eigen::Matrix3d(about(z, 30) * about(x, std::min(step, 90)) * about(y, std::max(0, step - 90)));
  });
  for (const Clip& clip : {through, near, spinning}) {
    const std::string text = write_bvh(std::vector<Clip>{clip}).value();
    EXPECT_LT(largest_error_m(clip, read_back(text).at(0)), 1e-5);
    EXPECT_LT(largest_root_step(text), 8.0);
  }
}

TEST(BvhWriter, WritesSeveralClipsAsSeveralRoots) {
  std::vector<Clip> clips = {random_poses(10, 1), random_poses(10, 2)};
  clips[0].name = "active";
  clips[1].name = "passive";
  const std::string text = write_bvh(clips).value();
  EXPECT_THAT(text, HasSubstr("ROOT active:root"));
  EXPECT_THAT(text, HasSubstr("JOINT passive:lfemur"));
  const auto back = read_back(text);
  ASSERT_EQ(back.size(), 2u);
  EXPECT_EQ(back[0].name, "active");
  EXPECT_EQ(back[1].name, "passive");
  for (std::size_t c = 0; c < 2; ++c) EXPECT_LT(largest_error_m(clips[c], back[c]), 1e-5);
}

TEST(BvhWriter, WritesInTheUnitAskedFor) {
  const Clip clip{"stand", 30.0, std::vector<Pose>(2, test::standing_pose())};
  const std::string text = write_bvh(std::vector<Clip>{clip}, 100.0).value();
  EXPECT_THAT(text, HasSubstr("95.000000"));
  EXPECT_LT(largest_error_m(clip, read_back(text, 0.01).at(0)), 1e-6);
}

TEST(BvhWriter, WritesNoExponents) {
  Clip clip{"tiny", 60.0, std::vector<Pose>(2, test::standing_pose())};
  clip.poses[1](0, 0) = 1e-9;
  const std::string text = write_bvh(std::vector<Clip>{clip}).value();
  EXPECT_EQ(text.find("e-"), std::string::npos);
  EXPECT_EQ(text.find("-0.000000"), std::string::npos);
}

TEST(BvhWriter, DoesNotLetErrorsOfBoneLengthAddUp) {
  std::mt19937 random(3);
  Clip clip{"shaken", 60.0, {}};
  for (int f = 0; f < 400; ++f) clip.poses.push_back(test::shaken(test::standing_pose(), 0.002, random));
  const Clip back = read_back(write_bvh(std::vector<Clip>{clip}).value()).at(0);
  double sum_sq = 0;
  for (std::size_t f = 0; f < clip.poses.size(); ++f)
    sum_sq += (clip.poses[f] - back.poses[f]).row(joints::left_hand).squaredNorm();
  // What is left is the difference of the hand's own bone from its median: 2 mm x sqrt 2.
  EXPECT_LT(std::sqrt(sum_sq / static_cast<double>(clip.poses.size())), 0.0033);
}

TEST(BvhWriter, RefusesWhatDoesNotFitIntoOneFile) {
  const Clip clip{"a", 60.0, std::vector<Pose>(2, test::standing_pose())};
  const auto refusal = [](const std::vector<Clip>& clips) { return write_bvh(clips).error().text(); };
  EXPECT_THAT(refusal({}), HasSubstr("no clip"));
  EXPECT_THAT(refusal({{"empty", 60.0, {}}}), HasSubstr("empty: has no frames"));
  EXPECT_THAT(refusal({clip, {"b", 60.0, std::vector<Pose>(3, test::standing_pose())}}),
              HasSubstr("as many frames"));
  EXPECT_THAT(refusal({clip, {"b", 30.0, clip.poses}}), HasSubstr("same rate"));
  EXPECT_THAT(refusal({clip, clip}), HasSubstr("names that differ"));
  EXPECT_THAT(refusal({{"b", 0.0, clip.poses}}), HasSubstr("frame rate"));
  Clip broken = clip;
  broken.poses[1](3, 2) = std::numeric_limits<double>::infinity();
  EXPECT_THAT(refusal({broken}), HasSubstr("a: frame 1"));
}

TEST(BvhWriter, GivesCapturedTakesBackWithinAMillimetre) {
  ABRAZO_REQUIRE_CAPTURED_DATA(data);
  std::vector<Clip> clips;
  for (const char* name : {"60_01.amc", "61_01.amc"}) {
    ImportOptions options;
    options.fps = 60;
    clips.push_back(load_motion((data / "cmu_salsa" / name).string(), "", options).value().front().clip);
  }
  const auto back = read_back(write_bvh(clips).value());
  ASSERT_EQ(back.size(), 2u);
  for (std::size_t c = 0; c < 2; ++c) {
    const double error = largest_error_m(clips[c], back[c]);
    RecordProperty(c == 0 ? "leader_error_m" : "follower_error_m", std::to_string(error));
    EXPECT_LT(error, 0.001);
  }
}

}  // namespace
}  // namespace abrazo::bvh_writer_test
