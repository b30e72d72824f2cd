#include "core/synthesis/motion/partner_place.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace abrazo::partner_place_test {
namespace {

constexpr double step_s = 1.0 / 240, rate = 7;

RootFrame at(double x, double heading_rad = 0) {
  return {{x, 0, 0}, heading_rad};
}

/// x'' = omega^2 e / (1 + |e| / 0.35) - 2 omega (x' - 0.6 v - 0.4 d), v' = (c - v) / 0.3, d' = (D' - d) /
/// 0.06, e = D - x, by the midpoint rule.
struct ByHand {
  double x = 0, speed = 0, recorded = 0, desired = 0;
  void advance(double wanted, double recorded_speed, double wanted_speed, double elapsed_s) {
    const auto acceleration = [&](double at, double at_speed, double carries, double leads) {
      const double off = wanted - at;
      return rate * rate * off / (1 + std::abs(off) / 0.35) -
             2 * rate * (at_speed - 0.6 * carries - 0.4 * leads);
    };
    const int parts = 200;
    const double part_s = elapsed_s / parts;
    for (int i = 0; i < parts; ++i) {
      const double middle = x + 0.5 * part_s * speed;
      const double middle_speed = speed + 0.5 * part_s * acceleration(x, speed, recorded, desired);
      const double middle_recorded = recorded + 0.5 * part_s * (recorded_speed - recorded) / 0.3;
      const double middle_desired = desired + 0.5 * part_s * (wanted_speed - desired) / 0.06;
      x += part_s * middle_speed;
      speed += part_s * acceleration(middle, middle_speed, middle_recorded, middle_desired);
      recorded += part_s * (recorded_speed - middle_recorded) / 0.3;
      desired += part_s * (wanted_speed - middle_desired) / 0.06;
    }
  }
};

struct Difference {
  double at = 0, speed = 0, recorded = 0, desired = 0;
};

/// Greatest difference over two seconds of a place that sways by 0.2 m, slower than a jump.
Difference from_by_hand(double elapsed_s) {
  PartnerPlace place(at(0));
  ByHand by_hand;
  Difference most;
  for (double now = 0; now < 2; now += elapsed_s) {
    const double wanted = 0.2 * std::sin(6 * now), recorded_speed = 0.4 * std::cos(4 * now);
    const double wanted_speed = now > 0 ? (wanted - 0.2 * std::sin(6 * (now - elapsed_s))) / elapsed_s : 0;
    place.advance({recorded_speed * Vec3::UnitX(), 0}, at(wanted), elapsed_s, rate);
    by_hand.advance(wanted, recorded_speed, wanted_speed, elapsed_s);
    most.at = std::max(most.at, std::abs(place.at().position.x() - by_hand.x));
    most.speed = std::max(most.speed, std::abs(place.speed().x() - by_hand.speed));
    most.recorded = std::max(most.recorded, std::abs(place.recorded_speed().x() - by_hand.recorded));
    most.desired = std::max(most.desired, std::abs(place.desired_speed().x() - by_hand.desired));
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
    EXPECT_LT(most.desired, 1e-4) << steps_per_s;
  }
}

TEST(PartnerPlace, NearItsPlaceWithoutARecordingItIsACriticallyDampedSpring) {
  PartnerPlace place(at(0));
  const double wanted = 1e-5;
  for (int step = 1; step <= 120; ++step) {
    place.advance({}, at(wanted), step_s, rate);
    const double after_s = step * step_s;
    const double left = (1 + rate * after_s) * std::exp(-rate * after_s);
    ASSERT_NEAR(place.at().position.x(), wanted * (1 - left), 1e-4 * wanted) << step;
  }
}

TEST(PartnerPlace, ARecordedSpeedIsThatOfTheTurningPartner) {
  PartnerPlace place(at(0, 1.0));
  const Vec3 own(1, 0, 0.2);
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
    place.advance({speed * Vec3::UnitX(), 0}, at(0), step_s, rate);
    if (step > 120) hardest = std::max(hardest, (place.speed() - before).norm() / step_s);
    before = place.speed();
  }
  EXPECT_LT(hardest, 0.7 * amplitude_m * sway * sway);
}

TEST(PartnerPlace, HalfStepsArriveWhereWholeStepsDo) {
  PartnerPlace whole(at(0, 0.3)), halves(at(0, 0.3));
  const RootFrame wanted = at(0.15, 0.5);
  for (int step = 0; step < 30; ++step) {
    const RecordedStep recorded{Vec3(0.48, 0, 0.24), 0};
    whole.advance(recorded, wanted, 2 * step_s, rate);
    for (int half = 0; half < 2; ++half) halves.advance(recorded, wanted, step_s, rate);
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
  EXPECT_LT(fastest, 0.35 * rate / 2) << "where damping and the farthest pull are in balance";
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

TEST(PartnerPlace, ADesiredPlaceThatMovesWithTheRecordingIsReached) {
  PartnerPlace place(at(0));
  const double speed = 0.5;
  double wanted = 0;
  for (int step = 0; step < 12 * 240; ++step) {
    wanted += speed * step_s;
    place.advance({speed * Vec3::UnitX(), 0}, at(wanted), step_s, rate);
  }
  EXPECT_NEAR(place.speed().x(), speed, 1e-4);
  EXPECT_NEAR(wanted + 0.5 * step_s * speed - place.at().position.x(), 0, 1e-4)
      << "the pull is that of the middle of the step";
}

TEST(PartnerPlace, ADesiredPlaceThatMovesWithoutTheRecordingIsFollowedAtAConstantDistance) {
  PartnerPlace place(at(0));
  const double speed = 0.5;
  double wanted = 0;
  for (int step = 0; step < 12 * 240; ++step) place.advance({}, at(wanted += speed * step_s), step_s, rate);
  EXPECT_NEAR(place.speed().x(), speed, 1e-4);
  // omega^2 s(e) = 2 omega (1 - gamma) speed
  const double pull = 2 * 0.6 * speed / rate;
  EXPECT_NEAR(wanted + 0.5 * step_s * speed - place.at().position.x(), pull / (1 - pull / 0.35), 1e-4);
}

TEST(PartnerPlace, ADesiredPlaceThatJumpsHasNoSpeed) {
  PartnerPlace place(at(0));
  place.advance({}, at(0), step_s, rate);
  place.advance({}, at(0.3), step_s, rate);
  EXPECT_EQ(place.desired_speed(), Vec3::Zero());
  place.advance({}, at(0.3 + 1.5 * step_s), step_s, rate);
  EXPECT_GT(place.desired_speed().x(), 0) << "as fast as a dancer walks";
}

TEST(PartnerPlace, AChangeOfWhatCarriesItKeepsItsSpeed) {
  PartnerPlace place(at(0));
  const Vec3 old_speed(0.8, 0, 0.1), new_speed(-0.3, 0, 0.4);
  for (int step = 0; step < 240; ++step) place.advance({old_speed, 0}, place.at(), step_s, rate);
  const Vec3 before = place.speed();
  place.advance({new_speed, 0}, place.at(), step_s, rate);
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
