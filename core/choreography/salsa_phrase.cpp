#include "core/choreography/salsa_phrase.hpp"

#include <array>
#include <cmath>
#include <numbers>
#include <utility>

namespace abrazo {
namespace {

constexpr std::array<SalsaMove, 6> moves = {SalsaMove::OpenHold, SalsaMove::ClosedHold,
                                            SalsaMove::Turn,     SalsaMove::CrossBodyLead,
                                            SalsaMove::Walk,     SalsaMove::InAndOut};

template <std::size_t Count>
SalsaFigure any_of(const std::array<SalsaFigure, Count>& figures, RandomSource& random) {
  return figures[static_cast<std::size_t>(random.below(static_cast<int>(Count)))];
}

SalsaFigure draw_figure(SalsaMove move, RandomSource& random) {
  using enum SalsaFigure;
  switch (move) {
    case SalsaMove::OpenHold:
      return OpenBasic;
    case SalsaMove::ClosedHold:
      return ClosedBasic;
    case SalsaMove::Turn:
      return any_of(std::array{FollowerRightTurn, FollowerRightTurn, FollowerLeftTurn, InsideTurn, InsideTurn,
                               LeaderRightTurn, LeaderLeftTurn},
                    random);
    case SalsaMove::CrossBodyLead:
      return CrossBodyLead;
    case SalsaMove::Walk:
      return any_of(std::array{WalkToHisLeft, WalkToHisRight, WalkInTandem}, random);
    case SalsaMove::InAndOut:
      return InAndOut;
  }
  return OpenBasic;
}

double usual_distance(SalsaFigure figure) {
  using enum SalsaFigure;
  switch (figure) {
    case OpenBasic:
      return 0.80;
    case ClosedBasic:
      return 0.565;
    case LeaderRightTurn:
    case LeaderLeftTurn:
      return 0.64;
    case InAndOut:
      return 0.72;
    case CrossBodyLead:
      return 0.63;
    case InsideTurn:
      return 0.58;
    default:
      return 0.66;
  }
}

bool exchanges_places(SalsaFigure figure) {
  return figure == SalsaFigure::CrossBodyLead || figure == SalsaFigure::InsideTurn;
}

/// Up to a quarter to either side; less while one of them turns. A cross body lead exchanges
/// their places.
double draw_couple_turn(SalsaFigure figure, RandomSource& random) {
  const double drawn = random.uniform(-0.47, 0.47) * std::numbers::pi;
  if (exchanges_places(figure)) return std::numbers::pi + 0.1 * drawn;
  const bool basic = figure == SalsaFigure::OpenBasic || figure == SalsaFigure::ClosedBasic;
  return (basic ? 1 : 0.5) * drawn;
}

/// @param centre  of the couple, from the origin, in the couple's space
SalsaPhrase draw_phrase(SalsaMove move, const Vec3& centre, RandomSource& random) {
  SalsaPhrase phrase{.figure = draw_figure(move, random)};
  phrase.step = 0.38 * random.uniform(0.85, 1.15) * (move == SalsaMove::ClosedHold ? 0.75 : 1.05);
  phrase.distance = usual_distance(phrase.figure) + random.uniform(-0.04, 0.05);
  phrase.offset = move == SalsaMove::ClosedHold ? random.uniform(0.10, 0.13) : random.uniform(0.01, 0.06);
  phrase.couple_turn = draw_couple_turn(phrase.figure, random);
  phrase.travel = Vec3(random.uniform(-0.3, 0.3), 0, random.uniform(-0.3, 0.3)) - 0.2 * centre;
  phrase.walk = random.uniform(1.1, 1.5);
  phrase.hips = random.uniform(0.7, 1.3);
  phrase.his_lean = random.uniform(-0.08, 0.08);
  phrase.her_lean = random.uniform(-0.08, 0.08);
  phrase.delay = random.uniform(-0.15, 0.15);
  phrase.hand_sway = random.uniform(0.08, 0.19);
  phrase.hand_height = random.uniform(-0.05, 0.10);
  phrase.hand_spread = random.uniform(-0.04, 0.08);
  phrase.grip = random.uniform(0.07, 0.11);
  phrase.both_hands = random.chance(0.7);
  return phrase;
}

Vec3 in_space_of(double heading, const Vec3& v) {
  return {v.x() * std::cos(heading) + v.z() * std::sin(heading), 0,
          -v.x() * std::sin(heading) + v.z() * std::cos(heading)};
}

/// Of the two directions of a walk the one that keeps nearer to the origin.
void walk_inwards(SalsaPhrase& phrase, const Vec3& centre) {
  if (walked(phrase).dot(centre) <= 0) return;
  if (phrase.figure == SalsaFigure::WalkToHisLeft)
    phrase.figure = SalsaFigure::WalkToHisRight;
  else if (phrase.figure == SalsaFigure::WalkToHisRight)
    phrase.figure = SalsaFigure::WalkToHisLeft;
}

}  // namespace

SalsaMove move_of(SalsaFigure figure) {
  using enum SalsaFigure;
  switch (figure) {
    case OpenBasic:
      return SalsaMove::OpenHold;
    case ClosedBasic:
      return SalsaMove::ClosedHold;
    case CrossBodyLead:
      return SalsaMove::CrossBodyLead;
    case WalkToHisLeft:
    case WalkToHisRight:
    case WalkInTandem:
      return SalsaMove::Walk;
    case InAndOut:
      return SalsaMove::InAndOut;
    default:
      return SalsaMove::Turn;
  }
}

std::string_view label_of(SalsaMove move) {
  static constexpr std::array<std::string_view, moves.size()> labels = {
      "open_hold", "closed_hold", "turn", "cross_body_lead", "walk", "in_and_out"};
  return labels[static_cast<std::size_t>(move)];
}

std::string_view detail_of(SalsaFigure figure) {
  static constexpr std::array<std::string_view, 12> details = {
      "hold Lr",
      "hold Lr RHback",
      "in place; follower right x1; hold Lr",
      "in place; follower left x1; hold Lr",
      "inside turn during cross body lead; follower left x1; places exchanged left; hold Lr",
      "in place; leader right x1; hold Lr",
      "in place; leader left x1; hold Lr",
      "hold Lr",
      "side by side to his left; hold Rl",
      "side by side to his right; hold Lr",
      "in tandem; hold Rr",
      "hold changing RHback"};
  return details[static_cast<std::size_t>(figure)];
}

Vec3 walked(const SalsaPhrase& phrase) {
  switch (phrase.figure) {
    case SalsaFigure::WalkToHisLeft:
      return {phrase.walk, 0, 0};
    case SalsaFigure::WalkToHisRight:
      return {-phrase.walk, 0, 0};
    case SalsaFigure::WalkInTandem:
      return {0, 0, 0.8 * phrase.walk};
    default:
      return Vec3::Zero();
  }
}

std::vector<SalsaPhrase> draw_phrases(int count, RandomSource& random) {
  constexpr int bag_size = 2 * static_cast<int>(moves.size());
  std::array<SalsaMove, bag_size> bag{};
  for (std::size_t i = 0; i < bag.size(); ++i) bag[i] = moves[i % moves.size()];
  std::vector<SalsaPhrase> phrases;
  Vec3 centre = Vec3::Zero();
  double heading = 0;
  for (int i = 0; i < count; ++i) {
    const int drawn = i % bag_size;
    std::swap(bag[static_cast<std::size_t>(drawn)],
              bag[static_cast<std::size_t>(drawn + random.below(bag_size - drawn))]);
    const Vec3 seen = in_space_of(-heading, centre);
    phrases.push_back(draw_phrase(bag[static_cast<std::size_t>(drawn)], seen, random));
    walk_inwards(phrases.back(), seen);
    centre += in_space_of(heading, phrases.back().travel + walked(phrases.back()));
    heading += phrases.back().couple_turn;
  }
  return phrases;
}

}  // namespace abrazo
