#pragma once

#include <optional>
#include <vector>

#include "core/annotation/candidate_grid.hpp"
#include "core/annotation/confidence_scale.hpp"
#include "core/annotation/decision_forest.hpp"
#include "core/annotation/label_order.hpp"
#include "core/annotation/labelled_moves.hpp"
#include "core/annotation/tiling.hpp"

namespace abrazo {

/// A stretch proposed as one move, in frames of the CoupleMotion.
struct ProposedMove {
  int begin = 0, end = 0;
  int label = 0;
  int active = 0;  ///< 0 = a, 1 = b
  ConfidenceScale::Evidence move_evidence, role_evidence;
  double confidence = 0;                              ///< that there is a move of that label, 0 to 1
  double role_confidence = 0;                         ///< that the role is right
  std::vector<DecisionForest::Neighbour> neighbours;  ///< labelled moves, numbered over all takes
};

/// Learns from labelled takes which stretches of motion are which move, and who is active in them.
///
/// Every stretch between two cuts is a candidate. A forest classifies its features as a label or as none (not
/// a whole move, or one with the performers exchanged). A hidden semi-Markov model over label and role then
/// finds the tiling with the greatest sum of log(share of the label / share of none) and log probabilities of
/// label succession. Tilings contain different candidates, so they are compared by the odds against none.
class MoveModel {
 public:
  /// @param moves  with at least one take; must outlive the model
  static Result<MoveModel> learn(const LabelledMoves& moves, const Progress& progress);

  /// The moves tile the take. Empty if it has no frames.
  std::vector<ProposedMove> propose(const std::array<MotionChannels, 2>& channels) const;

  /// Number of trials behind the confidences; 0 = too few takes.
  int trials() const { return move_scale_.trials(); }

 private:
  /// Weights of the tiling's terms, chosen by trials on the labelled takes.
  struct Weights {
    double segment = 0;  ///< added for every segment: the greater, the shorter they are
    double follows = 1;  ///< of the log probability that a label follows another
  };
  /// Results of trials on the labelled takes, each with trees that did not see it.
  struct Trials {
    std::vector<ConfidenceScale::Trial> moves, roles;
    double agreed_frames = 0, frames = 0;
    int right = 0, proposed = 0, truths = 0;

    /// Share of frames with their label, and F1 of the moves.
    double goodness() const;
    void add(const ProposedMove& move, const LabelledTake& take);
  };
  explicit MoveModel(const LabelledMoves& moves) : moves_(&moves) {}

  int role_count() const { return moves_->has_roles ? 2 : 1; }
  TilingScores evidence(const std::array<MotionChannels, 2>& channels, std::optional<int> unseen) const;
  void weigh(TilingScores& scores, const Weights& weights) const;
  std::vector<ProposedMove> read(const TilingScores& scores, const MotionChannels& channels) const;
  Status try_out(const Progress& progress);

  const LabelledMoves* moves_;
  CandidateLengths lengths_;
  LabelOrder order_;
  std::optional<DecisionForest> forest_;
  Weights weights_;
  ConfidenceScale move_scale_, role_scale_;
};

}  // namespace abrazo
