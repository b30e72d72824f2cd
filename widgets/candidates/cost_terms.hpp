#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string_view>

#include "core/session/frames/frame_snapshot.hpp"

class QColor;

namespace abrazo::widgets {

struct Palette;

/// A term of the cost: the first three of Eq. 7 [m^2], the others of `intent` [m].
enum class CostTerm { Pose, Active, Passive, Partner, Leader, Move, Meant, Change, Temporal };

inline constexpr std::size_t most_cost_terms = 6;  ///< maximum of one method

/// Names of a term; weights are written with their term.
struct CostTermInfo {
  CostTerm term;
  std::string_view name;     ///< in the column header, which is the legend of the bars
  std::string_view title;    ///< "temporal cost of the leader"
  std::string_view weighed;  ///< in a row's figures, for `typeset`: "α · temporal leader"
  std::string_view gain;     ///< as the reason of a winner: "less temporal cost of the leader"
};

/// The terms of one method.
struct CostTerms {
  std::span<const CostTermInfo> terms;  ///< they add up to the total; in the order of the bars
  std::string_view total;               ///< name of the total in lists of terms
  std::string_view unit;
};

const CostTerms& cost_terms(SelectionMethod method);
const CostTermInfo& info_of(CostTerm term);
/// Index among the terms of a method; none if it has no such term.
std::optional<std::size_t> place_of(CostTerm term, SelectionMethod method);

/// Terms of a character have its colour.
QColor colour_of(CostTerm term, const Palette& palette);

/// The method that compared the candidates of a frame; none without candidates.
std::optional<SelectionMethod> deciding_method(const FrameResult& result);

}  // namespace abrazo::widgets
