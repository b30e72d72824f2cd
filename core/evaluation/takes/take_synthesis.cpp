#include "core/evaluation/takes/take_synthesis.hpp"

#include <algorithm>

#include "core/synthesis/step/clip_synthesis.hpp"

namespace abrazo {

namespace {

const Clip& clip_of(const PairedTake& take, ActivePerformer performer) {
  return performer == ActivePerformer::B ? take.b : take.a;
}

/// Who is active in every frame; Unknown where it is not known, nothing if it changes.
std::optional<ActivePerformer> active_throughout(const PairedTake& take) {
  const auto frames = static_cast<int>(take.a.poses.size());
  const ActivePerformer first = active_at(take, 0);
  for (int frame = 1; frame < frames; ++frame)
    if (active_at(take, frame) != first) return std::nullopt;
  return first;
}

void keep(const ClipStep& step, bool follows, const MotionLibrary& library, SynthesisedTake& kept) {
  const FrameResult& result = step.result;
  const PartnerStep partner = partner_step(result, step.time_s, library, kept.user_role != UserRole::Active);
  kept.times_s.push_back(partner.time_s);
  kept.sources.push_back(partner.source);
  kept.locked_feet.push_back(partner.locked);
  kept.relaxed += result.status == StepStatus::Relaxed;
  kept.frames.push_back(static_cast<int>(step.input_frame));
  kept.results.push_back(result.result);
  kept.selected.push_back(result.selected_pair);
  kept.pairs.push_back(result.candidates[static_cast<std::size_t>(result.selected)].pair);
  kept.source_changed.push_back(result.source_changed);
  kept.follows.push_back(follows);
  kept.bone_length_max = std::max(kept.bone_length_max, result.residual.bone_length_max);
  kept.foot_lock_drift_max_m = std::max(kept.foot_lock_drift_max_m, result.residual.foot_lock_max_m);
}

}  // namespace

ActivePerformer other(ActivePerformer performer) {
  return performer == ActivePerformer::A ? ActivePerformer::B : ActivePerformer::A;
}

PartnerStep SynthesisedTake::partner_step(std::size_t step) const {
  return {.partner = partner(step),
          .time_s = times_s[step],
          .source = sources[step],
          .source_changed = source_changed[step] != 0,
          .locked = locked_feet[step]};
}

const Clip& SynthesisedTake::true_partner_clip() const {
  return clip_of(*take, other(user));
}

const Clip& SynthesisedTake::true_user_clip() const {
  return clip_of(*take, user);
}

const Pose& SynthesisedTake::true_partner(std::size_t step) const {
  return true_partner_clip().poses[static_cast<std::size_t>(frames[step])];
}

const Pose& SynthesisedTake::true_user(std::size_t step) const {
  return true_user_clip().poses[static_cast<std::size_t>(frames[step])];
}

PairPose SynthesisedTake::true_pair(std::size_t step) const {
  PairPose pair;
  if (user_role == UserRole::Active)
    pair << true_user(step), true_partner(step);
  else
    pair << true_partner(step), true_user(step);
  return pair;
}

Result<ActivePerformer> user_of(const PairedTake& take, UserRole role, bool both_roles) {
  if (both_roles) return ActivePerformer::A;
  const auto active = active_throughout(take);
  if (!active)
    return Error{
        "the performers change roles, so a user who keeps to one role cannot be either of them; evaluate "
        "both roles",
        "take " + take.name, Hint::EvaluateBothRoles};
  if (*active == ActivePerformer::Unknown) return ActivePerformer::A;
  return role == UserRole::Active ? *active : other(*active);
}

Result<SynthesisedTake> synthesise_take(const std::shared_ptr<const MotionLibrary>& library,
                                        const PairedTake& take, const TakeSynthesisOptions& options) {
  const auto user = user_of(take, options.settings.user_role, options.both_roles);
  if (!user) return user.error();
  auto synthesizer = PartnerSynthesizer::create(
      library, options.settings,
      options.leave_out ? std::vector<std::string>{take.name} : std::vector<std::string>{});
  if (!synthesizer) return synthesizer.error();

  SynthesisedTake kept;
  kept.take = &take;
  kept.user = *user;
  kept.user_role = options.settings.user_role;
  kept.of_library = options.leave_out;
  const Clip input = as_performed_by(options.variant, clip_of(take, *user), options.seed);
  kept.rate_hz = clip_step_rate(input, options.settings);
  bool solved = false;
  const Status done = synthesize_clip(**synthesizer, input,
                                      [&](const ClipStep& step) -> Status {
                                        kept.step_us.push_back(step.result.timing.total_us);
                                        const bool follows = solved;
                                        solved = step.result.status != StepStatus::Failed;
                                        if (solved)
                                          keep(step, follows, *library, kept);
                                        else
                                          ++kept.failed;
                                        return Done{};
                                      },
                                      {});
  if (!done) return done.error();
  if (kept.frames.empty()) return Error{"not one of its steps could be solved", "take " + take.name};
  return kept;
}

}  // namespace abrazo
