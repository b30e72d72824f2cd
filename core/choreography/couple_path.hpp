#pragma once

#include <vector>

#include "core/choreography/salsa_phrase.hpp"
#include "core/choreography/smooth_track.hpp"

namespace abrazo {

/// Position and heading of a dancer's spot on the floor; the steps are danced around it.
struct Spot {
  Vec3 place = Vec3::Zero();  ///< y = 0
  double heading = 0;         ///< [rad], not wrapped
};

Vec3 forward_of(double heading);
Vec3 left_of(double heading);

/// Placement, turns and travel of the couple over a dance. They face one another at the begin and end of
/// every figure. Beat 0 is count 1 of the first phrase.
class CouplePath {
 public:
  explicit CouplePath(const std::vector<SalsaPhrase>& phrases);

  Spot leader(double beat) const;
  Spot follower(double beat) const;

 private:
  /// Turns are relative to facing the partner; the heading is that of the line from leader to follower.
  enum Channel { CentreX, CentreZ, Heading, Distance, Offset, LeaderTurn, FollowerTurn, ChannelCount };
  using Station = Eigen::Array<double, ChannelCount, 1>;

  static Station station(const SalsaPhrase& phrase, double beat, double distance);

  SmoothTrack<Station> stations_;
};

}  // namespace abrazo
