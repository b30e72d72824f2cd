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

struct ZmpMean {
  WeightedMean mean;
  int frames = 0, skipped = 0;
  void add(const ZmpError& error) {
    mean.add(error.mean_m(), static_cast<double>(error.error_m.size()));
    frames += static_cast<int>(error.error_m.size());
    skipped += error.skipped();
  }
};

/// Calls `stretch(first, last)` for every run of steps [first, last) from one source, without a failed one.
template <typename Stretch>
void for_each_stretch(const SynthesisedTake& take, const Stretch& stretch) {
  std::size_t first = 0;
  for (std::size_t step = 1; step <= take.size(); ++step)
    if (step == take.size() || take.source_changed[step] != 0 || take.follows[step] == 0) {
      stretch(first, step);
      first = step;
    }
}

struct SlideMean {
  WeightedMean mean;
  void add(const std::vector<Pose>& poses, double fps) {
    const FootSlide slide = measure_foot_slide(poses, fps, toe_rest_height(poses));
    mean.add(slide.speed_m_s, slide.landed_frames);
  }
};

/// Radii of the two performers of a captured take, or of the library's usual bodies when it is not in the
/// library.
std::pair<const CapsuleRadii*, const CapsuleRadii*> radii_of(const SynthesisedTake& take,
                                                             const MotionLibrary& library) {
  if (take.of_library) {
    const LibraryTake& known = library.takes()[static_cast<std::size_t>(library.find_take(take.take->name))];
    return {&library.bodies()[known.body_a].capsule_radii, &library.bodies()[known.body_b].capsule_radii};
  }
  return {&library.usual_active_body().capsule_radii, &library.usual_passive_body().capsule_radii};
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
  ZmpMean original, synthesised, original_partner, synthesised_partner, between, original_between;
  for (const SynthesisedTake& take : takes) {
    const auto measured = [&](const auto& pose_of) {
      return measure_zmp(poses_of(take, pose_of), take.rate_hz, settings);
    };
    const ZmpError captured_partner = measured(true_partner), made_partner = measured(partner);
    original_partner.add(captured_partner);
    synthesised_partner.add(made_partner);
    original.add(captured_partner);
    original.add(measured(true_user));
    synthesised.add(made_partner);
    synthesised.add(measured(user_body));
    const std::vector<Pose> made = poses_of(take, partner), captured = poses_of(take, true_partner);
    for_each_stretch(take, [&](std::size_t first, std::size_t last) {
      const auto part_of = [&](const std::vector<Pose>& poses) {
        return measure_zmp(std::span(poses).subspan(first, last - first), take.rate_hz, settings);
      };
      between.add(part_of(made));
      original_between.add(part_of(captured));
    });
  }
  const int partner_frames = synthesised_partner.frames;
  return {
      .original_m = original.mean.value(),
      .synthesised_m = synthesised.mean.value(),
      .original_partner_m = original_partner.mean.value(),
      .synthesised_partner_m = synthesised_partner.mean.value(),
      .frames = synthesised.frames,
      .skipped_frames = synthesised.skipped,
      .original_skipped_frames = original.skipped,
      .partner_between_changes_m = between.mean.value(),
      .original_between_changes_m = original_between.mean.value(),
      .between_changes_share = partner_frames > 0 ? static_cast<double>(between.frames) / partner_frames : 0,
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
    original_slide.add(poses_of(take, true_partner), take.rate_hz);
    partner_slide.add(poses_of(take, partner), take.rate_hz);
    user_slide.add(poses_of(take, user_body), take.rate_hz);
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
