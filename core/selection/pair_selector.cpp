#include "core/selection/pair_selector.hpp"

#include <algorithm>

namespace abrazo {

namespace {

/// As many as can be set: a larger k does not allocate in the step where it is set.
constexpr std::size_t room_for_matches = 200;

}  // namespace

PairSelector::PairSelector(std::shared_ptr<const MotionLibrary> library, std::vector<int> pairs,
                           std::shared_ptr<const PoseIndex> index)
    : library_(library), pairs_(std::move(library), std::move(pairs)), index_(std::move(index)) {
  matches_.reserve(std::min(pairs_.pairs().size(), room_for_matches));
  if (!index_) index_ = std::make_shared<const PoseIndex>(pose_index_of(*library_, pairs_.pairs()));
}

int PairSelector::select(const SelectionQuery& query, std::vector<Candidate>& candidates) {
  candidates.clear();
  if (pairs_.all_vetoed()) return -1;
  if (pairs_.leaves_out())
    index_->nearest_without(pairs_.left_out(), query.features, query.neighbours, matches_);
  else
    index_->nearest(query.features, query.neighbours, matches_);
  for (const PoseMatch& match : matches_) {
    Candidate candidate;
    candidate.pair = match.pair;
    candidate.feature_distance = match.distance;
    candidates.push_back(candidate);
  }
  const bool plays = query.playhead.pair >= 0;
  for (int n = 1; query.current_pair >= 0 && n <= (plays ? 1 : query.continuations); ++n) {
    const int pair = plays ? nearest_pair(*library_, query.playhead)
                           : library_->later_pair(query.current_pair, n * query.expected_advance);
    if (pair < 0 || !pairs_.is_selectable(pair)) break;
    if (pairs_.is_left_out(pair)) continue;
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
