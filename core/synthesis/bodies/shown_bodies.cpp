#include "core/synthesis/bodies/shown_bodies.hpp"

#include <algorithm>
#include <cmath>

#include "core/motion/body/girth.hpp"
#include "core/motion/body/joint_set.hpp"
#include "core/synthesis/motion/transition.hpp"

namespace abrazo {

namespace {

constexpr double usual_step_s = 1.0 / 60;
constexpr double hold_weight = 200;
constexpr double own_pose = 1.2;  ///< of w_C: the relations weigh more here, and the user stays where he is
constexpr double foot_weight = 20000;  ///< of a toe base on the floor, at its rebuilt place
constexpr double foot_height_m = 0.04;
/// A foot changes its offset as it moves, by 63 % on this way: a standing foot stands, a sliding one slides.
constexpr double foot_way_m = 0.15;
constexpr double shift_rate = 6;       ///< [1/s]
constexpr double least_relation = 10;  ///< weight against those of near joints: far bodies are not shifted
constexpr double farthest_shift_m = 0.6;
constexpr double returns_s = 0.5;
constexpr double hold_opens_m = 0.05;
/// In the order of `all_hand_ends`.
constexpr std::array<std::string_view, 4> out_of_reach = {
    "nearest pose: the user's left hand and the partner's left hand are out of reach",
    "nearest pose: the user's left hand and the partner's right hand are out of reach",
    "nearest pose: the user's right hand and the partner's left hand are out of reach",
    "nearest pose: the user's right hand and the partner's right hand are out of reach"};

/// Frames come one by one, so smoothing costs lag: less of it than offline, where it looks both ways. One
/// body is given, so the other gives way alone: all that it has to keep counts more.
FitWeights live_weights() {
  FitWeights weights;
  weights.smooth = 10;
  weights.relation.contact *= 2;
  weights.relation.near *= 2;
  weights.posture.legs *= 4;
  weights.posture.trunk *= 2;
  return weights;
}

}  // namespace

ShownBodies::ShownBodies() : fit_(PairCapsules{}, live_weights()) {}

/// Where the partner had to be moved for near joints of both bodies to keep their relation, horizontally.
/// @param partner  rebuilt without a shift
Vec3 ShownBodies::wanted_shift(const ShownTask& task, const Pose& partner) const {
  static const RelationWeights relation;
  Vec3 sum = Vec3::Zero();
  double weights = least_relation;
  for (int a = 0; a < joint_count; ++a)
    for (int s = 0; s < joint_count; ++s) {
      const Eigen::RowVector3d kept = task.solved.row(s + joint_count) - task.solved.row(a);
      const double weight = relation_weight(relation, kept.norm());
      if (weight <= 0) continue;
      sum += weight * (kept - (partner.row(s) - task.user.row(a))).transpose();
      weights += weight;
    }
  const Vec3 shift = along_floor(sum / weights);
  const double far = shift.norm();
  return far > farthest_shift_m ? Vec3(farthest_shift_m / far * shift) : shift;
}

void ShownBodies::rebuild(const ShownTask& task, ShownMemory& memory) {
  const BodyChange change{*task.recorded[1], memory.bodies[1].now()};
  const Pose partner = task.solved.bottomRows<joint_count>();
  const Vec3 root = joint_at(partner, joints::Root);
  const Pose unshifted = rebuilt(partner, change, task.path * root);
  const Vec3 wanted = wanted_shift(task, unshifted);
  const double share = task.continues ? 1 - std::exp(-shift_rate * task.elapsed_s) : 1;
  memory.shift += share * (wanted - memory.shift);

  ToeBases feet = toe_bases(partner);
  for (std::size_t f = 0; f < feet.size(); ++f) {
    const Vec3 moved = along_floor(feet[f] - memory.feet[f]);
    memory.feet[f] = feet[f];
    const Vec3 offset = memory.shift + (change.legs() - task.path) * along_floor(feet[f] - root);
    const double changed = task.continues ? 1 - std::exp(-moved.norm() / foot_way_m) : 1;
    memory.foot_offsets[f] += changed * (offset - memory.foot_offsets[f]);
    const double over_rest = feet[f].y() - change.from.toe_rest_height;
    feet[f] = task.path * along_floor(feet[f]) + memory.foot_offsets[f];
    feet[f].y() = change.to.toe_rest_height + change.legs() * over_rest;
  }
  Pose shifted = unshifted;
  shifted.rowwise() += memory.shift.transpose();
  task_.rebuilt << task.user, standing_at(shifted, change.to, feet);
}

/// The nearer to the floor, the more a foot stays on its path; continuous, so that nothing jumps when it
/// lands.
void ShownBodies::weigh_feet(const ShownMemory& memory) {
  for (std::size_t foot = 0; foot < task_.foot_weights.size(); ++foot) {
    const int joint =
        (foot % 2 == 0 ? joints::left_toe_base : joints::right_toe_base) + (foot < 2 ? 0 : joint_count);
    const double rest = memory.bodies[foot / 2].now().toe_rest_height;
    const double over_rest = std::max(0.0, task_.rebuilt(joint, 1) - rest) / foot_height_m;
    task_.foot_weights[foot] = foot_weight * std::exp(-over_rest * over_rest);
  }
}

void ShownBodies::judge(const ShownTask& task) {
  using LetGo = PairFit::LetGo;
  shortfall_ = {};
  for (const HandEnds& hands : all_hand_ends)
    if (hands_hold(task.solved, hands) &&
        std::abs(hands_apart(outcome_.pose, hands) - hands_apart(task.solved, hands)) > hold_opens_m)
      shortfall_ = out_of_reach[static_cast<std::size_t>(&hands - all_hand_ends.data())];
  if (outcome_.let_go == LetGo::Capsules)
    shortfall_ = "nearest pose: these bodies overlap more than the recorded ones";
  if (outcome_.let_go > LetGo::Capsules)
    shortfall_ = "nearest pose: these bodies cannot meet the relation of the recorded ones";
}

const PairFit::Outcome& ShownBodies::fit(const ShownTask& task, ShownMemory& memory) {
  rebuild(task, memory);
  PairCapsules capsules{*task.radii[0], *task.radii[1], *task.radii[0], *task.radii[1]};
  for (double& radius : capsules.active) radius *= girth(*task.recorded[0], memory.bodies[0].now());
  for (double& radius : capsules.passive) radius *= girth(*task.recorded[1], memory.bodies[1].now());
  fit_.wear(capsules);

  task_.edges = task.edges;
  task_.recorded = task.solved;
  task_.given = own_pose * task.pose_weight;
  task_.holds = task.holds;
  task_.hold_weight = hold_weight;
  weigh_feet(memory);
  if (task.continues) {
    const PairPose change = memory.is_fitted ? memory.change : PairPose(task.solved - task_.rebuilt);
    smoothed_ = task_.rebuilt + change;
    task_.smooth_share = task.elapsed_s > 0 ? std::min(4.0, usual_step_s / task.elapsed_s) : 1;
  }
  task_.smoothed = task.continues ? &smoothed_ : nullptr;
  outcome_ = fit_.fit(task_);
  judge(task);
  memory.change = outcome_.pose - task_.rebuilt;
  memory.difference = outcome_.pose - task.solved;
  memory.is_fitted = true;
  memory.leaves_s = 0;
  return outcome_;
}

PairPose returning_to(const PairPose& solved, double elapsed_s, ShownMemory& memory) {
  const double before = quintic_fade(memory.leaves_s / returns_s);
  memory.leaves_s += elapsed_s;
  if (memory.leaves_s >= returns_s || before <= 0) {
    const auto bodies = memory.bodies;
    memory = {};
    memory.bodies = bodies;
    return solved;
  }
  memory.difference *= quintic_fade(memory.leaves_s / returns_s) / before;
  return solved + memory.difference;
}

}  // namespace abrazo
