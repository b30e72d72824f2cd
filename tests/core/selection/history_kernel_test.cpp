#include "core/selection/history_kernel.hpp"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>

#include "tests/core/selection/user_motions.hpp"
#include "tests/support/libraries.hpp"

namespace abrazo::history_kernel_test {
namespace {

using Rows = HistoryKernel::Rows;

/// Of four people who swing differently, every eighth frame.
Rows motions() {
  std::vector<HistoryKernel::Raw> raws;
  for (unsigned person = 1; person <= 4; ++person) {
    const std::vector<Pose> poses = test::swinging_take("user", 200, person).a.poses;
    for (int frame = 0; frame < 200; frame += 8)
      HistoryKernel::sample(test::history_at(poses, frame), raws.emplace_back());
  }
  Rows rows(static_cast<Eigen::Index>(raws.size()), HistoryKernel::raw_size);
  for (std::size_t i = 0; i < raws.size(); ++i)
    rows.row(static_cast<Eigen::Index>(i)) =
        Eigen::Map<const Eigen::RowVectorXf>(raws[i].data(), HistoryKernel::raw_size);
  return rows;
}

std::span<const float> row_of(const Rows& rows, Eigen::Index i) {
  return {rows.row(i).data(), static_cast<std::size_t>(rows.cols())};
}

Eigen::MatrixXd gram_of(const HistoryKernel& kernel, const Rows& described) {
  Eigen::MatrixXd gram(described.rows(), described.rows());
  for (Eigen::Index i = 0; i < described.rows(); ++i)
    for (Eigen::Index j = 0; j < described.rows(); ++j)
      gram(i, j) = static_cast<double>(kernel(row_of(described, i), row_of(described, j)));
  return gram;
}

TEST(HistoryKernel, SamplesEveryLagOfTheHistory) {
  const MotionHistory history = test::history_at(test::swinging_take("user", 200, 5).a.poses, 180);
  HistoryKernel::Raw raw;
  HistoryKernel::sample(history, raw);
  for (std::size_t lag = 0; lag < HistoryKernel::lags_s.size(); ++lag) {
    MotionHistory::Sample pose;
    history.sample(HistoryKernel::lags_s[lag], pose);
    EXPECT_TRUE(std::equal(pose.begin(), pose.end(),
                           raw.begin() + static_cast<std::ptrdiff_t>(lag * MotionHistory::coordinates)))
        << lag;
  }
}

TEST(HistoryKernel, IsOneForTheSameMotionAndLessForAnyOther) {
  const Rows raw = motions();
  const HistoryKernel kernel(raw);
  const Eigen::MatrixXd gram = gram_of(kernel, kernel.describe(raw));
  for (Eigen::Index i = 0; i < gram.rows(); ++i)
    for (Eigen::Index j = 0; j < gram.cols(); ++j) {
      EXPECT_EQ(gram(i, j), gram(j, i));
      if (i == j) {
        EXPECT_EQ(gram(i, j), 1);
      } else {
        EXPECT_GT(gram(i, j), 0) << i << ' ' << j;
        EXPECT_LT(gram(i, j), 1) << i << ' ' << j;
      }
    }
}

TEST(HistoryKernel, IsPositiveDefinite) {
  const Rows raw = motions();
  const HistoryKernel kernel(raw);
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> found(gram_of(kernel, kernel.describe(raw)));
  EXPECT_GT(found.eigenvalues()(0), 1e-6) << "float entries of about 1 round by 1e-7";
}

TEST(HistoryKernel, DescribesOneMotionAsItDescribesMany) {
  const Rows raw = motions();
  const HistoryKernel kernel(raw);
  const Rows described = kernel.describe(raw);
  ASSERT_EQ(described.cols(), kernel.size());
  std::vector<float> one(static_cast<std::size_t>(kernel.size()));
  for (Eigen::Index i = 0; i < raw.rows(); ++i) {
    HistoryKernel::Raw motion;
    std::copy_n(raw.row(i).data(), motion.size(), motion.begin());
    kernel.describe(motion, one);
    for (Eigen::Index c = 0; c < described.cols(); ++c)
      ASSERT_NEAR(one[static_cast<std::size_t>(c)], described(i, c), 1e-4) << "motion " << i;
  }
}

TEST(HistoryKernel, AMotionIsMoreLikeOneThatIsNearerInTime) {
  const Rows raw = motions();
  const HistoryKernel kernel(raw);
  const Eigen::MatrixXd gram = gram_of(kernel, kernel.describe(raw));
  // The first person's, in the middle, where two seconds are known.
  EXPECT_GT(gram(18, 19), gram(18, 22));
  EXPECT_GT(gram(18, 19), 0.5);
}

TEST(HistoryKernel, DoesNotDependOnUnitOrOriginOfTheMotionsItLearns) {
  const Rows raw = motions();
  Rows changed = 100 * raw;
  changed.rowwise() += Eigen::RowVectorXf::LinSpaced(changed.cols(), -50, 50);
  const HistoryKernel kernel(raw), other(changed);
  const Eigen::MatrixXd difference =
      gram_of(kernel, kernel.describe(raw)) - gram_of(other, other.describe(changed));
  EXPECT_LT(difference.cwiseAbs().maxCoeff(), 1e-3) << "rounding of centimetres 50 m away";
}

TEST(HistoryKernel, EveryPartCountsByItsUsualDistanceAndNotByItsMetres) {
  const Rows raw = motions();
  Rows changed = raw;
  changed.leftCols<MotionHistory::coordinates>() *= 10;  // the pose now
  const HistoryKernel kernel(raw), other(changed);
  const Eigen::MatrixXd difference =
      gram_of(kernel, kernel.describe(raw)) - gram_of(other, other.describe(changed));
  EXPECT_LT(difference.cwiseAbs().maxCoeff(), 1e-3);
}

TEST(HistoryKernel, OfASingleMotionTellsItFromOthers) {
  const Rows raw = motions();
  const HistoryKernel kernel(raw.topRows(1));
  const Rows described = kernel.describe(raw);
  EXPECT_TRUE(described.allFinite());
  EXPECT_EQ(kernel(row_of(described, 0), row_of(described, 0)), 1);
  EXPECT_LT(kernel(row_of(described, 0), row_of(described, 10)), 1);
}

}  // namespace
}  // namespace abrazo::history_kernel_test
