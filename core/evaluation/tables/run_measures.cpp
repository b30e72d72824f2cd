#include "core/evaluation/tables/run_measures.hpp"

#include <algorithm>
#include <vector>

#include "core/base/statistics.hpp"
#include "core/metrics/foot_slide.hpp"
#include "core/metrics/partner_error.hpp"

namespace abrazo {

namespace {

/// A mean of parts that count differently.
class WeightedMean {
 public:
  void add(double value, double weight) { sum_ += weight * value, weight_ += weight; }
  double value() const { return weight_ > 0 ? sum_ / weight_ : 0; }

 private:
  double sum_ = 0, weight_ = 0;
};

template <typename PoseOf>
std::vector<Pose> poses_of(const SynthesisedTake& take, const PoseOf& pose_of) {
  std::vector<Pose> poses;
  poses.reserve(take.size());
  for (std::size_t step = 0; step < take.size(); ++step) poses.push_back(pose_of(take, step));
  return poses;
}

const auto result_partner = [](const SynthesisedTake& take, std::size_t step) { return take.partner(step); };
const auto user_body = [](const SynthesisedTake& take, std::size_t step) { return take.user_body(step); };
const auto true_partner = [](const SynthesisedTake& take, std::size_t step) {
  return take.true_partner(step);
};
const auto true_user = [](const SynthesisedTake& take, std::size_t step) { return take.true_user(step); };

/// Steps [first, last) of a take.
struct Stretch {
  std::size_t first = 0, last = 0;
  std::span<const Pose> of(const std::vector<Pose>& poses) const {
    return std::span(poses).subspan(first, last - first);
  }
};

/// A take cut where a step failed, and also where the source changes when `by_source`: elsewhere there is no
/// speed to be had from one step to the next.
std::vector<Stretch> stretches_of(const SynthesisedTake& take, bool by_source) {
  std::vector<Stretch> stretches;
  for (std::size_t step = 0; step < take.size(); ++step) {
    const bool begins = step == 0 || take.follows[step] == 0 || (by_source && take.source_changed[step] != 0);
    if (begins) stretches.push_back({step, step});
    stretches.back().last = step + 1;
  }
  return stretches;
}

/// @param captured  the whole motion of the performer that `poses` stand beside
void add_slide(const SynthesisedTake& take, const std::vector<Pose>& poses, const Clip& captured,
               FootSlideMetric& metric) {
  const ToeRest rest = toe_rest(captured.poses);
  for (std::size_t step = 1; step < take.size(); ++step)
    if (take.follows[step])
      metric.add(poses[step - 1], poses[step], take.times_s[step] - take.times_s[step - 1], rest);
}

/// Result and capture are measured with the same radii, those of the bodies that a result has.
void add_contact(const SynthesisedTake& take, const MotionLibrary& library, HoldMetric& holds,
                 PenetrationMetric& penetration, PenetrationMetric& captured_penetration) {
  const CapsuleRadii& active = library.usual_active_body().capsule_radii;
  const CapsuleRadii& passive = library.usual_passive_body().capsule_radii;
  for (std::size_t step = 0; step < take.size(); ++step) {
    holds.add(take.results[step], take.selected[step]);
    penetration.add(take.results[step], take.selected[step], active, passive);
    const PairPose captured = take.true_pair(step);
    captured_penetration.add(captured, captured, active, passive);
  }
}

/// A body as captured and as it came out, in the same stretches of the same takes.
struct ZmpPair {
  ZmpError original, synthesised;
  ZmpComparison comparison;

  template <typename OriginalOf, typename SynthesisedOf>
  void add(const SynthesisedTake& take, const ZmpSettings& settings, bool by_source,
           const OriginalOf& original_of, const SynthesisedOf& synthesised_of) {
    const std::vector<Pose> captured = poses_of(take, original_of), made = poses_of(take, synthesised_of);
    for (const Stretch& stretch : stretches_of(take, by_source)) {
      const ZmpError of_captured = measure_zmp(stretch.of(captured), take.rate_hz, settings);
      const ZmpError of_made = measure_zmp(stretch.of(made), take.rate_hz, settings);
      comparison.add(of_captured, of_made);
      original.append(of_captured);
      synthesised.append(of_made);
    }
  }
  void append(const ZmpPair& other) {
    original.append(other.original);
    synthesised.append(other.synthesised);
    comparison.append(other.comparison);
  }
};

}  // namespace

ZmpTable measure_zmp(std::span<const SynthesisedTake> takes, const ZmpSettings& settings) {
  ZmpPair both, of_partner, of_partner_between;
  for (const SynthesisedTake& take : takes) {
    of_partner.add(take, settings, false, true_partner, result_partner);
    both.add(take, settings, false, true_user, user_body);
    of_partner_between.add(take, settings, true, true_partner, result_partner);
  }
  both.append(of_partner);
  const ZmpError &original = both.original, &synthesised = both.synthesised;
  const ZmpError &original_partner = of_partner.original, &synthesised_partner = of_partner.synthesised;
  const ZmpError &original_between = of_partner_between.original, &between = of_partner_between.synthesised;
  const std::size_t partner_frames = synthesised_partner.error_m.size();
  return {.original_m = original.mean_m(),
          .synthesised_m = synthesised.mean_m(),
          .original_partner_m = original_partner.mean_m(),
          .synthesised_partner_m = synthesised_partner.mean_m(),
          .frames = static_cast<int>(synthesised.error_m.size()),
          .skipped_frames = synthesised.skipped(),
          .original_skipped_frames = original.skipped(),
          .partner_between_changes_m = between.mean_m(),
          .original_between_changes_m = original_between.mean_m(),
          .between_changes_share = partner_frames > 0 ? static_cast<double>(between.error_m.size()) /
                                                            static_cast<double>(partner_frames)
                                                      : 0,
          .common = both.comparison.common(),
          .common_partner = of_partner.comparison.common(),
          .partner_free_fall = synthesised_partner.skipped_free_fall,
          .original_partner_free_fall = original_partner.skipped_free_fall,
          .partner_no_support = synthesised_partner.skipped_no_support,
          .original_partner_no_support = original_partner.skipped_no_support,
          .partner_frames = static_cast<int>(synthesised_partner.error_m.size()),
          .original_partner_frames = static_cast<int>(original_partner.error_m.size()),
          .settings = settings};
}

ContactTable measure_contact(std::span<const SynthesisedTake> takes, const MotionLibrary& library) {
  ContactTable table;
  HoldMetric holds;
  PenetrationMetric penetration, original_penetration;
  FootSlideMetric original_slide, partner_slide, user_slide;
  for (const SynthesisedTake& take : takes) {
    add_contact(take, library, holds, penetration, original_penetration);
    add_slide(take, poses_of(take, true_partner), take.true_partner_clip(), original_slide);
    add_slide(take, poses_of(take, result_partner), take.true_partner_clip(), partner_slide);
    add_slide(take, poses_of(take, user_body), take.true_user_clip(), user_slide);
    table.bone_length_max = std::max(table.bone_length_max, take.bone_length_max);
    table.foot_lock_drift_max_m = std::max(table.foot_lock_drift_max_m, take.foot_lock_drift_max_m);
  }
  table.holds = holds.figures();
  table.penetration = penetration.figures();
  table.original_penetration = original_penetration.figures();
  table.original_foot_slide_m_s = original_slide.figures().mean_m_s;
  table.foot_slide_m_s = partner_slide.figures().mean_m_s;
  table.user_foot_slide_m_s = user_slide.figures().mean_m_s;
  return table;
}

PartnerTable measure_partner(std::span<const SynthesisedTake> takes) {
  PartnerTable table;
  std::vector<double> errors_m;
  WeightedMean lag_s, correlation, behind;
  ContinuityMetric continuity, original;
  for (const SynthesisedTake& take : takes) {
    for (std::size_t step = 0; step < take.size(); ++step) {
      const Pose synthesised = take.partner(step);
      if (!take.follows[step]) continuity.interrupt(), original.interrupt();
      continuity.add(synthesised, take.source_changed[step] != 0);
      original.add(take.true_partner(step), false);
      errors_m.push_back(mean_joint_distance(synthesised, take.true_partner(step)));
      behind.add(mean_joint_distance(synthesised, take.selected_partner(step)), 1);
    }
    const Lag lag = measure_lag(poses_of(take, true_partner), poses_of(take, result_partner), take.rate_hz);
    lag_s.add(lag.shift_s, static_cast<double>(take.size()));
    correlation.add(lag.correlation, static_cast<double>(take.size()));
  }
  table.mean_joint_error_m = mean(errors_m);
  table.median_joint_error_m = percentile(errors_m, 0.5);
  table.p95_joint_error_m = percentile(errors_m, 0.95);
  table.lag_s = lag_s.value();
  table.lag_correlation = correlation.value();
  table.behind_selected_mean_m = behind.value();
  table.continuity = continuity.figures();
  table.original_continuity = original.figures();
  return table;
}

SolveTimes measure_solve_times(std::span<const SynthesisedTake> takes) {
  SolveTimes times;
  std::vector<double> all_us;
  for (const SynthesisedTake& take : takes) {
    all_us.insert(all_us.end(), take.step_us.begin(), take.step_us.end());
    times.relaxed += take.relaxed;
    times.failed += take.failed;
  }
  times.steps = static_cast<int>(all_us.size());
  times.p50_us = percentile(all_us, 0.5);
  times.p95_us = percentile(all_us, 0.95);
  times.p99_us = percentile(all_us, 0.99);
  return times;
}

}  // namespace abrazo
