#pragma once

#include "core/choreography/choreography_options.hpp"
#include "core/choreography/posture.hpp"
#include "core/choreography/random_source.hpp"
#include "core/choreography/smooth_track.hpp"

namespace abrazo {

/// Random deviations of a performer: start times of moves, and drift of trunk and hands. Smooth in time and
/// bounded. Does not affect feet and bone lengths.
class Wander {
 public:
  /// @param duration_s the deviations cover times from 0 to this
  Wander(const Performance& performance, double duration_s, RandomSource& random);

  /// Lead of the performer (positive: early) [s]; changes more slowly than time.
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
