// Segments as 4x4 transforms in C3D files, as Theia3D writes them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <limits>
#include <random>

#include "core/motion/files/import_clip.hpp"
#include "core/motion/tables/c3d_reader.hpp"
#include "tests/core/motion/c3d_bytes.hpp"
#include "tests/core/motion/motion_fixtures.hpp"
#include "tests/support/bodies.hpp"

namespace abrazo::c3d_rotations_test {
namespace {

using test::C3dBytesWriter;
using test::has_warning;
using test::place;
using test::the_warning;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

/// 16 numbers by columns and the reliability.
std::array<double, 17> stored(const Eigen::Affine3d& transform, double reliability = 1) {
  std::array<double, 17> numbers{};
  for (Eigen::Index i = 0; i < 16; ++i) numbers[static_cast<std::size_t>(i)] = transform.matrix().data()[i];
  numbers[16] = reliability;
  return numbers;
}

Eigen::Affine3d at(const Vec3& place, double turn_rad = 0) {
  return Eigen::Translation3d(place) * Eigen::AngleAxisd(turn_rad, Vec3(1, 2, 3).normalized());
}

/// Which joint is the origin of a segment, by Theia3D's documentation.
const std::vector<std::pair<std::string, int>>& segments() {
  using namespace joints;
  static const std::vector<std::pair<std::string, int>> all = {{"pelvis", Root},
                                                               {"l_thigh", left_hip},
                                                               {"l_shank", left_knee},
                                                               {"l_foot", left_ankle},
                                                               {"l_toes", left_toe_base},
                                                               {"r_thigh", right_hip},
                                                               {"r_shank", right_knee},
                                                               {"r_foot", right_ankle},
                                                               {"r_toes", right_toe_base},
                                                               {"torso", LowerNeck},
                                                               {"l_uarm", left_shoulder},
                                                               {"l_larm", left_elbow},
                                                               {"l_hand", left_wrist},
                                                               {"r_uarm", right_shoulder},
                                                               {"r_larm", right_elbow},
                                                               {"r_hand", right_wrist},
                                                               {"head", Head}};
  return all;
}

/// Millimetres, Z up, each segment turned in its own way; the body turns over the samples.
C3dBytesWriter theia_file(int samples) {
  C3dBytesWriter writer;
  writer.rate = 85;
  writer.announced_frames = samples;
  writer.segment_labels = {"worldbody_4X4"};
  for (const auto& [name, joint] : segments()) writer.segment_labels.push_back(name + "_4X4");
  for (int s = 0; s < samples; ++s) {
    const Pose pose = test::moved(test::standing_pose(), 0.05 * s, Vec3(0.01 * s, 0, 0));
    auto& sample = writer.segment_samples.emplace_back();
    sample.push_back(stored(Eigen::Affine3d::Identity()));
    for (std::size_t n = 0; n < segments().size(); ++n) {
      const Vec3 y_up = pose.row(segments()[n].second).transpose();
      sample.push_back(stored(at(1000 * Vec3(y_up.x(), -y_up.z(), y_up.y()), 0.1 * static_cast<double>(n))));
    }
  }
  return writer;
}

Result<std::vector<NamedMotion>> read(const std::string& bytes) {
  return read_c3d(bytes, "dance.c3d");
}
NamedMotion read_one(const std::string& bytes) {
  auto motions = read(bytes);
  if (motions && motions->size() == 1) return std::move(motions->front());
  ADD_FAILURE() << (motions ? "not one performer" : motions.error().text());
  return {};
}
std::string message_of(const std::string& bytes) {
  const auto motions = read(bytes);
  return motions ? "was read" : motions.error().text();
}

/// Two segments, one sample.
C3dBytesWriter two_segments() {
  C3dBytesWriter writer;
  writer.announced_frames = 1;
  writer.segment_labels = {"l_thigh_4X4", "l_shank_4X4"};
  writer.segment_samples = {{stored(at({1, 2, 3}, 0.4)), stored(at({4, 5, 6}, 1.4))}};
  return writer;
}

TEST(C3dRotations, OriginsOfSegmentsAreTheJointsOfABody) {
  const auto clip = import_clip(read_one(theia_file(12).bytes()), {});
  ASSERT_TRUE(clip) << clip.error().text();
  EXPECT_EQ(clip->report.joint_map, "theia");
  EXPECT_EQ(clip->report.metres_per_unit, 0.001);
  EXPECT_EQ(clip->clip.fps, 85);
  ASSERT_EQ(clip->clip.poses.size(), 12U);
  for (const int frame : {0, 11}) {
    const Pose pose = test::moved(test::standing_pose(), 0.05 * frame, Vec3(0.01 * frame, 0, 0));
    for (const auto& [name, joint] : segments())
      EXPECT_LT((clip->clip.poses[static_cast<std::size_t>(frame)].row(joint) - pose.row(joint)).norm(), 1e-6)
          << name << " in frame " << frame;
  }
  EXPECT_FALSE(has_warning(clip->report.warnings, "not-a-person"));
}

TEST(C3dRotations, StandInTheNumbersOfEveryProcessor) {
  for (const auto processor : {C3dBytesWriter::Intel, C3dBytesWriter::Dec, C3dBytesWriter::Mips}) {
    C3dBytesWriter writer = two_segments();
    writer.processor = processor;
    const NamedMotion motion = read_one(writer.bytes());
    EXPECT_THAT(motion.points, ElementsAre("l_thigh_4X4", "l_shank_4X4"));
    test::expect_near(place(motion, 0, "l_shank_4X4"), {4, 5, 6}, 1e-6);
  }
}

TEST(C3dRotations, HandsAndToesEndWhereTheFileSaysTheirLength) {
  C3dBytesWriter writer;
  writer.announced_frames = 1;
  writer.segment_labels = {"l_hand_4X4", "r_toes_4X4", "head_4X4"};
  const Eigen::Affine3d hand = at({100, 200, 300}, 0.7), toes = at({10, 20, 30}, -0.3),
                        head = at({0, 0, 1600}, 2);
  writer.segment_samples = {{stored(hand), stored(toes), stored(head)}};
  writer.add_texts("THEIA3D", "LHAND_LENGTH", {"0.085"});
  writer.add_texts("THEIA3D", "RTOE_LENGTH", {"0.06"});
  writer.add_reals("THEIA3D", "HEADCENTER_POS", {0.01, 0.02, 0.05});
  const NamedMotion motion = read_one(writer.bytes());
  test::expect_near(place(motion, 0, "l_hand_end"), hand * Vec3(0, 0, -85), 1e-4);
  test::expect_near(place(motion, 0, "r_toes_end"), toes * Vec3(0, 60, 0), 1e-4);
  test::expect_near(place(motion, 0, "head_center"), head * Vec3(10, 20, 50), 1e-3);
}

TEST(C3dRotations, ThatWereNotSeenAreGaps) {
  for (const int how : {0, 1, 2}) {
    C3dBytesWriter writer = two_segments();
    auto& segment = writer.segment_samples[0][1];
    if (how == 0) segment[16] = -1;
    if (how == 1) segment.fill(std::numeric_limits<double>::quiet_NaN());
    if (how == 2) segment.fill(0);
    const NamedMotion motion = read_one(writer.bytes());
    EXPECT_FALSE(place(motion, 0, "l_shank_4X4").allFinite()) << how;
    EXPECT_TRUE(place(motion, 0, "l_thigh_4X4").allFinite()) << how;
  }
}

TEST(C3dRotations, BesideMarkersAreTakenAtTheTimesOfTheMarkers) {
  C3dBytesWriter writer;
  writer.labels = {"BALL"};
  writer.segment_labels = {"pelvis_4X4"};
  writer.segment_ratio = 2;
  for (int f = 0; f < 3; ++f) writer.frames.push_back({{f + 1.0, 2, 3}});
  for (int s = 0; s < 6; ++s) writer.segment_samples.push_back({stored(at({10.0 * s, 0, 7}))});
  const NamedMotion motion = read_one(writer.bytes());
  EXPECT_THAT(motion.points, ElementsAre("BALL", "pelvis_4X4"));
  EXPECT_EQ(motion.fps, 100);
  ASSERT_EQ(motion.frames.size(), 3U);
  test::expect_near(place(motion, 2, "BALL"), {3, 2, 3}, 1e-6);
  test::expect_near(place(motion, 2, "pelvis_4X4"), {40, 0, 7}, 1e-5);
}

TEST(C3dRotations, AloneAreReadAtTheirOwnRate) {
  C3dBytesWriter writer = theia_file(8);
  writer.segment_ratio = 2;
  const NamedMotion motion = read_one(writer.bytes());
  EXPECT_EQ(motion.fps, 170);
  EXPECT_EQ(motion.frames.size(), 8U);
}

TEST(C3dRotations, WithoutANameAreLeftOutAndCounted) {
  C3dBytesWriter writer = two_segments();
  writer.segment_labels[0] = "";
  const NamedMotion motion = read_one(writer.bytes());
  EXPECT_THAT(motion.points, ElementsAre("l_shank_4X4"));
  test::expect_near(place(motion, 0, "l_shank_4X4"), {4, 5, 6}, 1e-6);
  EXPECT_THAT(the_warning(motion.warnings, "unlabelled").detail, HasSubstr("1 segments have no name"));
  writer.segment_labels[1] = "";
  EXPECT_THAT(message_of(writer.bytes()), HasSubstr("none of its 2 segments has a name"));
}

TEST(C3dRotations, OfAFileThatIsCutOffAreReadToTheLastWholeSample) {
  const std::string whole = theia_file(5).bytes();
  const NamedMotion motion = read_one(whole.substr(0, whole.size() - 10));
  EXPECT_EQ(motion.frames.size(), 4U);
  EXPECT_THAT(the_warning(motion.warnings, "frame-count").detail,
              HasSubstr("announces 5 frames and ends after 4"));
}

TEST(C3dRotations, WithoutACountAreAsManyAsTheFileSaysOrHolds) {
  C3dBytesWriter writer = theia_file(6);
  writer.announced_samples = 0;
  writer.announced_frames = 4;
  EXPECT_EQ(read_one(writer.bytes()).frames.size(), 4U);
  writer.announced_frames = 65535;  // as many as a header can count: perhaps more
  EXPECT_EQ(read_one(writer.bytes()).frames.size(), 6U);
}

TEST(C3dRotations, ThatAreNoTransformsAreRefused) {
  C3dBytesWriter writer = two_segments();
  auto& numbers = writer.segment_samples[0][1];
  const auto good = numbers;
  for (Eigen::Index row = 0; row < 4; ++row)  // by rows: the origin stands where the last row should
    for (Eigen::Index column = 0; column < 4; ++column)
      numbers[static_cast<std::size_t>(4 * row + column)] = good[static_cast<std::size_t>(4 * column + row)];
  EXPECT_THAT(message_of(writer.bytes()),
              HasSubstr("dance.c3d: sample 0: the numbers of the segment 'l_shank_4X4' are no transform"));
  numbers = good;
  for (std::size_t i = 0; i < 3; ++i) numbers[i] *= 1.2;
  EXPECT_THAT(message_of(writer.bytes()), HasSubstr("perpendicular axes of length 1"));
  numbers = good;
  for (std::size_t i = 0; i < 3; ++i) numbers[i] = -numbers[i];  // a mirror image
  EXPECT_THAT(message_of(writer.bytes()), HasSubstr("are no transform"));
}

TEST(C3dRotations, ThatAreSaidToBeWhereTheFileHasNoneAreRefused) {
  C3dBytesWriter writer = two_segments();
  writer.segment_data_block = 900;
  EXPECT_THAT(
      message_of(writer.bytes()),
      HasSubstr("ROTATION: the segments are said to begin at block 900, where one sample of 2 takes 136"));
  writer.segment_data_block = 0;
  EXPECT_THAT(message_of(writer.bytes()), HasSubstr("said to begin at block 0"));
  writer = two_segments();
  writer.segment_ratio = 30000;
  EXPECT_THAT(message_of(writer.bytes()), HasSubstr("30000 samples of the segments in a frame of points"));
  writer = two_segments();
  const std::string whole = writer.bytes();
  EXPECT_THAT(message_of(whole.substr(0, whole.size() - 1)), HasSubstr("it is cut off"));
}

TEST(C3dRotations, SurviveDamagedFiles) {
  const std::string whole = theia_file(4).bytes();
  std::mt19937 random(11);
  for (int n = 0; n < 2000; ++n) {
    std::string bytes = whole;
    for (unsigned i = 0; i < 1 + random() % 6; ++i) bytes[random() % 2048] = static_cast<char>(random());
    if (random() % 3 == 0) bytes.resize(random() % bytes.size());
    const auto motions = read(bytes);
    EXPECT_TRUE(motions.ok() || !motions.error().message.empty());
  }
}

}  // namespace
}  // namespace abrazo::c3d_rotations_test
