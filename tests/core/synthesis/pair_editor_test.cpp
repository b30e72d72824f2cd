#include "core/synthesis/edit/pair_editor.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/mesh/interaction_mesh.hpp"
#include "core/motion/body/joint_set.hpp"
#include "tests/support/bodies.hpp"

namespace abrazo::pair_editor_test {
namespace {

double degrees_between(const Eigen::RowVector3d& a, const Eigen::RowVector3d& b) {
  return std::acos(std::clamp(a.normalized().dot(b.normalized()), -1.0, 1.0)) * 180 / std::numbers::pi;
}

/// A bone row is linear: pulled towards a point at ten times its length, the hand would turn ten times too
/// far, to and fro with every step.
TEST(PairEditor, ABoneThatIsPulledHardTurnsToWhereItIsPulled) {
  const PairPose pair = test::facing_pair(2.0);
  const InteractionMesh mesh = tetrahedralize(pair);
  Settings settings;
  settings.collisions = settings.foot_locks = false;
  for (const double reach_m : {0.3, 1.0, 2.0}) {
    EditTask task;
    task.edges = mesh.edges;
    task.selected = task.reference = pair;
    task.target = pair.topRows<joint_count>();
    task.target.row(joints::left_hand) += Eigen::RowVector3d(0, reach_m, -reach_m);  // above and behind
    task.wanted = rigid_distances(pair);
    task.keeps_apart = false;
    task.active_radii = task.passive_radii = &generic_capsule_radii();
    PairEditor editor;
    FootLocks locks;
    ASSERT_TRUE(editor.edit(task, settings, locks).solved) << reach_m;
    const auto wrist = editor.result().row(joint_parents[joints::left_hand]);
    EXPECT_LT(degrees_between(editor.result().row(joints::left_hand) - wrist,
                              task.target.row(joints::left_hand) - wrist),
              2)
        << reach_m;
  }
}

}  // namespace
}  // namespace abrazo::pair_editor_test
