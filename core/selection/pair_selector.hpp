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

/// What is compared with the library for one frame.
struct SelectionQuery {
  Pose normalized;  ///< p'_in
  RootFrame root;   ///< of q'_in
  Features features;
  bool has_prediction = false;        ///< from the second frame on
  PairPose predicted;                 ///< s_A*, s_S* of Eq. 3-4, world; only with has_prediction
  Pose partner_speed = Pose::Zero();  ///< of the partner that is shown, relative to its root [m/s]
  double alpha = 0.5;
  int neighbours = 10;
  int current_pair = -1;     ///< the source of the previous frame; -1 at the start
  int expected_advance = 1;  ///< pairs of the library that one step takes in real time
  /// Where the source goes on in real time, with the playback `continuous`; without a pair by frames.
  SourcePlayhead playhead;
  double since_change_s = 1e9;    ///< of the source
  HandPairs held{};               ///< hands that hold one another in what is shown
  std::array<bool, 2> planted{};  ///< feet of the partner that stand in what is shown, left and right
  int continuations = 0;  ///< so many successors of the current pair, whole steps ahead, join the candidates
};

/// Finds the recorded pair that fits the user and the motion so far (paper 3.3.2-3.3.3).
class PairSelector {
 public:
  /// @param pairs  those that may be selected
  /// @param index  over those pairs, when there is one already; it may be shared
  PairSelector(std::shared_ptr<const MotionLibrary> library, std::vector<int> pairs,
               std::shared_ptr<const PoseIndex> index = nullptr);

  /// Fills `candidates`, ascending in feature distance, each with its cost by Eq. 7.
  /// @return index of the cheapest; -1 when there are none
  int select(const SelectionQuery& query, std::vector<Candidate>& candidates);

  /// Leaves these out from the next call on; in place of the vetoes before. The index stays as it is, so
  /// that a change never holds up the steps.
  void set_vetoes(const Vetoes& vetoes) { pairs_.set_vetoes(vetoes); }

  /// From the next call on only these, as long as one of them may be selected; otherwise as if none were
  /// meant.
  void set_meant(const std::optional<MeantPairs>& meant) { pairs_.set_meant(meant); }

  const SelectablePairs& pairs() const { return pairs_; }

 private:
  std::shared_ptr<const MotionLibrary> library_;
  SelectablePairs pairs_;
  std::shared_ptr<const PoseIndex> index_;  ///< over those that are selectable
  std::vector<PoseMatch> matches_;          ///< kept between calls so that a query does not allocate
};

/// Eq. 7 term by term for one recorded pair.
CostBreakdown pair_cost(const SelectionQuery& query, const PairPose& normalized_pair,
                        const PairPose& world_pair);

}  // namespace abrazo
