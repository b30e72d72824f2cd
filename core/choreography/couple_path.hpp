#pragma once

#include <vector>

#include "core/choreography/salsa_phrase.hpp"
#include "core/choreography/smooth_track.hpp"

namespace abrazo {

/// Where a dancer's spot on the floor is and where it faces; the steps are danced around it.
struct Spot {
  Vec3 place = Vec3::Zero();  ///< y = 0
  double heading = 0;         ///< [rad], not wrapped
};

Vec3 forward_of(double heading);
Vec3 left_of(double heading);

/// How the couple stands, turns and travels on the floor over a dance. Between figures they face one another;
/// every figure begins and ends so. Beat 0 is count 1 of the first phrase.
class CouplePath {
 public:
  explicit CouplePath(const std::vector<SalsaPhrase>& phrases);

  Spot leader(double beat) const;
  Spot follower(double beat) const;

 private:
  /// Turns are from facing the partner; the heading is that of the line from leader to follower.
  enum Channel { CentreX, CentreZ, Heading, Distance, Offset, LeaderTurn, FollowerTurn, ChannelCount };
  using Station = Eigen::Array<double, ChannelCount, 1>;

  static Station station(const SalsaPhrase& phrase, double beat, double distance);

  SmoothTrack<Station> stations_;
};

}  // namespace abrazo
