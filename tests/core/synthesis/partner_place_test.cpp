#include "core/synthesis/motion/partner_place.hpp"

#include <gtest/gtest.h>

namespace abrazo::partner_place_test {
namespace {

constexpr double step_s = 1.0 / 240, rate = 7;

RootFrame at(double x, double heading_rad = 0) {
  return {{x, 0, 0}, heading_rad};
}

TEST(PartnerPlace, WhatIsLeftIsClosedAsByACriticallyDampedSpring) {
  PartnerPlace place(at(0));
  const double from = -0.2;
  for (int step = 1; step <= 240; ++step) {
    place.approach(at(0.2), step_s, rate);
    const double time_s = step * step_s;
    EXPECT_NEAR(place.at().position.x() - 0.2, from * (1 + rate * time_s) * std::exp(-rate * time_s), 1e-9);
  }
}

TEST(PartnerPlace, APartnerThatIsFarOffWalksThere) {
  PartnerPlace place(at(0));
  double fastest = 0, fastest_turn = 0;
  for (int step = 0; step < 6 * 240; ++step) {
    const RootFrame before = place.at();
    place.approach(at(3, 3), step_s, rate);
    fastest = std::max(fastest, (place.at().position - before.position).norm() / step_s);
    fastest_turn = std::max(fastest_turn, std::abs(place.at().heading_rad - before.heading_rad) / step_s);
  }
  EXPECT_LT(fastest, 0.9);
  EXPECT_LT(fastest_turn, 3.6);
  EXPECT_NEAR(place.at().position.x(), 3, 1e-3);
  EXPECT_NEAR(place.at().heading_rad, 3, 1e-3);
}

TEST(PartnerPlace, AHandThatIsDrawnAddsToThePullWithoutItsBound) {
  const Vec3 drawn(0, 0, 0.15);
  PartnerPlace drawn_place(at(0)), elsewhere(at(0));
  drawn_place.approach(at(0.1), step_s, rate, drawn);
  elsewhere.approach({Vec3(0.1, 0, 0.15), 0}, step_s, rate);
  EXPECT_LT((drawn_place.at().position - elsewhere.at().position).norm(), 1e-12)
      << "near by it is another place";
  PartnerPlace far(at(0)), far_drawn(at(0));
  far.approach(at(3), step_s, rate);
  far_drawn.approach(at(3), step_s, rate, drawn);
  EXPECT_NEAR(far_drawn.at().position.x(), far.at().position.x(), 1e-12);
  EXPECT_NEAR(far_drawn.at().position.z(), drawn_place.at().position.z(), 1e-12);
}

TEST(PartnerPlace, AChangeOfWhatCarriesItKeepsItsSpeed) {
  PartnerPlace place(at(0));
  const Vec3 old_speed(0.8, 0, 0.1), new_speed(-0.3, 0, 0.4);
  for (int step = 0; step < 10; ++step) {
    place.carry(step_s * old_speed, 0);
    place.approach(place.at(), step_s, rate);
  }
  const RootFrame before = place.at();
  place.keep_speed(old_speed - new_speed, 0);
  place.carry(step_s * new_speed, 0);
  place.approach(place.at(), step_s, rate);
  EXPECT_LT(((place.at().position - before.position) / step_s - old_speed).norm(), 0.05);
}

}  // namespace
}  // namespace abrazo::partner_place_test
