#include "core/session/run/live_loop.hpp"

#include <algorithm>
#include <cmath>
#include <exception>
#include <limits>
#include <stdexcept>
#include <utility>
#include <variant>

#include "core/stream/protocol/stream_health.hpp"
#include "core/synthesis/step/synthesizer_state.hpp"

namespace abrazo {

namespace {

constexpr double highest_rate_hz = 120;
constexpr double interval_smoothing = 0.1;
/// Solving up to a frame from the last kept state takes a few milliseconds; a state is as large as a frame.
constexpr std::uint64_t frames_between_states = 32;
constexpr double intervals_until_loss = 3;  ///< of a slow source
/// A source with a larger time difference to the session uses another clock.
constexpr double same_clock_s = 1;
constexpr double least_between_frames_s = 1e-6;
constexpr double look_whether_learned_s = 0.05;
constexpr std::uint64_t frames_after_seen = 8;

double wanted_rate(const Settings& settings) {
  return settings.step_rate_hz > 0 ? settings.step_rate_hz : highest_rate_hz;
}

bool same_body(const Body& a, const Body& b) {
  return a.bone_lengths == b.bone_lengths && a.pseudo_lengths == b.pseudo_lengths &&
         a.toe_rest_height == b.toe_rest_height;
}

/// Not another library: each label that is given to a take makes one, and would be half a second of frames.
bool changes_the_answer(const Command& command) {
  return std::visit(
      []<typename Wish>(const Wish&) {
        return std::is_same_v<Wish, SetSettings> || std::is_same_v<Wish, PinPair> ||
               std::is_same_v<Wish, SetVetoes> || std::is_same_v<Wish, IntendMove> ||
               std::is_same_v<Wish, SetRoleControl> || std::is_same_v<Wish, ResetSolver> ||
               std::is_same_v<Wish, SeekInput> || std::is_same_v<Wish, ReplaceSource>;
      },
      command);
}

/// Replaces a result from a damaged library file, which would be meaningless.
void hold(FrameSnapshot& snapshot, const FrameSnapshotPtr& last, const std::string& why) {
  snapshot.elapsed_s = -1;
  snapshot.before = nullptr;
  snapshot.result = last ? last->result : FrameResult{};
  snapshot.result.status = StepStatus::Failed;
  snapshot.result.message = why + "; the partner holds its last pose";
}

}  // namespace

LiveLoop::LiveLoop(std::shared_ptr<PartnerSynthesizer> synthesizer, std::shared_ptr<PoseSource> source,
                   CommandQueue& commands, FrameHistory& history, LatestSlot<FrameSnapshot>& latest,
                   std::function<double()> clock)
    : control_(std::move(synthesizer)),
      source_(std::move(source)),
      commands_(commands),
      history_(history),
      latest_(latest),
      clock_(std::move(clock)) {
  listen_to_source();
}

LiveLoop::~LiveLoop() {
  source_->on_arrival([] {});
}

void LiveLoop::listen_to_source() {
  source_->set_max_rate(wanted_rate(control_.synthesizer().settings()));
  source_->on_arrival([wake_up = wake_up()] { wake_up->notify(); });
  source_body_.reset();
  take_measures();
  if (source_->finite())
    begin_clip();
  else
    note_progress({});
}

void LiveLoop::take_measures() {
  const std::optional<Body> body = source_->body();
  if (!body || (source_body_ && same_body(*body, *source_body_))) return;
  source_body_ = body;
  control_.synthesizer().set_user_body(*body);
  state_due_ = next_index_;
}

/// One of several independent actions: a failure is reported at the end of the turn and does not prevent the
/// others.
template <typename Action>
void LiveLoop::attempt(const Action& action) {
  try {
    action();
  } catch (const std::exception& failure) {
    if (!trouble_.empty()) trouble_ += "; ";
    trouble_ += failure.what();
    state_due_ = next_index_;
  }
}

double LiveLoop::turn(double now_s) {
  if (waiting_since_s_ < 0) waiting_since_s_ = now_s;
  bool is_other_answer = false, is_other_library = false;
  for (const Command& command : commands_.drain()) {
    attempt([&] { apply(command, now_s); });
    state_due_ = next_index_;
    is_other_library = is_other_library || std::holds_alternative<ReplaceSynthesizer>(command);
    is_other_answer = is_other_answer || is_other_library || changes_the_answer(command);
  }
  if (source_->finite() && (control_.take_learned() || is_other_answer)) begin_clip_again(!is_other_library);
  if (rests(now_s)) {
    if (!trouble_.empty()) throw std::runtime_error(std::exchange(trouble_, {}));
    return output_.next_hold_s();
  }
  if (const auto input = source_->poll(now_s)) {
    waiting_since_s_ = now_s;
    is_lost_ = false;
    solve(*input, now_s);
  } else {
    wait_for_pose(now_s);
  }
  if (!trouble_.empty()) throw std::runtime_error(std::exchange(trouble_, {}));
  if (source_->is_over())
    return control_.is_learning() ? now_s + look_whether_learned_s : source_->next_due_s();
  const double attention_s = is_lost_ ? output_.next_hold_s() : waiting_since_s_ + loss_after_s();
  return std::min(source_->next_due_s(), attention_s);
}

void LiveLoop::solve(const SourcePose& input, double now_s) {
  PartnerSynthesizer& synthesizer = control_.synthesizer();
  take_measures();
  if (input.discontinuous) {
    synthesizer.reset();
    previous_time_s_ = -1;
    state_due_ = next_index_;
  }
  const bool is_of_clip = source_->finite() != nullptr;
  attempt([&] {
    if (control_.before_step(is_of_clip ? input.time_s : now_s)) state_due_ = next_index_;
  });
  const double elapsed = time_since_previous(input);
  if (is_first_of_source_) dropped_at_start_ = input.dropped;
  is_first_of_source_ = false;
  dropped_now_ = input.dropped - dropped_at_start_;
  continue_counting();
  auto snapshot = std::make_shared<FrameSnapshot>();
  snapshot->time_s = frame_time(input, now_s);
  snapshot->input_frame = input.frame;
  snapshot->user = input.pose;
  snapshot->settings = synthesizer.settings();
  snapshot->is_learning = control_.is_learning();
  snapshot->elapsed_s = elapsed > 0 ? elapsed : 0.0;  // not so for a time that is not a number
  snapshot->before = state_if_due();
  snapshot->decisions = control_.decisions();
  snapshot->library = synthesizer.shared_library();
  snapshot->input = input_;
  snapshot->input_rate_hz = smoothed_interval_s_ > 0 ? 1.0 / smoothed_interval_s_ : source_->rate_hz();
  snapshot->dropped_inputs = dropped_before_ + dropped_now_;
  snapshot->result = synthesizer.step(input.pose, Duration(snapshot->elapsed_s));
  if (!is_of_clip)
    snapshot->times = {.arrived_s = input.arrived_s,
                       .assembled_s = input.assembled_s,
                       .taken_s = now_s,
                       .solved_s = clock_ ? clock_() : now_s};
  const std::optional<Error> damage = snapshot->library->damage();
  if (damage) hold(*snapshot, latest_.newest(), damage->text());
  if (is_of_clip) {
    // Its frames are not solved at the times at which a receiver would show them.
  } else if (damage ? output_.hold(snapshot->time_s)
                    : output_.send(snapshot->result, snapshot->library, snapshot->settings,
                                   synthesizer.user_body(), snapshot->time_s)) {
    snapshot->times.sent_s = clock_ ? clock_() : now_s;
  }
  has_solved_ = true;
  const FrameResult& solved = snapshot->result;
  control_.after_step(solved, input.pose, snapshot->time_s);
  publish(std::move(snapshot));
  if (damage) state_due_ = next_index_;
}

/// @return 0 for the first pose [s]
double LiveLoop::time_since_previous(const SourcePose& input) {
  // Of a clip without the rounding of its times.
  const double since_s = source_->finite() ? 1 / source_->rate_hz() : input.time_s - previous_time_s_;
  const double elapsed = previous_time_s_ < 0 ? 0.0 : since_s;
  if (elapsed > 0 && elapsed < loss_after_s())
    smoothed_interval_s_ +=
        (smoothed_interval_s_ > 0 ? interval_smoothing : 1.0) * (elapsed - smoothed_interval_s_);
  previous_time_s_ = input.time_s;
  return elapsed;
}

/// Frames of a session ascend in time, whatever the source's clock does. While a source catches up on a
/// backlog its times are behind those that were given, so the frames get the times at which they are solved.
double LiveLoop::frame_time(const SourcePose& input, double now_s) const {
  if (source_->finite()) return input.time_s;
  const bool is_usable = std::abs(input.time_s - now_s) < same_clock_s && input.time_s > last_frame_s_;
  const double time_s = is_usable ? input.time_s : now_s;
  return last_frame_s_ < 0 ? time_s : std::max(time_s, last_frame_s_ + least_between_frames_s);
}

double LiveLoop::loss_after_s() const {
  const double rate_hz = source_->rate_hz();
  constexpr double tracking_loss_s = PartnerSynthesizer::tracking_loss_s;
  static_assert(default_performer_loss_s < tracking_loss_s, "a stream reports the loss first");
  return rate_hz > 0 ? std::max(tracking_loss_s, intervals_until_loss / rate_hz) : tracking_loss_s;
}

/// Whether a held input needs no solving. Its sinks still get the pose; the solver's time does not pass.
bool LiveLoop::rests(double now_s) {
  const bool rested = rests_since_s_ >= 0;
  if (is_held_ && has_solved_ && now_s >= settles_until_s_) {
    if (!rested) rests_since_s_ = now_s;
    output_.hold(now_s, true);
    return true;
  }
  if (rested && previous_time_s_ >= 0) previous_time_s_ += now_s - rests_since_s_;
  if (rested) waiting_since_s_ = now_s;
  rests_since_s_ = -1;
  return false;
}

/// After a while without a pose one frame reports it, and the sinks are informed until poses return.
void LiveLoop::wait_for_pose(double now_s) {
  if (source_->is_over()) return;
  if (!is_lost_ && now_s - waiting_since_s_ >= loss_after_s()) {
    is_lost_ = true;
    if (has_solved_) publish_failure("the user is not tracked; the partner holds its last pose", now_s);
  }
  if (is_lost_) output_.hold(now_s);
}

void LiveLoop::replace_source(const ReplaceSource& replacement, double now_s) {
  if (!replacement.source || replacement.source == source_) return;
  source_->on_arrival([] {});
  source_ = replacement.source;
  if (ReplayControl* replay = source_->replay()) replay->set_paused(is_paused_, now_s);
  input_ = replacement.input;
  dropped_before_ += dropped_now_;
  dropped_now_ = 0;
  is_first_of_source_ = true;
  smoothed_interval_s_ = 0;
  previous_time_s_ = -1;
  waiting_since_s_ = now_s;
  is_lost_ = false;
  control_.synthesizer().forget_user_body();
  control_.synthesizer().reset();
  listen_to_source();
}

void LiveLoop::apply(const Command& command, double now_s) {
  if (std::holds_alternative<PauseInput>(command)) settles_until_s_ = -1;  // rests at once
  if (changes_the_answer(command)) settles_until_s_ = now_s + settling_s;
  std::visit(
      [&](const auto& wish) {
        using Wish = std::decay_t<decltype(wish)>;
        ReplayControl* replay = source_->replay();
        if constexpr (std::is_same_v<Wish, SetSettings>) {
          control_.set_settings(wish.settings);
          source_->set_max_rate(wanted_rate(wish.settings));
        } else if constexpr (std::is_same_v<Wish, PinPair>) {
          control_.pin(wish.pair);
        } else if constexpr (std::is_same_v<Wish, SetVetoes>) {
          control_.set_vetoes(wish.vetoes);
        } else if constexpr (std::is_same_v<Wish, IntendMove>) {
          control_.intend(wish.move);
        } else if constexpr (std::is_same_v<Wish, SetRoleControl>) {
          control_.control_role(wish.by);
        } else if constexpr (std::is_same_v<Wish, ResetSolver>) {
          control_.synthesizer().reset();
        } else if constexpr (std::is_same_v<Wish, PauseInput>) {
          is_paused_ = wish.paused;
          if (replay) replay->set_paused(wish.paused, now_s);
        } else if constexpr (std::is_same_v<Wish, SeekInput>) {
          if (replay) replay->seek(wish.time_s, now_s);
        } else if constexpr (std::is_same_v<Wish, SetInputSpeed>) {
          if (replay) replay->set_speed(wish.factor, now_s);
        } else if constexpr (std::is_same_v<Wish, ReplaceSource>) {
          replace_source(wish, now_s);
        } else if constexpr (std::is_same_v<Wish, ReplaceSynthesizer>) {
          if (wish.synthesizer) control_.replace(wish.synthesizer);
        } else if constexpr (std::is_same_v<Wish, AttachListener>) {
          if (wish.listener) listeners_.push_back(wish.listener);
        } else if constexpr (std::is_same_v<Wish, DetachListener>) {
          std::erase(listeners_, wish.listener);
        } else if constexpr (std::is_same_v<Wish, AttachSink>) {
          output_.attach(wish.character, wish.sink);
        } else {
          static_assert(std::is_same_v<Wish, DetachSink>);
          output_.detach(wish.sink);
        }
      },
      command);
  ReplayControl* replay = source_->replay();
  is_held_ = replay && replay->is_paused();
}

// ---- a clip that is solved over its length ----

std::optional<LiveLoop::ClipProgress> LiveLoop::clip_progress() const {
  const std::scoped_lock lock(progress_mutex_);
  return progress_;
}

void LiveLoop::note_progress(const std::optional<ClipProgress>& progress) {
  const std::scoped_lock lock(progress_mutex_);
  progress_ = progress;
}

/// From its first frame. The frames of before are seen until each is solved again.
void LiveLoop::begin_clip() {
  FiniteInput& clip = *source_->finite();
  clip.begin_at(0);
  control_.begin_again();
  next_index_ = state_due_ = 0;
  previous_time_s_ = last_frame_s_ = -1;
  preview_end_.reset();
  const std::uint64_t run = progress_ ? progress_->run + 1 : 1;
  if (progress_ && progress_->frames != clip.frames()) history_.clear();  // at another rate
  history_.keep_at_most(std::numeric_limits<std::size_t>::max());         // it has an end
  note_progress(ClipProgress{0, clip.frames(), run, clip.last_s()});
}

/// @param with_state  the states in the frames are those of this library
void LiveLoop::begin_clip_again(bool with_state) {
  FiniteInput& clip = *source_->finite();
  begin_clip();
  if (!with_state) return;
  const FrameSnapshotPtr seen = history_.at(seen_s_);
  if (!seen || seen->index == 0) return;
  const FrameHistory::SolvableAgain again = history_.solvable_again(seen->time_s, seen->time_s);
  const FrameSnapshotPtr first = again.run_up.empty() ? seen : again.run_up.front();
  if (!first->before) return;
  control_.continue_from(*first->before);
  clip.begin_at(first->time_s);
  next_index_ = state_due_ = first->index;
  previous_time_s_ = first->time_s - first->elapsed_s;
  preview_end_ = seen->index + frames_after_seen;
}

std::shared_ptr<const SynthesizerState> LiveLoop::state_if_due() {
  if (next_index_ < state_due_) return nullptr;
  state_due_ = next_index_ + frames_between_states;
  return std::make_shared<const SynthesizerState>(control_.synthesizer().state());
}

/// Frames of a continued session are numbered from the recorded ones.
void LiveLoop::continue_counting() {
  const auto recorded = history_.store();
  if (next_index_ > 0 || !recorded) return;
  const FrameStore::Span span = recorded->span();
  if (span.frames > 0) next_index_ = state_due_ = span.last_index + 1;
}

void LiveLoop::publish(std::shared_ptr<FrameSnapshot> snapshot) {
  snapshot->index = next_index_++;
  last_frame_s_ = snapshot->time_s;
  const FrameSnapshotPtr frozen = std::move(snapshot);
  history_.put(frozen);
  latest_.publish(frozen);
  for (const auto& listener : listeners_) listener->frame_solved(frozen);
  if (!progress_) return;
  if (preview_end_) {
    if (next_index_ >= *preview_end_ || source_->is_over()) begin_clip();
    return;
  }
  ClipProgress progress = *progress_;
  progress.solved = next_index_;
  note_progress(progress);
}

void LiveLoop::publish_failure(const std::string& why, double now_s) {
  const FrameSnapshotPtr last = latest_.newest();
  auto snapshot = last ? std::make_shared<FrameSnapshot>(*last) : std::make_shared<FrameSnapshot>();
  if (source_->finite()) {
    // A clip has no frames but its own: the last that was solved says it.
    snapshot->result.status = StepStatus::Failed;
    snapshot->result.message = why;
    const FrameSnapshotPtr told = std::move(snapshot);
    history_.put(told);
    latest_.publish(told);
    return;
  }
  snapshot->time_s = std::max(now_s, last_frame_s_ + least_between_frames_s);
  snapshot->elapsed_s = -1;
  snapshot->before = nullptr;
  snapshot->decisions = control_.decisions();
  snapshot->input = input_;
  snapshot->times = {};
  snapshot->result.status = StepStatus::Failed;
  snapshot->result.message = why;
  publish(std::move(snapshot));
  state_due_ = next_index_;
}

}  // namespace abrazo
