#include "tests/core/library/synthetic_takes.hpp"

#include <cmath>
#include <numbers>
#include <random>

#include "tests/support/bodies.hpp"

namespace abrazo::test {

PairedTake circling_take(const std::string& name, int frames, double distance_m, unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> turn_rad(0, 0.05), step_m(0, 0.01);
  // Turned and moved as a whole: bones keep their lengths.
  const auto disturbed = [&](const Pose& person, double yaw, const Vec3& offset) {
    return moved(person, yaw + turn_rad(random),
                 offset + Vec3(step_m(random), step_m(random), step_m(random)));
  };
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
    take.a.poses.push_back(disturbed(person_a, angle, -half));
    take.b.poses.push_back(disturbed(person_b, angle + std::numbers::pi, half));
  }
  return take;
}

}  // namespace abrazo::test
