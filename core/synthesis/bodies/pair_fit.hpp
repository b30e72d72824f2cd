#pragma once

#include <array>
#include <span>
#include <vector>

#include "core/base/positions.hpp"
#include "core/mesh/capsules.hpp"
#include "core/synthesis/bodies/placed_pair.hpp"
#include "core/synthesis/bodies/posture.hpp"
#include "core/synthesis/bodies/split_mesh.hpp"
#include "core/synthesis/edit/capsule_contacts.hpp"
#include "core/synthesis/edit/constrained_solver.hpp"

namespace abrazo {

/// Weights of a fit, all against the unit weight of the mesh's shape.
struct FitWeights {
  RelationWeights relation;
  PostureWeights posture;
  double place = 0.02;  ///< of every joint at the rebuilt pair
  double foot = 4;      ///< of ankle, toe base and toe tip at the rebuilt pair
  double smooth = 30;   ///< of every joint at the smoothed pair, if there is one
};

/// Radii of both bodies, recorded and new.
struct PairCapsules {
  CapsuleRadii recorded_active{}, recorded_passive{}, active{}, passive{};
};

/// One frame of a recorded pair that gets other bodies. World [m].
struct FitTask {
  std::span<const MeshEdge> edges;
  PairPose recorded = PairPose::Zero();
  PairPose rebuilt = PairPose::Zero();  ///< with the lengths of the result
  /// Standing feet, active left, active right, passive left, passive right: their toe bases stay at those of
  /// the rebuilt pair.
  std::array<bool, 4> stands{};
  const PairPose* smoothed = nullptr;  ///< begins there, so that equally good poses do not alternate
  double smooth_share = 1;             ///< times the weight of the smoothed pair

  // Of a live pair, whose active pose is given and whose feet are on their way.
  double given = 0;                         ///< weight of the active body's joints at the rebuilt pair
  std::array<double, 4> foot_weights = {};  ///< of the toe bases there, in the order of `stands`
  std::span<const HandHold> holds = {};     ///< hands that hold one another
  double hold_weight = 0;
};

/// Fits two bodies to the spatial relation of a recorded pair: mesh, springs of near joints, exact bones,
/// standing feet, floor, capsules. Has no state between tasks: frames can be fitted in any order.
class PairFit {
 public:
  explicit PairFit(const PairCapsules& capsules, const FitWeights& weights = {});

  /// Constraints that were relaxed, in this order, because not all could be satisfied. With `Everything` the
  /// result is the rebuilt pair itself.
  enum class LetGo : std::uint8_t { Nothing, Capsules, StandingFeet, Everything };

  struct Outcome {
    PairPose pose = PairPose::Zero();
    LetGo let_go = LetGo::Nothing;
    double bone_error = 0;    ///< largest, relative
    double foot_drift_m = 0;  ///< largest of standing feet
    double excess_m = 0;      ///< deepest overlap of capsules beyond the recorded one
  };
  Outcome fit(const FitTask& task);

  /// The bodies of the next fits.
  void wear(const PairCapsules& capsules) { capsules_ = capsules; }

  const SplitMesh& mesh() const { return mesh_; }
  /// Measures overlaps of the last fit.
  CapsuleContacts& contacts() { return contacts_; }

 private:
  bool morph(LetGo let_go);
  bool solve_step(LetGo let_go, double fraction);
  bool project_step(LetGo let_go);
  void build_rows(LetGo let_go);
  double foot_drift() const;
  double excess(LetGo let_go);

  PairCapsules capsules_;
  FitWeights weights_;
  const FitTask* task_ = nullptr;
  RigidDistances lengths_;
  SplitMesh mesh_;
  PairPose anchored_;  ///< the linear part of the anchors
  ConstrainedSolver solver_;
  CapsuleContacts contacts_;
  std::vector<ConstraintRow> rows_;
  std::vector<char> active_rows_;
  PairPose iterate_;
};

}  // namespace abrazo
