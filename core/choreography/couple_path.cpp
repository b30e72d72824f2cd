#include "core/choreography/couple_path.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace abrazo {
namespace {

constexpr int half_beats_per_phrase = 2 * beats_per_phrase;

/// A phrase's own value, reached from the previous phrase's over the four beats around the boundary.
template <typename Member>
double eased(const std::vector<SalsaPhrase>& phrases, PhraseTime now, Member member) {
  const double beat = 0.5 * now.half_beat;
  const double here = phrases[now.phrase].*member;
  if (beat < 2 && now.phrase > 0)
    return std::lerp(phrases[now.phrase - 1].*member, here, minimum_jerk((beat + 2) / 4));
  if (beat > 6 && now.phrase + 1 < phrases.size())
    return std::lerp(here, phrases[now.phrase + 1].*member, minimum_jerk((beat - 6) / 4));
  return here;
}

// How far she has turned to her left in a cross body lead, as a share of the couple's turn: she goes straight
// past him, then comes about.
constexpr std::array<double, half_beats_per_phrase> passing_turn = {0,   0,   0,   0,   .01, .03, .06, .12,
                                                                    .21, .34, .50, .67, .82, .93, .99, 1};

/// From facing him to where she faces [rad].
double turn_from_partner(const SalsaPhrase& phrase, int half_beat, double done) {
  if (phrase.move != SalsaMove::CrossBodyLead) return 0;
  return (passing_turn[static_cast<std::size_t>(half_beat)] - done) * phrase.couple_turn;
}

}  // namespace

Vec3 forward_of(double heading) {
  return {std::sin(heading), 0, std::cos(heading)};
}
Vec3 left_of(double heading) {
  return {std::cos(heading), 0, -std::sin(heading)};
}

PhraseTime phrase_time(int half_beat, std::size_t phrase_count) {
  const int last = static_cast<int>(phrase_count) * half_beats_per_phrase - 1;
  const int inside = std::clamp(half_beat, 0, last);
  return {static_cast<std::size_t>(inside / half_beats_per_phrase), inside % half_beats_per_phrase};
}

CouplePath::CouplePath(const std::vector<SalsaPhrase>& phrases)
    : centre_(0, 0.5, {}),
      heading_(0, 0.5, {}),
      distance_(0, 0.5, {}),
      offset_(0, 0.5, {}),
      follower_turn_(0, 0.5, {}) {
  std::vector<Vec3> centre;
  std::vector<double> heading, distance, offset, follower_turn;
  Vec3 centre_before = Vec3::Zero();
  double heading_before = 0;
  for (std::size_t p = 0; p < phrases.size(); ++p) {
    for (int half_beat = 0; half_beat < half_beats_per_phrase; ++half_beat) {
      const double done = couple_progress(phrases[p].move, 0.5 * half_beat);
      follower_turn.push_back(turn_from_partner(phrases[p], half_beat, done));
      // He gives way, so that her path is nearly straight.
      const double way = phrases[p].move == SalsaMove::CrossBodyLead ? 0.05 * smooth_bump(done) : 0;
      centre.emplace_back(centre_before + done * phrases[p].travel -
                          way * forward_of(heading_before + 0.5 * phrases[p].couple_turn));
      heading.push_back(heading_before + done * phrases[p].couple_turn);
      distance.push_back(eased(phrases, {p, half_beat}, &SalsaPhrase::distance));
      offset.push_back(eased(phrases, {p, half_beat}, &SalsaPhrase::offset));
    }
    centre_before += phrases[p].travel;
    heading_before += phrases[p].couple_turn;
  }
  centre_ = {0, 0.5, std::move(centre)};
  heading_ = {0, 0.5, std::move(heading)};
  distance_ = {0, 0.5, std::move(distance)};
  offset_ = {0, 0.5, std::move(offset)};
  follower_turn_ = {0, 0.5, std::move(follower_turn)};
}

Spot CouplePath::leader(double beat) const {
  const double heading = heading_.at(beat);
  return {centre_.at(beat) - 0.5 * distance_.at(beat) * forward_of(heading) +
              0.5 * offset_.at(beat) * left_of(heading),
          heading};
}

Spot CouplePath::follower(double beat) const {
  const double heading = heading_.at(beat);
  return {centre_.at(beat) + 0.5 * distance_.at(beat) * forward_of(heading) -
              0.5 * offset_.at(beat) * left_of(heading),
          heading + std::numbers::pi + follower_turn_.at(beat)};
}

}  // namespace abrazo
