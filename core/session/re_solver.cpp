#include "core/session/re_solver.hpp"

#include <stdexcept>
#include <utility>

#include "core/synthesis/synthesizer_state.hpp"

namespace abrazo {

Result<std::unique_ptr<ReSolver>> ReSolver::create(std::shared_ptr<const MotionLibrary> library,
                                                   const std::vector<std::string>& excluded_takes) {
  auto synthesizer = PartnerSynthesizer::create(std::move(library), Settings{}, excluded_takes);
  if (!synthesizer) return synthesizer.error();
  return std::make_unique<ReSolver>(std::move(synthesizer).value());
}

ReSolver::ReSolver(std::unique_ptr<PartnerSynthesizer> synthesizer) : synthesizer_(std::move(synthesizer)) {}

void ReSolver::go_to(std::span<const FrameSnapshotPtr> run_up, const FrameSnapshot& next) {
  const FrameSnapshot& first = run_up.empty() ? next : *run_up.front();
  if (!first.before) throw std::invalid_argument("the first frame to be solved again has no state");
  synthesizer_->restore(*first.before);
  vetoes_ = first.before->vetoes;
  for (const FrameSnapshotPtr& frame : run_up) {
    if (frame->before && frame != run_up.front()) follow_commands(*frame->before);
    synthesizer_->set_settings(frame->settings);
    if (frame->elapsed_s >= 0) synthesizer_->step(frame->user, Duration(frame->elapsed_s));
  }
}

void ReSolver::follow_commands(const SynthesizerState& recorded) {
  synthesizer_->pin_pair(recorded.pinned);
  if (vetoes_ != recorded.vetoes) synthesizer_->set_vetoes(*recorded.vetoes);
  vetoes_ = recorded.vetoes;
  if (recorded.memory.frames_since_reset == 0) synthesizer_->reset();
}

std::shared_ptr<FrameSnapshot> ReSolver::solve(const FrameSnapshot& recorded, const Settings& settings) {
  if (recorded.before) follow_commands(*recorded.before);
  synthesizer_->set_settings(settings);
  auto solved = std::make_shared<FrameSnapshot>();
  solved->index = recorded.index;
  solved->time_s = recorded.time_s;
  solved->input_frame = recorded.input_frame;
  solved->user = recorded.user;
  solved->settings = settings;
  solved->elapsed_s = recorded.elapsed_s;
  solved->input_rate_hz = recorded.input_rate_hz;
  solved->dropped_inputs = recorded.dropped_inputs;
  const bool was_stepped = recorded.elapsed_s >= 0;  // otherwise there is nothing to take again
  solved->result =
      was_stepped ? synthesizer_->step(recorded.user, Duration(recorded.elapsed_s)) : recorded.result;
  return solved;
}

}  // namespace abrazo
