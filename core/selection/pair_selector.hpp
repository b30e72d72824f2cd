#pragma once

#include <memory>
#include <vector>

#include "core/library/store/motion_library.hpp"
#include "core/library/store/pose_index.hpp"
#include "core/mesh/capsules.hpp"
#include "core/selection/candidate.hpp"
#include "core/selection/selectable_pairs.hpp"
#include "core/selection/source_playhead.hpp"

namespace abrazo {

/// Input of the selection for one frame.
struct SelectionQuery {
  Pose normalized;  ///< p'_in
  RootFrame root;   ///< of q'_in
  Features features;
  bool has_prediction = false;        ///< true from the second frame on
  PairPose predicted;                 ///< s_A*, s_S* of Eq. 3-4, world; only with has_prediction
  Pose partner_speed = Pose::Zero();  ///< of the shown partner, relative to its root [m/s]
  double alpha = 0.5;
  int neighbours = 10;
  int current_pair = -1;     ///< the source of the previous frame; -1 at the start
  int expected_advance = 1;  ///< pairs of the library per step in real time
  /// Continuation of the source in real time, with the playback `continuous`; without a pair with `frames`.
  SourcePlayhead playhead;
  double since_change_s = 1e9;    ///< of the source
  HandPairs held{};               ///< hands that hold one another in the shown poses
  std::array<bool, 2> planted{};  ///< feet of the shown partner that stand, left and right
  int continuations = 0;  ///< number of successors of the current pair, whole steps ahead, that join the
                          ///< candidates
};

/// Finds the recorded pair that fits the user and the previous motion best (paper 3.3.2-3.3.3).
class PairSelector {
 public:
  /// @param pairs the selectable pairs
  /// @param index over those pairs; may be shared; null: built here
  PairSelector(std::shared_ptr<const MotionLibrary> library, std::vector<int> pairs,
               std::shared_ptr<const PoseIndex> index = nullptr);

  /// Fills `candidates`, ascending in feature distance, each with its cost by Eq. 7.
  /// @return index of the cheapest; -1 when there are none
  int select(const SelectionQuery& query, std::vector<Candidate>& candidates);

  /// Replaces the vetoes, from the next call on. The index stays unchanged, so that a change never delays a
  /// step.
  void set_vetoes(const Vetoes& vetoes) { pairs_.set_vetoes(vetoes); }

  /// Restricts the selection to these from the next call on, as long as one of them is selectable.
  void set_intended(const std::optional<IntendedPairs>& meant) { pairs_.set_intended(meant); }

  const SelectablePairs& pairs() const { return pairs_; }

 private:
  std::shared_ptr<const MotionLibrary> library_;
  SelectablePairs pairs_;
  std::shared_ptr<const PoseIndex> index_;  ///< over the selectable pairs
  std::vector<PoseMatch> matches_;          ///< kept between calls to avoid allocation
};

/// Eq. 7 term by term for one recorded pair.
CostBreakdown pair_cost(const SelectionQuery& query, const PairPose& normalized_pair,
                        const PairPose& world_pair);

}  // namespace abrazo
