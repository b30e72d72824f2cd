#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>

#include "core/motion/body/body.hpp"
#include "core/motion/body/clip.hpp"
#include "core/motion/scenes/character_skin.hpp"
#include "core/motion/scenes/humanoid_rig.hpp"
#include "core/motion/scenes/rig_motion.hpp"

namespace abrazo {

/// A humanoid character (GLB, VRM 0.x or 1.0) that is shown as the skin of a body.
struct WornCharacter {
  std::string file;
  std::shared_ptr<const HumanoidRig> rig;
  CharacterSkin skin;
};

/// A character on the poses of a body, at the body's place and of the size at which its legs are as long as
/// the body's. @see RigMotion
class CharacterFit {
 public:
  /// @param stance  of the performer, or of one of other size
  CharacterFit(std::shared_ptr<const WornCharacter> character, const Stance& stance);

  const WornCharacter& character() const { return *character_; }
  /// Fits the points of the skin to a pose. Twists continue from the pose before; a jump in time and a body
  /// of other lengths begin anew, otherwise there is no allocation.
  /// @param time_s  of the pose
  /// @param points, normals  3 numbers for each point of the skin
  void fit(const Pose& pose, double time_s, std::span<float> points, std::span<float> normals);

 private:
  void begin(const Pose& pose);

  std::shared_ptr<const WornCharacter> character_;
  std::optional<RigMotion> motion_;
  Stance stance_;
  SkinShape shape_;
  Body body_;  ///< for which the motion was begun
  double time_s_ = 0;
};

}  // namespace abrazo
