#include "core/session/run/re_solver.hpp"

#include <stdexcept>
#include <utility>

#include "core/synthesis/step/synthesizer_state.hpp"

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
  decisions_ = {};
  decisions_.pinned = first.before->pinned;
  decisions_.vetoes = *first.before->vetoes;
  synthesizer_->set_intended(std::nullopt);
  for (const FrameSnapshotPtr& frame : run_up) {
    follow_commands(*frame);
    synthesizer_->set_settings(frame->settings);
    if (frame->elapsed_s >= 0) synthesizer_->step(frame->user, Duration(frame->elapsed_s));
  }
}

/// What came between the frame before and this one: each command makes that a frame has a state.
void ReSolver::follow_commands(const FrameSnapshot& recorded, const std::optional<Decisions>& instead) {
  follow_decisions(instead ? *instead : recorded.decisions ? *recorded.decisions : Decisions{});
  if (!recorded.before) return;
  const FrameMemory& before = recorded.before->memory;
  if (before.frames_since_reset == 0 && !before.partner_is_shown) synthesizer_->reset();
  if (recorded.before->user_body)
    synthesizer_->set_user_body(*recorded.before->user_body);
  else if (!recorded.before->memory.user.body())
    synthesizer_->forget_user_body();
}

void ReSolver::follow_decisions(const Decisions& decisions) {
  if (decisions.pinned != decisions_.pinned) synthesizer_->pin_pair(decisions.pinned);
  if (decisions.vetoes != decisions_.vetoes) synthesizer_->set_vetoes(decisions.vetoes);
  if (decisions.meant != decisions_.meant) synthesizer_->set_intended(pairs_of(decisions.meant));
  decisions_ = decisions;
}

std::shared_ptr<FrameSnapshot> ReSolver::solve(const FrameSnapshot& recorded, const Settings& settings,
                                               const std::optional<Decisions>& decisions) {
  follow_commands(recorded, decisions);
  synthesizer_->set_settings(settings);
  auto solved = std::make_shared<FrameSnapshot>();
  solved->index = recorded.index;
  solved->time_s = recorded.time_s;
  solved->input_frame = recorded.input_frame;
  solved->user = recorded.user;
  solved->settings = settings;
  solved->elapsed_s = recorded.elapsed_s;
  solved->decisions = decisions ? std::make_shared<const Decisions>(*decisions) : recorded.decisions;
  solved->input_rate_hz = recorded.input_rate_hz;
  solved->dropped_inputs = recorded.dropped_inputs;
  const bool was_stepped = recorded.elapsed_s >= 0;  // otherwise there is nothing to restore
  solved->result =
      was_stepped ? synthesizer_->step(recorded.user, Duration(recorded.elapsed_s)) : recorded.result;
  return solved;
}

}  // namespace abrazo
