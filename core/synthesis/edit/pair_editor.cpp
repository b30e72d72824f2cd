#include "core/synthesis/edit/pair_editor.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/motion/body/joint_set.hpp"
#include "core/synthesis/edit/hold_springs.hpp"
#include "core/synthesis/edit/turning_bones.hpp"
#include "core/synthesis/frames/frame_room.hpp"

namespace abrazo {

namespace {

/// Tolerated bone length error after the configured projection steps; above it further steps follow.
constexpr double bone_goal = 2e-4;
constexpr double bone_limit = 1e-3;  ///< beyond this the constraints contradict one another
constexpr double drift_limit_m = 1e-3;
/// The same two for capsules: rows were linear where the last step began, and the bodies have moved since.
constexpr double overlap_goal_m = 1e-3;
constexpr double overlap_limit_m = 1e-2;
constexpr int extra_projection_steps = 8;
constexpr double farthest_sensible_m =
    50.0;  ///< from the selected pair: a result beyond it is a numerical accident

int locked_bodies(const Settings& settings, PairEditor::Relaxation relaxation) {
  if (!settings.foot_locks || relaxation >= PairEditor::Relaxation::Feet) return 0;
  return relaxation >= PairEditor::Relaxation::PassiveFeet ? 1 : 2;
}

}  // namespace

PairEditor::PairEditor() {
  rows_.reserve(ConstrainedSolver::max_rows);
  active_rows_.reserve(ConstrainedSolver::max_rows);
  steps_.reserve(most_edit_steps);
}

PairEditor::Outcome PairEditor::edit(const EditTask& task, const Settings& settings, FootLocks& locks) {
  task_ = task;
  steps_.clear();
  recorded_ = rigid_distances(task_.reference);
  laplacian_.build(task_.edges, task_.selected, settings.edge_weights);
  prepare_contacts(task_);

  // K and the constant part of R: the gradient of E_L + w_Delta E_V + E_C is K V - R.
  VertexMatrix energy = laplacian_.gram();
  constant_.noalias() = laplacian_.gram() * task_.reference;
  energy.diagonal().head<joint_count>().array() += settings.morph_weight;
  energy.diagonal().tail<joint_count>().array() += task_.anchor_weight;
  constant_.bottomRows<joint_count>() += task_.anchor_weight * task_.reference.bottomRows<joint_count>();
  if (task_.has_previous && task_.velocity_weight > 0) {
    energy.diagonal().array() += task_.velocity_weight;
    constant_ += task_.velocity_weight * task_.velocity_target;
  }
  add_hold_springs(task_.holds, task_.hold_weight, energy, constant_);
  if (!solver_.set_energy(energy)) return {};

  std::optional<Relaxation> tried;
  for (const auto relaxation : {Relaxation::None, Relaxation::PassiveFeet, Relaxation::Feet,
                                Relaxation::Capsules, Relaxation::Everything}) {
    if (tried && !lets_more_go(settings, locks, *tried, relaxation)) continue;
    tried = relaxation;
    if (!morph(settings, locks, relaxation)) continue;
    if (drift(locks, locked_bodies(settings, relaxation)) > drift_limit_m) continue;
    locks.release(locked_bodies(settings, relaxation));
    return {true, relaxation};
  }
  return {};
}

void PairEditor::prepare_contacts(const EditTask& task) {
  contacts_.prepare(task.selected, *task.active_radii, *task.passive_radii, task.clearance_m);
  if (task.sides) contacts_.keep_sides_of(*task.sides);
}

bool PairEditor::presses(const EditTask& task) {
  prepare_contacts(task);
  return contacts_.deepest_excess_m(task.reference) > 0;
}

/// Without the rows that it lets go, the same would be calculated again.
bool PairEditor::lets_more_go(const Settings& settings, const FootLocks& locks, Relaxation tried,
                              Relaxation next) const {
  if (next == Relaxation::Everything) return true;
  if (next == Relaxation::Capsules && met_capsules_) return true;
  return held_feet(locks, locked_bodies(settings, next)) < held_feet(locks, locked_bodies(settings, tried));
}

int PairEditor::held_feet(const FootLocks& locks, int bodies) const {
  int held = locks.held(bodies);
  if (bodies == 2)
    for (const auto& toe_base : task_.planted) held += toe_base.has_value();
  return held;
}

double PairEditor::drift(const FootLocks& locks, int bodies) const {
  double largest = locks.drift(bodies, result());
  if (bodies == 2)
    for (std::size_t f = 0; f < task_.planted.size(); ++f)
      if (const auto& toe_base = task_.planted[f]) {
        const auto at = result().row(FootLocks::ankles[2 + f] + 1);
        largest = std::max(largest, std::hypot(at.x() - toe_base->x(), at.z() - toe_base->z()));
      }
  return largest;
}

bool PairEditor::morph(const Settings& settings, const FootLocks& locks, Relaxation relaxation) {
  met_capsules_ = false;
  steps_.clear();
  active_rows_.clear();
  rows_.clear();
  iterate_ = task_.reference;
  // A reference whose leader is the user has no way to go.
  const int morph_steps = task_.reference.topRows<joint_count>() == task_.target ? 1 : settings.morph_steps;
  for (int step = 1; step <= morph_steps; ++step)
    if (!solve_step(settings, locks, relaxation, static_cast<double>(step) / morph_steps)) return false;
  for (int step = 0; step < settings.projection_steps; ++step)
    if (!solve_step(settings, locks, relaxation, 1.0)) return false;
  for (int step = 0;; ++step) {
    const double bone_error = bone_length_error(iterate_, task_.wanted);
    const bool is_last = step == extra_projection_steps;
    // Overlaps are measured where they decide: it takes a search among all capsules.
    if (bone_error <= bone_goal || is_last) {
      const double overlap_m = overlap(settings, relaxation);
      if (overlap_m <= overlap_goal_m || is_last)
        return !steps_.empty() && bone_error <= bone_limit && overlap_m <= overlap_limit_m;
    }
    if (!project_step(settings, locks, relaxation)) return false;
  }
}

bool PairEditor::solve_step(const Settings& settings, const FootLocks& locks, Relaxation relaxation,
                            double fraction) {
  PairPose linear = constant_;
  // Eq. 8: the intermediate target between the selected pose and the user's.
  linear.topRows<joint_count>() +=
      settings.morph_weight * (task_.reference.topRows<joint_count>() +
                               fraction * (task_.target - task_.reference.topRows<joint_count>()));
  RigidDistances lengths = task_.wanted;
  for (std::size_t n = 0; n < lengths.size(); ++n)
    lengths[n].length_m =
        recorded_[n].length_m + fraction * (task_.wanted[n].length_m - recorded_[n].length_m);
  damp_turning_bones(lengths, iterate_, !rows_.empty(), solver_, linear);
  build_rows(settings, locks, relaxation, lengths);
  return solver_.solve(linear, rows_, active_rows_, iterate_) && keep_iterate();
}

bool PairEditor::project_step(const Settings& settings, const FootLocks& locks, Relaxation relaxation) {
  solver_.relax();
  build_rows(settings, locks, relaxation, task_.wanted);
  const PairPose from = iterate_;
  return solver_.project(from, rows_, active_rows_, iterate_) && keep_iterate();
}

void PairEditor::build_rows(const Settings& settings, const FootLocks& locks, Relaxation relaxation,
                            const RigidDistances& lengths) {
  rows_.clear();
  add_bone_rows(iterate_, task_.reference, lengths, rows_);
  if (relaxation < Relaxation::Everything) add_floor_rows(task_.reference, task_.floor_m, rows_);
  const int bodies = locked_bodies(settings, relaxation);
  locks.add_rows(bodies, rows_);
  for (std::size_t f = 0; bodies == 2 && f < task_.planted.size(); ++f)
    if (task_.planted[f]) add_place_rows(FootLocks::ankles[2 + f] + 1, *task_.planted[f], rows_);
  const std::size_t lasting_rows = rows_.size();
  if (parts_bodies(settings, relaxation)) contacts_.add_rows(iterate_, rows_);
  // Capsule rows are determined again in every step, so the guess of active rows is kept only for the others.
  met_capsules_ |= rows_.size() > lasting_rows;
  active_rows_.resize(lasting_rows, 0);
  active_rows_.resize(rows_.size(), 0);
  for (std::size_t r = lasting_rows; r < rows_.size(); ++r)
    active_rows_[r] = rows_[r].value(iterate_) < rows_[r].target ? 1 : 0;
}

bool PairEditor::keep_iterate() {
  // Of numbers and what is no number maxCoeff may give the number.
  if (!iterate_.allFinite()) return false;
  if ((iterate_ - task_.reference).cwiseAbs().maxCoeff() > farthest_sensible_m) return false;
  steps_.push_back(iterate_);
  return true;
}

bool PairEditor::parts_bodies(const Settings& settings, Relaxation relaxation) const {
  return settings.collisions && task_.keeps_apart && relaxation < Relaxation::Capsules;
}

/// Deepest beyond the selected pair's own at the iterate; 0 while capsules may overlap.
double PairEditor::overlap(const Settings& settings, Relaxation relaxation) {
  if (!parts_bodies(settings, relaxation)) return 0;
  return contacts_.deepest_excess_m(iterate_);
}

}  // namespace abrazo
