#include "core/synthesis/motion/partner_place.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace abrazo::partner_place_test {
namespace {

constexpr double step_s = 1.0 / 240, rate = 7;

RootFrame at(double x, double heading_rad = 0) {
  return {{x, 0, 0}, heading_rad};
}

/// x'' = omega^2 e / (1 + |e| / 0.32) - 2.5 omega (x' - 0.8 v), v' = (c' - v) / 0.13, e = wanted - x, by the
/// midpoint rule.
struct ByHand {
  double x = 0, speed = 0, recorded = 0;
  void advance(double wanted, double recorded_speed, double elapsed_s) {
    const auto acceleration = [&](double at, double at_speed, double carries) {
      const double off = wanted - at;
      return rate * rate * off / (1 + std::abs(off) / 0.32) - 2.5 * rate * (at_speed - 0.8 * carries);
    };
    const int parts = 200;
    const double part_s = elapsed_s / parts;
    for (int i = 0; i < parts; ++i) {
      const double middle = x + 0.5 * part_s * speed;
      const double middle_speed = speed + 0.5 * part_s * acceleration(x, speed, recorded);
      const double middle_recorded = recorded + 0.5 * part_s * (recorded_speed - recorded) / 0.13;
      x += part_s * middle_speed;
      speed += part_s * acceleration(middle, middle_speed, middle_recorded);
      recorded += part_s * (recorded_speed - middle_recorded) / 0.13;
    }
  }
};

struct Difference {
  double at = 0, speed = 0, recorded = 0;
};

/// Greatest difference over two seconds of a place that sways by 0.4 m.
Difference from_by_hand(double elapsed_s) {
  PartnerPlace place(at(0));
  ByHand by_hand;
  Difference most;
  for (double now = 0; now < 2; now += elapsed_s) {
    const double wanted = 0.4 * std::sin(6 * now), recorded_speed = 0.4 * std::cos(4 * now);
    place.advance({elapsed_s * recorded_speed * Vec3::UnitX(), 0}, at(wanted), elapsed_s, rate);
    by_hand.advance(wanted, recorded_speed, elapsed_s);
    most.at = std::max(most.at, std::abs(place.at().position.x() - by_hand.x));
    most.speed = std::max(most.speed, std::abs(place.speed().x() - by_hand.speed));
    most.recorded = std::max(most.recorded, std::abs(place.recorded_speed().x() - by_hand.recorded));
  }
  return most;
}

TEST(PartnerPlace, MovesByItsEquationAtEveryStepRate) {
  for (const auto& [steps_per_s, bound_m] :
       {std::pair{240, 2e-5}, std::pair{60, 3e-4}, std::pair{15, 5e-3}}) {
    const Difference most = from_by_hand(1.0 / steps_per_s);
    EXPECT_LT(most.at, bound_m) << steps_per_s;
    EXPECT_LT(most.speed, 20 * bound_m) << steps_per_s;
    EXPECT_LT(most.recorded, 1e-5) << steps_per_s;
  }
}

TEST(PartnerPlace, NearItsPlaceWithoutARecordingItIsADampedSpring) {
  PartnerPlace place(at(0));
  const double wanted = 1e-5, slow = rate * (1.25 - 0.75), fast = rate * (1.25 + 0.75);
  for (int step = 1; step <= 120; ++step) {
    place.advance({}, at(wanted), step_s, rate);
    const double after_s = step * step_s;
    const double left = (fast * std::exp(-slow * after_s) - slow * std::exp(-fast * after_s)) / (fast - slow);
    ASSERT_NEAR(place.at().position.x(), wanted * (1 - left), 1e-4 * wanted) << step;
  }
}

TEST(PartnerPlace, ARecordedPathIsThatOfTheTurningPartner) {
  PartnerPlace place(at(0, 1.0));
  const Vec3 own(0.01, 0, 0.002);
  place.advance({own, 0.2}, at(0, 1.2), step_s, rate);
  const Vec3 expected = RootFrame{Vec3::Zero(), 1.1}.rotation() * own;
  EXPECT_LT(place.speed().normalized().cross(expected.normalized()).norm(), 1e-9);
  EXPECT_NEAR(place.at().heading_rad, 1.2, 1e-12);
}

/// A mass that is carried by the recording would accelerate as hard as the recorded one.
TEST(PartnerPlace, AQuickSwayOfTheRecordingReachesItWeakly) {
  PartnerPlace place(at(0));
  const double sway_hz = 2, sway = 2 * 3.14159265358979 * sway_hz, amplitude_m = 0.05;
  double hardest = 0;
  Vec3 before = place.speed();
  for (int step = 0; step < 480; ++step) {
    const double speed = amplitude_m * sway * std::cos(sway * step * step_s);
    place.advance({step_s * speed * Vec3::UnitX(), 0}, at(0), step_s, rate);
    if (step > 120) hardest = std::max(hardest, (place.speed() - before).norm() / step_s);
    before = place.speed();
  }
  EXPECT_LT(hardest, 0.7 * amplitude_m * sway * sway);
}

TEST(PartnerPlace, HalfStepsArriveWhereWholeStepsDo) {
  PartnerPlace whole(at(0, 0.3)), halves(at(0, 0.3));
  const RootFrame wanted = at(0.15, 0.5);
  for (int step = 0; step < 30; ++step) {
    whole.advance({Vec3(0.004, 0, 0.002), 0}, wanted, 2 * step_s, rate);
    for (int half = 0; half < 2; ++half) halves.advance({Vec3(0.002, 0, 0.001), 0}, wanted, step_s, rate);
  }
  EXPECT_LT((whole.at().position - halves.at().position).norm(), 1e-3);
  EXPECT_NEAR(whole.at().heading_rad, halves.at().heading_rad, 1e-9);
}

TEST(PartnerPlace, APartnerThatIsFarOffWalksThere) {
  PartnerPlace place(at(0));
  double fastest = 0, fastest_turn = 0;
  for (int step = 0; step < 8 * 240; ++step) {
    const RootFrame before = place.at();
    place.advance({}, at(3, 3), step_s, rate);
    fastest = std::max(fastest, (place.at().position - before.position).norm() / step_s);
    fastest_turn = std::max(fastest_turn, std::abs(place.at().heading_rad - before.heading_rad) / step_s);
  }
  EXPECT_LT(fastest, 0.32 * rate / 2.5) << "where damping and the farthest pull are in balance";
  EXPECT_LT(fastest_turn, 0.5 * 8) << "as a pull of 1 rad at 8/s";
  EXPECT_NEAR(place.at().position.x(), 3, 1e-3);
  EXPECT_NEAR(place.at().heading_rad, 3, 1e-3);
}

TEST(PartnerPlace, AHandThatIsDrawnAddsToThePullWithoutItsBound) {
  const Vec3 drawn(0, 0, 0.15);
  PartnerPlace drawn_place(at(0)), elsewhere(at(0));
  drawn_place.advance({}, at(0.1), step_s, rate, drawn);
  elsewhere.advance({}, {Vec3(0.1, 0, 0.15), 0}, step_s, rate);
  EXPECT_GT(drawn_place.at().position.z(), 1.05 * elsewhere.at().position.z())
      << "another place pulls within the bound";
  PartnerPlace far(at(0)), far_drawn(at(0));
  far.advance({}, at(3), step_s, rate);
  far_drawn.advance({}, at(3), step_s, rate, drawn);
  EXPECT_NEAR(far_drawn.at().position.x(), far.at().position.x(), 1e-12);
  EXPECT_NEAR(far_drawn.at().position.z(), drawn_place.at().position.z(), 1e-12);
}

TEST(PartnerPlace, ADesiredPlaceThatMovesWithTheRecordingIsFollowedAtAConstantDistance) {
  PartnerPlace place(at(0));
  const double speed = 0.5;
  double wanted = 0;
  for (int step = 0; step < 12 * 240; ++step) {
    wanted += speed * step_s;
    place.advance({step_s * speed * Vec3::UnitX(), 0}, at(wanted), step_s, rate);
  }
  EXPECT_NEAR(place.speed().x(), speed, 1e-4);
  // omega^2 s(e) = 2 zeta omega (1 - beta) speed
  const double pull = 2.5 * 0.2 * speed / rate;
  EXPECT_NEAR(wanted + 0.5 * step_s * speed - place.at().position.x(), pull / (1 - pull / 0.32), 1e-4)
      << "the pull is that of the middle of the step";
}

TEST(PartnerPlace, AChangeOfWhatCarriesItKeepsItsSpeed) {
  PartnerPlace place(at(0));
  const Vec3 old_speed(0.8, 0, 0.1), new_speed(-0.3, 0, 0.4);
  for (int step = 0; step < 240; ++step) place.advance({step_s * old_speed, 0}, place.at(), step_s, rate);
  const Vec3 before = place.speed();
  place.advance({step_s * new_speed, 0}, place.at(), step_s, rate);
  EXPECT_LT((place.speed() - before).norm(), 0.1);
}

TEST(PartnerPlace, ATurnGoesOnAtAChange) {
  PartnerPlace place(at(0));
  for (int step = 0; step < 10; ++step) place.advance({Vec3::Zero(), 2 * step_s}, place.at(), step_s, rate);
  const double before = place.at().heading_rad;
  place.keep_turning(2 - -1);
  place.advance({Vec3::Zero(), -1 * step_s}, place.at(), step_s, rate);
  EXPECT_NEAR((place.at().heading_rad - before) / step_s, 2, 0.2);
}

}  // namespace
}  // namespace abrazo::partner_place_test
