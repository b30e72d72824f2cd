#include "core/motion/files/format_recognition.hpp"

#include "core/motion/files/import_clip.hpp"
#include "core/motion/tables/point_csv.hpp"
#include "tests/fuzz/fuzz_target.hpp"

namespace fuzz = abrazo::fuzz;

/// What a file is, told by its content, and its reading by whatever it is found to be. The scene formats have
/// targets of their own: what is none of ours would only be tried there again.
ABRAZO_FUZZ_TARGET(motion_format)(fuzz::Bytes bytes) {
  const std::string_view head = fuzz::text_of(bytes);
  const auto format = abrazo::format_of_content(head);
  for (const char* name : {"motion", "motion.bvh", "motion.csv", "motion.json"})
    (void)abrazo::foreign_kind(head, name);
  (void)abrazo::holds_positions(head);
  using abrazo::MotionFormat;
  if (format == MotionFormat::Gltf || format == MotionFormat::Fbx || format == MotionFormat::Collada) return;
  const fuzz::ScratchFile file("input", bytes);
  fuzz::expect_motions(abrazo::read_motion_points(file.path().string(), {}));
}
