#include "core/motion/acclaim/acclaim_skeleton.hpp"
#include "core/motion/acclaim/asf_amc.hpp"
#include "tests/fuzz/fuzz_target.hpp"

namespace fuzz = abrazo::fuzz;

/// The skeleton alone, and with a motion that moves nothing but the root.
ABRAZO_FUZZ_TARGET(asf)(fuzz::Bytes bytes) {
  const std::string_view text = fuzz::text_of(bytes);
  const auto skeleton = abrazo::parse_asf(text, "input.asf");
  if (fuzz::accepted(skeleton))
    for (std::size_t b = 0; b < skeleton->bones.size(); ++b)
      fuzz::expect(skeleton->bones[b].parent < static_cast<int>(b), "a bone stands before its parent");
  const auto motion = abrazo::read_asf_amc(text, "input.asf", ":DEGREES\n1\nroot 0 0 0 0 0 0\n", "still.amc");
  if (fuzz::accepted(motion)) fuzz::expect_motions(std::vector<abrazo::NamedMotion>{*motion});
}
