#include "core/selection/intent_selector.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "core/mesh/capsules.hpp"
#include "core/motion/body/joint_set.hpp"
#include "core/selection/recorded_motion.hpp"

namespace abrazo {

namespace {

constexpr float never = std::numeric_limits<float>::infinity();
constexpr float belief_width_m = 0.03F;  ///< so much worse is believed in e times less
constexpr double most_pace = 3;          ///< largest pace at which a source is continued
constexpr int judged_paces = 6;          ///< of them
constexpr double speed_counts_s = 0.1;   ///< a difference in speed, as one of place
// A source that was just changed to is only left for a much better one.
constexpr double hurry_factor = 5;
constexpr double hurry_s = 0.4;
// The way of a hand to a hold, a hold that would be lost and a standing foot that would be lifted count as
// this much of mean joint distance.
constexpr double per_hand_way = 0.5, farthest_hand_way_m = 1, lost_hold_m = 0.25;
constexpr double lifted_foot_m = 0.05, lifted_height_m = 0.1;
constexpr double holds_within_s = 0.2;
constexpr int hold_looks = 3;
constexpr int most_looked_at = 60;
constexpr double least_ahead_s = 0.5;  ///< a pair that is changed to has so much of its take ahead
constexpr double looks_back_s = 0.4, looks_ahead_s = 0.6;  ///< for where the user is in the source
constexpr double lead_width_m = 0.01;                      ///< so much worse counts e times less
// Scales of the mean place: belief, range and similarity.
constexpr float place_width_m = 0.03F, place_widths = 4;
constexpr double like_place_m = 0.3, like_turn = 0.6;
constexpr double same_moment_s = 0.3;  ///< pairs of a take that are this near are one proposal

bool is_same_moment(const MotionLibrary& library, int a, int b) {
  const PairSource& one = library.source(a);
  const PairSource& other = library.source(b);
  return one.take == other.take && one.swapped == other.swapped &&
         std::abs(static_cast<double>(one.frame) - static_cast<double>(other.frame)) <
             same_moment_s * library.take_of(a).fps;
}

void sum_up(IntentCost& cost) {
  cost.total = cost.partner + cost.leader + cost.move + cost.meant + cost.change + cost.temporal;
}

/// Mean over the joints of how far a recorded partner is from the shown one and, with `speed_counts_s`, of
/// how differently it moves about its root [m].
double temporal_distance(const MotionLibrary& library, int pair, const SelectionQuery& query) {
  const auto partner_of = [&](int at) -> Pose {
    return library.pair_in_world(at, query.root).bottomRows<joint_count>();
  };
  const Pose partner = partner_of(pair);
  const double apart = (partner - query.predicted.bottomRows<joint_count>()).rowwise().norm().mean();
  const int next = library.later_pair(pair, 1);
  if (next < 0) return apart;
  const RootFrame &root = library.root(pair), &root_next = library.root(next);
  // Both where the first is, so that what the leader does meanwhile is in the partner's speed.
  RootFrame placed = query.root;
  placed.heading_rad += root_next.heading_rad - root.heading_rad;
  Pose speed = library.pair_in_world(next, placed).bottomRows<joint_count>() - partner;
  speed.rowwise() -= speed.row(0).eval();
  speed *= pair_rate(library, pair);
  return apart + speed_counts_s * (speed - query.partner_speed).rowwise().norm().mean();
}

/// Partner's hand from the user's where they next hold one another in the recording, if they do within
/// `holds_within_s`.
std::optional<Vec3> next_hold(const MotionLibrary& library, int pair, int user_hand, int partner_hand) {
  for (int look = 0; look <= hold_looks; ++look) {
    const double ahead_s = look * holds_within_s / hold_looks;
    const int due =
        library.later_pair(pair, static_cast<int>(std::lround(ahead_s * pair_rate(library, pair))));
    if (due < 0) break;
    const Vec3 apart = library.pose(due).row(partner_hand + joint_count) - library.pose(due).row(user_hand);
    if (apart.norm() < hold_distance_m) return apart;
  }
  return std::nullopt;
}

/// Motion of the shown partner's hands and feet required by this pair: the distance to its held hands, lost
/// holds, and standing feet that it has in the air [m].
double contact_distance(const MotionLibrary& library, int pair, const SelectionQuery& query) {
  constexpr std::array hands = {joints::left_hand, joints::right_hand};
  constexpr std::array toe_bases = {joints::left_toe_base, joints::right_toe_base};
  const Eigen::Matrix3d heading = query.root.rotation();
  double sum = 0;
  for (std::size_t p = 0; p < query.held.size(); ++p) {
    const int user_hand = hands[p / 2], partner_hand = hands[p % 2];
    if (const auto offset = next_hold(library, pair, user_hand, partner_hand)) {
      const Vec3 target = query.root.position + heading * (Vec3(query.normalized.row(user_hand)) + *offset);
      const Vec3 shown = query.predicted.row(partner_hand + joint_count);
      sum += per_hand_way * std::min(farthest_hand_way_m, (target - shown).norm());
    } else if (query.held[p]) {
      sum += lost_hold_m;
    }
  }
  for (std::size_t f = 0; f < query.planted.size(); ++f) {
    if (!query.planted[f]) continue;
    const double height = library.root(pair).position.y() + library.pose(pair)(toe_bases[f] + joint_count, 1);
    const double over_rest = height - library.passive_body(pair).body.toe_rest_height;
    sum += lifted_foot_m * std::clamp(over_rest / lifted_height_m, 0.0, 1.0);
  }
  return sum;
}

}  // namespace

IntentSelector::IntentSelector(std::shared_ptr<const IntentModel> model)
    : model_(std::move(model)),
      reading_(model_->make_reading()),
      totals_(model_->landings().size()),
      best_(model_->blocks().size()) {}

/// The leader kernel is computed only where it can decide: a landing that is worse than the best without it
/// gets the kernel of the best, and stays worse.
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
                           (selectable.is_not_intended(pair) ? static_cast<float>(weights.meant) : 0.0F);
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
  cost.meant = selectable.is_not_intended(pair) ? weights.meant : 0.0;
  if (query.has_prediction && query.alpha > 0)
    cost.temporal =
        query.alpha * (temporal_distance(library, pair, query) + contact_distance(library, pair, query));
  if (is_change && query.current_pair >= 0)
    cost.change = weights.switch_margin * (1 + hurry_factor * std::exp(-query.since_change_s / hurry_s));
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
  const auto looked_at =
      std::min(best_.size(), std::max(wanted, std::min<std::size_t>(3 * wanted, most_looked_at)));
  const auto end = best_.begin() + static_cast<std::ptrdiff_t>(looked_at);
  if (end != best_.end()) std::nth_element(best_.begin(), end, best_.end(), better);
  std::sort(best_.begin(), end, better);
  for (auto at = best_.begin(); at != end && *at >= 0; ++at) {
    const auto landing = static_cast<std::size_t>(*at);
    const int pair = model_->landings()[landing];
    if (query.playhead.pair >= 0 &&
        recorded_ahead(*model_->library(), {pair, 0, 1}, least_ahead_s) < least_ahead_s)
      continue;
    if (std::any_of(candidates.begin(), candidates.end(), [&](const Candidate& listed) {
          return is_same_moment(*model_->library(), listed.pair, pair);
        }))
      continue;
    const IntentModel::PairReading read{reading_.partner_m[landing], model_->leader_kernel(landing, reading_),
                                        model_->label_of_landing(landing)};
    candidates.push_back(priced(pair, read, query, selectable, weights, true));
  }
  if (candidates.size() <= wanted) return;
  std::nth_element(candidates.begin(), candidates.begin() + static_cast<std::ptrdiff_t>(wanted),
                   candidates.end(), [](const Candidate& a, const Candidate& b) {
                     return a.intent->total != b.intent->total ? a.intent->total < b.intent->total
                                                               : a.pair < b.pair;
                   });
  candidates.resize(wanted);
}

/// The mean over the believed pairs of where their partners are, those like `like` foremost: one pair's own
/// place is off by more.
RootFrame IntentSelector::place(int like) const {
  const RootFrame near = partner_place(*model_->library(), like);
  const float least = *std::min_element(totals_.begin(), totals_.end());
  Vec3 apart_sum = Vec3::Zero();
  double turn_sum = 0, weights = 1;  // its own
  for (std::size_t l = 0; l < totals_.size(); ++l) {
    const float off = totals_[l] - least;
    if (!(off < place_widths * place_width_m)) continue;
    const RootFrame& there = model_->place_of_landing(l);
    const Vec3 apart = there.position - near.position;
    const double turn = within_half_turn(there.heading_rad - near.heading_rad);
    const double likeness =
        apart.squaredNorm() / (like_place_m * like_place_m) + turn * turn / (like_turn * like_turn);
    const double weight = std::exp(-static_cast<double>(off / place_width_m) - 0.5 * likeness);
    apart_sum += weight * apart;
    turn_sum += weight * turn;
    weights += weight;
  }
  return {near.position + apart_sum / weights, within_half_turn(near.heading_rad + turn_sum / weights)};
}

/// The mean of the source's moments around the playhead, by how well each fits the user.
double IntentSelector::lead(const SelectionQuery& query, const IntentWeights& weights) const {
  const MotionLibrary& library = *model_->library();
  const std::vector<int>& landings = model_->landings();
  const int now = query.playhead.pair;
  const double rate = pair_rate(library, now);
  const int first = now - static_cast<int>(looks_back_s * rate);
  const int last = now + static_cast<int>(looks_ahead_s * rate);
  double sum = 0, share_sum = 0;
  std::optional<float> least;
  for (const bool weighs : {false, true})
    for (auto at = std::lower_bound(landings.begin(), landings.end(), first);
         at != landings.end() && *at <= last; ++at) {
      const auto seconds = seconds_to(library, query.playhead, *at);
      if (!seconds) continue;
      const auto l = static_cast<std::size_t>(at - landings.begin());
      const float cost = reading_.partner_m[l] +
                         static_cast<float>(weights.leader) * (1 - model_->leader_kernel(l, reading_)) +
                         static_cast<float>(weights.move) *
                             (1 - reading_.moves[static_cast<std::size_t>(model_->label_of_landing(l))]);
      if (!std::isfinite(cost)) continue;
      if (!weighs) {
        least = std::min(least.value_or(cost), cost);
        continue;
      }
      const double share = std::exp(-static_cast<double>(cost - *least) / lead_width_m);
      sum += share * *seconds;
      share_sum += share;
    }
  return share_sum > 0 ? sum / share_sum : 0;
}

/// The current source at the pace that fits best, from standing still to three times its own.
int IntentSelector::list_continuation(const SelectionQuery& query, const SelectablePairs& selectable,
                                      const IntentWeights& weights, std::vector<Candidate>& candidates) {
  const MotionLibrary& library = *model_->library();
  int judged = -1;
  std::optional<Candidate> best;
  const bool plays = query.playhead.pair >= 0;
  for (int pace = 0; pace <= (plays ? 0 : judged_paces); ++pace) {
    const int ahead =
        plays ? nearest_pair(library, query.playhead) - query.current_pair
              : static_cast<int>(std::lround(pace * most_pace / judged_paces * query.expected_advance));
    if (ahead == judged) continue;
    judged = ahead;
    const int pair = library.later_pair(query.current_pair, ahead);
    if (pair < 0) break;
    if (!selectable.is_selectable(pair) || selectable.is_vetoed(pair)) continue;
    const Candidate on = candidate(pair, query, selectable, weights, false);
    if (!best || on.intent->total < best->intent->total) best = on;
  }
  // At the end of a take there is no continuation: standing still does not count.
  if (!best || library.later_pair(plays ? best->pair : query.current_pair, 1) < 0) return -1;
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
  if (query.playhead.pair >= 0) intent.lead_s = lead(query, weights);
  if (query.current_pair >= 0) intent.continued = list_continuation(query, selectable, weights, candidates);
  std::sort(candidates.begin(), candidates.end(), [](const Candidate& a, const Candidate& b) {
    return a.feature_distance != b.feature_distance ? a.feature_distance < b.feature_distance
                                                    : a.pair < b.pair;
  });
  const auto best = std::min_element(
      candidates.begin(), candidates.end(),
      [](const Candidate& a, const Candidate& b) { return a.intent->total < b.intent->total; });
  if (best == candidates.end()) return -1;
  if (query.playhead.pair >= 0) intent.partner_place = place(best->pair);
  return static_cast<int>(best - candidates.begin());
}

void reserve_room(FrameIntent& intent, const IntentModel& model) {
  intent.belief.reserve(model.blocks().size());
  intent.moves.reserve(model.labels().size());
}

}  // namespace abrazo
