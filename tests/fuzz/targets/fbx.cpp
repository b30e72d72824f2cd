#include "core/motion/scenes/assimp_scene.hpp"
#include "tests/fuzz/fuzz_target.hpp"

namespace fuzz = abrazo::fuzz;

ABRAZO_FUZZ_TARGET(fbx)(fuzz::Bytes bytes) {
  fuzz::expect_motions(abrazo::read_scene(fuzz::text_of(bytes), abrazo::MotionFormat::Fbx, "input.fbx"));
}
