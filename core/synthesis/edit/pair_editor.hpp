#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/mesh/laplacian.hpp"
#include "core/synthesis/edit/capsule_contacts.hpp"
#include "core/synthesis/edit/constrained_solver.hpp"
#include "core/synthesis/edit/foot_locks.hpp"
#include "core/synthesis/settings/settings.hpp"

namespace abrazo {

/// Input and targets of the edit of one frame. World space [m].
struct EditTask {
  std::span<const MeshEdge> edges;  ///< interaction mesh of the selected pair
  PairPose selected;                ///< q''_sel: defines mesh weights and allowed overlaps of capsules
  PairPose reference;               ///< the shape that the deformation energy preserves; q''_sel in the paper
  Pose target;                      ///< q'_in
  bool has_previous = false;
  PairPose velocity_target;                    ///< V'_{i-1}, or its prediction; only with has_previous
  double velocity_weight = 0;                  ///< w_Delta for this step
  RigidDistances wanted;                       ///< lengths of the result
  double floor_m = 0;                          ///< lower limit of foot joints, unless the reference is lower
  std::array<std::optional<Vec3>, 2> planted;  ///< the partner's toe bases, left and right: x and z are fixed
  std::span<const HandHold> holds;
  double anchor_weight = 0;         ///< w_a: pulls the partner to the reference
  double hold_weight = 0;           ///< w_H
  bool keeps_apart = true;          ///< capsules
  double clearance_m = 0;           ///< additional to the distance in the selected pair
  const PairPose* sides = nullptr;  ///< pose that defines the side of each capsule; null: the selected pair
  const CapsuleRadii* active_radii = nullptr;
  const CapsuleRadii* passive_radii = nullptr;
};

/// Edits a recorded pair until its active body has the user's pose while the spatial relations of the two
/// bodies are preserved: iterative morphing (Eq. 8-9) with the constrained minimisation of Eq. 11 in each
/// step.
class PairEditor {
 public:
  PairEditor();

  /// Constraints that are dropped, in this order, if not all can be met; bones are kept longest.
  enum class Relaxation { None, PassiveFeet, Feet, Capsules, Everything };

  struct Outcome {
    bool solved = false;
    Relaxation relaxation = Relaxation::None;
  };

  /// @param[in,out] locks locks that had to be dropped are released
  Outcome edit(const EditTask& task, const Settings& settings, FootLocks& locks);

  /// Whether capsules of the reference are nearer to one another than allowed.
  bool presses(const EditTask& task);

  const PairPose& result() const { return steps_.back(); }
  const std::vector<PairPose>& steps() const { return steps_; }
  const Laplacian& laplacian() const { return laplacian_; }
  CapsuleContacts& contacts() { return contacts_; }
  const EditTask& task() const { return task_; }
  /// Largest distance of a locked vertex of the first `bodies` from its locked position [m].
  double drift(const FootLocks& locks, int bodies) const;

 private:
  void prepare_contacts(const EditTask& task);
  bool lets_more_go(const Settings& settings, const FootLocks& locks, Relaxation tried,
                    Relaxation next) const;
  bool morph(const Settings& settings, const FootLocks& locks, Relaxation relaxation);
  int held_feet(const FootLocks& locks, int bodies) const;
  bool solve_step(const Settings& settings, const FootLocks& locks, Relaxation relaxation, double fraction);
  bool project_step(const Settings& settings, const FootLocks& locks, Relaxation relaxation);
  void build_rows(const Settings& settings, const FootLocks& locks, Relaxation relaxation,
                  const RigidDistances& lengths);
  bool keep_iterate();
  bool parts_bodies(const Settings& settings, Relaxation relaxation) const;
  double overlap(const Settings& settings, Relaxation relaxation);

  EditTask task_;
  PairPose constant_;        ///< the part of R that does not change between morph steps
  RigidDistances recorded_;  ///< lengths in the selected pair
  Laplacian laplacian_;
  ConstrainedSolver solver_;
  CapsuleContacts contacts_;
  std::vector<ConstraintRow> rows_;
  std::vector<char> active_rows_;
  std::vector<PairPose> steps_;
  PairPose iterate_;
  bool met_capsules_ = false;  ///< capsule rows occurred in the last morph
};

}  // namespace abrazo
