#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <optional>
#include <random>

#include "core/mesh/capsules.hpp"
#include "core/synthesis/edit/capsule_contacts.hpp"
#include "core/synthesis/edit/constrained_solver.hpp"
#include "tests/support/bodies.hpp"
#include "tests/support/dense_algebra.hpp"
#include "tests/support/libraries.hpp"

namespace abrazo::solver_property_test {
namespace {

constexpr int unknowns = 3 * pair_vertex_count;

double number(double least, double most) {
  return least + (most - least) * *rc::gen::inRange(0, 1001) / 1000.0;
}

/// What one step of a frame asks: two bodies that dance, close enough to touch, feet held, a user elsewhere.
struct Problem {
  PairPose reference;
  VertexMatrix energy;
  PairPose linear;
  std::vector<ConstraintRow> rows;

  Problem() {
    static const PairedTake take = test::swinging_take("take", 180, 5);
    const auto frame = *rc::gen::inRange<std::size_t>(0, 180);
    reference << take.a.poses[frame],
        take.b.poses[frame].rowwise() + Eigen::RowVector3d(0, 0, number(-0.05, 0.3));
    std::mt19937 random(static_cast<unsigned>(*rc::gen::inRange(0, 1000)));
    set_energies(random);
    set_rows();
  }

 private:
  void set_energies(std::mt19937& random) {
    Laplacian laplacian;
    laplacian.build(tetrahedralize(reference).edges, reference,
                    *rc::gen::element(EdgeWeights::Inverse, EdgeWeights::InverseMean, EdgeWeights::Uniform));
    const double morph = *rc::gen::element(0.1, 10.0, 1000.0);
    const double velocity = *rc::gen::element(1e-3, 0.2, 16.0);
    energy = laplacian.gram();
    energy.diagonal().head<joint_count>().array() += morph;
    energy.diagonal().array() += velocity;
    const PairPose before = reference.rowwise() + Eigen::RowVector3d(0.02, 0, -0.01);
    linear = laplacian.gram() * reference + velocity * before;
    linear.topRows<joint_count>() +=
        morph * test::shaken(reference.topRows<joint_count>(), number(0, 0.2), random);
  }

  void set_rows() {
    add_bone_rows(reference, reference, rigid_distances(reference), rows);
    add_floor_rows(reference, 0.01, rows);
    for (const int ankle : {3, 8, 28, 33}) {
      if (*rc::gen::arbitrary<bool>()) continue;
      const Eigen::RowVector3d slid(number(0, 0.02), 0, 0);
      for (const int vertex : {ankle, ankle + 1})
        add_position_rows(vertex, reference.row(vertex) + slid, rows);
    }
    CapsuleContacts contacts;
    contacts.prepare(test::facing_pair(0.8), generic_capsule_radii(), generic_capsule_radii());
    contacts.add_rows(reference, rows);
  }
};

/// Eq. 11 in full, all axes and rows in one matrix, by LU with full pivoting: nothing in common with the
/// solver. Nothing where rows contradict one another.
std::optional<PairPose> dense_answer(const Problem& problem, const std::vector<char>& binding) {
  std::vector<const ConstraintRow*> held;
  for (std::size_t r = 0; r < problem.rows.size(); ++r)
    if (binding[r]) held.push_back(&problem.rows[r]);
  const auto count = static_cast<Eigen::Index>(held.size());
  Eigen::MatrixXd kkt = Eigen::MatrixXd::Zero(unknowns + count, unknowns + count);
  Eigen::VectorXd right(unknowns + count);
  for (int i = 0; i < pair_vertex_count; ++i)
    for (int axis = 0; axis < 3; ++axis) {
      for (int j = 0; j < pair_vertex_count; ++j) kkt(3 * i + axis, 3 * j + axis) = problem.energy(i, j);
      right(3 * i + axis) = problem.linear(i, axis);
    }
  for (Eigen::Index r = 0; r < count; ++r) {
    const ConstraintRow& row = *held[static_cast<std::size_t>(r)];
    right(unknowns + r) = row.target;
    for (int i = 0; i < row.count; ++i)
      for (int axis = 0; axis < 3; ++axis) {
        const int at = 3 * row.vertices[static_cast<std::size_t>(i)] + axis;
        kkt(unknowns + r, at) += row.coefficient(i)(axis);
        kkt(at, unknowns + r) += row.coefficient(i)(axis);
      }
  }
  const Eigen::VectorXd answer = test::solve_by_lu(kkt, right);
  if ((kkt * answer - right).cwiseAbs().maxCoeff() > 1e-9) return std::nullopt;
  return PairPose(Eigen::Map<const PairPose>(answer.data()));
}

bool touches(const Problem& problem, const std::vector<char>& binding) {
  for (std::size_t r = 0; r < binding.size(); ++r)
    if (binding[r] && problem.rows[r].kind == RowKind::Capsule) return true;
  return false;
}

TEST(SolverProperty, EqualsADenseLuOfTheWholeSystem) {
  EXPECT_TRUE(rc::check("any step of any frame", [] {
    Problem problem;
    ConstrainedSolver solver;
    RC_ASSERT(solver.set_energy(problem.energy));
    for (int n = *rc::gen::inRange(0, 4); n > 0; --n) {
      const int a = *rc::gen::inRange(0, 25);
      const int b = *rc::gen::inRange(25, 50);
      const double c = number(0, 20);
      solver.stiffen(a, b, c);
      problem.energy(a, a) += c, problem.energy(b, b) += c;
      problem.energy(a, b) -= c, problem.energy(b, a) -= c;
    }
    std::vector<char> binding;
    PairPose positions;
    RC_ASSERT(solver.solve(problem.linear, problem.rows, binding, positions));
    RC_ASSERT(positions.allFinite());
    const auto expected = dense_answer(problem, binding);
    RC_CLASSIFY(!expected, "contradictory");
    RC_CLASSIFY(touches(problem, binding), "with capsules that touch");
    if (!expected) return;
    const double apart = (positions - *expected).cwiseAbs().maxCoeff();
    RC_LOG() << "apart by " << apart << " m\n";
    RC_ASSERT(apart < 1e-8);
    for (std::size_t r = 0; r < problem.rows.size(); ++r)
      RC_ASSERT(!binding[r] || problem.rows[r].value(positions) > problem.rows[r].target - 1e-8);
  }));
}

}  // namespace
}  // namespace abrazo::solver_property_test
