#include "core/selection/partner_embedding.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/bodies.hpp"
#include "tests/support/libraries.hpp"

namespace abrazo::partner_embedding_test {
namespace {

/// By hand.
double mean_joint_distance(const Pose& a, const Pose& b) {
  double sum = 0;
  for (int joint = 0; joint < joint_count; ++joint)
    sum += std::sqrt(std::pow(a(joint, 0) - b(joint, 0), 2) + std::pow(a(joint, 1) - b(joint, 1), 2) +
                     std::pow(a(joint, 2) - b(joint, 2), 2));
  return sum / joint_count;
}

/// Partners of some people, who also walk about, from `first` on every `step`-th frame.
std::vector<Pose> partners(int first, int step) {
  std::vector<Pose> poses;
  for (unsigned person = 1; person <= 4; ++person) {
    const std::vector<Pose> take = test::swinging_take("some", 240, person).b.poses;
    for (std::size_t frame = static_cast<std::size_t>(first); frame < take.size();
         frame += static_cast<std::size_t>(step)) {
      const double t = static_cast<double>(frame) / 60;
      poses.push_back(test::moved(take[frame], 0.3 * t, Vec3(0.2 * std::sin(2 * t + person), 0, 0.1 * t)));
    }
  }
  return poses;
}

std::vector<Eigen::VectorXf> points_of(const PartnerEmbedding& embedding, const std::vector<Pose>& poses) {
  std::vector<Eigen::VectorXf> points;
  std::vector<float> work(static_cast<std::size_t>(embedding.room()));
  for (const Pose& pose : poses) {
    Eigen::VectorXf& point = points.emplace_back(embedding.size());
    embedding.embed(pose, {point.data(), static_cast<std::size_t>(point.size())}, work);
  }
  return points;
}

/// By how much squared distances differ from mean joint distances [m], over all pairs of poses.
struct Errors {
  double mean = 0, largest = 0;
  double usual_distance = 0;
};

Errors errors_of(const PartnerEmbedding& embedding, const std::vector<Pose>& poses) {
  const std::vector<Eigen::VectorXf> points = points_of(embedding, poses);
  Errors errors;
  double sum = 0, distances = 0;
  for (std::size_t i = 0; i < poses.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      const double error = std::abs(static_cast<double>((points[i] - points[j]).squaredNorm()) -
                                    mean_joint_distance(poses[i], poses[j]));
      errors.largest = std::max(errors.largest, error);
      distances += mean_joint_distance(poses[i], poses[j]);
      sum += error;
    }
  const double pairs = static_cast<double>(poses.size() * (poses.size() - 1)) / 2;
  errors.mean = sum / pairs;
  errors.usual_distance = distances / pairs;
  return errors;
}

TEST(PartnerEmbedding, SquaredDistancesOfLandmarksAreTheirMeanJointDistances) {
  const std::vector<Pose> landmarks = partners(0, 40);
  ASSERT_LE(landmarks.size(), static_cast<std::size_t>(PartnerEmbedding::most_axes)) << "every axis is kept";
  EXPECT_LT(errors_of(PartnerEmbedding(landmarks), landmarks).largest, 1e-3);
}

TEST(PartnerEmbedding, OfOtherPosesTheyAreNearlySo) {
  const Errors errors = errors_of(PartnerEmbedding(partners(0, 8)), partners(3, 20));
  EXPECT_LT(errors.mean, 0.15 * errors.usual_distance) << "some of it is in the axes that are left out";
}

TEST(PartnerEmbedding, MoreLandmarksThanAxesKeepTheAxesThatMatter) {
  const std::vector<Pose> landmarks = partners(0, 2);
  const PartnerEmbedding embedding(landmarks);
  ASSERT_GT(landmarks.size(), 400U);
  EXPECT_EQ(embedding.size(), PartnerEmbedding::most_axes);
  const Errors errors = errors_of(embedding, landmarks);
  EXPECT_LT(errors.mean, 0.15 * errors.usual_distance);
}

TEST(PartnerEmbedding, TheNearestPointIsTheNearestPose) {
  const std::vector<Pose> landmarks = partners(0, 8), others = partners(5, 24);
  const PartnerEmbedding embedding(landmarks);
  const std::vector<Eigen::VectorXf> known = points_of(embedding, landmarks),
                                     asked = points_of(embedding, others);
  for (std::size_t other = 0; other < others.size(); ++other) {
    const auto nearest = std::min_element(known.begin(), known.end(), [&](const auto& a, const auto& b) {
      return (a - asked[other]).squaredNorm() < (b - asked[other]).squaredNorm();
    });
    double least = 1e9;
    for (const Pose& landmark : landmarks)
      least = std::min(least, mean_joint_distance(landmark, others[other]));
    const Pose& found = landmarks[static_cast<std::size_t>(nearest - known.begin())];
    EXPECT_LT(mean_joint_distance(found, others[other]), least + 0.005) << other;
  }
}

TEST(PartnerEmbedding, OfOnePoseHasNothingToTellApart) {
  for (const std::size_t copies : {1U, 5U}) {
    const PartnerEmbedding embedding(std::vector<Pose>(copies, test::standing_pose()));
    EXPECT_EQ(embedding.size(), 0);
    EXPECT_EQ(points_of(embedding, {test::standing_pose()}).front().size(), 0);
  }
}

}  // namespace
}  // namespace abrazo::partner_embedding_test
