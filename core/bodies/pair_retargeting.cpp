#include "core/bodies/pair_retargeting.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "core/base/parallel.hpp"
#include "core/bodies/foot_steps.hpp"
#include "core/library/build/capsule_calibration.hpp"
#include "core/motion/body/girth.hpp"
#include "core/motion/body/joint_set.hpp"
#include "core/motion/body/smooth_window.hpp"

namespace abrazo {

namespace {

constexpr double smoothed_over_s = 0.1;  ///< to either side
constexpr double planned_foot = 200;     ///< weight of a foot on its planned path, in the air too
constexpr std::size_t block_frames = 32;

/// The frames of a take, and what is planned for them.
struct Plan {
  const RecordedPair* recorded;
  PairBodies bodies;
  double path = 1;                                ///< scale of the common path
  std::vector<InteractionMesh> meshes;            ///< per frame
  std::array<std::vector<char>, 4> standing;      ///< per foot and frame
  std::array<std::vector<Vec3>, 4> foot_offsets;  ///< against its recorded path, scaled with the legs; y is 0
  std::vector<PairPose> rebuilt;                  ///< with the feet as planned
  std::vector<PairPose> smoothed;                 ///< empty before the last fit

  std::size_t frames() const { return recorded->active.poses.size(); }
  const Pose& pose(bool active, std::size_t frame) const {
    return (active ? recorded->active : recorded->passive).poses[frame];
  }
  const BodyChange& change(bool active) const { return active ? bodies.active : bodies.passive; }
};

bool is_active(std::size_t foot) {
  return foot < 2;
}
int toe_base_joint(std::size_t foot) {
  return foot % 2 == 0 ? joints::left_toe_base : joints::right_toe_base;
}

PairPose recorded_pair(const Plan& plan, std::size_t frame) {
  PairPose pair;
  pair << plan.pose(true, frame), plan.pose(false, frame);
  return pair;
}

Vec3 offset_of_path(const Plan& plan, bool active, std::size_t frame) {
  return (plan.path - plan.change(active).legs()) *
         along_floor(joint_at(plan.pose(active, frame), joints::Root));
}

/// Both bodies over their feet: what moves the feet moves the body by their mean.
void rebuild(Plan& plan) {
  plan.rebuilt.resize(plan.frames());
  for (std::size_t frame = 0; frame < plan.frames(); ++frame)
    for (const bool active : {true, false}) {
      const BodyChange& change = plan.change(active);
      const Pose& recorded = plan.pose(active, frame);
      const std::size_t left = active ? 0 : 2;
      const std::array<Vec3, 2> offsets = {plan.foot_offsets[left][frame],
                                           plan.foot_offsets[left + 1][frame]};
      ToeBases feet = toe_bases(recorded);
      for (std::size_t side = 0; side < 2; ++side) feet[side] = change.legs() * feet[side] + offsets[side];
      const Vec3 place = change.legs() * joint_at(recorded, joints::Root) + 0.5 * (offsets[0] + offsets[1]);
      plan.rebuilt[frame].middleRows<joint_count>(active ? 0 : joint_count) =
          standing_at(rebuilt(recorded, change, place), change.to, feet);
    }
}

bool make_meshes(Plan& plan, const Progress& progress) {
  plan.meshes.resize(plan.frames());
  return for_each_row(plan.frames(), block_frames, progress, "meshing", [&](std::size_t frame) {
    plan.meshes[frame] = tetrahedralize(recorded_pair(plan, frame));
  });
}

bool fit_frames(const Plan& plan, const PairCapsules& capsules, FitWeights weights, bool stand,
                const Progress& progress, std::string_view doing, std::vector<PairFit::Outcome>& outcomes) {
  if (stand) weights.foot = planned_foot;
  outcomes.resize(plan.frames());
  const std::size_t blocks = (plan.frames() + block_frames - 1) / block_frames;
  return for_each_row(blocks, 1, progress, doing, [&](std::size_t block) {
    PairFit fit(capsules, weights);
    FitTask task;
    for (std::size_t frame = block * block_frames;
         frame < std::min(plan.frames(), (block + 1) * block_frames); ++frame) {
      task.edges = plan.meshes[frame].edges;
      task.recorded = recorded_pair(plan, frame);
      task.rebuilt = plan.rebuilt[frame];
      for (std::size_t foot = 0; foot < 4; ++foot) task.stands[foot] = stand && plan.standing[foot][frame];
      task.smoothed = plan.smoothed.empty() ? nullptr : &plan.smoothed[frame];
      outcomes[frame] = fit.fit(task);
    }
  });
}

/// Feet stand where the fitted bodies put them on average.
void plan_steps(const std::vector<PairFit::Outcome>& fitted, Plan& plan) {
  for (std::size_t foot = 0; foot < 4; ++foot) {
    const bool active = is_active(foot);
    std::vector<Vec3> wanted(plan.frames());
    for (std::size_t frame = 0; frame < plan.frames(); ++frame) {
      const int joint = toe_base_joint(foot);
      const Vec3 at = fitted[frame].pose.row(joint + (active ? 0 : joint_count));
      wanted[frame] =
          along_floor(at - plan.change(active).legs() * joint_at(plan.pose(active, frame), joint));
    }
    plan.foot_offsets[foot] = stepwise(wanted, plan.standing[foot]);
  }
}

void smooth(const std::vector<PairFit::Outcome>& fitted, double fps, Plan& plan) {
  std::vector<PairPose> changes(plan.frames());
  for (std::size_t frame = 0; frame < plan.frames(); ++frame)
    changes[frame] = fitted[frame].pose - plan.rebuilt[frame];
  const int half_width = static_cast<int>(std::lround(smoothed_over_s * fps));
  plan.smoothed = half_width > 0 ? hann_mean(changes, half_width) : changes;
  for (std::size_t frame = 0; frame < plan.frames(); ++frame) plan.smoothed[frame] += plan.rebuilt[frame];
}

Plan planned(const RecordedPair& recorded, const PairBodies& bodies) {
  Plan plan{.recorded = &recorded,
            .bodies = bodies,
            .path = path_scale(bodies),
            .meshes = {},
            .standing = {},
            .foot_offsets = {},
            .rebuilt = {},
            .smoothed = {}};
  for (std::size_t foot = 0; foot < 4; ++foot) {
    std::vector<Vec3> path;
    for (std::size_t frame = 0; frame < plan.frames(); ++frame) {
      path.push_back(joint_at(plan.pose(is_active(foot), frame), toe_base_joint(foot)));
      plan.foot_offsets[foot].push_back(offset_of_path(plan, is_active(foot), frame));
    }
    plan.standing[foot] = standing_frames(path, recorded.active.fps);
  }
  return plan;
}

void measure_holds(const PairPose& recorded, RetargetedFrame& made) {
  for (const HandEnds& hands : all_hand_ends) {
    if (!hands_hold(recorded, hands)) continue;
    const double change_m = std::abs(hands_apart(made.pose, hands) - hands_apart(recorded, hands));
    if (made.holds++ > 0 && change_m <= made.hold_change_m) continue;
    made.hold_change_m = change_m;
    made.changed_hold = hands;
  }
}

Clip clip_of(const RetargetedPair& pair, const std::string& name, int first_vertex) {
  Clip clip{name, pair.recorded.active.fps, {}};
  for (const RetargetedFrame& frame : pair.frames)
    clip.poses.push_back(frame.pose.middleRows<joint_count>(first_vertex));
  return clip;
}

}  // namespace

bool RetargetedFrame::is_nearest_only() const {
  return let_go != PairFit::LetGo::Nothing || hold_change_m > reachable_m;
}

std::string RetargetedFrame::shortfall() const {
  if (!is_nearest_only()) return "";
  std::string text;
  if (let_go == PairFit::LetGo::Capsules)
    text = fmt::format("bodies overlap by {:.0f} mm more", 1000 * excess_m);
  if (let_go == PairFit::LetGo::StandingFeet)
    text = fmt::format("feet slip by {:.0f} mm", 1000 * foot_drift_m);
  if (let_go == PairFit::LetGo::Everything) text = "the relation of the bodies could not be met";
  if (hold_change_m > reachable_m)
    text += fmt::format(
        "{}the active body's {} hand and the passive body's {} hand are out of reach by {:.0f} mm",
        text.empty() ? "" : ", ", changed_hold.active == joints::left_hand ? "left" : "right",
        changed_hold.passive == joints::left_hand ? "left" : "right", 1000 * hold_change_m);
  return "nearest pose, " + text;
}

Clip RetargetedPair::active() const {
  return clip_of(*this, "active", 0);
}

Clip RetargetedPair::passive() const {
  return clip_of(*this, "passive", joint_count);
}

PairCapsules capsules_of(const RecordedPair& recorded, const PairBodies& bodies) {
  PairedTake take;
  take.a = recorded.active;
  take.b = recorded.passive;
  const auto radii = calibrate_capsules(std::array{take}, std::array{TakeBodies{0, 1}},
                                        std::array{bodies.active.from, bodies.passive.from});
  PairCapsules capsules{radii[0], radii[1], radii[0], radii[1]};
  for (double& radius : capsules.active) radius *= girth(bodies.active.from, bodies.active.to);
  for (double& radius : capsules.passive) radius *= girth(bodies.passive.from, bodies.passive.to);
  return capsules;
}

double path_scale(const PairBodies& bodies) {
  return 0.5 * (bodies.active.legs() + bodies.passive.legs());
}

std::vector<PairPose> rebuilt_on_steps(const RecordedPair& recorded, const PairBodies& bodies) {
  Plan plan = planned(recorded, bodies);
  for (std::size_t foot = 0; foot < 4; ++foot)
    plan.foot_offsets[foot] = stepwise(plan.foot_offsets[foot], plan.standing[foot]);
  rebuild(plan);
  return std::move(plan.rebuilt);
}

std::vector<PairPose> rebuilt_on_path(const RecordedPair& recorded, const PairBodies& bodies) {
  const double path = path_scale(bodies);
  std::vector<PairPose> poses;
  for (std::size_t frame = 0; frame < recorded.active.poses.size(); ++frame) {
    const Pose &active = recorded.active.poses[frame], &passive = recorded.passive.poses[frame];
    PairPose pose;
    pose << rebuilt(active, bodies.active, path * joint_at(active, joints::Root)),
        rebuilt(passive, bodies.passive, path * joint_at(passive, joints::Root));
    poses.push_back(pose);
  }
  return poses;
}

Result<RetargetedPair> retarget_pair(RecordedPair recorded, const PairBodies& bodies,
                                     const Progress& progress, const FitWeights& weights) {
  if (recorded.active.poses.empty() || recorded.active.poses.size() != recorded.passive.poses.size())
    throw std::invalid_argument("retarget_pair: a pair has as many poses of both bodies, and at least one");
  RetargetedPair result{std::move(recorded), bodies, {}, {}};
  Plan plan = planned(result.recorded, bodies);
  result.capsules = capsules_of(result.recorded, bodies);
  result.frames.resize(plan.frames());
  std::vector<PairFit::Outcome> fitted;
  if (bodies.active.changes() || bodies.passive.changes()) {
    const Error cancelled{"cancelled", result.recorded.name};
    const auto fit = [&](bool stand, double from, double to, std::string_view doing) {
      return fit_frames(plan, result.capsules, weights, stand, part(progress, from, to), doing, fitted);
    };
    if (!make_meshes(plan, part(progress, 0, 0.1))) return cancelled;
    rebuild(plan);
    if (!fit(false, 0.1, 0.4, "fitting the bodies")) return cancelled;
    plan_steps(fitted, plan);
    rebuild(plan);
    if (!fit(true, 0.4, 0.7, "fitting the steps")) return cancelled;
    smooth(fitted, result.recorded.active.fps, plan);
    if (!fit(true, 0.7, 1, "smoothing")) return cancelled;
  }
  for (std::size_t frame = 0; frame < plan.frames(); ++frame) {
    RetargetedFrame& made = result.frames[frame];
    const PairPose of_recording = recorded_pair(plan, frame);
    made.pose = fitted.empty() ? of_recording : fitted[frame].pose;
    for (std::size_t foot = 0; foot < 4; ++foot) made.stands[foot] = plan.standing[foot][frame] != 0;
    measure_holds(of_recording, made);
    if (fitted.empty()) continue;
    made.let_go = fitted[frame].let_go;
    made.bone_error = fitted[frame].bone_error;
    made.foot_drift_m = fitted[frame].foot_drift_m;
    made.excess_m = fitted[frame].excess_m;
  }
  return result;
}

}  // namespace abrazo
