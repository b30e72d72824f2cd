#include "core/evaluation/tables/body_table.hpp"

#include <algorithm>
#include <cmath>

#include "core/base/statistics.hpp"
#include "core/bodies/foot_steps.hpp"
#include "core/evaluation/takes/body_baselines.hpp"
#include "core/evaluation/takes/live_bodies.hpp"
#include "core/metrics/bone_lengths.hpp"
#include "core/metrics/holds.hpp"
#include "core/metrics/movement.hpp"
#include "core/motion/body/body_choice.hpp"
#include "core/motion/body/joint_set.hpp"

namespace abrazo {

namespace {

constexpr double on_floor_m = 0.02;
constexpr double never_lost_m = 1e9;  ///< a hold counts even if it opens

constexpr std::array all_variants = {
    BodyVariant{"both 0.7", {.all = 0.7}, {.all = 0.7}},
    BodyVariant{"both 0.85", {.all = 0.85}, {.all = 0.85}, true},
    BodyVariant{"both 1.15", {.all = 1.15}, {.all = 1.15}, true},
    BodyVariant{"both 1.3", {.all = 1.3}, {.all = 1.3}},
    BodyVariant{"active 0.85", {.all = 0.85}, {}, true},
    BodyVariant{"active 1.15", {.all = 1.15}, {}, true},
    BodyVariant{"active 0.85, passive 1.15", {.all = 0.85}, {.all = 1.15}, true},
    BodyVariant{"active 1.15, passive 0.85", {.all = 1.15}, {.all = 0.85}, true},
    BodyVariant{"active 1.3, passive 0.85", {.all = 1.3}, {.all = 0.85}},
    BodyVariant{"both arms 1.2", {.arms = 1.2}, {.arms = 1.2}},
    BodyVariant{"both legs 0.85", {.legs = 0.85}, {.legs = 0.85}},
};

class ContactCount {
 public:
  explicit ContactCount(double within_m) : within_m_(within_m) {}
  void add(double recorded_m, double result_m) {
    const bool recorded = recorded_m < within_m_, shown = result_m < within_m_;
    recorded_ += recorded;
    shown_ += shown;
    both_ += recorded && shown;
  }
  ContactScore score() const {
    const auto share = [](double part, double of) { return of > 0 ? part / of : 0; };
    return {share(both_, shown_), share(both_, recorded_), share(2 * both_, shown_ + recorded_)};
  }

 private:
  double within_m_;
  double recorded_ = 0, shown_ = 0, both_ = 0;
};

/// Everything that is collected over the takes for one method.
struct Collected {
  ContactCount within_15cm{0.15}, within_25cm{0.25};
  HoldMetric holds{never_lost_m};
  std::vector<double> excesses_m, slides_m_s, speeds, accelerations;
  std::array<PostureChange, 2> posture{{{0, 0, 0}, {0, 0, 0}}};  ///< sums
  double floor_feet = 0, standing_feet = 0, nearest_only = 0, frames = 0, bone_error = 0;
};

std::vector<Pose> body_of_pairs(const std::vector<PairPose>& pairs, bool active) {
  std::vector<Pose> poses;
  for (const PairPose& pair : pairs)
    poses.emplace_back(pair.middleRows<joint_count>(active ? 0 : joint_count));
  return poses;
}

void collect_contacts(const std::vector<PairPose>& made, const std::vector<PairPose>& recorded,
                      const PairCapsules& capsules, Collected& all) {
  CapsuleContacts contacts;
  std::vector<CapsuleContact> overlaps;
  for (std::size_t f = 0; f < made.size(); ++f) {
    for (int a = 0; a < joint_count; ++a)
      for (int s = joint_count; s < pair_vertex_count; ++s) {
        const double was = (recorded[f].row(a) - recorded[f].row(s)).norm();
        const double is = (made[f].row(a) - made[f].row(s)).norm();
        all.within_15cm.add(was, is);
        all.within_25cm.add(was, is);
      }
    all.holds.add(made[f], recorded[f]);
    contacts.prepare(recorded[f], capsules.recorded_active, capsules.recorded_passive);
    contacts.wear(capsules.active, capsules.passive);
    double deepest_m = 0, excess_m = 0;
    contacts.measure(made[f], overlaps, deepest_m, excess_m);
    all.excesses_m.push_back(excess_m);
  }
}

/// @param scale  divides speeds and accelerations
void collect_movement(const std::vector<Pose>& poses, double fps, double scale, Collected& all) {
  MovementMetric movement(toe_rest(poses));
  for (std::size_t f = 0; f < poses.size(); ++f) movement.add(poses[f], static_cast<double>(f) / fps);
  for (const double speed : movement.speeds_m_s()) all.speeds.push_back(speed / scale);
  for (const double value : movement.accelerations_m_s2()) all.accelerations.push_back(value / scale);
  const auto& slides = movement.slide().speeds_m_s();
  all.slides_m_s.insert(all.slides_m_s.end(), slides.begin(), slides.end());
}

void collect_feet(const std::vector<Pose>& made, const std::vector<Pose>& recorded, double fps, double legs,
                  Collected& all) {
  for (const int joint : {joints::left_toe_base, joints::right_toe_base}) {
    std::vector<Vec3> path;
    for (const Pose& pose : recorded) path.push_back(joint_at(pose, joint));
    const std::vector<char> standing = standing_frames(path, fps);
    for (std::size_t f = 0; f < made.size(); ++f) {
      if (!standing[f]) continue;
      ++all.standing_feet;
      all.floor_feet += std::abs(made[f](joint, 1) - legs * recorded[f](joint, 1)) < on_floor_m;
    }
  }
}

void collect_posture(const std::vector<Pose>& made, const std::vector<Pose>& recorded, double legs,
                     PostureChange& sum) {
  for (std::size_t f = 0; f < made.size(); ++f) {
    const PostureChange change = posture_change(made[f], recorded[f], legs);
    sum.pelvis += change.pelvis;
    sum.knee_deg += change.knee_deg;
    sum.trunk_deg += change.trunk_deg;
  }
}

void collect(const std::vector<PairPose>& made, const std::vector<PairPose>& recorded, double fps,
             const PairBodies& bodies, const PairCapsules& capsules, Collected& all) {
  collect_contacts(made, recorded, capsules, all);
  for (const bool active : {true, false}) {
    const BodyChange& change = active ? bodies.active : bodies.passive;
    const std::vector<Pose> poses = body_of_pairs(made, active), before = body_of_pairs(recorded, active);
    collect_movement(poses, fps, change.legs(), all);
    collect_feet(poses, before, fps, change.legs(), all);
    collect_posture(poses, before, change.legs(), all.posture[active ? 0 : 1]);
    all.bone_error = std::max(all.bone_error, measure_bone_lengths(poses, change.to).max);
  }
  all.frames += static_cast<double>(made.size());
}

BodyFigures figures_of(const Collected& all, const Collected& recording) {
  const auto share = [](double part, double of) { return of > 0 ? part / of : 0; };
  BodyFigures figures;
  figures.within_15cm = all.within_15cm.score();
  figures.within_25cm = all.within_25cm.score();
  const HoldMetric::Figures holds = all.holds.figures();
  figures.hold_change_mean_m = holds.change_mean_m;
  figures.hold_change_p95_m = holds.change_p95_m;
  figures.penetration_excess_p99_m = percentile(all.excesses_m, 0.99);
  figures.floor_contact = share(all.floor_feet, all.standing_feet);
  figures.slide_m_s = mean(all.slides_m_s);
  figures.slide_ratio = share(figures.slide_m_s, mean(recording.slides_m_s));
  figures.speed_p99_ratio = share(percentile(all.speeds, 0.99), percentile(recording.speeds, 0.99));
  figures.acceleration_p99_ratio =
      share(percentile(all.accelerations, 0.99), percentile(recording.accelerations, 0.99));
  figures.bone_error_max = all.bone_error;
  for (std::size_t b = 0; b < figures.posture.size(); ++b) {
    const PostureChange& sum = all.posture[b];
    figures.posture[b] = {share(sum.pelvis, all.frames), share(sum.knee_deg, all.frames),
                          share(sum.trunk_deg, all.frames)};
  }
  figures.nearest_only = share(all.nearest_only, all.frames);
  return figures;
}

std::vector<PairPose> pairs_of(const RecordedPair& recorded) {
  std::vector<PairPose> pairs;
  for (std::size_t f = 0; f < recorded.active.poses.size(); ++f) {
    PairPose pair;
    pair << recorded.active.poses[f], recorded.passive.poses[f];
    pairs.push_back(pair);
  }
  return pairs;
}

PairBodies bodies_of(const RecordedPair& recorded, const BodyVariant& variant) {
  const Body active = body_of(recorded.active.poses), passive = body_of(recorded.passive.poses);
  return {{active, body_with(active, variant.active)}, {passive, body_with(passive, variant.passive)}};
}

}  // namespace

std::span<const BodyVariant> body_variants() {
  return all_variants;
}

Body body_with(const Body& body, const BodyVariant::Ratios& ratios) {
  Body other = scaled_body(body, ratios.all);
  using namespace joints;
  for (const auto& [first, last] : {std::pair{left_hip, left_toe_tip}, std::pair{right_hip, right_toe_tip}})
    for (int joint = first; joint <= last; ++joint)
      other.bone_lengths[static_cast<std::size_t>(joint - 1)] *= ratios.legs;
  for (const auto& [first, last] : {std::pair{left_elbow, left_hand}, std::pair{right_elbow, right_hand}})
    for (int joint = first; joint <= last; ++joint)
      other.bone_lengths[static_cast<std::size_t>(joint - 1)] *= ratios.arms;
  other.toe_rest_height *= ratios.legs;
  return other;
}

Result<BodyTable> measure_bodies(const std::vector<const PairedTake*>& takes, const Progress& progress,
                                 std::span<const BodyVariant> variants) {
  BodyTable table;
  table.takes = static_cast<int>(takes.size());
  Collected recording;
  for (const PairedTake* take : takes) {
    table.frames += static_cast<int>(take->a.poses.size());
    for (const Clip* clip : {&take->a, &take->b}) collect_movement(clip->poses, take->fps, 1, recording);
  }
  table.recorded_slide_m_s = mean(recording.slides_m_s);
  const double share = 1.0 / static_cast<double>(std::max<std::size_t>(1, variants.size() * takes.size()));
  double done = 0;
  for (const BodyVariant& variant : variants) {
    std::array<Collected, body_method_count> collected;
    for (const PairedTake* take : takes) {
      const RecordedPair recorded = recorded_pair_of(*take);
      const PairBodies bodies = bodies_of(recorded, variant);
      const auto ours = retarget_pair(recorded, bodies, part(progress, done, done + 0.6 * share));
      if (!ours) return ours.error();
      const std::vector<PairPose> pairs = pairs_of(recorded);
      const auto measure = [&](BodyMethod method, const std::vector<PairPose>& made) {
        collect(made, pairs, recorded.active.fps, bodies, ours->capsules,
                collected[static_cast<std::size_t>(method)]);
      };
      std::vector<PairPose> made;
      for (const RetargetedFrame& frame : ours->frames) {
        made.push_back(frame.pose);
        collected.front().nearest_only += frame.is_nearest_only();
      }
      measure(BodyMethod::Retargeted, made);
      const LivePair live = shown_live(recorded, bodies, ours->capsules);
      measure(BodyMethod::Live, live.poses);
      collected[static_cast<std::size_t>(BodyMethod::Live)].nearest_only += live.nearest_only;
      measure(BodyMethod::AnglesCopied, rebuilt_on_path(recorded, bodies));
      measure(BodyMethod::NoMesh, by_inverse_kinematics(recorded, bodies));
      if (!report(progress, done + 0.7 * share, "measuring bodies")) return Error{"cancelled", take->name};
      measure(BodyMethod::PaperMesh, by_mesh_of_the_paper(recorded, bodies));
      done += share;
      if (!report(progress, done, "measuring bodies")) return Error{"cancelled", take->name};
    }
    BodyRow row{std::string(variant.name), variant.has_marks, {}};
    for (std::size_t m = 0; m < collected.size(); ++m) row.methods[m] = figures_of(collected[m], recording);
    table.rows.push_back(row);
  }
  return table;
}

}  // namespace abrazo
