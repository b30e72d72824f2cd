#include "core/evaluation/sweep/sweep_axis.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace abrazo::sweep_axis_test {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

std::string refusal(std::string_view text) {
  const auto axis = parse_sweep_axis(text);
  return axis ? "accepted" : axis.error().text();
}

TEST(SweepAxis, GoesInEqualStepsFromOneEndToTheOther) {
  const auto axis = parse_sweep_axis("alpha=0:1:5");
  ASSERT_TRUE(axis) << axis.error().text();
  EXPECT_EQ(axis->key, "alpha");
  EXPECT_THAT(axis->values, ElementsAre("0", "0.25", "0.5", "0.75", "1"));
}

TEST(SweepAxis, HasTheNumbersOneWouldWrite) {
  EXPECT_THAT(parse_sweep_axis("alpha=0.1:0.7:7")->values,
              ElementsAre("0.1", "0.2", "0.3", "0.4", "0.5", "0.6", "0.7"));
}

TEST(SweepAxis, GoesInEqualRatiosWhenLogarithmic) {
  EXPECT_THAT(parse_sweep_axis("velocity-weight=log:0.01:1:5")->values,
              ElementsAre("0.01", "0.03162", "0.1", "0.3162", "1"));
}

TEST(SweepAxis, MayGoDownwards) {
  EXPECT_THAT(parse_sweep_axis("alpha=1:0:3")->values, ElementsAre("1", "0.5", "0"));
}

TEST(SweepAxis, RoundsWholeNumbers) {
  EXPECT_THAT(parse_sweep_axis("neighbours=log:5:200:4")->values, ElementsAre("5", "17", "58", "200"));
}

TEST(SweepAxis, RefusesWholeNumbersThatRoundToTheSame) {
  EXPECT_THAT(refusal("morph-steps=1:3:5"),
              HasSubstr("gives 2 twice; ask for fewer values or a wider range"));
}

TEST(SweepAxis, TakesValuesByName) {
  EXPECT_THAT(parse_sweep_axis("edge-weights=inverse,uniform")->values, ElementsAre("inverse", "uniform"));
  EXPECT_THAT(parse_sweep_axis("collisions=off,on")->values, ElementsAre("off", "on"));
  EXPECT_THAT(parse_sweep_axis("alpha=0.50, 1")->values, ElementsAre("0.5", "1"));
  EXPECT_THAT(parse_sweep_axis("alpha=0.5")->values, ElementsAre("0.5"));
}

TEST(SweepAxis, SaysTheRangeWhenAValueIsOutsideIt) {
  EXPECT_THAT(refusal("alpha=0:9:4"),
              HasSubstr("alpha=0:9:4: '6' cannot be used: a number from 0 to 5 is expected"));
  EXPECT_THAT(refusal("step-rate=1:60:3"), HasSubstr("5 to 120"));
  EXPECT_THAT(refusal("edge-weights=inverse,cubic"), HasSubstr("inverse|inverse-mean|uniform"));
}

TEST(SweepAxis, RefusesWhatItCannotRead) {
  EXPECT_THAT(refusal("alpha"), HasSubstr("as in alpha=0:1:5"));
  EXPECT_THAT(refusal("alfa=0:1:5"),
              HasSubstr("'alfa' is not a setting; there are selection, alpha, neighbours"));
  EXPECT_THAT(refusal("alpha=0:1"), HasSubstr("FROM:TO:COUNT"));
  EXPECT_THAT(refusal("alpha=0:x:3"), HasSubstr("FROM:TO:COUNT"));
  EXPECT_THAT(refusal("alpha=0:1:1"), HasSubstr("from 2 to 1000 values"));
  EXPECT_THAT(refusal("alpha=0:1:2000"), HasSubstr("from 2 to 1000 values"));
  EXPECT_THAT(refusal("alpha=log:0:1:3"), HasSubstr("above 0"));
  EXPECT_THAT(refusal("collisions=0:1:2"), HasSubstr("name its values"));
}

}  // namespace
}  // namespace abrazo::sweep_axis_test
