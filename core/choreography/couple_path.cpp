#include "core/choreography/couple_path.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "core/base/units.hpp"

namespace abrazo {
namespace {

constexpr int half_beats_per_phrase = 2 * beats_per_phrase;
constexpr double full_turn = 2 * std::numbers::pi;

/// A phrase's own value, reached from the previous phrase's over the three beats around the boundary.
template <typename Member>
double eased(const std::vector<SalsaPhrase>& phrases, std::size_t p, double beat, Member member) {
  const double here = phrases[p].*member;
  if (beat < 1.5 && p > 0) return std::lerp(phrases[p - 1].*member, here, minimum_jerk((beat + 1.5) / 3));
  if (beat > 6.5 && p + 1 < phrases.size())
    return std::lerp(here, phrases[p + 1].*member, minimum_jerk((beat - 6.5) / 3));
  return here;
}

double ramp(double beat, double from, double to) {
  return minimum_jerk((beat - from) / (to - from));
}

/// One turn to the left, made mostly on 5, 6, 7, and wound up a little before.
double turn(double beat, double delay) {
  return full_turn * ramp(beat, 2.7 + delay, 7.2 + delay) -
         9 * radians_per_degree * smooth_bump((beat - 1) / 3.5);
}

// How far she has turned to her left in a cross body lead, as a share of the couple's turn: she goes straight
// past him, then comes about.
constexpr std::array<double, half_beats_per_phrase + 1> passing_turn = {
    0, 0, 0, 0, .01, .03, .06, .12, .21, .34, .50, .67, .82, .93, .99, 1, 1};

double passing(double beat) {
  const double place = std::clamp(2 * beat, 0.0, half_beats_per_phrase - 1.0);
  const auto i = static_cast<std::size_t>(place);
  return std::lerp(passing_turn[i], passing_turn[i + 1], place - std::floor(place));
}

}  // namespace

Vec3 forward_of(double heading) {
  return {std::sin(heading), 0, std::cos(heading)};
}
Vec3 left_of(double heading) {
  return {std::cos(heading), 0, -std::sin(heading)};
}

/// Relative to the couple's place and heading at the start of the phrase.
CouplePath::Station CouplePath::station(const SalsaPhrase& phrase, double beat, double distance) {
  using enum SalsaFigure;
  const bool exchange = phrase.figure == CrossBodyLead || phrase.figure == InsideTurn;
  const double done = exchange ? ramp(beat, 0.4, 7.4) : ramp(beat, -0.5, 7.5);
  Station at = Station::Zero();
  at[Heading] = done * phrase.couple_turn;
  at[Distance] = distance;
  Vec3 centre = done * phrase.travel;
  if (exchange) {
    // He gives way, so that her path is nearly straight.
    centre -= 0.05 * smooth_bump(done) * forward_of(0.5 * phrase.couple_turn);
    at[FollowerTurn] = (passing(beat) - done) * phrase.couple_turn;
  }
  if (phrase.figure == FollowerRightTurn) at[FollowerTurn] -= turn(beat, phrase.delay);
  if (phrase.figure == FollowerLeftTurn) at[FollowerTurn] += turn(beat, phrase.delay);
  if (phrase.figure == InsideTurn) at[FollowerTurn] += full_turn * ramp(beat, 2.1, 7.6);
  if (move_of(phrase.figure) == SalsaMove::Turn) {  // near enough for the raised hold
    const bool she_turns_in_place = phrase.figure == FollowerRightTurn || phrase.figure == FollowerLeftTurn;
    at[Distance] -= (she_turns_in_place            ? 0.16
                     : phrase.figure == InsideTurn ? 0
                                                   : 0.05) *
                    smooth_bump((beat - 1.7) / 6.6);
  }
  if (phrase.figure == LeaderRightTurn) at[LeaderTurn] -= turn(beat, phrase.delay);
  if (phrase.figure == LeaderLeftTurn) at[LeaderTurn] += turn(beat, phrase.delay);
  if (move_of(phrase.figure) == SalsaMove::Walk) {
    const double side = phrase.figure == WalkToHisLeft ? 1 : -1;
    const bool tandem = phrase.figure == WalkInTandem;
    const double opened = ramp(beat, -0.5, tandem ? 1.7 : 2.0) - ramp(beat, tandem ? 5.7 : 5.4, 7.7);
    at[LeaderTurn] = tandem ? 0 : side * 80 * radians_per_degree * opened;
    at[FollowerTurn] = tandem ? 178 * radians_per_degree * opened : -side * 80 * radians_per_degree * opened;
    at[Distance] = std::lerp(distance, tandem ? 0.56 : 0.62, opened);
    centre += std::clamp((beat + 0.2) / 7.2, 0.0, 1.0) * walked(phrase);
  }
  if (phrase.figure == InAndOut) {
    const double in = ramp(beat, -0.3, 3.4) - ramp(beat, 4.0, 7.5);
    const double swung = -104 * radians_per_degree * in;
    at[Heading] += swung;
    at[LeaderTurn] = 80 * radians_per_degree * in;
    at[FollowerTurn] = 288 * radians_per_degree * in;
    at[Distance] = std::lerp(distance, 0.50, in);
    // He stays where he is.
    centre += 0.5 * at[Distance] * forward_of(swung) - 0.5 * distance * forward_of(0);
  }
  at[CentreX] = centre.x();
  at[CentreZ] = centre.z();
  return at;
}

CouplePath::CouplePath(const std::vector<SalsaPhrase>& phrases) : stations_(0, 0.5, {}) {
  std::vector<Station> stations;
  Station start = Station::Zero();
  const auto placed = [&](std::size_t p, double beat) {
    Station at = station(phrases[p], beat, eased(phrases, p, beat, &SalsaPhrase::distance));
    const Vec3 centre = at[CentreZ] * forward_of(start[Heading]) + at[CentreX] * left_of(start[Heading]);
    at[CentreX] = start[CentreX] + centre.x();
    at[CentreZ] = start[CentreZ] + centre.z();
    for (const Channel turned : {Heading, LeaderTurn, FollowerTurn}) at[turned] += start[turned];
    at[Offset] = eased(phrases, p, beat, &SalsaPhrase::offset);
    return at;
  };
  for (std::size_t p = 0; p < phrases.size(); ++p) {
    for (int half_beat = 0; half_beat < half_beats_per_phrase; ++half_beat)
      stations.push_back(placed(p, 0.5 * half_beat));
    start = placed(p, beats_per_phrase);
  }
  stations_ = {0, 0.5, std::move(stations)};
}

Spot CouplePath::leader(double beat) const {
  const Station at = stations_.at(beat);
  const double heading = at[Heading];
  return {Vec3(at[CentreX], 0, at[CentreZ]) - 0.5 * at[Distance] * forward_of(heading) +
              0.5 * at[Offset] * left_of(heading),
          heading + at[LeaderTurn]};
}

Spot CouplePath::follower(double beat) const {
  const Station at = stations_.at(beat);
  const double heading = at[Heading];
  return {Vec3(at[CentreX], 0, at[CentreZ]) + 0.5 * at[Distance] * forward_of(heading) -
              0.5 * at[Offset] * left_of(heading),
          heading + std::numbers::pi + at[FollowerTurn]};
}

}  // namespace abrazo
