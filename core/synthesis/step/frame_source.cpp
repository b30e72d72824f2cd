// The part of FramePipeline that chooses the recorded pair of a frame and follows it from one to the next.

#include <algorithm>
#include <cmath>

#include "core/synthesis/step/frame_pipeline.hpp"

namespace abrazo {

namespace {

constexpr double same_motion_s = 0.3;  ///< a pair of the source this near to its time is the source

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
  if (next_.frames_since_reset < 2 || next_.previous_dt_s <= 0) return next_.previous;
  return next_.previous + (dt_s / next_.previous_dt_s) * (next_.previous - next_.before_previous);
}

SelectionQuery FramePipeline::query_of(double dt_s) const {
  SelectionQuery query;
  query.normalized = out_.query_normalized;
  query.root = out_.query_root;
  query.features = out_.features;
  query.has_prediction = next_.frames_since_reset > 0;
  query.predicted = predicted(dt_s);
  query.alpha = settings_.alpha;
  query.neighbours = settings_.neighbours;
  query.current_pair = next_.current_pair;
  query.continuations = settings_.continuations;
  if (plays()) {
    query.playhead = expected_playhead(dt_s);
    query.since_change_s = next_.motion.since_change_s;
    for (std::size_t p = 0; p < query.held.size(); ++p)
      query.held[p] = settings_.hold_weight > 0 && next_.motion.holds.pairs()[p].ramp > 0.5;
    for (std::size_t f = 0; f < query.planted.size(); ++f)
      query.planted[f] = settings_.foot_locks && next_.motion.plants.feet()[f].planted;
  }
  query.partner_speed = partner_speed();
  if (next_.current_pair >= 0)
    query.expected_advance = expected_advance(library_->take_of(next_.current_pair), dt_s);
  return query;
}

/// Of the partner that is shown, about its root [m/s].
Pose FramePipeline::partner_speed() const {
  if (next_.frames_since_reset < 2 || next_.previous_dt_s <= 0) return Pose::Zero();
  Pose speed = (next_.previous - next_.before_previous).bottomRows<joint_count>() / next_.previous_dt_s;
  speed.rowwise() -= speed.row(0).eval();
  return speed;
}

/// Position of the source after this step, if it continues.
SourcePlayhead FramePipeline::expected_playhead(double dt_s) const {
  const SourcePlayhead& now = next_.motion.playhead;
  if (now.pair < 0) return {};
  return pinned_ ? now : moved(*library_, now, now.rate * dt_s);
}

bool FramePipeline::select(double dt_s) {
  const SelectionQuery query = query_of(dt_s);
  next_.history.add(out_.query_world, out_.query_root, dt_s);
  if (selects_by_intent())
    out_.selected = intent_->select(query, next_.history, selector_.pairs(), weights_of(settings_),
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
                                   *pinned_ != next_.current_pair);
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

/// Whether the selected pair continues the source of the previous frame, at any pace.
bool FramePipeline::continues_source(int pair, double dt_s) const {
  if (plays()) {
    const SourcePlayhead& now = next_.motion.playhead;
    if (now.pair < 0) return false;
    if (pinned_ && pair == *pinned_) return now.pair == pair && now.fraction == 0;
    const auto ahead = seconds_to(*library_, now, pair);
    return ahead && std::abs(*ahead) < same_motion_s;
  }
  if (next_.current_pair < 0) return false;
  const PairSource& now = library_->source(pair);
  const PairSource& before = library_->source(next_.current_pair);
  const int frames = static_cast<int>(now.frame) - static_cast<int>(before.frame);
  // From standing still to three times the expected pace it is still the same stretch of recorded motion.
  const int advance = expected_advance(library_->take_of(next_.current_pair), dt_s);
  const int most = std::max(3, 3 * advance * library_->take_of(pair).frame_stride);
  return now.take == before.take && now.swapped == before.swapped && frames >= 0 && frames <= most;
}

/// Detects that the selected pair does not continue the source.
void FramePipeline::follow_source(double dt_s) {
  const int pair = out_.candidates[static_cast<std::size_t>(out_.selected)].pair;
  out_.selected_pair = library_->pair_in_world(pair, out_.query_root);
  const bool has_source = next_.current_pair >= 0 || next_.frames_since_reset > 0;
  out_.source_changed = has_source && !continues_source(pair, dt_s);
  next_.current_pair = pair;
}

std::optional<ShownPartner> FramePipeline::shown_partner(double dt_s) const {
  if (!next_.partner_is_shown) return std::nullopt;
  ShownPartner shown;
  shown.before = next_.previous.bottomRows<joint_count>();
  shown.pose = predicted(dt_s).bottomRows<joint_count>();
  const bool has_speed = next_.frames_since_reset >= 2 && next_.previous_dt_s > 0;
  shown.before_s = has_speed ? dt_s : 0;
  return shown;
}

/// Moves the partner on, by the selected pair.
bool FramePipeline::move(double dt_s) {
  const bool is_pinned = pinned_ && *pinned_ == next_.current_pair;
  MotionStep step{.library = *library_,
                  .settings = settings_,
                  .user = out_.query_world,
                  .user_root = out_.query_root,
                  .elapsed_s = dt_s,
                  .chosen = next_.current_pair,
                  .changes = out_.source_changed,
                  .stands = is_pinned,
                  .lead_s = out_.intent.lead_s,
                  .shown = shown_partner(dt_s)};
  if (!is_pinned) step.partner_place = out_.intent.partner_place;
  if (!out_.intent.model && !step.changes && next_.motion.playhead.pair >= 0)
    step.lead_s = seconds_to(*library_, expected_playhead(dt_s), step.chosen).value_or(0);
  PartnerMover mover(next_.motion, step);
  PairPose moved = mover.move();
  const EditTask parting = parting_task(moved);
  if (settings_.collisions && editor_.presses(parting)) {
    FootLocks none;
    if (!editor_.edit(parting, settings_, none).solved) return false;
    moved = editor_.result();
  }
  partner_ = mover.adapt(moved.bottomRows<joint_count>());
  next_.motion.holds.list(partner_, out_.query_world, out_.query_root, out_.holds);
  return true;
}

}  // namespace abrazo
