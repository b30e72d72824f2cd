#include "core/motion/scenes/assimp_scene.hpp"
#include "tests/fuzz/fuzz_target.hpp"

namespace fuzz = abrazo::fuzz;

/// Text, which is read by its file's name; what begins as a GLB is another target's.
ABRAZO_FUZZ_TARGET(gltf)(fuzz::Bytes bytes) {
  const std::string_view text = fuzz::text_of(bytes);
  if (text.starts_with("glTF")) return;
  const fuzz::ScratchFile file("input.gltf", bytes);
  fuzz::expect_motions(abrazo::read_scene(text, abrazo::MotionFormat::Gltf, file.path().string()));
}
