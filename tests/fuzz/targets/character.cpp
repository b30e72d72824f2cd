#include <array>
#include <memory>
#include <string>

#include "core/motion/scenes/character_glb.hpp"
#include "core/motion/scenes/character_skin.hpp"
#include "core/motion/scenes/glb_file.hpp"
#include "core/motion/scenes/humanoid_rig.hpp"
#include "core/motion/scenes/rig_motion.hpp"
#include "tests/fuzz/fuzz_target.hpp"
#include "tests/support/bodies.hpp"

namespace fuzz = abrazo::fuzz;

namespace {

using namespace abrazo;

Clip two_poses() {
  Clip clip;
  clip.fps = 60;
  clip.poses = {test::standing_pose(), test::moved(test::standing_pose(), 0.3, {0.2, 0, -0.1})};
  return clip;
}

void expect_consistent(const CharacterSkin& skin, std::size_t nodes) {
  fuzz::expect(skin.normals.size() == skin.points.size() && skin.shares.size() == skin.points.size() &&
                   skin.colours.size() == skin.points.size(),
               "each point has all that is known of it");
  for (const auto& triangle : skin.triangles)
    for (const std::int32_t corner : triangle)
      fuzz::expect(corner >= 0 && static_cast<std::size_t>(corner) < skin.points.size(),
                   "a triangle's corners exist");
  for (const CharacterSkin::Carrier& carrier : skin.carriers)
    fuzz::expect(carrier.node >= 0 && static_cast<std::size_t>(carrier.node) < nodes, "a carrier is a node");
  for (std::size_t p = 0; p < skin.points.size(); ++p) {
    fuzz::expect(skin.points[p].allFinite() && skin.normals[p].allFinite(), "points are finite");
    float sum = 0;
    for (std::size_t c = 0; c < 4; ++c) {
      fuzz::expect(skin.shares[p].carriers[c] < skin.carriers.size(), "a point's carriers exist");
      sum += skin.shares[p].weights[c];
    }
    fuzz::expect(sum > 0.999F && sum < 1.001F, "the weights of a point add up to 1");
  }
}

/// The character in a pose of the scene.
void show(const CharacterSkin& skin, const std::shared_ptr<const HumanoidRig>& rig, const Clip& clip) {
  RigMotion motion(rig, clip, place_on_rig(*rig, stance_of(clip.poses)));
  motion.set_pose(clip.poses.back(), 1 / clip.fps);
  std::vector<float> points(3 * skin.points.size()), normals(points.size());
  SkinShape shape(skin);
  shape.place(skin, motion.world(), 1, points, normals);
}

}  // namespace

ABRAZO_FUZZ_TARGET(character)(fuzz::Bytes bytes) {
  static const std::array clips = {two_poses()};
  const auto glb = parse_glb(fuzz::text_of(bytes), "input.glb");
  if (!fuzz::accepted(glb)) return;
  auto rig = read_humanoid_rig(*glb, "input.glb");
  if (!fuzz::accepted(rig)) return;
  const auto shared = std::make_shared<const HumanoidRig>(std::move(*rig));
  const auto skin = read_character_skin(*glb, *shared, "input.glb");
  if (fuzz::accepted(skin)) {
    expect_consistent(*skin, shared->nodes.size());
    show(*skin, shared, clips.front());
  }
  const auto performed = write_character_glbs(fuzz::text_of(bytes), clips, "input.glb");
  if (!fuzz::accepted(performed)) return;
  const auto again = parse_glb(performed->front(), "written.glb");
  fuzz::expect(again.ok() && read_humanoid_rig(*again, "written.glb").ok(), "what is written is read again");
}
