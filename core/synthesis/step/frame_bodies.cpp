// The part of FramePipeline that shows the solved pair on the chosen bodies.

#include <algorithm>
#include <cmath>

#include "core/motion/body/body_choice.hpp"
#include "core/motion/body/joint_set.hpp"
#include "core/synthesis/frames/frame_room.hpp"
#include "core/synthesis/motion/body_shape.hpp"
#include "core/synthesis/step/frame_pipeline.hpp"

namespace abrazo {
namespace {

/// Relative; tracking stretches bones, and up to this the user's pose is shown as it is.
constexpr double tracked_bone_error = 5e-4;

/// The pose with the lengths of `body` where its own are others: those that a tracked user has in this frame.
Pose with_bones_of(const Body& body, const Pose& pose) {
  double largest = 0;
  for (int b = 0; b < bone_count; ++b) {
    const double wanted = body.bone_lengths[static_cast<std::size_t>(b)];
    const auto [from, to] = bone(b);
    if (wanted > 1e-6)
      largest = std::max(largest, std::abs((pose.row(from) - pose.row(to)).norm() - wanted) / wanted);
  }
  if (largest <= tracked_bone_error) return pose;
  const RootFrame root = root_frame(pose);
  return placed_body(shape_of(to_normalized(pose, root), root.position.y()), body, root);
}

}  // namespace

/// With the library's bodies for both, the solved pair is shown as it is.
void FramePipeline::show(const Pose& user, double dt_s) {
  const bool user_is_active = settings_.user_role == UserRole::Active;
  const BodyChoice& of_user = user_is_active ? settings_.active_body : settings_.passive_body;
  const BodyChoice& of_partner = user_is_active ? settings_.passive_body : settings_.active_body;
  const bool wants_library =
      of_user.kind == BodyChoice::Kind::Library && of_partner.kind == BodyChoice::Kind::Library;
  ShownMemory& shown = next_.shown;
  const bool at_once = !next_.partner_is_shown || (wants_library && !shown.is_fitted);
  const auto follow = [&](GlidingBody& body, const BodyChoice& choice, const Body& recorded) {
    body.follow(body_of_choice(choice, recorded, next_.user.body()), choice.kind == BodyChoice::Kind::User,
                dt_s, at_once);
  };
  follow(shown.bodies[0], of_user, library_->usual_active_body().body);
  follow(shown.bodies[1], of_partner, library_->usual_passive_body().body);
  if (!wants_library || !shown.bodies[0].is_there() || !shown.bodies[1].is_there()) {
    show_on_bodies(user, dt_s);
  } else if (shown.is_fitted) {
    out_.result = returning_to(out_.result, dt_s, shown);
    out_.morph_steps.push_back(out_.result);
  }
}

void FramePipeline::show_on_bodies(const Pose& user, double dt_s) {
  ShownMemory& shown = next_.shown;
  const LibraryBody& active = library_->usual_active_body();
  const LibraryBody& passive = library_->usual_passive_body();
  const BodyRetargeter on_body(*next_.user.body(), shown.bodies[0].now(), settings_.scale_root_path);
  const Pose target = with_bones_of(shown.bodies[0].now(), on_body.apply(user));
  const ShownTask task{.edges = out_.edges,
                       .solved = editor_.result(),
                       .user = target,
                       .path = on_body.path_scale() / retargeter_->path_scale(),
                       .recorded = {&active.body, &passive.body},
                       .radii = {&active.capsule_radii, &passive.capsule_radii},
                       .holds = out_.holds,
                       .elapsed_s = dt_s,
                       .continues = next_.partner_is_shown,
                       .pose_weight = settings_.morph_weight};
  const PairFit::Outcome& outcome = shown_.fit(task, shown);
  // As a failed frame after it adds them up, so that it holds this pose to the bit.
  out_.result = editor_.result() + shown.difference;
  out_.morph_steps.push_back(out_.result);
  out_.residual.bone_length_max = outcome.bone_error;
  shown_.contacts().measure(outcome.pose, out_.collisions, out_.residual.penetration_max_m,
                            out_.residual.excess_penetration_max_m);
  if (shown_.shortfall().empty()) return;
  out_.status = StepStatus::Relaxed;
  if (!out_.message.empty()) out_.message.append("; ");
  out_.message.append(shown_.shortfall());
}

}  // namespace abrazo
