#include "core/metrics/foot_slide.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/statistics.hpp"
#include "core/motion/body/joint_set.hpp"

namespace abrazo {

namespace {

constexpr std::array<int, 2> toe_bases = {joints::left_toe_base, joints::right_toe_base};

}  // namespace

ToeRest toe_rest(std::span<const Pose> poses) {
  ToeRest rest{};
  for (std::size_t foot = 0; foot < toe_bases.size(); ++foot) {
    std::vector<double> heights_m;
    heights_m.reserve(poses.size());
    for (const Pose& pose : poses) heights_m.push_back(pose(toe_bases[foot], 1));
    rest[foot] = quantile(std::move(heights_m), 0.05);
  }
  return rest;
}

std::array<std::optional<double>, 2> landed_foot_speeds(const Pose& before, const Pose& after,
                                                        double elapsed_s, const ToeRest& rest) {
  std::array<std::optional<double>, 2> speeds_m_s;
  for (std::size_t foot = 0; foot < toe_bases.size(); ++foot) {
    const int toe_base = toe_bases[foot];
    if (std::max(before(toe_base, 1), after(toe_base, 1)) >= rest[foot] + landed_below_m) continue;
    speeds_m_s[foot] =
        std::hypot(after(toe_base, 0) - before(toe_base, 0), after(toe_base, 2) - before(toe_base, 2)) /
        elapsed_s;
  }
  return speeds_m_s;
}

void FootSlideMetric::add(const std::array<std::optional<double>, 2>& speeds_m_s) {
  for (const std::optional<double>& speed_m_s : speeds_m_s) {
    ++steps_;
    if (speed_m_s) speeds_m_s_.push_back(*speed_m_s);
  }
}

FootSlideMetric::Figures FootSlideMetric::figures() const {
  constexpr double nothing = std::numeric_limits<double>::quiet_NaN();
  Figures f{.mean_m_s = nothing, .share_fast = nothing, .landed_share = nothing};
  f.landed = static_cast<int>(speeds_m_s_.size());
  if (steps_ > 0) f.landed_share = static_cast<double>(f.landed) / steps_;
  if (f.landed == 0) return f;
  const auto fast = std::count_if(speeds_m_s_.begin(), speeds_m_s_.end(),
                                  [](double speed_m_s) { return speed_m_s > fast_m_s; });
  f.mean_m_s = mean(speeds_m_s_);
  f.share_fast = static_cast<double>(fast) / f.landed;
  return f;
}

}  // namespace abrazo
