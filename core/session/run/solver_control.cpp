#include "core/session/run/solver_control.hpp"

#include <stdexcept>
#include <utility>

#include "core/session/frames/decision_edits.hpp"
#include "core/synthesis/step/role_views.hpp"
#include "core/synthesis/step/synthesizer_state.hpp"

namespace abrazo {

namespace {

std::size_t number(UserRole role) {
  return role == UserRole::Passive ? 1 : 0;
}

}  // namespace

SolverControl::SolverControl(std::shared_ptr<PartnerSynthesizer> synthesizer)
    : synthesizer_(std::move(synthesizer)),
      asked_role_(synthesizer_->settings().user_role),
      asked_selection_(synthesizer_->settings().selection),
      role_switch_(synthesizer_->views(), asked_role_) {
  apply(synthesizer_->settings());
}

void SolverControl::set_settings(const Settings& settings) {
  asked_role_ = settings.user_role;
  if (settings.selection != asked_selection_) could_not_learn_ = {};  // asked for again
  asked_selection_ = settings.selection;
  Settings wanted = settings;
  if (current_.role_control == RoleControl::Hand)
    role_switch_.control(RoleControl::Hand, settings.user_role);
  else
    wanted.user_role = role_switch_.role();
  if (wanted.user_role != synthesizer_->settings().user_role && !can_take(wanted.user_role))
    wanted.user_role = synthesizer_->settings().user_role;  // changes before a later step
  apply(wanted);
}

/// The only way settings reach the synthesizer: with a selection that need not be waited for.
void SolverControl::apply(Settings wanted) {
  wanted.selection = possible_selection(wanted.user_role);
  synthesizer_->set_settings(wanted);
}

/// What the selection `intent` learns first is learned beside the steps, not in one. Then the other role is
/// learned too, so that a change of role finds it.
SelectionMethod SolverControl::possible_selection(UserRole role) {
  if (asked_selection_ == SelectionMethod::Paper || could_not_learn_[number(role)])
    return SelectionMethod::Paper;
  const RoleViews& views = *synthesizer_->views();
  if (views.is_intent_ready(role)) {
    const UserRole other = role == UserRole::Active ? UserRole::Passive : UserRole::Active;
    if (!views.is_costly(other) && !could_not_learn_[number(other)]) views.prepare_intent(other);
    return SelectionMethod::Intent;
  }
  if (const auto trouble = views.intent_trouble(role)) {
    could_not_learn_[number(role)] = true;
    unreported_ = "Eq. 7 continues to select: learning the library failed, " + trouble->message;
  } else {
    views.prepare_intent(role);
  }
  return SelectionMethod::Paper;
}

bool SolverControl::is_learning() const {
  const Settings& now = synthesizer_->settings();
  return asked_selection_ != now.selection && !could_not_learn_[number(now.user_role)];
}

/// A view that is made in memory first is waited for between steps, not in one.
bool SolverControl::can_take(UserRole role) {
  const RoleViews& views = *synthesizer_->views();
  if (!views.is_costly(role) || views.is_ready(role)) return true;
  if (const auto trouble = views.trouble(role)) {
    role_switch_.control(current_.role_control, synthesizer_->settings().user_role);
    throw std::runtime_error("the role stays: " + trouble->message);
  }
  views.prepare(role);
  return false;
}

void SolverControl::decide(const Decisions& decisions) {
  current_ = decisions;
  decisions_ = current_ == Decisions{} ? nullptr : std::make_shared<const Decisions>(current_);
}

void SolverControl::pin(std::optional<int> pair) {
  Decisions wanted = current_;
  wanted.pinned = pair;
  decide(wanted);
  synthesizer_->pin_pair(pair);
}

void SolverControl::set_vetoes(const Vetoes& vetoes) {
  Decisions wanted = current_;
  wanted.vetoes = vetoes;
  decide(wanted);
  synthesizer_->set_vetoes(vetoes);
}

void SolverControl::intend(const std::optional<IntendedMove>& move) {
  asked_move_ = move;
  follow(move);
}

void SolverControl::follow(const std::optional<IntendedMove>& move) {
  Decisions wanted = current_;
  wanted.meant = move;
  decide(wanted);
  followed_pair_ = -1;
  move_is_done_ = false;
  synthesizer_->set_intended(pairs_of(move));
}

void SolverControl::control_role(RoleControl by) {
  Decisions wanted = current_;
  wanted.role_control = by;
  decide(wanted);
  role_switch_.control(by, by == RoleControl::Hand ? asked_role_ : synthesizer_->settings().user_role);
}

void SolverControl::replace(std::shared_ptr<PartnerSynthesizer> synthesizer) {
  synthesizer->set_settings(synthesizer_->settings());  // may throw; nothing is changed yet
  std::shared_ptr<PartnerSynthesizer> before = std::exchange(synthesizer_, std::move(synthesizer));
  decide(carried_over(current_, before->library(), synthesizer_->library()));
  if (!current_.meant) asked_move_.reset();
  could_not_learn_ = {};
  apply(before->settings());
  synthesizer_->pin_pair(current_.pinned);
  synthesizer_->set_vetoes(current_.vetoes);
  synthesizer_->set_intended(pairs_of(current_.meant));
  synthesizer_->take_over(before->state());
  role_switch_ = RoleSwitch(synthesizer_->views(), before->settings().user_role);
  role_switch_.control(current_.role_control, before->settings().user_role);
  followed_pair_ = -1;
  // What is learned for it may go on for seconds, and is waited for when it ends: not between two steps.
  leaving_ =
      std::jthread([last = std::move(before), earlier = std::move(leaving_)]() mutable { last.reset(); });
}

bool SolverControl::is_over(const IntendedMove& move, double now_s) const {
  return (move.until_s >= 0 && now_s >= move.until_s) || (move.until_done && move_is_done_);
}

void SolverControl::begin_again() {
  synthesizer_->reset();
  if (asked_move_ != current_.meant) follow(asked_move_);
  followed_pair_ = -1;
  move_is_done_ = false;
  // Another role than the synthesizer's is taken before the next step.
  role_switch_ = RoleSwitch(synthesizer_->views(), asked_role_);
  role_switch_.control(current_.role_control, asked_role_);
}

void SolverControl::continue_from(const SynthesizerState& state) {
  synthesizer_->restore(state);
  synthesizer_->pin_pair(current_.pinned);
  synthesizer_->set_vetoes(current_.vetoes);
  synthesizer_->set_intended(pairs_of(current_.meant));
}

bool SolverControl::take_learned() {
  if (!is_learning() || possible_selection(synthesizer_->settings().user_role) != asked_selection_)
    return false;
  apply(synthesizer_->settings());
  return true;
}

bool SolverControl::before_step(double now_s) {
  bool changed = false;
  if (current_.meant && is_over(*current_.meant, now_s)) {
    follow(std::nullopt);
    changed = true;
  }
  if (synthesizer_->settings().user_role != role_switch_.role() && can_take(role_switch_.role())) {
    Settings settings = synthesizer_->settings();
    settings.user_role = role_switch_.role();
    apply(settings);
    changed = true;
  }
  changed = take_learned() || changed;
  if (!unreported_.empty()) throw std::runtime_error(std::exchange(unreported_, {}));
  return changed;
}

void SolverControl::after_step(const FrameResult& result, const Pose& user, double time_s) {
  if (current_.meant && current_.meant->until_done) watch_move(result);
  if (current_.role_control == RoleControl::Hand || result.status == StepStatus::Failed) return;
  const std::optional<Body>& body = synthesizer_->user_body();
  role_switch_.after({result, user, body, time_s});
}

/// A move has come to its end when the pair that is followed is the last of its label or take.
void SolverControl::watch_move(const FrameResult& result) {
  if (result.selected < 0) return;
  const MotionLibrary& library = synthesizer_->library();
  const int pair = result.candidates[static_cast<std::size_t>(result.selected)].pair;
  const IntendedMove& meant = *current_.meant;
  // What is named is evidence to the selection `intent`: another move may be followed meanwhile.
  const bool is_meant = (!meant.label || library.label(pair) == *meant.label) &&
                        (!meant.take || library.take_of(pair).name == *meant.take);
  const bool was_followed = followed_pair_ >= 0 && !result.source_changed;
  followed_pair_ = is_meant ? pair : -1;
  if (!was_followed) return;
  const int next = library.later_pair(pair, 1);
  move_is_done_ = !is_meant || next < 0 || (meant.label && library.label(next) != *meant.label);
}

}  // namespace abrazo
