#include "tests/core/library/synthetic_takes.hpp"

#include <cmath>
#include <numbers>
#include <random>

#include "tests/support/bodies.hpp"

namespace abrazo::test {

PairedTake circling_take(const std::string& name, int frames, double distance_m, unsigned seed) {
  std::mt19937 random(seed);
  PairedTake take;
  take.name = name;
  take.a.name = name + "/a";
  take.b.name = name + "/b";
  // The second performer is 8 % smaller: another body.
  const Pose person_a = standing_pose();
  const Pose person_b = 0.92 * standing_pose();
  for (int frame = 0; frame < frames; ++frame) {
    const double angle = 0.03 * frame;
    const Vec3 half = 0.5 * distance_m * Vec3(std::sin(angle), 0, std::cos(angle));
    take.a.poses.push_back(shaken(moved(person_a, angle, -half), 0.002, random));
    take.b.poses.push_back(shaken(moved(person_b, angle + std::numbers::pi, half), 0.002, random));
  }
  return take;
}

}  // namespace abrazo::test
