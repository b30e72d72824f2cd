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

/// Phrase and half-beat in it (0..15) of a control value; before the first phrase and after the last, those
/// two.
struct PhraseTime {
  std::size_t phrase = 0;
  int half_beat = 0;
};
PhraseTime phrase_time(int half_beat, std::size_t phrase_count);

/// How the couple stands and turns on the floor over a dance. They face one another; in a cross body lead she
/// walks past him before she turns to him.
class CouplePath {
 public:
  explicit CouplePath(const std::vector<SalsaPhrase>& phrases);

  Spot leader(double beat) const;
  Spot follower(double beat) const;

 private:
  SmoothTrack<Vec3> centre_;
  SmoothTrack<double> heading_, distance_, offset_;
  SmoothTrack<double> follower_turn_;  ///< of the follower from facing the leader [rad]
};

}  // namespace abrazo
