#include "core/evaluation/run_measures.hpp"

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

const auto partner = [](const SynthesisedTake& take, std::size_t step) { return take.partner(step); };
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

struct SlideMean {
  WeightedMean mean;
  void add(const SynthesisedTake& take, const std::vector<Pose>& poses) {
    const double floor_m = toe_rest_height(poses);
    for (const Stretch& stretch : stretches_of(take, false)) {
      const FootSlide slide = measure_foot_slide(stretch.of(poses), take.rate_hz, floor_m);
      mean.add(slide.speed_m_s, slide.landed_frames);
    }
  }
};

/// Radii of performers A and B of a captured take; of the library's usual bodies in their roles when it is
/// not in the library.
std::pair<const CapsuleRadii*, const CapsuleRadii*> radii_of(const SynthesisedTake& take,
                                                             const MotionLibrary& library) {
  if (take.of_library) {
    const LibraryTake& known = library.takes()[static_cast<std::size_t>(library.find_take(take.take->name))];
    return {&library.bodies()[known.body_a].capsule_radii, &library.bodies()[known.body_b].capsule_radii};
  }
  const CapsuleRadii *active = &library.usual_active_body().capsule_radii,
                     *passive = &library.usual_passive_body().capsule_radii;
  return take.active() == ActivePerformer::A ? std::pair(active, passive) : std::pair(passive, active);
}

PairPose captured_pair(const PairedTake& take, int frame) {
  PairPose pair;
  pair << take.a.poses[static_cast<std::size_t>(frame)], take.b.poses[static_cast<std::size_t>(frame)];
  return pair;
}

void add_captured_penetration(const SynthesisedTake& take, const MotionLibrary& library,
                              PenetrationMetric& metric) {
  const auto [a, b] = radii_of(take, library);
  for (const int frame : take.frames) {
    const PairPose pair = captured_pair(*take.take, frame);
    metric.add(pair, pair, *a, *b);
  }
}

void add_contact(const SynthesisedTake& take, const MotionLibrary& library, HoldMetric& holds,
                 PenetrationMetric& penetration) {
  for (std::size_t step = 0; step < take.size(); ++step) {
    holds.add(take.results[step], take.selected[step]);
    penetration.add(take.results[step], take.selected[step],
                    library.active_body(take.pairs[step]).capsule_radii,
                    library.passive_body(take.pairs[step]).capsule_radii);
  }
}

}  // namespace

ZmpTable measure_zmp(std::span<const SynthesisedTake> takes, const ZmpSettings& settings) {
  ZmpError original, synthesised, original_partner, synthesised_partner, between, original_between;
  for (const SynthesisedTake& take : takes) {
    const auto measured = [&](const auto& pose_of, bool by_source) {
      const std::vector<Pose> poses = poses_of(take, pose_of);
      ZmpError error;
      for (const Stretch& stretch : stretches_of(take, by_source))
        error.append(measure_zmp(stretch.of(poses), take.rate_hz, settings));
      return error;
    };
    original_partner.append(measured(true_partner, false));
    synthesised_partner.append(measured(partner, false));
    original.append(measured(true_user, false));
    synthesised.append(measured(user_body, false));
    original_between.append(measured(true_partner, true));
    between.append(measured(partner, true));
  }
  original.append(original_partner);
  synthesised.append(synthesised_partner);
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
          .settings = settings};
}

ContactTable measure_contact(std::span<const SynthesisedTake> takes, const MotionLibrary& library) {
  ContactTable table;
  HoldMetric holds;
  PenetrationMetric penetration, original_penetration;
  SlideMean original_slide, partner_slide, user_slide;
  for (const SynthesisedTake& take : takes) {
    add_contact(take, library, holds, penetration);
    add_captured_penetration(take, library, original_penetration);
    original_slide.add(take, poses_of(take, true_partner));
    partner_slide.add(take, poses_of(take, partner));
    user_slide.add(take, poses_of(take, user_body));
    table.bone_length_max = std::max(table.bone_length_max, take.bone_length_max);
    table.foot_lock_drift_max_m = std::max(table.foot_lock_drift_max_m, take.foot_lock_drift_max_m);
  }
  table.holds = holds.figures();
  table.penetration = penetration.figures();
  table.original_penetration = original_penetration.figures();
  table.original_foot_slide_m_s = original_slide.mean.value();
  table.foot_slide_m_s = partner_slide.mean.value();
  table.user_foot_slide_m_s = user_slide.mean.value();
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
    const Lag lag = measure_lag(poses_of(take, true_partner), poses_of(take, partner), take.rate_hz);
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
