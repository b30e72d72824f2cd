#include "core/video/camera_file.hpp"

#include "tests/fuzz/fuzz_target.hpp"

namespace fuzz = abrazo::fuzz;

ABRAZO_FUZZ_TARGET(camera)(fuzz::Bytes bytes) {
  const fuzz::ScratchFile file("camera.json", bytes);
  const auto camera = abrazo::read_camera(file.path());
  if (!fuzz::accepted(camera)) return;
  fuzz::expect(abrazo::check_camera(*camera, "camera.json").ok(),
               "a camera was read that does not hold together");
  (void)camera->project({0.3, 1.2, -0.4});
  (void)camera->project_segment({0.3, 1.2, -0.4}, {0.1, 0.2, 0.9});
}
