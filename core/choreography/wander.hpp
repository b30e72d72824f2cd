#pragma once

#include "core/choreography/choreography_options.hpp"
#include "core/choreography/posture.hpp"
#include "core/choreography/random_source.hpp"
#include "core/choreography/smooth_track.hpp"

namespace abrazo {

/// What of a performer is not choreographed: how early or late moves are begun, and how trunk and hands stray
/// from where they should be. Smooth in time and bounded. Feet and bone lengths are not touched.
class Wander {
 public:
  /// @param duration_s  times from 0 to here have a wander of their own
  Wander(const Performance& performance, double duration_s, RandomSource& random);

  /// How much ahead (positive) the performer is [s]; changes by less than the time that passes.
  double ahead_s(double time_s) const { return timing_.at(time_s); }
  void displace(double time_s, TrunkPosture& trunk) const;
  Vec3 hand(Side side, double time_s) const;

 private:
  using Drift = Eigen::Array<double, 15, 1>;

  double slow_m_, timing_s_;
  SmoothTrack<double> timing_;
  SmoothTrack<Drift> slow_, quick_;
};

}  // namespace abrazo
