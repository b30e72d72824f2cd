#include "core/video/camera_model.hpp"
#include "tests/fuzz/fuzz_target.hpp"

namespace fuzz = abrazo::fuzz;

/// OpenCV's YAML, XML and JSON.
ABRAZO_FUZZ_TARGET(intrinsics)(fuzz::Bytes bytes) {
  const fuzz::ScratchFile file("calibration.yml", bytes);
  const auto intrinsics = abrazo::read_intrinsics(file.path());
  if (!fuzz::accepted(intrinsics)) return;
  fuzz::expect(intrinsics->width > 0 && intrinsics->height > 0, "a calibration for pictures without a size");
  fuzz::expect(intrinsics->fx > 0 && intrinsics->fy > 0, "a focal length that is none");
}
