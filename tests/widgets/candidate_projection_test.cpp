#include "widgets/candidates/feature_projection.hpp"

#include <gtest/gtest.h>

#include <Eigen/SVD>
#include <cmath>
#include <random>

#include "tests/support/libraries.hpp"

namespace abrazo::widgets::candidate_projection_test {
namespace {

std::vector<Features> spread_features(int count) {
  std::mt19937 random(7);
  std::normal_distribution<double> normal;
  Eigen::Matrix<double, 15, 15> mix;
  for (int i = 0; i < mix.size(); ++i) mix.data()[i] = normal(random);
  std::vector<Features> features;
  for (int n = 0; n < count; ++n) {
    Features independent;
    for (int i = 0; i < 15; ++i) independent[i] = normal(random) * (15 - i);
    features.push_back(mix * independent);
  }
  return features;
}

TEST(FeatureProjection, IsThatOfTheSingularVectorsOfTheCentredFeatures) {
  const auto features = spread_features(400);
  const FeatureProjection projection(features);
  Eigen::MatrixXd rows(400, 15);
  for (int n = 0; n < 400; ++n) rows.row(n) = features[static_cast<std::size_t>(n)].transpose();
  rows.rowwise() -= rows.colwise().mean().eval();
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(rows, Eigen::ComputeThinV);
  for (int axis = 0; axis < 2; ++axis)
    EXPECT_NEAR(std::abs(svd.matrixV().col(axis).dot(projection.axes().col(axis))), 1, 1e-9);
  const Eigen::VectorXd squares = svd.singularValues().array().square();
  EXPECT_NEAR(projection.explained(), squares.head<2>().sum() / squares.sum(), 1e-12);
  EXPECT_NEAR(projection(projection.mean()).norm(), 0, 1e-12);
}

TEST(FeatureProjection, NeverMakesADistanceLonger) {
  const auto features = spread_features(60);
  const FeatureProjection projection(features);
  for (std::size_t i = 1; i < features.size(); ++i)
    EXPECT_LE((projection(features[i]) - projection(features[i - 1])).norm(),
              (features[i] - features[i - 1]).norm() * (1 + 1e-12));
}

TEST(FeatureProjection, OfOneFeatureVectorIsAPointAndOfNoneIsRefused) {
  const FeatureProjection projection(std::vector<Features>{Features::Constant(2)});
  EXPECT_NEAR(projection(Features::Constant(2)).norm(), 0, 1e-12);
  EXPECT_DOUBLE_EQ(projection.explained(), 1);
  EXPECT_THROW(FeatureProjection(std::vector<Features>{}), std::invalid_argument);
}

TEST(FeatureCloud, BoundsEveryPairAndKeepsAllOfASmallLibrary) {
  const auto library = test::small_library();
  const FeatureCloud cloud(*library, UserRole::Active);
  EXPECT_EQ(cloud.points.size(), static_cast<std::size_t>(library->pair_count()));
  for (int pair = 0; pair < library->pair_count(); ++pair) {
    const Eigen::Vector2d at = cloud.projection(library->features(pair));
    EXPECT_TRUE((at.array() >= cloud.low.array() - 1e-12).all() &&
                (at.array() <= cloud.high.array() + 1e-12).all());
  }
}

TEST(FeatureCloud, OfAPassiveUserIsThatOfTheLibraryWithItsRolesExchanged) {
  const auto library = test::small_library();
  const MotionLibrary exchanged = with_roles_exchanged(*library);
  for (int pair = 0; pair < library->pair_count(); pair += 7)
    EXPECT_NEAR((user_features(*library, pair, UserRole::Passive) - exchanged.features(pair)).norm(), 0,
                1e-9);
}

TEST(PlaneView, FitsBothDirectionsInOneScaleAndPutsUpUp) {
  const PlaneView view = PlaneView::fitting({-1, 0}, {3, 1}, 220, 120, 10);
  EXPECT_DOUBLE_EQ(view.pixels_per_metre, 50) << "200 px for 4 m; the height would allow 100";
  EXPECT_EQ(view.pixel({1, 0.5}), Eigen::Vector2d(110, 60));
  EXPECT_EQ(view.pixel({-1, 0.5}), Eigen::Vector2d(10, 60));
  EXPECT_LT(view.pixel({1, 1}).y(), 60);
}

TEST(PlaneView, ComesNearerAboutAPoint) {
  const PlaneView near = PlaneView::fitting({0, 0}, {2, 2}, 100, 100, 0).nearer(4, {0.5, 0.25});
  EXPECT_EQ(near.pixel({0.5, 0.25}), Eigen::Vector2d(50, 50));
  EXPECT_DOUBLE_EQ(near.pixel({0.6, 0.25}).x(), 50 + 4 * 50 * 0.1);
}

TEST(PlaneView, OfAPointHasAScaleToo) {
  EXPECT_DOUBLE_EQ(PlaneView::fitting({1, 1}, {1, 1}, 120, 80, 10).pixels_per_metre, 60);
}

}  // namespace
}  // namespace abrazo::widgets::candidate_projection_test
