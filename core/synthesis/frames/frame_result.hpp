#pragma once

#include <array>
#include <string>
#include <vector>

#include "core/library/store/normalization.hpp"
#include "core/mesh/interaction_mesh.hpp"
#include "core/selection/candidate.hpp"
#include "core/selection/frame_intent.hpp"

namespace abrazo {

/// Energies of Eq. 11 at the result.
struct FrameEnergy {
  double deformation = 0;  ///< E_L = 1/2 sum_j |delta_j - L(v'_j)|^2, against the selected pair [m^2]
  double velocity =
      0;  ///< E_V = 1/2 |V' - V'_previous|^2 (or the predicted form), not yet times w_Delta [m^2]
  double constraint = 0;  ///< E_C = w_C/2 |V'_A - q'_in|^2
};

/// Residuals of the nonlinear constraints, measured at the result, not predicted by the linear system.
struct FrameResidual {
  double bone_length_max = 0;           ///< largest |length - wanted| / wanted
  double foot_lock_max_m = 0;           ///< largest distance of a locked foot from its locked position
  double penetration_max_m = 0;         ///< deepest overlap of two capsules of different bodies
  double excess_penetration_max_m = 0;  ///< deepest beyond the selected pair's own
  double morph_rms_m = 0;               ///< of the active joints from the user's pose
};

/// A foot held where it landed.
struct FootLock {
  bool active_body = true;
  bool left = true;
  bool operator==(const FootLock&) const = default;
};

/// A hand of each body that the edit brings together, because they hold one another in the recording.
struct HandHold {
  bool active_left = true;
  bool passive_left = true;
  double strength = 0;         ///< 0 = released, 1 = held
  Vec3 offset = Vec3::Zero();  ///< desired offset of the passive hand from the active one; world [m]
};

/// Two capsules of different bodies that touch or are kept apart. A capsule's ends are vertices 0..49.
struct CapsuleContact {
  std::array<int, 2> a{};
  std::array<int, 2> b{};
  double depth_m = 0;          ///< overlap at the result
  double allowed_depth_m = 0;  ///< the selected pair's own overlap
};

struct StepTiming {
  double retarget_us = 0, select_us = 0, mesh_us = 0, solve_us = 0, total_us = 0;
};

enum class StepStatus { Ok, Relaxed, Failed };

/// Everything that one step computed. World space, metres.
struct FrameResult {
  Pose query_world = Pose::Zero();       ///< q'_in: the user retargeted to the library's body
  Pose query_normalized = Pose::Zero();  ///< p'_in
  Features features = Features::Zero();
  RootFrame query_root;

  std::vector<Candidate> candidates;  ///< ascending feature distance
  int selected = -1;                  ///< index into candidates; -1 if nothing could be selected
  bool source_changed =
      false;  ///< not the same take within 0 to 3 times the expected pace of the previous one

  FrameIntent intent;  ///< set by the selection `intent`

  PairPose selected_pair = PairPose::Zero();  ///< q''_sel: input of the edit
  std::vector<MeshEdge> edges;
  std::vector<MeshTetrahedron> tetrahedra;
  std::vector<double> edge_weights;      ///< per edge: mean of w_jl and w_lj
  std::vector<double> edge_residuals_m;  ///< per edge: mean Laplacian residual |delta - L(v')| of its ends

  PairPose result = PairPose::Zero();  ///< active then passive
  std::vector<PairPose> morph_steps;   ///< after each morph and projection step; the last is `result`

  FrameEnergy energy;
  FrameResidual residual;
  std::vector<FootLock> foot_locks;
  std::vector<HandHold> holds;
  std::vector<CapsuleContact>
      collisions;  ///< overlapping capsules, deepest first, without hands that hold one another
  StepStatus status = StepStatus::Failed;
  std::string message = "not solved yet";  ///< why the frame was relaxed or failed
  StepTiming timing;

  auto active() const { return result.topRows<joint_count>(); }
  auto passive() const { return result.bottomRows<joint_count>(); }
  /// "ok", "relaxed: ..." or "failed: ...".
  std::string status_text() const;
};

}  // namespace abrazo
