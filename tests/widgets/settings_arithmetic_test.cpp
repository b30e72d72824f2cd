#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <regex>

#include "core/synthesis/settings/preset_choice.hpp"
#include "widgets/common/typeset.hpp"
#include "widgets/settings/setting_help.hpp"
#include "widgets/settings/slider_scale.hpp"

namespace abrazo::widgets::settings_arithmetic_test {
namespace {

using testing::HasSubstr;
using testing::Not;

/// Without what says how large an index is.
std::string plain_typeset(const char* line) {
  return std::regex_replace(typeset(line), std::regex("<sub[^>]*>"), "<sub>");
}

TEST(Typeset, SetsLowWhatFollowsAnUnderscore) {
  EXPECT_EQ(plain_typeset("w_\u0394 E_V"), "w<sub>\u0394</sub> E<sub>V</sub>");
  EXPECT_EQ(plain_typeset("q\u2033_A|\u00b2"), "q\u2033<sub>A</sub>|\u00b2");
  EXPECT_EQ(plain_typeset("V_{i-1} \u2212 V_{i-2}"), "V<sub>i-1</sub> \u2212 V<sub>i-2</sub>");
  EXPECT_EQ(plain_typeset("a < b & c_1"), "a &lt; b &amp; c<sub>1</sub>");
  EXPECT_EQ(plain_typeset("a_ b"), "a_ b");
  EXPECT_EQ(plain_typeset(""), "");
}

TEST(SettingHelp, EverySettingTellsItsPaperSectionOrThatItIsNotInThePaper) {
  for (const SettingInfo& info : all_settings()) {
    const std::string help(info.help);
    EXPECT_TRUE(help.find("Paper 3.") != std::string::npos ||
                help.find("Not in the paper") != std::string::npos)
        << info.key;
    const std::string tooltip = setting_tooltip(info);
    EXPECT_THAT(tooltip, HasSubstr(value_range(info))) << info.key;
    EXPECT_THAT(tooltip, HasSubstr("default ")) << info.key;
    EXPECT_THAT(tooltip, Not(HasSubstr("_"))) << "every index is set low: " << info.key;
  }
}

TEST(SettingHelp, NamesRangeUnitAndDefaults) {
  EXPECT_EQ(value_range(*find_setting("foot-lock-speed")), "0 to 1 m/s");
  EXPECT_EQ(value_range(*find_setting("collisions")), "on, off");
  EXPECT_EQ(value_range(*find_setting("velocity-form")), "velocity, predicted");
  EXPECT_EQ(preset_values(*find_setting("alpha")), "0.5 (paper), 0.2 (responsive)");
  EXPECT_EQ(preset_values(*find_setting("neighbours")), "10");
}

TEST(SettingHelp, IsFoundByAnyOfItsWords) {
  const SettingInfo& alpha = *find_setting("alpha");
  for (const char* words : {"", "alpha", "TEMPORAL", "smooth coherence", "selection", "eq. 7"})
    EXPECT_TRUE(matches(alpha, words)) << words;
  EXPECT_FALSE(matches(alpha, "temporal foot"));
  EXPECT_TRUE(matches(*find_setting("velocity-weight"), "w_delta")) << "Greek letters are hard to type";
}

/// 0.69 was 0.6900000000000001, and so the settings lane said.
TEST(SliderScale, ValuesAreTheNearestOfTheirDecimals) {
  const SliderScale plain{0, 2, false, false}, wide{0, 5000, false, false};
  for (int hundredth = 0; hundredth <= 200; ++hundredth)
    EXPECT_EQ(plain.value(hundredth / 200.0), hundredth / 100.0);
  EXPECT_EQ(wide.value(0.5), 2500);
}

TEST(SliderScale, KeysGoThroughWholeNumbersOneByOneAlsoWhereTheScaleIsLogarithmic) {
  const SliderScale scale{1, 200, true, true};
  EXPECT_EQ(scale.stepped(10, 1), 11);
  EXPECT_EQ(scale.stepped(10, -10), 1);
  EXPECT_EQ(scale.stepped(199, 10), 200);
}

TEST(SliderScale, EveryKeyChangesAReal) {
  for (const SettingInfo& info : all_settings()) {
    if (info.kind != SettingInfo::Kind::Real) continue;
    const SliderScale scale{info.minimum, info.maximum, info.logarithmic, false};
    const double middle = scale.value(0.5);
    EXPECT_GT(scale.stepped(middle, 1), middle) << info.key;
    EXPECT_LT(scale.stepped(middle, -1), middle) << info.key;
  }
}

TEST(SliderScale, NothingLiesInTheGap) {
  const SliderScale rate{0, 120, false, false, 5};
  EXPECT_EQ(rate.value(1.0 / 120), 0);
  EXPECT_EQ(rate.value(4.0 / 120), 5);
  EXPECT_NEAR(rate.value(15.0 / 120), 15, 0.01);
  EXPECT_EQ(rate.stepped(0, 1), 5);
  EXPECT_GE(rate.stepped(5, 1), 5);
}

TEST(PresetChoice, IsTheOneChosenUntilAnotherFits) {
  const std::vector<OwnPreset> own = {{"calm", [] {
                                         Settings settings = *preset("paper");
                                         settings.alpha = 2;
                                         return settings;
                                       }()}};
  PresetChoice choice;
  EXPECT_EQ(choice.name, "paper");
  choice = choice_for(*preset("responsive"), choice, own);
  EXPECT_EQ(choice.name, "responsive");
  Settings changed = *preset("responsive");
  changed.alpha = 0.3;
  choice = choice_for(changed, choice, own);
  EXPECT_EQ(choice.name, "responsive") << "with a star";
  choice = choice_for(own[0].settings, choice, own);
  EXPECT_EQ(choice.name, "calm");
  EXPECT_TRUE(choice.own);
  const PresetChoice namesake{"as the paper", true, *preset("paper")};
  EXPECT_EQ(choice_for(*preset("paper"), namesake, own), namesake) << "the chosen one of two that are equal";
}

}  // namespace
}  // namespace abrazo::widgets::settings_arithmetic_test
