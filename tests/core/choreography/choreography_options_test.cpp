#include "core/choreography/choreography_options.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <stdexcept>
#include <string>

#include "core/choreography/dancer_body.hpp"

namespace abrazo::choreography_options_test {
namespace {

TEST(ChoreographyOptions, AnExpertIsTheDefault) {
  const Performance expert = performance_of_skill(1), usual;
  EXPECT_EQ(expert.amplitude, usual.amplitude);
  EXPECT_EQ(expert.timing_error_s, usual.timing_error_s);
  EXPECT_EQ(expert.wander_m, usual.wander_m);
}

TEST(ChoreographyOptions, LessSkillIsSmallerLaterAndUnsteadier) {
  for (const double skill : {0.0, 0.3, 0.8}) {
    const Performance worse = performance_of_skill(skill), better = performance_of_skill(skill + 0.2);
    EXPECT_LT(worse.amplitude, better.amplitude);
    EXPECT_GT(worse.timing_error_s, better.timing_error_s);
    EXPECT_GT(worse.wander_m, better.wander_m);
    check_performer({.performance = worse}, "anyone");
  }
}

TEST(ChoreographyOptions, RefusesWhatIsOutOfRangeAndNamesIt) {
  EXPECT_THROW(performance_of_skill(-0.1), std::invalid_argument);
  EXPECT_THROW(performance_of_skill(std::nan("")), std::invalid_argument);
  for (const PerformerOptions& bad :
       {PerformerOptions{.height_m = 1.3}, PerformerOptions{.arm_scale = 1.3},
        PerformerOptions{.leg_scale = 0.8}, PerformerOptions{.performance = {.amplitude = 0}},
        PerformerOptions{.performance = {.timing_error_s = -1}},
        PerformerOptions{.performance = {.wander_m = std::nan("")}}})
    EXPECT_THROW(check_performer(bad, "anyone"), std::invalid_argument);
  try {
    check_options({.b = {.height_m = 3}});
    FAIL();
  } catch (const std::invalid_argument& refused) {
    EXPECT_NE(std::string(refused.what()).find("performer b's height"), std::string::npos) << refused.what();
  }
}

double standing_height(const DancerBody& body) {
  const auto sum = [](const auto& lengths) { return std::accumulate(lengths.begin(), lengths.end(), 0.0); };
  return body.standing_root_height(1) + sum(body.spine) + sum(body.neck);
}

TEST(DancerBody, LongerLegsLeaveTheHeightAndShortenTheTrunk) {
  for (const double scale : {0.85, 1.0, 1.15}) {
    const DancerBody usual = leader_body(1.9), body = leader_body({.height_m = 1.9, .leg_scale = scale});
    EXPECT_NEAR(body.leg(), scale * usual.leg(), 1e-12);
    EXPECT_NEAR(standing_height(body), standing_height(usual), 1e-12);
    EXPECT_EQ(body.upper_arm, usual.upper_arm);
  }
}

TEST(DancerBody, LongerArmsAreLongerInEveryPart) {
  const DancerBody usual = follower_body(1.6), body = follower_body({.height_m = 1.6, .arm_scale = 1.2});
  EXPECT_NEAR(body.upper_arm, 1.2 * usual.upper_arm, 1e-12);
  EXPECT_NEAR(body.forearm, 1.2 * usual.forearm, 1e-12);
  EXPECT_NEAR(body.hand, 1.2 * usual.hand, 1e-12);
  EXPECT_EQ(body.thigh, usual.thigh);
}

}  // namespace
}  // namespace abrazo::choreography_options_test
