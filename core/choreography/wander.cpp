#include "core/choreography/wander.hpp"

#include <cmath>
#include <vector>

namespace abrazo {
namespace {

constexpr double timing_spacing = 2.2;  ///< some six beats, so that time never runs backwards [s]
constexpr double slow_spacing = 0.6, quick_spacing = 0.13;
/// Rms of a uniform cubic B-spline over independent controls of variance 1.
constexpr double spline_rms = 0.6926;

/// Independent in every component, rms 1.
template <typename Value, typename Draw>
SmoothTrack<Value> noise(double duration, double spacing, Draw draw) {
  const auto count = static_cast<std::size_t>(std::ceil(duration / spacing)) + 3;
  std::vector<Value> controls;
  for (std::size_t i = 0; i < count; ++i) controls.push_back(draw());
  return {-spacing, spacing, std::move(controls)};
}

}  // namespace

Wander::Wander(const Performance& performance, double duration_s, RandomSource& random)
    : slow_m_(performance.wander_m),
      timing_s_(performance.timing_error_s),
      timing_(0, 1, {}),
      slow_(0, 1, {}),
      quick_(0, 1, {}) {
  const auto drift = [&] {
    Drift values;
    for (double& value : values) value = random.bell() / spline_rms;
    return values;
  };
  timing_ = noise<double>(duration_s, timing_spacing, [&] { return timing_s_ * random.bell() / spline_rms; });
  slow_ = noise<Drift>(duration_s, slow_spacing, drift);
  quick_ = noise<Drift>(duration_s, quick_spacing, drift);
}

void Wander::displace(double time_s, TrunkPosture& trunk) const {
  // Even an expert is never quite still: millimetres at the trunk, at 1 .. 4 Hz.
  const double per_axis = slow_m_ / std::sqrt(3.0);
  const Drift drift = per_axis * slow_.at(time_s) + 0.002 * quick_.at(time_s);
  trunk.root += Vec3(drift[0], 0.3 * drift[1], drift[2]);
  // 1 cm at the shoulders is some 2 degrees.
  constexpr double angle = 3.5;
  trunk.pelvis.yaw += 0.6 * angle * drift[3];
  trunk.chest.yaw += angle * drift[4];
  trunk.chest.pitch += 0.5 * angle * drift[5];
  trunk.chest.roll += 0.5 * angle * drift[6];
  trunk.head.yaw += angle * drift[7];
  trunk.head.pitch += angle * drift[8];
}

Vec3 Wander::hand(Side side, double time_s) const {
  const Eigen::Index first = side == Side::Left ? 9 : 12;
  const Drift drift = slow_m_ / std::sqrt(3.0) * slow_.at(time_s) + 0.011 * quick_.at(time_s);
  return drift.segment<3>(first).matrix();
}

}  // namespace abrazo
