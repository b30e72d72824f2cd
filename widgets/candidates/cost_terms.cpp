#include "widgets/candidates/cost_terms.hpp"

#include <algorithm>
#include <array>

#include "widgets/common/palette.hpp"

namespace abrazo::widgets {
namespace {

constexpr std::array<CostTermInfo, 3> paper_terms = {{
    {CostTerm::Pose, "pose", "pose cost", "pose", "nearer to the user's pose"},
    {CostTerm::Active, "leader", "temporal cost of the leader", "α · temporal leader",
     "less temporal cost of the leader"},
    {CostTerm::Passive, "follower", "temporal cost of the follower", "α · temporal follower",
     "less temporal cost of the follower"},
}};

constexpr std::array<CostTermInfo, most_cost_terms> intent_terms = {{
    {CostTerm::Partner, "partner", "expected distance of the partner", "expected distance of the partner",
     "partner expected nearer"},
    {CostTerm::Leader, "leader", "motion of the leader", "w_l · other motion of the leader",
     "motion of the leader"},
    {CostTerm::Move, "move", "unlikely move", "w_m · unlikely move", "likelier move"},
    {CostTerm::Meant, "intended", "not the intended move", "w_p · not the intended move",
     "the intended move"},
    {CostTerm::Change, "change", "margin for a change of source", "margin for a change of source",
     "it continues the source"},
    {CostTerm::Temporal, "temporal", "distance from the shown partner", "α · distance from the shown partner",
     "nearer to the shown partner"},
}};

constexpr std::array<CostTerms, 2> of_methods = {{
    {paper_terms, "total (Eq. 7)", "m²"},
    {intent_terms, "total (intent)", "m"},
}};

}  // namespace

const CostTerms& cost_terms(SelectionMethod method) {
  return of_methods[static_cast<std::size_t>(method)];
}

const CostTermInfo& info_of(CostTerm term) {
  const auto place = place_of(term, SelectionMethod::Paper);
  return place ? paper_terms[*place] : intent_terms[*place_of(term, SelectionMethod::Intent)];
}

std::optional<std::size_t> place_of(CostTerm term, SelectionMethod method) {
  const auto terms = cost_terms(method).terms;
  const auto found = std::ranges::find(terms, term, &CostTermInfo::term);
  if (found == terms.end()) return std::nullopt;
  return static_cast<std::size_t>(found - terms.begin());
}

QColor colour_of(CostTerm term, const Palette& palette) {
  switch (term) {
    case CostTerm::Pose:
    case CostTerm::Change:
      return palette.user;
    case CostTerm::Active:
    case CostTerm::Leader:
      return palette.active;
    case CostTerm::Passive:
    case CostTerm::Partner:
      return palette.passive;
    case CostTerm::Move:
      return palette.residual_penetration;
    case CostTerm::Meant:
      return palette.warning;
    case CostTerm::Temporal:
      return palette.good;
  }
  return palette.text;
}

std::optional<SelectionMethod> deciding_method(const FrameResult& result) {
  if (result.candidates.empty()) return std::nullopt;
  // Files may be inconsistent; if a candidate lacks the cost by intent, all still have that of Eq. 7.
  const bool all =
      std::ranges::all_of(result.candidates, [](const Candidate& c) { return c.intent.has_value(); });
  return all ? SelectionMethod::Intent : SelectionMethod::Paper;
}

}  // namespace abrazo::widgets
