#include "core/choreography/salsa_phrase.hpp"

#include <array>
#include <numbers>
#include <utility>

#include "core/choreography/smooth_track.hpp"

namespace abrazo {
namespace {

constexpr std::array<SalsaMove, 8> bag = {
    SalsaMove::OpenHold, SalsaMove::OpenHold, SalsaMove::ClosedHold,    SalsaMove::ClosedHold,
    SalsaMove::Turn,     SalsaMove::Turn,     SalsaMove::CrossBodyLead, SalsaMove::CrossBodyLead};

double usual_distance(SalsaMove move) {
  switch (move) {
    case SalsaMove::OpenHold:
      return 0.82;
    case SalsaMove::ClosedHold:
      return 0.53;
    case SalsaMove::Turn:
    case SalsaMove::CrossBodyLead:
      return 0.62;
  }
  return 0;
}

/// A quarter or an eighth to either side, or none; less while she turns. A cross body lead exchanges their
/// places.
double draw_couple_turn(SalsaMove move, RandomSource& random) {
  static constexpr std::array<double, 6> eighths = {0, 0, 1, -1, 2, -2};
  const double drawn = eighths[static_cast<std::size_t>(random.below(6))] * random.uniform(0.85, 1.1);
  if (move == SalsaMove::CrossBodyLead) return std::numbers::pi + 0.1 * drawn;
  return (move == SalsaMove::Turn ? 0.5 : 1) * drawn * std::numbers::pi / 4;
}

SalsaPhrase draw_phrase(SalsaMove move, const Vec3& centre, RandomSource& random) {
  SalsaPhrase phrase{.move = move};
  phrase.step = 0.26 * random.uniform(0.85, 1.15) * (move == SalsaMove::OpenHold ? 1.05 : 0.9);
  phrase.distance = usual_distance(move) + random.uniform(-0.03, 0.04);
  phrase.offset = move == SalsaMove::ClosedHold ? random.uniform(0.04, 0.07) : random.uniform(-0.02, 0.04);
  phrase.couple_turn = draw_couple_turn(move, random);
  phrase.travel = Vec3(random.uniform(-0.25, 0.25), 0, random.uniform(-0.25, 0.25)) - 0.2 * centre;
  phrase.hips = random.uniform(0.7, 1.3);
  phrase.hand_sway = random.uniform(0.03, 0.10);
  phrase.hand_height = random.uniform(-0.05, 0.08);
  phrase.hand_spread = random.uniform(-0.04, 0.08);
  phrase.grip = random.uniform(0.032, 0.056);
  return phrase;
}

}  // namespace

std::string_view label_of(SalsaMove move) {
  switch (move) {
    case SalsaMove::OpenHold:
      return "open_hold";
    case SalsaMove::ClosedHold:
      return "closed_hold";
    case SalsaMove::Turn:
      return "turn";
    case SalsaMove::CrossBodyLead:
      return "cross_body_lead";
  }
  return "";
}

double couple_progress(SalsaMove move, double beat) {
  return move == SalsaMove::CrossBodyLead ? minimum_jerk((beat - 0.4) / 7) : minimum_jerk((beat + 0.5) / 8);
}

std::vector<SalsaPhrase> draw_phrases(int count, RandomSource& random) {
  std::vector<SalsaPhrase> phrases;
  Vec3 centre = Vec3::Zero();
  std::array<SalsaMove, bag.size()> order = bag;
  for (int i = 0; i < count; ++i) {
    const int drawn = i % static_cast<int>(bag.size());
    std::swap(order[static_cast<std::size_t>(drawn)],
              order[static_cast<std::size_t>(drawn + random.below(static_cast<int>(bag.size()) - drawn))]);
    phrases.push_back(draw_phrase(order[static_cast<std::size_t>(drawn)], centre, random));
    centre += phrases.back().travel;
  }
  return phrases;
}

}  // namespace abrazo
