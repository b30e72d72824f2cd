#include "core/synthesis/bodies/pair_fit.hpp"

#include <algorithm>

#include "core/motion/body/joint_set.hpp"
#include "core/synthesis/edit/foot_locks.hpp"
#include "core/synthesis/edit/hold_springs.hpp"
#include "core/synthesis/edit/turning_bones.hpp"

namespace abrazo {

namespace {

constexpr int morph_steps = 5;
constexpr int further_steps = 3;  ///< on the whole target
constexpr int most_projections = 12;
constexpr double bone_goal = 1e-4;
constexpr double bone_limit = 1e-3;
constexpr double drift_limit_m = 1e-3;
constexpr double excess_goal_m = 1e-3, excess_limit_m = 1e-2;
constexpr double farthest_m = 5;  ///< from the rebuilt pair: a result beyond is a numerical accident

constexpr std::array<int, 6> foot_joints = {joints::LeftTibia,  joints::LeftFoot,  joints::LeftToes,
                                            joints::RightTibia, joints::RightFoot, joints::RightToes};

int toe_base_of(std::size_t foot) {
  return FootLocks::ankles[foot] + 1;
}

}  // namespace

PairFit::PairFit(const PairCapsules& capsules, const FitWeights& weights)
    : capsules_(capsules), weights_(weights) {
  rows_.reserve(ConstrainedSolver::max_rows);
  active_rows_.reserve(ConstrainedSolver::max_rows);
}

PairFit::Outcome PairFit::fit(const FitTask& task) {
  task_ = &task;
  lengths_ = rigid_distances(task.rebuilt);
  mesh_.build(task.edges, task.recorded, task.rebuilt, weights_.relation);
  contacts_.prepare(task.recorded, capsules_.recorded_active, capsules_.recorded_passive);
  contacts_.wear(capsules_.active, capsules_.passive);

  VertexMatrix energy = mesh_.energy();
  energy.diagonal().array() += weights_.place;
  anchored_ = weights_.place * task.rebuilt;
  for (const int first : {0, joint_count})
    for (const int joint : foot_joints) {
      energy(first + joint, first + joint) += weights_.foot;
      anchored_.row(first + joint) += weights_.foot * task.rebuilt.row(first + joint);
    }
  if (task.smoothed) {
    const double smooth = task.smooth_share * weights_.smooth;
    energy.diagonal().array() += smooth;
    anchored_ += smooth * *task.smoothed;
  }
  if (task.given > 0) {
    energy.diagonal().head<joint_count>().array() += task.given;
    anchored_.topRows<joint_count>() += task.given * task.rebuilt.topRows<joint_count>();
  }
  for (std::size_t foot = 0; foot < task.foot_weights.size(); ++foot) {
    const int toe_base = toe_base_of(foot);
    energy(toe_base, toe_base) += task.foot_weights[foot];
    anchored_.row(toe_base) += task.foot_weights[foot] * task.rebuilt.row(toe_base);
  }
  add_posture(task.rebuilt, weights_.posture, energy, anchored_);
  add_hold_springs(task.holds, task.hold_weight, energy, anchored_);

  Outcome outcome;
  outcome.let_go = LetGo::Everything;
  if (solver_.set_energy(energy))
    for (const LetGo let_go : {LetGo::Nothing, LetGo::Capsules, LetGo::StandingFeet}) {
      // Without the rows that it lets go, the same would be calculated again.
      if (let_go == LetGo::StandingFeet && std::ranges::find(task.stands, true) == task.stands.end())
        continue;
      if (morph(let_go)) {
        outcome.let_go = let_go;
        break;
      }
    }
  if (outcome.let_go == LetGo::Everything) iterate_ = task.rebuilt;
  outcome.pose = iterate_;
  outcome.bone_error = bone_length_error(iterate_, lengths_);
  outcome.foot_drift_m = foot_drift();
  outcome.excess_m = contacts_.deepest_excess_m(iterate_);
  return outcome;
}

bool PairFit::morph(LetGo let_go) {
  rows_.clear();
  active_rows_.clear();
  iterate_ = task_->smoothed ? *task_->smoothed : task_->rebuilt;
  if (!task_->smoothed)
    for (int step = 1; step <= morph_steps; ++step)
      if (!solve_step(let_go, static_cast<double>(step) / morph_steps)) return false;
  for (int step = 0; step < further_steps; ++step)
    if (!solve_step(let_go, 1)) return false;
  for (int step = 0;; ++step) {
    const double bone_error = bone_length_error(iterate_, lengths_);
    const bool is_last = step == most_projections;
    // Overlaps are measured where they decide: it takes a search among all capsules.
    if (bone_error <= bone_goal || is_last) {
      const double excess_m = excess(let_go);
      if (excess_m <= excess_goal_m || is_last)
        return bone_error <= bone_limit && excess_m <= excess_limit_m &&
               (let_go >= LetGo::StandingFeet || foot_drift() <= drift_limit_m);
    }
    if (!project_step(let_go)) return false;
  }
}

bool PairFit::solve_step(LetGo let_go, double fraction) {
  PairPose linear = mesh_.linear(fraction) + anchored_;
  damp_turning_bones(lengths_, iterate_, !rows_.empty(), solver_, linear);
  build_rows(let_go);
  return solver_.solve(linear, rows_, active_rows_, iterate_) && iterate_.allFinite() &&
         (iterate_ - task_->rebuilt).cwiseAbs().maxCoeff() < farthest_m;
}

bool PairFit::project_step(LetGo let_go) {
  solver_.relax();
  build_rows(let_go);
  const PairPose from = iterate_;
  return solver_.project(from, rows_, active_rows_, iterate_);
}

void PairFit::build_rows(LetGo let_go) {
  rows_.clear();
  add_bone_rows(iterate_, task_->rebuilt, lengths_, rows_);
  add_floor_rows(task_->rebuilt, 0, rows_);
  if (let_go < LetGo::StandingFeet)
    for (std::size_t foot = 0; foot < task_->stands.size(); ++foot)
      if (task_->stands[foot])
        add_position_rows(toe_base_of(foot), task_->rebuilt.row(toe_base_of(foot)), rows_);
  const std::size_t lasting_rows = rows_.size();
  if (let_go < LetGo::Capsules) contacts_.add_rows(iterate_, rows_);
  // Capsule rows are determined again in every step, so the guess of active rows is kept only for the others.
  active_rows_.resize(lasting_rows, 0);
  active_rows_.resize(rows_.size(), 0);
  for (std::size_t r = lasting_rows; r < rows_.size(); ++r)
    active_rows_[r] = rows_[r].value(iterate_) < rows_[r].target ? 1 : 0;
}

double PairFit::foot_drift() const {
  double largest = 0;
  for (std::size_t foot = 0; foot < task_->stands.size(); ++foot)
    if (task_->stands[foot])
      largest =
          std::max(largest, (iterate_.row(toe_base_of(foot)) - task_->rebuilt.row(toe_base_of(foot))).norm());
  return largest;
}

double PairFit::excess(LetGo let_go) {
  return let_go < LetGo::Capsules ? contacts_.deepest_excess_m(iterate_) : 0;
}

}  // namespace abrazo
