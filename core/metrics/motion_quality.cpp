#include "core/metrics/motion_quality.hpp"

#include <algorithm>

#include "core/base/statistics.hpp"
#include "core/motion/body/joint_set.hpp"

namespace abrazo {

namespace {

constexpr double longest_advance_s = 1.0 / 3;
constexpr double time_tolerance_s = 1e-6;
constexpr double standing_pace = 0.25, source_pace_low = 0.75, source_pace_high = 1.25;

double mean_or_nothing(const std::vector<double>& values) {
  return values.empty() ? quantile({}, 0) : mean(values);
}

double share_between(const std::vector<double>& values, double low, double high) {
  if (values.empty()) return quantile({}, 0);
  const auto inside =
      std::count_if(values.begin(), values.end(), [&](double value) { return value > low && value < high; });
  return static_cast<double>(inside) / static_cast<double>(values.size());
}

}  // namespace

PartnerStep partner_step(const FrameResult& frame, double time_s, const MotionLibrary& library,
                         bool partner_is_active) {
  PartnerStep step;
  step.partner = partner_is_active ? Pose(frame.active()) : Pose(frame.passive());
  step.time_s = time_s;
  step.source_changed = frame.source_changed;
  if (frame.selected >= 0) {
    const int pair = frame.candidates[static_cast<std::size_t>(frame.selected)].pair;
    const PairSource& source = library.source(pair);
    step.source = {.take = static_cast<int>(source.take),
                   .swapped = source.swapped,
                   .time_s = static_cast<double>(source.frame) / library.take_of(pair).fps};
  }
  for (const FootLock& lock : frame.foot_locks)
    if (lock.active_body == partner_is_active) step.locked[lock.left ? 0 : 1] = true;
  return step;
}

bool continues(const SourceMoment& before, const SourceMoment& after) {
  const double advance_s = after.time_s - before.time_s;
  return before.take == after.take && before.swapped == after.swapped && advance_s > -time_tolerance_s &&
         advance_s < longest_advance_s + time_tolerance_s;
}

void MotionQuality::add(const PartnerStep& step) {
  if (last_ && !(step.time_s > last_->time_s)) interrupt();
  add_source(step, movement_.add(step.partner, step.time_s));
  using namespace joints;
  for (const auto& [foot, toe_base] : {std::pair{0U, left_toe_base}, std::pair{1U, right_toe_base}})
    if (step.locked[foot]) hovers_m_.push_back(step.partner(toe_base, 1) - rest_[foot]);
  last_ = step;
}

void MotionQuality::add_source(const PartnerStep& step, const std::optional<MovementStep>& moved) {
  if (!last_) return;
  const double elapsed_s = step.time_s - last_->time_s;
  observed_s_ += elapsed_s;
  if (!step.source_changed && continues(last_->source, step.source)) {
    paces_.push_back((step.source.time_s - last_->source.time_s) / elapsed_s);
    return;
  }
  ++changes_;
  if (moved && moved->unexplained_m) steps_at_change_m_.push_back(*moved->unexplained_m);
}

void MotionQuality::interrupt() {
  movement_.interrupt();
  last_.reset();
}

MotionQuality::Figures MotionQuality::figures() const {
  Figures f;
  f.movement = movement_.figures();
  f.changes_per_s = observed_s_ > 0 ? changes_ / observed_s_ : quantile({}, 0);
  f.pace_p05 = quantile(paces_, 0.05);
  f.pace_p50 = quantile(paces_, 0.5);
  f.pace_p95 = quantile(paces_, 0.95);
  f.standing_share = share_between(paces_, -1, standing_pace);
  f.source_pace_share = share_between(paces_, source_pace_low, source_pace_high);
  f.step_at_change_max_m = quantile(steps_at_change_m_, 1);
  f.step_at_change_mean_m = mean_or_nothing(steps_at_change_m_);
  f.hover_mean_m = mean_or_nothing(hovers_m_);
  f.hover_p90_m = quantile(hovers_m_, 0.9);
  return f;
}

}  // namespace abrazo
