#include "core/choreography/salsa_phrase.hpp"

#include <array>
#include <numbers>
#include <utility>

namespace abrazo {
namespace {

constexpr std::array<SalsaMove, 6> bag = {SalsaMove::OpenHold,   SalsaMove::OpenHold, SalsaMove::ClosedHold,
                                          SalsaMove::ClosedHold, SalsaMove::Turn,     SalsaMove::Turn};

double usual_distance(SalsaMove move) {
  switch (move) {
    case SalsaMove::OpenHold:
      return 0.82;
    case SalsaMove::ClosedHold:
      return 0.53;
    case SalsaMove::Turn:
      return 0.62;
  }
  return 0;
}

/// A quarter or an eighth to either side, or none.
double draw_couple_turn(RandomSource& random) {
  static constexpr std::array<double, 6> eighths = {0, 0, 1, -1, 2, -2};
  return eighths[static_cast<std::size_t>(random.below(6))] * random.uniform(0.85, 1.1) * std::numbers::pi /
         4;
}

SalsaPhrase draw_phrase(SalsaMove move, const Vec3& centre, RandomSource& random) {
  SalsaPhrase phrase{.move = move};
  phrase.step = 0.26 * random.uniform(0.85, 1.15) * (move == SalsaMove::OpenHold ? 1.05 : 0.9);
  phrase.distance = usual_distance(move) + random.uniform(-0.03, 0.04);
  phrase.offset = move == SalsaMove::ClosedHold ? random.uniform(0.04, 0.07) : random.uniform(-0.02, 0.04);
  phrase.couple_turn = move == SalsaMove::Turn ? 0.5 * draw_couple_turn(random) : draw_couple_turn(random);
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
  }
  return "";
}

std::vector<SalsaPhrase> draw_phrases(int count, RandomSource& random) {
  std::vector<SalsaPhrase> phrases;
  Vec3 centre = Vec3::Zero();
  std::array<SalsaMove, 6> order = bag;
  for (int i = 0; i < count; ++i) {
    const int drawn = i % 6;
    std::swap(order[static_cast<std::size_t>(drawn)],
              order[static_cast<std::size_t>(drawn + random.below(6 - drawn))]);
    phrases.push_back(draw_phrase(order[static_cast<std::size_t>(drawn)], centre, random));
    centre += phrases.back().travel;
  }
  return phrases;
}

}  // namespace abrazo
