#include "core/motion/scenes/worn_character.hpp"

#include <cmath>

#include "core/base/atomic_file.hpp"
#include "core/motion/scenes/glb_file.hpp"
#include "core/motion/scenes/read_worn_character.hpp"

namespace abrazo {

namespace {

/// Of bone lengths; results keep theirs to 0.1 %.
constexpr double same_body = 0.01;
constexpr double longest_step_s = 0.5;

bool is_of_body(const Pose& pose, const Body& body) {
  for (int b = 0; b < bone_count; ++b) {
    const double length = body.bone_lengths[static_cast<std::size_t>(b)];
    const double now = (pose.row(bone(b).first) - pose.row(bone(b).second)).norm();
    if (!(std::abs(now - length) <= same_body * length + 0.001)) return false;
  }
  return true;
}

}  // namespace

Result<std::shared_ptr<const WornCharacter>> read_worn_character(const std::string& file) {
  const auto content = read_whole_file(file);
  if (!content) return content.error();
  const auto glb = parse_glb(*content, file);
  if (!glb) return glb.error();
  auto rig = read_humanoid_rig(*glb, file);
  if (!rig) return rig.error();
  auto skin = read_character_skin(*glb, *rig, file);
  if (!skin) return skin.error();
  return std::make_shared<const WornCharacter>(
      WornCharacter{file, std::make_shared<const HumanoidRig>(std::move(*rig)), std::move(*skin)});
}

CharacterFit::CharacterFit(std::shared_ptr<const WornCharacter> character, const Stance& stance)
    : character_(std::move(character)), stance_(stance), shape_(character_->skin) {}

void CharacterFit::begin(const Pose& pose) {
  Clip clip;
  clip.poses = {pose};
  body_ = body_of(pose);
  motion_.emplace(character_->rig, clip,
                  place_on_rig(*character_->rig, stance_.with_legs(body_.leg_length())));
}

void CharacterFit::fit(const Pose& pose, double time_s, std::span<float> points, std::span<float> normals) {
  const double step_s = time_s - time_s_;
  const bool continues = motion_ && step_s >= 0 && step_s < longest_step_s && is_of_body(pose, body_);
  if (!continues) begin(pose);
  motion_->set_pose(pose, continues ? step_s : 0);
  time_s_ = time_s;
  shape_.place(character_->skin, motion_->world(), 1 / motion_->place().path, points, normals);
}

}  // namespace abrazo
