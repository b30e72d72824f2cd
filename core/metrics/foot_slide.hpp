#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "core/base/positions.hpp"
#include "core/motion/body/body.hpp"

namespace abrazo {

/// Heights of the toe bases above the floor while standing: left, right [m].
using ToeRest = std::array<double, 2>;

/// Rest heights of a motion: the 5th percentile of each toe base's height; NaN for no poses.
ToeRest toe_rest(std::span<const Pose> poses);
/// Rest heights of a body without a motion.
inline ToeRest toe_rest(const Body& body) {
  return {body.toe_rest_height, body.toe_rest_height};
}

/// Horizontal speed of each toe base from one pose to the next [m/s], left and right; nothing for a foot that
/// is not landed: less than `landed_below_m` above its rest at both.
inline constexpr double landed_below_m = 0.03;
std::array<std::optional<double>, 2> landed_foot_speeds(const Pose& before, const Pose& after,
                                                        double elapsed_s, const ToeRest& rest);

/// Sliding of feet on the floor: the horizontal speed of a toe base from one pose to the next, counted if it
/// is less than `landed_below_m` above its rest at both poses. Captured dancers brush and pivot, so the
/// target is their value, not 0.
class FootSlideMetric {
 public:
  static constexpr double fast_m_s = 0.3;

  /// @param elapsed_s  between the two poses, more than 0
  void add(const Pose& before, const Pose& after, double elapsed_s, const ToeRest& rest) {
    add(landed_foot_speeds(before, after, elapsed_s, rest));
  }
  void add(const std::array<std::optional<double>, 2>& speeds_m_s);

  struct Figures {
    double mean_m_s = 0;      ///< NaN if no foot landed
    double share_fast = 0;    ///< share of landed steps faster than `fast_m_s`; NaN if no foot landed
    double landed_share = 0;  ///< share of all steps of feet that were measured
    int landed = 0;           ///< steps of landed feet
  };
  Figures figures() const;
  /// One value per step of a landed foot, in order.
  const std::vector<double>& speeds_m_s() const { return speeds_m_s_; }

 private:
  std::vector<double> speeds_m_s_;
  int steps_ = 0;  ///< of both feet
};

}  // namespace abrazo
