#include "core/session/live_loop.hpp"

#include <utility>
#include <variant>

#include "core/synthesis/synthesizer_state.hpp"

namespace abrazo {

namespace {

constexpr double highest_rate_hz = 120;
constexpr double interval_smoothing = 0.1;
/// Solving up to a frame from the last kept state takes a few milliseconds; a state is a sixth of a frame.
constexpr std::uint64_t frames_between_states = 32;

double wanted_rate(const Settings& settings) {
  return settings.step_rate_hz > 0 ? settings.step_rate_hz : highest_rate_hz;
}

}  // namespace

LiveLoop::LiveLoop(std::unique_ptr<PartnerSynthesizer> synthesizer, std::unique_ptr<PoseSource> source,
                   CommandQueue& commands, FrameHistory& history, LatestSlot<FrameSnapshot>& latest)
    : synthesizer_(std::move(synthesizer)),
      source_(std::move(source)),
      commands_(commands),
      history_(history),
      latest_(latest) {
  if (const auto body = source_->body()) synthesizer_->set_user_body(*body);
  source_->set_max_rate(wanted_rate(synthesizer_->settings()));
}

double LiveLoop::turn(double now_s) {
  for (const Command& command : commands_.drain()) {
    apply(command, now_s);
    state_due_ = next_index_;
  }
  if (const auto input = source_->poll(now_s)) {
    if (input->discontinuous) {
      synthesizer_->reset();
      previous_time_s_ = -1;
      state_due_ = next_index_;
    }
    const double elapsed = previous_time_s_ < 0 ? 0.0 : input->time_s - previous_time_s_;
    if (elapsed > 0)
      smoothed_interval_s_ +=
          (smoothed_interval_s_ > 0 ? interval_smoothing : 1.0) * (elapsed - smoothed_interval_s_);
    previous_time_s_ = input->time_s;
    auto snapshot = std::make_shared<FrameSnapshot>();
    snapshot->time_s = input->time_s;
    snapshot->input_frame = input->frame;
    snapshot->user = input->pose;
    snapshot->settings = synthesizer_->settings();
    snapshot->elapsed_s = elapsed;
    snapshot->before = state_if_due();
    snapshot->input_rate_hz = smoothed_interval_s_ > 0 ? 1.0 / smoothed_interval_s_ : source_->rate_hz();
    snapshot->dropped_inputs = input->dropped;
    snapshot->result = synthesizer_->step(input->pose, Duration(elapsed));
    publish(std::move(snapshot));
  }
  return source_->next_due_s();
}

void LiveLoop::apply(const Command& command, double now_s) {
  std::visit(
      [&](const auto& wish) {
        using Wish = std::decay_t<decltype(wish)>;
        if constexpr (std::is_same_v<Wish, SetSettings>) {
          synthesizer_->set_settings(wish.settings);
          source_->set_max_rate(wanted_rate(wish.settings));
        } else if constexpr (std::is_same_v<Wish, PinPair>) {
          synthesizer_->pin_pair(wish.pair);
        } else if constexpr (std::is_same_v<Wish, SetVetoes>) {
          synthesizer_->set_vetoes(wish.vetoes);
        } else if constexpr (std::is_same_v<Wish, ResetSolver>) {
          synthesizer_->reset();
        } else if constexpr (std::is_same_v<Wish, PauseInput>) {
          if (ReplayControl* replay = source_->replay()) replay->set_paused(wish.paused, now_s);
        } else if constexpr (std::is_same_v<Wish, SeekInput>) {
          if (ReplayControl* replay = source_->replay()) replay->seek(wish.time_s, now_s);
        } else if constexpr (std::is_same_v<Wish, SetInputSpeed>) {
          if (ReplayControl* replay = source_->replay()) replay->set_speed(wish.factor, now_s);
        }
      },
      command);
}

std::shared_ptr<const SynthesizerState> LiveLoop::state_if_due() {
  if (next_index_ < state_due_) return nullptr;
  state_due_ = next_index_ + frames_between_states;
  return std::make_shared<const SynthesizerState>(synthesizer_->state());
}

void LiveLoop::publish(std::shared_ptr<FrameSnapshot> snapshot) {
  snapshot->index = next_index_++;
  const FrameSnapshotPtr frozen = std::move(snapshot);
  history_.append(frozen);
  latest_.publish(frozen);
}

void LiveLoop::publish_failure(const std::string& why, double now_s) {
  const FrameSnapshotPtr last = latest_.newest();
  auto snapshot = last ? std::make_shared<FrameSnapshot>(*last) : std::make_shared<FrameSnapshot>();
  snapshot->time_s = now_s;
  snapshot->elapsed_s = -1;
  snapshot->before = nullptr;
  snapshot->result.status = StepStatus::Failed;
  snapshot->result.message = why;
  publish(std::move(snapshot));
  state_due_ = next_index_;
}

}  // namespace abrazo
