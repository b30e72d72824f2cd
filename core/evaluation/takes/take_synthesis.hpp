#pragma once

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "core/base/result.hpp"
#include "core/evaluation/takes/user_variant.hpp"
#include "core/library/store/motion_library.hpp"
#include "core/library/takes/paired_take.hpp"
#include "core/metrics/motion_quality.hpp"
#include "core/synthesis/settings/settings.hpp"

namespace abrazo {

/// The other performer, A or B.
ActivePerformer other(ActivePerformer performer);

/// A take in which one performer was the user and the library replaced the other: results of the steps.
struct SynthesisedTake {
  const PairedTake* take = nullptr;
  ActivePerformer user = ActivePerformer::A;  ///< which performer was the input
  UserRole user_role = UserRole::Active;
  bool of_library = true;  ///< the take is one of the library's own, left out
  double rate_hz = 0;      ///< steps per second

  // One entry per step that did not fail.
  std::vector<int> frames;         ///< of the take
  std::vector<PairPose> results;   ///< active then passive
  std::vector<PairPose> selected;  ///< q''_sel
  std::vector<int> pairs;          ///< of the library
  std::vector<char> source_changed;
  std::vector<char> follows;  ///< the step before did not fail
  std::vector<double> times_s;
  std::vector<SourceMoment> sources;
  std::vector<std::array<bool, 2>> locked_feet;  ///< of the partner: left, right

  std::vector<double> step_us;  ///< of every step
  int relaxed = 0, failed = 0;
  double bone_length_max = 0, foot_lock_drift_max_m = 0;

  std::size_t size() const { return frames.size(); }
  Pose partner(std::size_t step) const { return body(results[step], user_role != UserRole::Active); }
  Pose user_body(std::size_t step) const { return body(results[step], user_role == UserRole::Active); }
  Pose selected_partner(std::size_t step) const {
    return body(selected[step], user_role != UserRole::Active);
  }
  PartnerStep partner_step(std::size_t step) const;
  /// The performer in the active role.
  ActivePerformer active() const { return user_role == UserRole::Active ? user : other(user); }
  /// The captured partner of the take.
  const Pose& true_partner(std::size_t step) const;
  const Pose& true_user(std::size_t step) const;
  /// Both as captured, in the order of `results`.
  PairPose true_pair(std::size_t step) const;
  const Clip& true_partner_clip() const;
  const Clip& true_user_clip() const;

 private:
  static Pose body(const PairPose& pair, bool active) {
    return active ? Pose(pair.topRows<joint_count>()) : Pose(pair.bottomRows<joint_count>());
  }
};

/// The performer of a take who is the user: the one with the user's role throughout; A if either is possible
/// (`both_roles`) or roles are unknown. An Error if the performers change roles in a library that follows
/// them.
Result<ActivePerformer> user_of(const PairedTake& take, UserRole role, bool both_roles);

struct TakeSynthesisOptions {
  Settings settings;
  bool both_roles = false;
  bool leave_out = true;  ///< the take itself is not selected from
  UserVariant variant;
  unsigned seed = 1;  ///< of the variant's noise
};

/// The whole pipeline over the user of a take. `take` must outlive what is returned.
Result<SynthesisedTake> synthesise_take(const std::shared_ptr<const MotionLibrary>& library,
                                        const PairedTake& take, const TakeSynthesisOptions& options);

}  // namespace abrazo
