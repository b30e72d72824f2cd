#pragma once

#include <memory>
#include <vector>

#include "core/selection/frame_intent.hpp"
#include "core/selection/intent_model.hpp"
#include "core/selection/pair_selector.hpp"

namespace abrazo {

/// Weights of IntentCost [m]; `switch_margin` is its `change`.
struct IntentWeights {
  double switch_margin = 0.03;
  double leader = 0.2;
  double move = 0.1;
  double meant = 0.2;
};

/// Finds the recorded pair whose partner the user most probably intends: the one of least expected distance
/// among all landings and the continuations of the current source. Keeps work space between frames but no
/// state: a choice depends only on the arguments.
class IntentSelector {
 public:
  explicit IntentSelector(std::shared_ptr<const IntentModel> model);

  const std::shared_ptr<const IntentModel>& model() const { return model_; }

  /// Fills `candidates`, ascending in feature distance: the best `query.neighbours` landings, one per moment
  /// of a take, and the best continuation of the current source. Each also has its cost by Eq. 7. The choice
  /// is exact; for landings that cannot win, listing and belief use the leader term of the best one instead
  /// of their own.
  /// @param history of the user, including this frame; not empty
  /// @return index of the chosen one; -1 if everything is vetoed
  int select(const SelectionQuery& query, const MotionHistory& history, const SelectablePairs& selectable,
             const IntentWeights& weights, std::vector<Candidate>& candidates, FrameIntent& intent);

  /// Any pair of the library as a candidate, rated by the user's motion of the last frame.
  Candidate candidate(int pair, const SelectionQuery& query, const SelectablePairs& selectable,
                      const IntentWeights& weights, bool is_change);

 private:
  Candidate priced(int pair, const IntentModel::PairReading& read, const SelectionQuery& query,
                   const SelectablePairs& selectable, const IntentWeights& weights, bool is_change) const;
  void judge_landings(const SelectablePairs& selectable, const IntentWeights& weights);
  void list_landings(const SelectionQuery& query, const SelectablePairs& selectable,
                     const IntentWeights& weights, std::vector<Candidate>& candidates);
  int list_continuation(const SelectionQuery& query, const SelectablePairs& selectable,
                        const IntentWeights& weights, std::vector<Candidate>& candidates);
  double lead(const SelectionQuery& query, const IntentWeights& weights) const;
  RootFrame place(int like) const;
  void believe(FrameIntent& intent);

  std::shared_ptr<const IntentModel> model_;
  IntentModel::Reading reading_;
  std::vector<float> totals_;  ///< per landing, without the margin; infinite if not selectable
  std::vector<int> best_;      ///< per block: its best landing; -1 if none is selectable
};

/// Reserves memory for the belief of this model, so that a frame does not allocate.
void reserve_room(FrameIntent& intent, const IntentModel& model);

}  // namespace abrazo
