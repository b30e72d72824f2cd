#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string_view>

#include "core/session/frames/frame_snapshot.hpp"

class QColor;

namespace abrazo::widgets {

struct Palette;

/// A part of what decides between candidates: the first three of Eq. 7 [m^2], the others of `intent` [m].
enum class CostTerm { Pose, Active, Passive, Partner, Leader, Move, Meant, Change };

inline constexpr std::size_t most_cost_terms = 5;  ///< that one method has

/// How a term is called; weights stand with what they weigh.
struct CostTermInfo {
  CostTerm term;
  std::string_view name;   ///< in a column's head
  std::string_view brief;  ///< where that is too wide
  std::string_view key;    ///< in the key of colours
  std::string_view brief_key;
  std::string_view title;    ///< "temporal cost of the leader"
  std::string_view weighed;  ///< in a row's figures, for `typeset`: "α · temporal leader"
  std::string_view gain;     ///< why a winner won by it: "less temporal cost of the leader"
};

/// What one method decides by.
struct CostTerms {
  std::span<const CostTermInfo> terms;  ///< they add up to the total; in the order of the bars
  std::string_view total;               ///< how the total is called where terms are listed
  std::string_view unit;
};

const CostTerms& cost_terms(SelectionMethod method);
const CostTermInfo& info_of(CostTerm term);
/// Among the terms of a method; nothing when it is not one of them.
std::optional<std::size_t> place_of(CostTerm term, SelectionMethod method);

/// What belongs to a character has that one's colour.
QColor colour_of(CostTerm term, const Palette& palette);

/// By what the candidates of a frame were compared; nothing when it has none.
std::optional<SelectionMethod> deciding_method(const FrameResult& result);

}  // namespace abrazo::widgets
