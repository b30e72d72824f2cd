#include "core/evaluation/tables/body_table.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "core/evaluation/report/report_html.hpp"
#include "core/evaluation/report/report_json.hpp"
#include "core/evaluation/takes/body_baselines.hpp"
#include "core/metrics/bone_lengths.hpp"
#include "core/motion/body/joint_set.hpp"
#include "tests/support/libraries.hpp"

namespace abrazo::body_table_test {
namespace {

using ::testing::HasSubstr;

const PairedTake& take() {
  static const PairedTake made = test::swinging_take("swing", 90, 1, 0.45);
  return made;
}

/// As they are, and one body smaller.
const BodyTable& table() {
  static const BodyTable made = [] {
    const std::array variants = {BodyVariant{"as recorded", {}, {}},
                                 BodyVariant{"active 0.85", {.all = 0.85}, {}, true}};
    return *measure_bodies({&take()}, {}, variants);
  }();
  return made;
}

const BodyFigures& figures(std::size_t row, BodyMethod method) {
  return table().rows[row].methods[static_cast<std::size_t>(method)];
}

TEST(BodyTable, BodiesAsRecordedHaveTheRecordingsFigures) {
  for (const BodyMethod method : {BodyMethod::Retargeted, BodyMethod::AnglesCopied}) {
    const BodyFigures& same = figures(0, method);
    EXPECT_NEAR(same.within_25cm.f1, 1, 1e-9);
    EXPECT_LT(same.penetration_excess_p99_m, 1e-6);
    EXPECT_EQ(same.floor_contact, 1);
    EXPECT_NEAR(same.slide_ratio, 1, 1e-6);
    EXPECT_NEAR(same.speed_p99_ratio, 1, 1e-6);
    EXPECT_NEAR(same.acceleration_p99_ratio, 1, 1e-6);
    EXPECT_EQ(same.nearest_only, 0);
    for (const PostureChange& posture : same.posture) {
      EXPECT_NEAR(posture.pelvis, 1, 1e-9);
      EXPECT_NEAR(posture.knee_deg, 0, 1e-9);
      EXPECT_NEAR(posture.trunk_deg, 0, 1e-9);
    }
  }
  EXPECT_EQ(table().takes, 1);
  EXPECT_EQ(table().frames, 90);
}

TEST(BodyTable, ContactsAreKeptBetterThanByCopiedAngles) {
  const BodyFigures &ours = figures(1, BodyMethod::Retargeted),
                    &copied = figures(1, BodyMethod::AnglesCopied);
  EXPECT_GT(ours.within_25cm.f1, copied.within_25cm.f1);
  EXPECT_GT(ours.within_25cm.f1, 0.9);
  EXPECT_LT(ours.bone_error_max, 1e-3);
}

TEST(BodyTable, RatiosAreOfLegsAndArmsByThemselves) {
  const Body body = body_of(take().a.poses);
  const Body other = body_with(body, {.arms = 1.2, .legs = 0.85});
  EXPECT_NEAR(other.leg_length(), 0.85 * body.leg_length(), 1e-12);
  for (const int joint : {joints::LeftHumerus, joints::LeftWrist, joints::RightHumerus, joints::RightWrist}) {
    const auto bone = static_cast<std::size_t>(joint - 1);
    EXPECT_NEAR(other.bone_lengths[bone], 1.2 * body.bone_lengths[bone], 1e-12);
  }
  EXPECT_EQ(other.bone_lengths[joints::Head - 1], body.bone_lengths[joints::Head - 1]);
}

TEST(BodyTable, BaselinesHaveTheNewBonesToo) {
  const RecordedPair pair = recorded_pair_of(take());
  const Body active = body_of(pair.active.poses), passive = body_of(pair.passive.poses);
  const PairBodies bodies{{active, body_with(active, {.all = 0.85})}, {passive, passive}};
  for (const auto& made : {by_inverse_kinematics(pair, bodies), by_mesh_of_the_paper(pair, bodies),
                           rebuilt_on_path(pair, bodies)}) {
    std::vector<Pose> poses;
    for (const PairPose& each : made) poses.emplace_back(each.topRows<joint_count>());
    EXPECT_EQ(poses.size(), 90u);
    EXPECT_LT(measure_bone_lengths(poses, bodies.active.to).max, 2e-3);
  }
}

TEST(BodyTable, StopsWhenItIsAskedTo) {
  const auto stopped = measure_bodies({&take()}, [](double, std::string_view) { return false; });
  ASSERT_FALSE(stopped);
  EXPECT_EQ(stopped.error().message, "cancelled");
}

TEST(BodyTable, IsInTheReportAndOnThePage) {
  Evaluation evaluation;
  evaluation.bodies = table();
  const auto json = nlohmann::json::parse(report_json(evaluation));
  const auto& pairs = json.at("bodies").at("pairs");
  ASSERT_EQ(pairs.size(), 2u);
  EXPECT_EQ(pairs[1].at("bodies"), "active 0.85");
  EXPECT_EQ(pairs[1].at("retargeted").at("contact_25cm").at("f1"),
            figures(1, BodyMethod::Retargeted).within_25cm.f1);
  EXPECT_EQ(pairs[1].at("live").at("posture_passive").at("knee_change_deg"),
            figures(1, BodyMethod::Live).posture[1].knee_deg);
  for (const std::string_view key : body_method_keys) EXPECT_TRUE(pairs[1].contains(key)) << key;
  EXPECT_THAT(report_html(evaluation), HasSubstr("recorded pairs on other bodies"));
  evaluation.bodies.reset();
  EXPECT_FALSE(nlohmann::json::parse(report_json(evaluation)).contains("bodies"));
}

}  // namespace
}  // namespace abrazo::body_table_test
