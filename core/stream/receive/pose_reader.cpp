#include "core/stream/receive/pose_reader.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace abrazo {

namespace {

constexpr double silent_s = 1;        ///< a performer that a new one may replace
constexpr double look_again_s = 0.1;  ///< when nothing is known to come
constexpr double rates_alike = 1.1;   ///< a rate so little above the wanted one is not thinned
constexpr double smallest_step_s = 1e-4;

constexpr double together_s = 1;      ///< two that begin within it: which is the user is not known
constexpr double clearly_faster = 2;  ///< of two rates

/// One that began together with the followed performer and sends clearly more poses, looked at once both have
/// been there for half of that time.
PerformerStream* faster_beginner(StreamPipeline& pipeline, const PerformerStream& followed, double now_s) {
  for (const auto& other : pipeline.streams()) {
    const double later_s = std::max(other->first_seen_s(), followed.first_seen_s());
    const double apart_s = std::abs(other->first_seen_s() - followed.first_seen_s());
    const double both_for_s = now_s - later_s;
    if (apart_s <= together_s && both_for_s >= together_s / 2 && both_for_s <= 2 * together_s &&
        other->last_pose_s() >= 0 && now_s - other->last_pose_s() <= silent_s &&
        other->rate_hz(now_s) >= clearly_faster * followed.rate_hz(now_s))
      return other.get();
  }
  return nullptr;
}

}  // namespace

/// Of VMC, where a performer is a sender: anyone may send, and nothing but the choice of a person tells whom
/// to follow. The skeletons of the other protocols come from one sender.
void PoseReader::note_undecided(StreamPipeline& pipeline, const PerformerStream* followed,
                                double now_s) const {
  std::vector<std::string> together;
  if (wanted_.empty() && followed && pipeline.uri().scheme == StreamUri::Scheme::Vmc)
    for (const auto& other : pipeline.streams())
      if (std::abs(other->first_seen_s() - followed->first_seen_s()) <= together_s &&
          other->last_pose_s() >= 0 && now_s - other->last_pose_s() <= silent_s)
        together.push_back(other->name());
  if (together.size() < 2) together.clear();
  pipeline.note_undecided(std::move(together));
}

PerformerStream* PoseReader::follow(StreamPipeline& pipeline, double now_s) {
  PerformerStream* const current = followed_.empty() ? nullptr : pipeline.find(followed_);
  PerformerStream* chosen = current;
  bool is_faster = false;
  if (!wanted_.empty()) {
    chosen = pipeline.find(wanted_);
  } else if (!current || now_s - current->last_frame_s() > silent_s) {
    for (const auto& stream : pipeline.streams()) {
      const bool is_newcomer = !current || stream->first_seen_s() > current->last_frame_s();
      if (is_newcomer && stream->last_pose_s() >= 0 && now_s - stream->last_pose_s() <= silent_s) {
        chosen = stream.get();
        break;
      }
    }
  } else if (PerformerStream* const faster = faster_beginner(pipeline, *current, now_s)) {
    chosen = faster;
    is_faster = true;
  }
  if (chosen && (chosen->name() != followed_ || chosen->first_seen_s() != followed_since_s_)) {
    if (wanted_.empty() && !followed_.empty() && chosen->name() != followed_)
      pipeline.note_sender_change(
          chosen->name() + " is followed now, since " +
              (is_faster ? "it sends more poses than " + followed_ + ", which began with it"
                         : followed_ + " stopped sending poses") +
              "; name the performer to follow only that one",
          now_s);
    followed_ = chosen->name();
    if (wanted_.empty()) pipeline.note_followed(followed_);
    followed_since_s_ = chosen->first_seen_s();
    cursor_ = chosen->buffer().now(now_s);
    break_pending_ = true;
  }
  note_undecided(pipeline, chosen, now_s);
  return chosen;
}

bool PoseReader::is_wanted(double time_s, double rate_hz) {
  if (max_rate_hz_ <= 0 || rate_hz <= rates_alike * max_rate_hz_) {
    next_slot_s_ = time_s;
    return true;
  }
  const double slot_s = 1 / max_rate_hz_;
  if (time_s < next_slot_s_ - 0.5 / rate_hz && next_slot_s_ - time_s <= slot_s) return false;
  next_slot_s_ += slot_s;
  if (next_slot_s_ < time_s || next_slot_s_ > time_s + 2 * slot_s) next_slot_s_ = time_s + slot_s;
  return true;
}

std::optional<SourcePose> PoseReader::poll(StreamPipeline& pipeline, double now_s) {
  last_poll_s_ = now_s;
  PerformerStream* const stream = follow(pipeline, now_s);
  if (!stream) return std::nullopt;
  const double rate = stream->rate_hz(now_s);
  std::optional<SourcePose> newest;
  std::uint64_t passed = 0;
  bool wanted = false;
  while (const auto due = stream->buffer().due_after(cursor_, now_s)) {
    passed += due->number - cursor_.next + 1;
    cursor_.next = due->number + 1;
    break_pending_ = break_pending_ || due->entry->pose.discontinuous;
    newest = due->entry->pose;
    newest->time_s = due->entry->sent_s + stream->buffer().delay_s();
    wanted = is_wanted(newest->time_s, rate) || wanted;
  }
  const std::uint64_t left_out = wanted ? passed - 1 : passed;
  dropped_ += left_out;
  stream->count_dropped(left_out);
  if (!wanted) return std::nullopt;
  // Clocks may be corrected backwards by a little; what comes later is later.
  const double least_step = rate > 0 ? 0.25 / rate : smallest_step_s;
  if (started_) newest->time_s = std::max(newest->time_s, last_time_s_ + least_step);
  started_ = true;
  last_time_s_ = newest->time_s;
  newest->discontinuous = std::exchange(break_pending_, false);
  newest->dropped = dropped_;
  return newest;
}

double PoseReader::next_due_s(StreamPipeline& pipeline) const {
  PerformerStream* const stream = followed_.empty() ? nullptr : pipeline.find(followed_);
  if (stream)
    if (const auto due = stream->buffer().next_due_s(cursor_)) return *due;
  return last_poll_s_ + look_again_s;
}

double PoseReader::rate_hz(StreamPipeline& pipeline) const {
  PerformerStream* const stream = followed_.empty() ? nullptr : pipeline.find(followed_);
  const double rate = stream ? stream->rate_hz(last_poll_s_) : 0;
  return max_rate_hz_ > 0 ? std::min(rate, max_rate_hz_) : rate;
}

}  // namespace abrazo
