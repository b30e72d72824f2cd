#include "core/selection/intent_selector.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace abrazo {

namespace {

constexpr float never = std::numeric_limits<float>::infinity();
constexpr float belief_width_m = 0.03F;  ///< so much worse is believed in e times less
constexpr double most_pace = 3;          ///< a source is gone on with at up to so many times its pace
constexpr int judged_paces = 6;          ///< of them
constexpr double same_moment_s = 0.3;    ///< pairs of a take that are this near are one proposal

bool is_same_moment(const MotionLibrary& library, int a, int b) {
  const PairSource& one = library.source(a);
  const PairSource& other = library.source(b);
  return one.take == other.take && one.swapped == other.swapped &&
         std::abs(static_cast<double>(one.frame) - static_cast<double>(other.frame)) <
             same_moment_s * library.take_of(a).fps;
}

void sum_up(IntentCost& cost) {
  cost.total = cost.partner + cost.leader + cost.move + cost.meant + cost.change;
}

}  // namespace

IntentSelector::IntentSelector(std::shared_ptr<const IntentModel> model)
    : model_(std::move(model)),
      reading_(model_->make_reading()),
      totals_(model_->landings().size()),
      best_(model_->blocks().size()) {}

/// The kernel of two motions is asked for only where it can decide: a landing that is worse than the best
/// without it gets that of the best, and stays worse.
void IntentSelector::judge_landings(const SelectablePairs& selectable, const IntentWeights& weights) {
  const std::vector<int>& landings = model_->landings();
  std::size_t first = 0;
  for (std::size_t l = 0; l < landings.size(); ++l) {
    const int pair = landings[l];
    const auto label = static_cast<std::size_t>(model_->label_of_landing(l));
    totals_[l] = selectable.is_vetoed(pair)
                     ? never
                     : reading_.partner_m[l] +
                           static_cast<float>(weights.move) * (1 - reading_.moves[label]) +
                           (selectable.is_not_meant(pair) ? static_cast<float>(weights.meant) : 0.0F);
    if (!std::isfinite(totals_[l])) totals_[l] = never;  // a user too far off for a float
    if (totals_[l] < totals_[first]) first = l;
  }
  std::fill(best_.begin(), best_.end(), -1);
  if (totals_[first] == never) return;
  const auto leader = [&](std::size_t l) {
    return static_cast<float>(weights.leader) * (1 - model_->leader_kernel(l, reading_));
  };
  float least_leader = leader(first);
  float best = totals_[first] + least_leader;
  for (std::size_t l = 0; l < landings.size(); ++l) {
    if (totals_[l] > best) {
      totals_[l] += least_leader;
      continue;
    }
    const float of_this = leader(l);
    totals_[l] += of_this;
    if (totals_[l] >= best) continue;
    best = totals_[l];
    least_leader = of_this;
  }
  for (std::size_t l = 0; l < landings.size(); ++l) {
    int& of_block = best_[static_cast<std::size_t>(model_->block_of_landing(l))];
    if (totals_[l] != never && (of_block < 0 || totals_[l] < totals_[static_cast<std::size_t>(of_block)]))
      of_block = static_cast<int>(l);
  }
}

Candidate IntentSelector::candidate(int pair, const SelectionQuery& query, const SelectablePairs& selectable,
                                    const IntentWeights& weights, bool is_change) {
  return priced(pair, model_->read_pair(pair, reading_), query, selectable, weights, is_change);
}

Candidate IntentSelector::priced(int pair, const IntentModel::PairReading& read, const SelectionQuery& query,
                                 const SelectablePairs& selectable, const IntentWeights& weights,
                                 bool is_change) const {
  const MotionLibrary& library = *model_->library();
  Candidate candidate;
  candidate.pair = pair;
  candidate.continuation = !is_change;
  candidate.feature_distance = (library.features(pair) - query.features).norm();
  candidate.cost = pair_cost(query, library.pose(pair), library.pair_in_world(pair, query.root));
  IntentCost& cost = candidate.intent.emplace();
  cost.partner = static_cast<double>(read.partner_m);
  cost.leader = weights.leader * (1 - static_cast<double>(read.leader_kernel));
  const double likely =
      read.label < 0 ? 0.0 : static_cast<double>(reading_.moves[static_cast<std::size_t>(read.label)]);
  cost.move = weights.move * (1 - likely);
  cost.meant = selectable.is_not_meant(pair) ? weights.meant : 0.0;
  cost.change = is_change && query.current_pair >= 0 ? weights.switch_margin : 0.0;
  sum_up(cost);
  return candidate;
}

void IntentSelector::list_landings(const SelectionQuery& query, const SelectablePairs& selectable,
                                   const IntentWeights& weights, std::vector<Candidate>& candidates) {
  const auto better = [&](int a, int b) {
    if (a < 0 || b < 0) return b < 0 && a >= 0;
    const float of_a = totals_[static_cast<std::size_t>(a)], of_b = totals_[static_cast<std::size_t>(b)];
    return of_a != of_b ? of_a < of_b : a < b;
  };
  // Two blocks can have their best where they meet, so that some more than are listed are looked at.
  const auto wanted = static_cast<std::size_t>(query.neighbours);
  const auto looked_at = std::min(best_.size(), 3 * wanted);
  const auto end = best_.begin() + static_cast<std::ptrdiff_t>(looked_at);
  if (end != best_.end()) std::nth_element(best_.begin(), end, best_.end(), better);
  std::sort(best_.begin(), end, better);
  for (auto at = best_.begin(); at != end && *at >= 0 && candidates.size() < wanted; ++at) {
    const auto landing = static_cast<std::size_t>(*at);
    const int pair = model_->landings()[landing];
    if (std::any_of(candidates.begin(), candidates.end(), [&](const Candidate& listed) {
          return is_same_moment(*model_->library(), listed.pair, pair);
        }))
      continue;
    const IntentModel::PairReading read{reading_.partner_m[landing], model_->leader_kernel(landing, reading_),
                                        model_->label_of_landing(landing)};
    candidates.push_back(priced(pair, read, query, selectable, weights, true));
  }
}

/// The current source at the pace that fits best, from standing still to three times its own.
int IntentSelector::list_continuation(const SelectionQuery& query, const SelectablePairs& selectable,
                                      const IntentWeights& weights, std::vector<Candidate>& candidates) {
  const MotionLibrary& library = *model_->library();
  int judged = -1;
  std::optional<Candidate> best;
  for (int pace = 0; pace <= judged_paces; ++pace) {
    const int ahead = static_cast<int>(std::lround(pace * most_pace / judged_paces * query.expected_advance));
    if (ahead == judged) continue;
    judged = ahead;
    const int pair = library.later_pair(query.current_pair, ahead);
    if (pair < 0) break;
    if (!selectable.is_selectable(pair) || selectable.is_vetoed(pair)) continue;
    const Candidate on = candidate(pair, query, selectable, weights, false);
    if (!best || on.intent->total < best->intent->total) best = on;
  }
  // At the end of a take there is nothing to go on with: standing still is not going on.
  if (!best || library.later_pair(query.current_pair, 1) < 0) return -1;
  std::erase_if(candidates,
                [&](const Candidate& listed) { return is_same_moment(library, listed.pair, best->pair); });
  candidates.push_back(*best);
  return best->pair;
}

void IntentSelector::believe(FrameIntent& intent) {
  float least = never;
  for (const int landing : best_)
    if (landing >= 0) least = std::min(least, totals_[static_cast<std::size_t>(landing)]);
  intent.belief.resize(best_.size());
  for (std::size_t b = 0; b < best_.size(); ++b) {
    const float off = best_[b] < 0 ? never : totals_[static_cast<std::size_t>(best_[b])] - least;
    intent.belief[b] = static_cast<std::uint8_t>(std::lround(255 * std::exp(-off / belief_width_m)));
  }
}

int IntentSelector::select(const SelectionQuery& query, const MotionHistory& history,
                           const SelectablePairs& selectable, const IntentWeights& weights,
                           std::vector<Candidate>& candidates, FrameIntent& intent) {
  candidates.clear();
  intent.model = model_;
  intent.continued = -1;
  model_->read(history, reading_);
  intent.moves.assign(reading_.moves.begin(), reading_.moves.end());
  judge_landings(selectable, weights);
  believe(intent);
  if (selectable.all_vetoed()) return -1;
  list_landings(query, selectable, weights, candidates);
  if (query.current_pair >= 0) intent.continued = list_continuation(query, selectable, weights, candidates);
  std::sort(candidates.begin(), candidates.end(), [](const Candidate& a, const Candidate& b) {
    return a.feature_distance != b.feature_distance ? a.feature_distance < b.feature_distance
                                                    : a.pair < b.pair;
  });
  const auto best = std::min_element(
      candidates.begin(), candidates.end(),
      [](const Candidate& a, const Candidate& b) { return a.intent->total < b.intent->total; });
  return best == candidates.end() ? -1 : static_cast<int>(best - candidates.begin());
}

void reserve_room(FrameIntent& intent, const IntentModel& model) {
  intent.belief.reserve(model.blocks().size());
  intent.moves.reserve(model.labels().size());
}

}  // namespace abrazo
