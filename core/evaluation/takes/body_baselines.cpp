#include "core/evaluation/takes/body_baselines.hpp"

#include "core/metrics/foot_slide.hpp"
#include "core/motion/body/joint_set.hpp"
#include "core/retarget/body_retargeter.hpp"
#include "core/synthesis/edit/pair_editor.hpp"

namespace abrazo {

namespace {

struct Arm {
  int shoulder, elbow, wrist, hand;
};
constexpr std::array<Arm, 2> both_arms = {
    {{joints::left_shoulder, joints::left_elbow, joints::left_wrist, joints::left_hand},
     {joints::right_shoulder, joints::right_elbow, joints::right_wrist, joints::right_hand}}};

Pose reaching(Pose pose, const Pose& recorded, const Body& body, double path) {
  const auto length = [&](int joint) { return body.bone_lengths[static_cast<std::size_t>(joint - 1)]; };
  for (const Arm& arm : both_arms) {
    const Vec3 wrist_to_hand = pose.row(arm.hand) - pose.row(arm.wrist);
    Vec3 wrist = path * joint_at(recorded, arm.hand) - wrist_to_hand;
    const Vec3 elbow = two_bone_joint(joint_at(pose, arm.shoulder), wrist, length(arm.elbow),
                                      length(arm.wrist), joint_at(pose, arm.elbow));
    pose.row(arm.elbow) = elbow.transpose();
    pose.row(arm.wrist) = wrist.transpose();
    pose.row(arm.hand) = (wrist + wrist_to_hand).transpose();
  }
  return pose;
}

FootLocks::Situations feet_of(const Pose& active, const ToeRest& active_rest, const Body& active_body,
                              const Pose& passive, const ToeRest& passive_rest, const Body& passive_body) {
  FootLocks::Situations feet;
  for (std::size_t foot = 0; foot < feet.size(); ++foot) {
    const bool of_active = foot < 2, left = foot % 2 == 0;
    const Pose& pose = of_active ? active : passive;
    const double rest = (of_active ? active_rest : passive_rest)[left ? 0 : 1];
    FootSituation& now = feet[foot];
    now.toe_base = joint_at(pose, left ? joints::left_toe_base : joints::right_toe_base);
    now.hip = joint_at(pose, left ? joints::left_hip : joints::right_hip);
    now.leg_length = (of_active ? active_body : passive_body).leg_length();
    now.landed = now.toe_base.y() < rest + landed_below_m;
  }
  return feet;
}

}  // namespace

std::vector<PairPose> by_inverse_kinematics(const RecordedPair& recorded, const PairBodies& bodies) {
  std::vector<PairPose> poses = rebuilt_on_steps(recorded, bodies);
  const double path = path_scale(bodies);
  for (std::size_t frame = 0; frame < poses.size(); ++frame) {
    const Pose active =
        reaching(poses[frame].topRows<joint_count>(), recorded.active.poses[frame], bodies.active.to, path);
    const Pose passive = reaching(poses[frame].bottomRows<joint_count>(), recorded.passive.poses[frame],
                                  bodies.passive.to, path);
    poses[frame] << active, passive;
  }
  return poses;
}

std::vector<PairPose> by_mesh_of_the_paper(const RecordedPair& recorded, const PairBodies& bodies) {
  const Settings settings = *preset("paper");
  const double elapsed_s = 1 / recorded.active.fps;
  const PairCapsules capsules = capsules_of(recorded, bodies);
  const BodyRetargeter retargeter(bodies.active.from, bodies.active.to);
  const std::vector<PairPose> rebuilt = rebuilt_on_path(recorded, bodies);
  std::vector<Pose> users;
  for (const Pose& pose : recorded.active.poses) users.push_back(retargeter.apply(pose));
  const ToeRest user_rest = toe_rest(users), partner_rest = toe_rest(recorded.passive.poses);

  PairEditor editor;
  FootLocks locks;
  std::vector<PairPose> poses;
  for (std::size_t frame = 0; frame < users.size(); ++frame) {
    EditTask task;
    task.selected << recorded.active.poses[frame], recorded.passive.poses[frame];
    const InteractionMesh mesh = tetrahedralize(task.selected);
    task.selected.rowwise() += along_floor(joint_at(users[frame], joints::Root) -
                                           joint_at(recorded.active.poses[frame], joints::Root))
                                   .transpose();
    task.edges = mesh.edges;
    task.reference = task.selected;
    task.target = users[frame];
    task.has_previous = !poses.empty();
    if (task.has_previous) task.velocity_target = poses.back();
    task.velocity_weight = velocity_weight_at(settings, elapsed_s);
    task.wanted = rigid_distances(rebuilt[frame]);
    task.anchor_weight = settings.anchor_weight;
    task.active_radii = &capsules.active;
    task.passive_radii = &capsules.passive;
    locks.update(feet_of(users[frame], user_rest, bodies.active.to, task.selected.bottomRows<joint_count>(),
                         partner_rest, bodies.passive.to),
                 poses.empty() ? nullptr : &poses.back(), false);
    const bool solved = editor.edit(task, settings, locks).solved;
    if (!solved) locks.reset();
    poses.push_back(solved ? editor.result() : poses.empty() ? rebuilt[frame] : poses.back());
  }
  return poses;
}

}  // namespace abrazo
