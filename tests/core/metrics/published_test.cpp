// By hand, and against another implementation of the same descriptions: published_check.py, with NumPy.
#include "core/metrics/published.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <numbers>

#include "core/motion/files/clip_file.hpp"
#include "tests/support/bodies.hpp"
#include "tests/support/libraries.hpp"
#include "tests/support/numpy_python.hpp"

namespace abrazo::published_test {
namespace {

using ::testing::ElementsAre;

/// Someone who stands, moved by `way` more in every frame.
std::vector<Pose> gliding(std::size_t frames, const Vec3& way) {
  std::vector<Pose> poses;
  for (std::size_t f = 0; f < frames; ++f)
    poses.push_back(test::moved(test::standing_pose(), 0, static_cast<double>(f) * way));
  return poses;
}

TEST(Published, MpjpeIsTheMeanDistanceOfTheJoints) {
  std::vector<Pose> captured = gliding(4, Vec3::Zero()), made = captured;
  for (Pose& pose : made) pose.row(joints::Head) += Eigen::RowVector3d(0.3, 0, 0.4);
  EXPECT_NEAR(mpjpe_m(made, captured), 0.5 / 25, 1e-12);
  EXPECT_NEAR(mpjve_m(made, captured), 0, 1e-12) << "it is off by the same in every frame";
  EXPECT_NEAR(mpjve_m(gliding(4, Vec3(0.02, 0, 0)), captured), 0.02, 1e-12);
  EXPECT_TRUE(std::isnan(mpjve_m({}, {})));
}

TEST(Published, FeetThatGlideSlideAndSkate) {
  // The first frame has none before it and counts with zero.
  EXPECT_NEAR(foot_sliding_m(gliding(5, Vec3(0.04, 0, 0))), 0.04 * 4 / 5, 1e-12);
  // The first of four differences is passed over, and counted in the number.
  EXPECT_NEAR(skating_share(gliding(5, Vec3(0.04, 0, 0))), 3.0 / 4, 1e-12);
  EXPECT_EQ(skating_share(gliding(5, Vec3(0.02, 0, 0))), 0);
  EXPECT_EQ(skating_share(gliding(5, Vec3(0, 0.1, 0))), 0) << "up is no skating";
}

TEST(Published, FeetInTheAirDoNotSlide) {
  std::vector<Pose> poses = gliding(5, Vec3::Zero());
  for (std::size_t f = 1; f < 5; ++f)
    poses[f].row(joints::left_toe_base) += Eigen::RowVector3d(0.1 * static_cast<double>(f), 0.06, 0);
  EXPECT_EQ(foot_sliding_m(poses), 0);
}

TEST(Published, JitterIsTheThirdDifferenceByTheThirdPowerOfTheRate) {
  std::vector<Pose> poses;
  for (int f = 0; f < 8; ++f)
    poses.push_back(test::moved(test::standing_pose(), 0, Vec3(1e-4 * f * f * f, 0, 0)));
  EXPECT_NEAR(jitter_10_m_s3(poses), 6e-4 * 27000 / 10, 1e-9);
  EXPECT_NEAR(jitter_10_m_s3(gliding(8, Vec3(0.1, 0, 0))), 0, 1e-9);
}

TEST(Published, TwoJointsAtOnePlacePenetrate) {
  Duet duet{gliding(4, Vec3::Zero()), {}};
  for (const double apart : {0.0, 0.004, 0.02, 5.0}) {
    Pose partner = test::moved(test::standing_pose(), 0, Vec3(50, 0, 0));
    partner.row(joints::left_hand) = duet.user[0].row(joints::right_hand) + Eigen::RowVector3d(-apart, 0, 0);
    duet.partner.push_back(partner);
  }
  EXPECT_NEAR(joint_penetration(duet).share, 0.5, 1e-12);
  EXPECT_NEAR(joint_penetration(duet).mean_depth_m, (0.01 + 0.006) / 4, 1e-12);
}

TEST(Published, ContactsAreCountedAgainstTheRecordedOnes) {
  Pose apart;
  for (int j = 0; j < joint_count; ++j) apart.row(j) << 10 * j, 0, 0;
  Pose far = apart;
  far.col(1).array() += 100;
  Duet made{{apart}, {far}}, captured = made;
  const auto touch = [](Duet& duet, int of_partner, int of_user) {
    duet.partner[0].row(of_partner) = duet.user[0].row(of_user) + Eigen::RowVector3d(0.2, 0, 0);
  };
  touch(captured, joints::left_wrist, joints::right_wrist),
      touch(made, joints::left_wrist, joints::right_wrist);
  touch(captured, joints::right_wrist, joints::left_wrist);
  touch(made, joints::UpperNeck, joints::UpperNeck);
  const ContactCounts counts = joint_contacts(made, captured);
  EXPECT_EQ(counts.both, 1);
  EXPECT_EQ(counts.only_made, 1);
  EXPECT_EQ(counts.only_captured, 1);
  EXPECT_EQ(counts.f1(), 0.5);
  EXPECT_TRUE(std::isnan(ContactCounts{}.precision()));
}

TEST(Published, WhoTurnsMoreThanHalfARightAngleIsTurnedAway) {
  const auto turned = [](double degrees) {
    const double yaw = std::numbers::pi - degrees * std::numbers::pi / 180;  // the user faces +Z
    return turned_away_share(
        {gliding(1, Vec3::Zero()), {test::moved(test::standing_pose(), yaw, Vec3(0, 0, 1))}});
  };
  EXPECT_EQ(turned(0), 0);
  EXPECT_EQ(turned(44), 0);
  EXPECT_EQ(turned(-44), 0);
  EXPECT_EQ(turned(46), 1);
  EXPECT_EQ(turned(-46), 1);
  EXPECT_EQ(turned(180), 1);
}

TEST(Published, ABeatIsWhereTheMotionIsSlowest) {
  std::vector<Pose> poses;
  double x = 0;
  for (int f = 0; f < 120; ++f) {
    poses.push_back(test::moved(test::standing_pose(), 0, Vec3(x, 0, 0)));
    x += 0.02 + 0.015 * std::cos(2 * std::numbers::pi * f / 40);  // slowest at 20, 60 and 100
  }
  EXPECT_THAT(motion_beats(poses), ElementsAre(20, 60, 100));
}

TEST(Published, AnEchoThreeFramesLateIsWorthTheRootOfE) {
  EXPECT_NEAR(beat_echo_degree(std::vector{10, 50}, std::vector{13, 50}), (std::exp(-0.5) + 1) / 2, 1e-12);
  EXPECT_EQ(beat_echo_degree(std::vector{10}, {}), 0);
  EXPECT_TRUE(std::isnan(beat_echo_degree({}, std::vector{10})));
}

TEST(Published, CrossDistancesHaveThePartnersJointsInRows) {
  const Duet duet{gliding(2, Vec3::Zero()),
                  {test::moved(test::standing_pose(), 0, Vec3(0, 0, 1)),
                   test::moved(test::standing_pose(), 0, Vec3(0, 0, 3))}};
  const CrossDistances distances = cross_distances(duet);
  EXPECT_NEAR(distances[0], 2, 1e-12) << "roots, mean over both frames";
  const auto apart = [&](int of_partner, int of_user, std::size_t f) {
    return (duet.partner[f].row(of_partner) - duet.user[f].row(of_user)).norm();
  };
  EXPECT_NEAR(distances[31],
              (apart(joints::left_toe_base, joints::left_ankle, 0) +
               apart(joints::left_toe_base, joints::left_ankle, 1)) /
                  2,
              1e-12);
}

TEST(Published, TheFrechetDistanceOfNormalsIsThatOfTheirMeansAndDeviations) {
  Eigen::MatrixXd first(4, 2), second(4, 2);
  first << 1, 1, 1, -1, -1, 1, -1, -1;  // variances 4/3, without covariance
  second = 3 * first;
  second.rowwise() += Eigen::RowVector2d(5, 0);
  // Along one axis (5 - 0)^2 + (3 s - s)^2, along the other (3 s - s)^2, s^2 = 4/3.
  EXPECT_NEAR(frechet_distance(first, second), 25 + 2 * 4 * 4.0 / 3, 1e-12);
  EXPECT_NEAR(frechet_distance(second, second), 0, 1e-12);
  EXPECT_TRUE(std::isnan(frechet_distance(first.topRows(1), second)));
}

TEST(Published, DiversityIsTheMeanDistanceOfTwoClips) {
  Eigen::MatrixXd features(3, 1);
  features << 0, 1, 3;
  EXPECT_NEAR(diversity(features), (1 + 3 + 2) / 3.0, 1e-12);
  const Eigen::MatrixXd scored = z_scored(features, features);
  EXPECT_NEAR(scored.mean(), 0, 1e-9);
  EXPECT_NEAR(scored.squaredNorm() / 3, 1, 1e-6) << "by the deviation of all, not of a sample";
}

// ---- against NumPy ----

/// Three clips of 20 s: user, captured partner, made partner. They walk, turn and come near one another, so
/// that every figure has something to measure.
std::vector<Clip> three_dancers() {
  constexpr std::size_t frames = 600;
  std::mt19937 random(7);
  std::vector<Clip> clips(3);
  const PairedTake one = test::swinging_take("one", static_cast<int>(frames), 1);
  const PairedTake two = test::swinging_take("two", static_cast<int>(frames), 2);
  for (std::size_t f = 0; f < frames; ++f) {
    const double t = static_cast<double>(f) / 30;
    const auto around = [&](const Pose& pose, double yaw, const Vec3& offset) {
      return test::shaken(test::moved(pose, yaw, offset), 0.001, random);
    };
    const Vec3 walk(2.5 * std::sin(0.5 * t), 0, 0.1 * std::sin(3 * t));
    clips[0].poses.push_back(around(one.a.poses[f], 0.3 * std::sin(t), walk));
    clips[1].poses.push_back(around(one.b.poses[f], 0.9 * std::sin(0.7 * t), walk + Vec3(0, 0, -0.25)));
    clips[2].poses.push_back(
        around(two.b.poses[f], 1.1 * std::sin(0.6 * t),
               Vec3(2.5 * std::sin(0.5 * t + 0.05), 0.02 * std::sin(5 * t), -0.6 + 0.3 * std::sin(t))));
  }
  for (std::size_t f = 100; f < 110; ++f)
    clips[2].poses[f].row(joints::left_hand) =
        clips[0].poses[f].row(joints::right_hand) + Eigen::RowVector3d(0.004, 0, 0);
  for (Clip& clip : clips) clip.fps = published_rate_hz;
  return clips;
}

Eigen::MatrixXd clip_rows(const std::vector<Pose>& user, const std::vector<Pose>& partner) {
  constexpr std::size_t length = 60;
  Eigen::MatrixXd rows(static_cast<Eigen::Index>(user.size() / length), 100);
  for (std::size_t c = 0; c < user.size() / length; ++c) {
    Duet clip;
    for (std::size_t f = c * length; f < (c + 1) * length; ++f)
      clip.user.push_back(user[f]), clip.partner.push_back(partner[f]);
    rows.row(static_cast<Eigen::Index>(c)) = cross_distances(clip).transpose();
  }
  return rows;
}

TEST(Published, AgreesWithAnIndependentImplementation) {
  const std::string python = test::python_with_numpy();
  if (python.empty()) GTEST_SKIP() << "there is no Python 3 with NumPy here";
  const std::vector<Clip> clips = three_dancers();
  const auto file = std::filesystem::temp_directory_path() / "abrazo_published.npz";
  ASSERT_TRUE(write_clip_file(file.string(), clips));
  const auto script =
      std::filesystem::path(ABRAZO_FIXTURES).parent_path() / "core/metrics/published_check.py";
  const auto expected = nlohmann::json::parse(
      test::printed_by(python + " " + script.string() + " " + file.string()), nullptr, false);
  std::filesystem::remove(file);
  ASSERT_TRUE(expected.is_object());

  const std::vector<Pose>&user = clips[0].poses, &captured = clips[1].poses, &made = clips[2].poses;
  const ContactCounts contacts = joint_contacts({user, made}, {user, captured});
  const JointPenetration penetration = joint_penetration({user, made});
  const Eigen::MatrixXd reference = clip_rows(user, captured),
                        own = z_scored(clip_rows(user, made), reference);
  const std::map<std::string, double> found = {
      {"mpjpe_m", mpjpe_m(made, captured)},
      {"mpjve_m", mpjve_m(made, captured)},
      {"foot_sliding_m", foot_sliding_m(made)},
      {"skating_share", skating_share(made)},
      {"jitter_10_m_s3", jitter_10_m_s3(made)},
      {"penetration_share", penetration.share},
      {"penetration_depth_m", penetration.mean_depth_m},
      {"contact_precision", contacts.precision()},
      {"contact_recall", contacts.recall()},
      {"contact_f1", contacts.f1()},
      {"turned_away_share", turned_away_share({user, made})},
      {"beat_echo_degree", beat_echo_degree(motion_beats(user), motion_beats(made))},
      {"fid_cd", frechet_distance(own, z_scored(reference, reference))},
      {"diversity", diversity(own)},
  };
  ASSERT_EQ(expected.size(), found.size());
  for (const auto& [name, value] : found) {
    const double theirs = expected.at(name).get<double>();
    EXPECT_NEAR(value, theirs, 1e-6 * std::max(1.0, std::abs(theirs))) << name;
    EXPECT_GT(value, 0) << name << " has nothing to measure here";
  }
}

}  // namespace
}  // namespace abrazo::published_test
