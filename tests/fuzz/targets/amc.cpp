#include "core/motion/acclaim/asf_amc.hpp"
#include "tests/fuzz/fuzz_target.hpp"

namespace fuzz = abrazo::fuzz;

namespace {

constexpr std::string_view skeleton = R"(:version 1.10
:name leg
:units
  mass 1.0
  length 0.45
  angle deg
:root
  order TX TY TZ RX RY RZ
  axis XYZ
  position 0 0 0
  orientation 0 0 0
:bonedata
  begin
    id 1
    name lhipjoint
    direction 0.6 -0.7 0.3
    length 2.4
    axis 0 0 0 XYZ
  end
  begin
    id 2
    name lfemur
    direction 0.34 -0.94 0
    length 7.2
    axis 0 0 20 XYZ
    dof rx ry rz
    limits (-160.0 20.0)
           (-70.0 70.0)
           (-60.0 70.0)
  end
  begin
    id 3
    name ltibia
    direction 0.34 -0.94 0
    length 7.5
    axis 0 0 20 XYZ
    dof rx
    limits (-10.0 170.0)
  end
:hierarchy
  begin
    root lhipjoint
    lhipjoint lfemur
    lfemur ltibia
  end
)";

}  // namespace

ABRAZO_FUZZ_TARGET(amc)(fuzz::Bytes bytes) {
  const auto motion = abrazo::read_asf_amc(skeleton, "leg.asf", fuzz::text_of(bytes), "input.amc");
  if (fuzz::accepted(motion)) fuzz::expect_motions(std::vector<abrazo::NamedMotion>{*motion});
}
