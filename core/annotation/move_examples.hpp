#pragma once

#include "core/annotation/candidate_grid.hpp"
#include "core/annotation/decision_forest.hpp"

namespace abrazo {

/// What a forest learns moves from: candidates of the labelled takes. Their class is the label of the move
/// that they nearly cover; the last class, "none", has candidates that cover no move well, and moves with the
/// performers in each other's place. Takes are the groups; origins count the moves of all takes on.
///
/// Every label weighs the same, since its frequency is in the order of labels, and a move weighs
/// the same however many candidates cover it.
ForestExamples move_examples(const LabelledMoves& moves, const CandidateLengths& lengths);

}  // namespace abrazo
