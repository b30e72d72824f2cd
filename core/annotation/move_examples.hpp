#pragma once

#include "core/annotation/candidate_grid.hpp"
#include "core/annotation/decision_forest.hpp"

namespace abrazo {

/// Training examples for moves: candidates of the labelled takes. Their class is the label of the move that
/// they nearly cover; the last class, "none", has candidates that match no move, and moves with the
/// performers exchanged. Takes are the groups; origins number the moves of all takes.
///
/// Every label has the same total weight, because LabelOrder has its frequency; a move has the same weight
/// however many candidates cover it.
ForestExamples move_examples(const LabelledMoves& moves, const CandidateLengths& lengths);

}  // namespace abrazo
