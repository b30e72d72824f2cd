#include "core/selection/pair_selector.hpp"

#include <algorithm>
#include <string>
#include <string_view>

namespace abrazo {

namespace {

/// As many as can be set: a larger k does not allocate in the step where it is set.
constexpr std::size_t room_for_matches = 200;

std::vector<bool> as_flags(const std::vector<int>& pairs, int count) {
  std::vector<bool> flags(static_cast<std::size_t>(count), false);
  for (const int pair : pairs) flags[static_cast<std::size_t>(pair)] = true;
  return flags;
}

/// Asked for one pair after the other: those of a take and of a move stand together, and what was found for
/// the pair before mostly holds for the next.
class VetoTest {
 public:
  VetoTest(const Vetoes& vetoes, const MotionLibrary& library) : vetoes_(vetoes), library_(library) {
    for (const LibraryTake& take : library.takes()) takes_.push_back(vetoes.takes.contains(take.name));
  }

  bool operator()(int pair) {
    return takes_[library_.source(pair).take] || vetoes_.pairs.contains(pair) || has_vetoed_label(pair);
  }

 private:
  bool has_vetoed_label(int pair) {
    if (vetoes_.labels.empty()) return false;
    const std::string_view label = library_.label(pair);
    if (label != last_label_ || !asked_) last_answer_ = vetoes_.labels.contains(std::string(label));
    asked_ = true;
    last_label_ = label;
    return last_answer_;
  }

  const Vetoes& vetoes_;
  const MotionLibrary& library_;
  std::vector<bool> takes_;
  std::string_view last_label_;
  bool asked_ = false, last_answer_ = false;
};

}  // namespace

PairSelector::PairSelector(std::shared_ptr<const MotionLibrary> library, std::vector<int> pairs,
                           std::shared_ptr<const PoseIndex> index)
    : library_(std::move(library)),
      pairs_(std::move(pairs)),
      selectable_(as_flags(pairs_, library_->pair_count())),
      vetoed_(selectable_.size(), false),
      left_out_(vetoed_),
      index_(std::move(index)) {
  matches_.reserve(std::min(pairs_.size(), room_for_matches));
  if (!index_) index_ = std::make_shared<const PoseIndex>(library_->columns().features, pairs_);
}

void PairSelector::set_vetoes(const Vetoes& vetoes) {
  VetoTest is_unwanted(vetoes, *library_);
  veto_count_ = 0;
  for (const int pair : pairs_) {
    const bool unwanted = is_unwanted(pair);
    vetoed_[static_cast<std::size_t>(pair)] = unwanted;
    if (unwanted) ++veto_count_;
  }
  leave_out();
}

void PairSelector::set_meant(const std::optional<MeantPairs>& meant) {
  meant_ = meant;
  leave_out();
}

void PairSelector::leave_out() {
  left_out_ = vetoed_;
  leaves_out_ = veto_count_ > 0;
  if (!meant_ || all_vetoed()) return;
  const int take = meant_->take ? library_->find_take(*meant_->take) : -1;
  const auto is_meant = [&](int pair) {
    return (!meant_->take || static_cast<int>(library_->source(pair).take) == take) &&
           (!meant_->label || library_->label(pair) == *meant_->label);
  };
  bool leaves_any = false;
  for (const int pair : pairs_) {
    const auto at = static_cast<std::size_t>(pair);
    left_out_[at] = vetoed_[at] || !is_meant(pair);
    leaves_any = leaves_any || !left_out_[at];
  }
  leaves_out_ = leaves_any || veto_count_ > 0;
  if (!leaves_any) left_out_ = vetoed_;
}

int PairSelector::select(const SelectionQuery& query, std::vector<Candidate>& candidates) {
  candidates.clear();
  if (all_vetoed()) return -1;
  if (leaves_out_)
    index_->nearest_without(left_out_, query.features, query.neighbours, matches_);
  else
    index_->nearest(query.features, query.neighbours, matches_);
  for (const PoseMatch& match : matches_) {
    Candidate candidate;
    candidate.pair = match.pair;
    candidate.feature_distance = match.distance;
    candidates.push_back(candidate);
  }
  for (int n = 1; query.current_pair >= 0 && n <= query.continuations; ++n) {
    const int pair = library_->later_pair(query.current_pair, n * query.expected_advance);
    if (pair < 0 || !is_selectable(pair)) break;
    if (is_left_out(pair)) continue;
    if (std::any_of(candidates.begin(), candidates.end(), [&](const Candidate& c) { return c.pair == pair; }))
      continue;
    Candidate candidate;
    candidate.pair = pair;
    candidate.continuation = true;
    candidate.feature_distance = (library_->features(pair) - query.features).norm();
    candidates.push_back(candidate);
  }
  std::sort(candidates.begin(), candidates.end(), [](const Candidate& a, const Candidate& b) {
    return a.feature_distance != b.feature_distance ? a.feature_distance < b.feature_distance
                                                    : a.pair < b.pair;
  });
  int cheapest = -1;
  for (std::size_t c = 0; c < candidates.size(); ++c) {
    candidates[c].cost = pair_cost(query, library_->pose(candidates[c].pair),
                                   library_->pair_in_world(candidates[c].pair, query.root));
    if (cheapest < 0 || candidates[c].cost.total < candidates[static_cast<std::size_t>(cheapest)].cost.total)
      cheapest = static_cast<int>(c);
  }
  return cheapest;
}

CostBreakdown pair_cost(const SelectionQuery& query, const PairPose& normalized_pair,
                        const PairPose& world_pair) {
  CostBreakdown cost;
  cost.pose = (query.normalized - normalized_pair.topRows<joint_count>()).squaredNorm();
  if (query.has_prediction) {
    cost.temporal_active = (query.predicted - world_pair).topRows<joint_count>().squaredNorm();
    cost.temporal_passive = (query.predicted - world_pair).bottomRows<joint_count>().squaredNorm();
    cost.total = cost.pose + query.alpha * (cost.temporal_active + cost.temporal_passive);
  } else {
    cost.total = cost.pose;
  }
  return cost;
}

}  // namespace abrazo
