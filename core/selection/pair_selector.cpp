#include "core/selection/pair_selector.hpp"

#include <algorithm>

namespace abrazo {

namespace {

std::vector<bool> as_flags(const std::vector<int>& pairs, int count) {
  std::vector<bool> flags(static_cast<std::size_t>(count), false);
  for (const int pair : pairs) flags[static_cast<std::size_t>(pair)] = true;
  return flags;
}

bool is_vetoed_by(const Vetoes& vetoes, const MotionLibrary& library, int pair) {
  return vetoes.pairs.contains(pair) || vetoes.takes.contains(library.take_of(pair).name) ||
         vetoes.labels.contains(std::string(library.label(pair)));
}

}  // namespace

PairSelector::PairSelector(std::shared_ptr<const MotionLibrary> library, std::vector<int> pairs)
    : library_(std::move(library)),
      pairs_(std::move(pairs)),
      selectable_(as_flags(pairs_, library_->pair_count())),
      vetoed_(selectable_.size(), false),
      index_(library_->columns().features, pairs_) {}

void PairSelector::set_vetoes(const Vetoes& vetoes) {
  std::vector<bool> vetoed(selectable_.size(), false);
  std::vector<int> left;
  for (const int pair : pairs_) {
    const bool unwanted = is_vetoed_by(vetoes, *library_, pair);
    vetoed[static_cast<std::size_t>(pair)] = unwanted;
    if (!unwanted) left.push_back(pair);
  }
  if (vetoed == vetoed_) return;
  index_ = PoseIndex(library_->columns().features, left);
  vetoed_ = std::move(vetoed);
}

int PairSelector::select(const SelectionQuery& query, std::vector<Candidate>& candidates) {
  candidates.clear();
  index_.nearest(query.features, query.neighbours, matches_);
  for (const PoseMatch& match : matches_) {
    Candidate candidate;
    candidate.pair = match.pair;
    candidate.feature_distance = match.distance;
    candidates.push_back(candidate);
  }
  for (int n = 1; query.current_pair >= 0 && n <= query.continuations; ++n) {
    const int pair = library_->later_pair(query.current_pair, n * query.expected_advance);
    if (pair < 0 || !is_selectable(pair)) break;
    if (is_vetoed(pair)) continue;
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
