// The part of FramePipeline that chooses the recorded pair of a frame and follows it from one to the next.

#include <algorithm>
#include <cmath>

#include "core/mesh/capsules.hpp"
#include "core/synthesis/frame_pipeline.hpp"

namespace abrazo {

namespace {

constexpr double hold_hurry = 4.0;

IntentWeights weights_of(const Settings& settings) {
  return {settings.switch_margin, settings.leader_weight, settings.move_weight, settings.meant_weight};
}

/// Whole frames of the library that fit into a step, at least one.
int expected_advance(const LibraryTake& take, double dt_s) {
  return std::max(1, static_cast<int>(std::lround(dt_s * take.fps / take.frame_stride)));
}

}  // namespace

/// Eq. 3-4, with the velocity over the time that passed.
PairPose FramePipeline::predicted(double dt_s) const {
  if (memory_.frames_since_reset < 2 || memory_.previous_dt_s <= 0) return memory_.previous;
  return memory_.previous + (dt_s / memory_.previous_dt_s) * (memory_.previous - memory_.before_previous);
}

SelectionQuery FramePipeline::query_of(double dt_s) const {
  SelectionQuery query;
  query.normalized = out_.query_normalized;
  query.root = out_.query_root;
  query.features = out_.features;
  query.has_prediction = memory_.frames_since_reset > 0;
  query.predicted = predicted(dt_s);
  query.alpha = settings_.alpha;
  query.neighbours = settings_.neighbours;
  query.current_pair = memory_.current_pair;
  query.continuations = settings_.continuations;
  if (memory_.current_pair >= 0)
    query.expected_advance = expected_advance(library_->take_of(memory_.current_pair), dt_s);
  return query;
}

bool FramePipeline::select(double dt_s) {
  const SelectionQuery query = query_of(dt_s);
  history_ = memory_.history;
  history_.add(out_.query_world, out_.query_root, dt_s);
  if (selects_by_intent())
    out_.selected = intent_->select(query, history_, selector_.pairs(), weights_of(settings_),
                                    out_.candidates, out_.intent);
  // All that may be selected can lie between the pairs that may be changed to.
  if (out_.selected < 0) {
    out_.intent.model.reset();
    out_.selected = selector_.select(query, out_.candidates);
  }
  if (pinned_ && *pinned_ >= 0 && *pinned_ < library_->pair_count() &&
      selector_.pairs().is_selectable(*pinned_))
    select_pinned(query);
  return out_.selected >= 0;
}

void FramePipeline::select_pinned(const SelectionQuery& query) {
  const auto at = std::find_if(out_.candidates.begin(), out_.candidates.end(),
                               [&](const Candidate& c) { return c.pair == *pinned_; });
  if (at != out_.candidates.end()) {
    out_.selected = static_cast<int>(at - out_.candidates.begin());
    return;
  }
  Candidate candidate;
  if (selects_by_intent()) {
    candidate = intent_->candidate(*pinned_, query, selector_.pairs(), weights_of(settings_),
                                   *pinned_ != memory_.current_pair);
  } else {
    candidate.pair = *pinned_;
    candidate.feature_distance = (library_->features(*pinned_) - out_.features).norm();
    candidate.cost =
        pair_cost(query, library_->pose(*pinned_), library_->pair_in_world(*pinned_, out_.query_root));
  }
  const auto place = std::upper_bound(
      out_.candidates.begin(), out_.candidates.end(), candidate,
      [](const Candidate& a, const Candidate& b) { return a.feature_distance < b.feature_distance; });
  out_.selected = static_cast<int>(place - out_.candidates.begin());  // insert may move them all
  out_.candidates.insert(place, candidate);
}

/// Velocity of the recorded partner relative to the user's root [m/s].
Pose FramePipeline::partner_velocity(int pair) const {
  const int next = library_->later_pair(pair, 1);
  if (next < 0) return Pose::Zero();
  const LibraryTake& take = library_->take_of(pair);
  const double dt = take.frame_stride / take.fps;
  return (library_->pair_in_world(next, out_.query_root) - library_->pair_in_world(pair, out_.query_root))
             .bottomRows<joint_count>() /
         dt;
}

/// The partner's arms that hold a hand in the selected pair get there sooner than the body.
std::array<double, joint_count> FramePipeline::hurry_of_holds() const {
  std::array<double, joint_count> hurry{};
  hurry.fill(1.0);
  for (const int hand : {joints::left_hand, joints::right_hand}) {
    const auto passive_hand = out_.selected_pair.row(hand + joint_count);
    const bool holds = (out_.selected_pair.row(joints::left_hand) - passive_hand).norm() < hold_distance_m ||
                       (out_.selected_pair.row(joints::right_hand) - passive_hand).norm() < hold_distance_m;
    if (!holds) continue;
    const auto arm = static_cast<std::size_t>(hand);
    hurry[arm] = hurry[arm - 1] = hold_hurry;
    hurry[arm - 2] = 0.5 * hold_hurry;
  }
  return hurry;
}

/// Notices when the selected pair does not continue the previous one, and lets the partner glide over.
void FramePipeline::follow_source(double dt_s) {
  const int pair = out_.candidates[static_cast<std::size_t>(out_.selected)].pair;
  out_.selected_pair = library_->pair_in_world(pair, out_.query_root);
  memory_.transition.fade(dt_s, settings_.transition_half_life_s, hurry_of_holds());
  out_.source_changed = false;
  if (memory_.current_pair >= 0)
    glide_from_continued(pair, dt_s);
  else if (memory_.frames_since_reset > 0)
    glide_from_prediction(pair, dt_s);
  memory_.current_pair = pair;
}

void FramePipeline::glide_from_continued(int pair, double dt_s) {
  const int advance = expected_advance(library_->take_of(memory_.current_pair), dt_s);
  const PairSource& now = library_->source(pair);
  const PairSource& before = library_->source(memory_.current_pair);
  const int frames = static_cast<int>(now.frame) - static_cast<int>(before.frame);
  // From standing still to three times the expected pace it is still the same stretch of recorded motion.
  const int most = std::max(3, 3 * advance * library_->take_of(pair).frame_stride);
  out_.source_changed =
      now.take != before.take || now.swapped != before.swapped || frames < 0 || frames > most;
  const int continued = library_->later_pair(memory_.current_pair, advance);
  if (settings_.transition_half_life_s <= 0 || pair == continued) return;
  const Pose chosen = out_.selected_pair.bottomRows<joint_count>();
  const int from = continued >= 0 ? continued : memory_.current_pair;
  const Pose would_be = library_->pair_in_world(from, out_.query_root).bottomRows<joint_count>();
  memory_.transition.jump(would_be, partner_velocity(from), chosen, partner_velocity(pair));
}

/// The partner goes on without a recorded pair that did: from where its own motion would have taken it.
void FramePipeline::glide_from_prediction(int pair, double dt_s) {
  out_.source_changed = true;
  if (settings_.transition_half_life_s <= 0) return;
  Pose velocity = Pose::Zero();
  if (memory_.frames_since_reset >= 2 && memory_.previous_dt_s > 0)
    velocity = (memory_.previous - memory_.before_previous).bottomRows<joint_count>() / memory_.previous_dt_s;
  memory_.transition.reset();  // what was left of it is in the prediction
  memory_.transition.jump(predicted(dt_s).bottomRows<joint_count>(), velocity,
                          out_.selected_pair.bottomRows<joint_count>(), partner_velocity(pair));
}

}  // namespace abrazo
