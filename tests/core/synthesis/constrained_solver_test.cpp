#include "core/synthesis/edit/constrained_solver.hpp"

#include <gtest/gtest.h>

#include <random>

#include "core/synthesis/edit/capsule_contacts.hpp"
#include "tests/support/bodies.hpp"
#include "tests/support/dense_algebra.hpp"

namespace abrazo::constrained_solver_test {
namespace {

constexpr int unknowns = 3 * pair_vertex_count;

/// A problem as a frame has it: Laplacian, morphing and velocity energies, bone rows.
struct Problem {
  PairPose reference = test::facing_pair(0.6);
  VertexMatrix energy;
  PairPose linear;
  std::vector<ConstraintRow> rows;

  explicit Problem(unsigned seed) {
    std::mt19937 random(seed);
    Laplacian laplacian;
    const InteractionMesh mesh = tetrahedralize(reference);
    laplacian.build(mesh.edges, reference, EdgeWeights::Inverse);
    energy = laplacian.gram();
    energy.diagonal().head<joint_count>().array() += 10.0;
    energy.diagonal().array() += 0.2;
    PairPose target = reference;
    target.topRows<joint_count>() = test::shaken(target.topRows<joint_count>(), 0.1, random);
    linear = laplacian.gram() * reference + 0.2 * reference;
    linear.topRows<joint_count>() += 10.0 * target.topRows<joint_count>();
    add_bone_rows(reference, reference, rigid_distances(reference), rows);
  }
};

Eigen::MatrixXd dense_rows(const std::vector<ConstraintRow>& rows, Eigen::VectorXd& targets) {
  Eigen::MatrixXd h = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(rows.size()), unknowns);
  targets.resize(h.rows());
  for (Eigen::Index r = 0; r < h.rows(); ++r) {
    const ConstraintRow& row = rows[static_cast<std::size_t>(r)];
    targets(r) = row.target;
    for (int i = 0; i < row.count; ++i)
      for (int axis = 0; axis < 3; ++axis)
        h(r, 3 * row.vertices[static_cast<std::size_t>(i)] + axis) += row.coefficient(i)(axis);
  }
  return h;
}

Eigen::VectorXd flat(const PairPose& pose) {
  return Eigen::Map<const Eigen::VectorXd>(pose.data(), unknowns);
}

/// K (x) I_3 in the vertex-major order of `flat`.
Eigen::MatrixXd dense_energy(const VertexMatrix& energy) {
  Eigen::MatrixXd k = Eigen::MatrixXd::Zero(unknowns, unknowns);
  for (int i = 0; i < pair_vertex_count; ++i)
    for (int j = 0; j < pair_vertex_count; ++j)
      for (int axis = 0; axis < 3; ++axis) k(3 * i + axis, 3 * j + axis) = energy(i, j);
  return k;
}

/// Eq. 11 as one dense system, solved with a rank-revealing factorisation.
Eigen::VectorXd dense_kkt(const Problem& problem) {
  Eigen::VectorXd targets;
  const Eigen::MatrixXd h = dense_rows(problem.rows, targets);
  const Eigen::Index n = unknowns + h.rows();
  Eigen::MatrixXd kkt = Eigen::MatrixXd::Zero(n, n);
  kkt.topLeftCorner(unknowns, unknowns) = dense_energy(problem.energy);
  kkt.topRightCorner(unknowns, h.rows()) = h.transpose();
  kkt.bottomLeftCorner(h.rows(), unknowns) = h;
  Eigen::VectorXd right(n);
  right << flat(problem.linear), targets;
  return test::solve_by_least_length(kkt, right).col(0).head(unknowns);
}

PairPose solved(const Problem& problem) {
  ConstrainedSolver solver;
  EXPECT_TRUE(solver.set_energy(problem.energy));
  std::vector<char> active;
  PairPose positions;
  EXPECT_TRUE(solver.solve(problem.linear, problem.rows, active, positions));
  return positions;
}

TEST(ConstrainedSolver, ItsStiffnessBetweenTwoJointsIsThatOfTheEnergy) {
  const Problem problem(1);
  ConstrainedSolver solver;
  ASSERT_TRUE(solver.set_energy(problem.energy));
  const Eigen::MatrixXd energy = problem.energy;
  for (const auto& [a, b] : {std::pair(0, 1), std::pair(7, 30), std::pair(49, 3)}) {
    Eigen::VectorXd apart = Eigen::VectorXd::Zero(pair_vertex_count);
    apart(a) = 1;
    apart(b) = -1;
    const double by_hand = 1 / apart.dot(energy.ldlt().solve(apart));
    EXPECT_NEAR(solver.stiffness(a, b), by_hand, 1e-9 * by_hand) << a << ' ' << b;
  }
}

TEST(ConstrainedSolver, EqualsADenseKktSolve) {
  for (unsigned seed = 0; seed < 5; ++seed) {
    const Problem problem(seed);
    EXPECT_LT((flat(solved(problem)) - dense_kkt(problem)).cwiseAbs().maxCoeff(), 1e-8);
  }
}

TEST(ConstrainedSolver, RedundantRowsOfPinnedFeetAreHarmless) {
  Problem problem(3);
  for (const int vertex : {3, 4, 5, 8, 9, 10})
    add_position_rows(vertex, problem.reference.row(vertex), problem.rows);
  Eigen::VectorXd targets;
  const Eigen::MatrixXd h = dense_rows(problem.rows, targets);
  ASSERT_LT(test::rank_of(h), h.rows()) << "the case must be rank deficient to test anything";
  const PairPose positions = solved(problem);
  EXPECT_LT((flat(positions) - dense_kkt(problem)).cwiseAbs().maxCoeff(), 1e-8);
  EXPECT_LT((h * flat(positions) - targets).cwiseAbs().maxCoeff(), 1e-9);
}

TEST(ConstrainedSolver, NoStepInTheNullSpaceOfTheRowsLowersTheEnergy) {
  std::mt19937 random(5);
  std::normal_distribution<double> normal;
  for (unsigned seed = 0; seed < 5; ++seed) {
    const Problem problem(seed);
    const PairPose positions = solved(problem);
    Eigen::VectorXd targets;
    const Eigen::MatrixXd null_space = test::null_space_of(dense_rows(problem.rows, targets));
    const Eigen::MatrixXd k = dense_energy(problem.energy);
    const Eigen::VectorXd r = flat(problem.linear);
    const auto energy = [&](const Eigen::VectorXd& v) { return 0.5 * v.dot(k * v) - r.dot(v); };
    const double at_solution = energy(flat(positions));
    for (int trial = 0; trial < 50; ++trial) {
      Eigen::VectorXd mixture(null_space.cols());
      for (auto& m : mixture) m = normal(random);
      const Eigen::VectorXd step = 1e-3 * (null_space * mixture).normalized();
      EXPECT_GE(energy(flat(positions) + step), at_solution);
    }
  }
}

TEST(ConstrainedSolver, AnInequalityThatHoldsAnywayChangesNothing) {
  Problem problem(1);
  const PairPose without = solved(problem);
  ConstraintRow floor;
  floor.kind = RowKind::Floor;
  floor.inequality = true;
  floor.count = 1;
  floor.vertices[0] = 40;
  floor.weights[0] = 1;
  floor.direction = Vec3::UnitY();
  floor.target = without(40, 1) - 0.5;
  problem.rows.push_back(floor);
  EXPECT_EQ(solved(problem), without);
}

TEST(ConstrainedSolver, AViolatedInequalityBindsExactlyAndPushesOnly) {
  Problem problem(1);
  const PairPose without = solved(problem);
  ConstraintRow lift;
  lift.inequality = true;
  lift.count = 1;
  lift.vertices[0] = 40;
  lift.weights[0] = 1;
  lift.direction = Vec3::UnitY();
  lift.target = without(40, 1) + 0.05;
  problem.rows.push_back(lift);
  ConstrainedSolver solver;
  ASSERT_TRUE(solver.set_energy(problem.energy));
  std::vector<char> active;
  PairPose positions;
  ASSERT_TRUE(solver.solve(problem.linear, problem.rows, active, positions));
  EXPECT_NEAR(positions(40, 1), lift.target, 1e-8);
  EXPECT_GT(solver.multiplier(problem.rows.size() - 1), 0);
}

TEST(ConstrainedSolver, AWrongGuessOfABindingInequalityIsDropped) {
  Problem problem(1);
  const PairPose without = solved(problem);
  ConstraintRow row;
  row.inequality = true;
  row.count = 1;
  row.vertices[0] = 40;
  row.weights[0] = 1;
  row.direction = Vec3::UnitY();
  row.target = without(40, 1) - 0.2;
  problem.rows.push_back(row);
  ConstrainedSolver solver;
  ASSERT_TRUE(solver.set_energy(problem.energy));
  std::vector<char> active(problem.rows.size(), 1);
  PairPose positions;
  ASSERT_TRUE(solver.solve(problem.linear, problem.rows, active, positions));
  EXPECT_LT((positions - without).cwiseAbs().maxCoeff(), 1e-9);
}

TEST(ConstrainedSolver, StiffeningEqualsAddingToTheEnergy) {
  const Problem problem(2);
  constexpr int a = 20;
  constexpr int b = 45;
  constexpr double c = 3.5;
  ConstrainedSolver changed;
  ASSERT_TRUE(changed.set_energy(problem.energy));
  changed.stiffen(a, b, c);
  Problem direct = problem;
  direct.energy(a, a) += c;
  direct.energy(b, b) += c;
  direct.energy(a, b) -= c;
  direct.energy(b, a) -= c;
  std::vector<char> active;
  PairPose positions;
  ASSERT_TRUE(changed.solve(problem.linear, problem.rows, active, positions));
  EXPECT_LT((positions - solved(direct)).cwiseAbs().maxCoeff(), 1e-9);
  changed.relax();
  ASSERT_TRUE(changed.solve(problem.linear, problem.rows, active, positions));
  EXPECT_EQ(positions, solved(problem));
}

TEST(ConstrainedSolver, ProjectionIsTheNearestPointInTheMetricOfTheEnergy) {
  const Problem problem(4);
  std::mt19937 random(6);
  PairPose from = problem.reference;
  from.bottomRows<joint_count>() = test::shaken(from.bottomRows<joint_count>(), 0.02, random);
  Problem nearest = problem;
  nearest.linear = problem.energy * from;  // 1/2 (V - from)^T K (V - from) up to a constant
  ConstrainedSolver solver;
  ASSERT_TRUE(solver.set_energy(problem.energy));
  std::vector<char> active;
  PairPose positions;
  ASSERT_TRUE(solver.project(from, problem.rows, active, positions));
  EXPECT_LT((positions - solved(nearest)).cwiseAbs().maxCoeff(), 1e-9);
}

TEST(ConstrainedSolver, AnEnergyWithoutAMinimumIsRefused) {
  ConstrainedSolver solver;
  VertexMatrix energy = VertexMatrix::Identity();
  energy(7, 7) = -1;
  EXPECT_FALSE(solver.set_energy(energy));
}

TEST(ConstrainedSolver, ContradictoryRowsGiveAFiniteAnswer) {
  Problem problem(0);
  add_position_rows(5, Vec3(0, 0, 0), problem.rows);
  add_position_rows(5, Vec3(1, 0, 0), problem.rows);
  EXPECT_TRUE(solved(problem).allFinite());
}

}  // namespace
}  // namespace abrazo::constrained_solver_test
