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

/// Finds the recorded pair whose partner the user most probably means: the least expected distance to it,
/// over every pair that may be changed to and over going on with the current source. Keeps room between
/// frames, no state: everything a choice depends on is in its arguments.
class IntentSelector {
 public:
  explicit IntentSelector(std::shared_ptr<const IntentModel> model);

  const std::shared_ptr<const IntentModel>& model() const { return model_; }

  /// Fills `candidates`, ascending in feature distance: the best `query.neighbours` that may be changed to,
  /// those of one moment of a take by their best one, and how the current source is best gone on with. Each
  /// has its cost by Eq. 7 too. The choice is exact; of those that cannot win, which are listed (and their
  /// belief) is decided with the best one's leader term in place of their own.
  /// @param history  of the user, with this frame; not empty
  /// @return index of the chosen one; -1 when everything is vetoed
  int select(const SelectionQuery& query, const MotionHistory& history, const SelectablePairs& selectable,
             const IntentWeights& weights, std::vector<Candidate>& candidates, FrameIntent& intent);

  /// Any pair of the library, judged by what the last frame's user did.
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
  std::vector<float> totals_;  ///< per landing, without the margin; infinite when it may not be selected
  std::vector<int> best_;      ///< per block: its best landing; -1 when none may be selected
};

/// Memory for the belief of this model, so that a frame does not allocate.
void reserve_room(FrameIntent& intent, const IntentModel& model);

}  // namespace abrazo
