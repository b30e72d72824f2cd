#include "core/synthesis/settings/settings.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <tuple>

#include "core/base/limits.hpp"
#include "core/synthesis/settings/settings_check.hpp"
#include "tests/support/bodies.hpp"

namespace abrazo::settings_test {
namespace {

TEST(Settings, ThePaperPresetIsThePapersLetter) {
  const Settings paper = *preset("paper");
  EXPECT_EQ(paper.selection, SelectionMethod::Paper);
  EXPECT_EQ(paper.alpha, 0.5);
  EXPECT_EQ(paper.velocity_weight, 0.2);
  EXPECT_EQ(paper.velocity_form, VelocityForm::Velocity);
  EXPECT_EQ(paper.neighbours, 10);
  EXPECT_EQ(paper.step_rate_hz, 15);
  EXPECT_EQ(paper.morph_steps, 5);
  EXPECT_EQ(paper.continuations, 0);
  EXPECT_EQ(paper.playback, SourcePlayback::Frames);
  EXPECT_EQ(paper.hold_weight, 0);
  EXPECT_EQ(paper.foot_lock_speed, 0);
}

TEST(Settings, TheResponsivePresetIsThatOfTheGuide) {
  Settings wanted;  // of all others the default is the paper's value
  wanted.selection = SelectionMethod::Intent;
  wanted.alpha = 0.2;
  wanted.continuations = 3;
  wanted.switch_margin = 0.097;
  wanted.velocity_weight = 0;
  wanted.hold_weight = 50;
  wanted.foot_lock_speed = 0.3;
  wanted.playback = SourcePlayback::Continuous;
  wanted.step_rate_hz = 0;
  EXPECT_EQ(*preset("responsive"), wanted);
}

TEST(Settings, AnUnknownPresetNamesTheKnownOnes) {
  const auto unknown = preset("fast");
  ASSERT_FALSE(unknown);
  EXPECT_NE(unknown.error().text().find("paper or responsive"), std::string::npos);
}

TEST(Settings, EverySettingRoundTripsThroughItsText) {
  for (const auto name : preset_names) {
    const Settings original = *preset(name);
    Settings copy;
    for (const SettingInfo& info : all_settings()) {
      const Status set = set_setting(copy, info.key, setting_text(original, info.key));
      EXPECT_TRUE(set.ok()) << info.key;
    }
    EXPECT_EQ(copy, original);
  }
}

TEST(Settings, MoreJsonThanSettingsCanHaveIsRefusedUnread) {
  const std::string room(limits::settings_bytes - 2, ' ');
  EXPECT_TRUE(parse_settings("{" + room + "}", Settings{}, "x.json"));
  const auto refused = parse_settings("{ " + room + "}", Settings{}, "x.json");
  ASSERT_FALSE(refused);
  EXPECT_THAT(refused.error().text(),
              testing::HasSubstr("x.json: has 1048577 bytes of settings; up to 1048576 are read"));
}

TEST(Settings, JsonRoundTrips) {
  Settings settings = *preset("responsive");
  settings.alpha = 0.1234567890123;
  settings.edge_weights = EdgeWeights::InverseMean;
  settings.collisions = false;
  settings.selection = SelectionMethod::Intent;
  settings.switch_margin = 0.0625;
  settings.leader_weight = 1.0 / 3;
  settings.move_weight = 0;
  settings.meant_weight = 2;
  const auto back = parse_settings(settings_json(settings), Settings{}, "settings.json");
  ASSERT_TRUE(back.ok());
  EXPECT_EQ(*back, settings);
}

TEST(Settings, BodiesAreSaidByTheirWordAndAMeasuredFileKeepsItsLengths) {
  Settings settings;
  ASSERT_TRUE(set_setting(settings, "active-body", "user"));
  ASSERT_TRUE(set_setting(settings, "passive-body", "scale:0.85"));
  EXPECT_EQ(setting_text(settings, "active-body"), "user");
  EXPECT_EQ(setting_text(settings, "passive-body"), "scale:0.85");
  EXPECT_TRUE(check_settings(settings));
  ASSERT_TRUE(set_setting(settings, "active-body", "tall.bvh"));
  EXPECT_FALSE(check_settings(settings)) << "the file was not read";
  settings.active_body.measured = body_of(test::standing_pose());
  EXPECT_TRUE(check_settings(settings));
  const auto read = parse_settings(settings_json(settings), Settings{}, "settings.json");
  ASSERT_TRUE(read) << read.error().text();
  EXPECT_EQ(*read, settings);
  EXPECT_FALSE(parse_settings(R"({"active-body": {"file": "tall.bvh", "bones": [1]}})", Settings{}, "s"));
  EXPECT_FALSE(set_setting(settings, "passive-body", "user"));
  EXPECT_EQ(setting_text(settings, "passive-body"), "scale:0.85");
}

TEST(Settings, AMeasuredBodyHasItsFourFieldsAndNoOthers) {
  Settings settings;
  ASSERT_TRUE(set_setting(settings, "active-body", "tall.bvh"));
  settings.active_body.measured = body_of(test::standing_pose());
  const nlohmann::json whole = nlohmann::json::parse(settings_json(settings));
  const auto refusal = [](const nlohmann::json& json) {
    const auto read = parse_settings(json.dump(), Settings{}, "settings.json");
    return read ? std::string("was read") : read.error().text();
  };
  EXPECT_EQ(refusal(whole), "was read");
  nlohmann::json more = whole;
  more["active-body"]["height"] = 1.8;
  EXPECT_THAT(refusal(more), testing::HasSubstr("a file with its lengths in metres is expected"));
  for (const auto& [field, value] : whole["active-body"].items()) {
    nlohmann::json less = whole;
    less["active-body"].erase(field);
    EXPECT_THAT(refusal(less), testing::HasSubstr("a file with its lengths in metres is expected")) << field;
  }
}

TEST(Settings, TheContractsKeysExist) {
  for (const auto key :
       {"alpha", "velocity-weight", "velocity-form", "morph-weight", "morph-steps", "projection-steps",
        "neighbours", "edge-weights", "step-rate", "collisions", "foot-locks", "user-role", "selection",
        "switch-margin", "leader-weight", "move-weight", "meant-weight"})
    EXPECT_NE(find_setting(key), nullptr) << key;
}

TEST(Settings, WrongValuesAreRefusedWithTheRangeAndChangeNothing) {
  Settings settings;
  for (const auto& [key, text, hint] : std::vector<std::tuple<const char*, const char*, const char*>>{
           {"alpha", "-1", "from 0 to 5"},
           {"alpha", "nan", "from 0 to 5"},
           {"alpha", "0,5", "from 0 to 5"},
           {"step-rate", "3", "5 to 120"},
           {"step-rate", "1e-20", "5 to 120"},
           {"neighbours", "10.5", "whole number"},
           {"neighbours", "201", "from 1 to 200"},
           {"collisions", "yes", "on or off"},
           {"selection", "eq7", "paper|intent"},
           {"switch-margin", "0.51", "from 0 to 0.5"},
           {"switch-margin", "-0.01", "from 0 to 0.5"},
           {"leader-weight", "2.1", "from 0 to 2"},
           {"move-weight", "inf", "from 0 to 2"},
           {"meant-weight", "-1", "from 0 to 2"},
           {"edge-weights", "cubic", "inverse|inverse-mean|uniform"}}) {
    const Status set = set_setting(settings, key, text);
    ASSERT_FALSE(set.ok()) << key << '=' << text;
    EXPECT_NE(set.error().text().find(hint), std::string::npos) << set.error().text();
  }
  EXPECT_EQ(settings, Settings{});
}

TEST(Settings, TheMethodOfSelectionIsSaidByName) {
  Settings settings;
  EXPECT_EQ(setting_text(settings, "selection"), "paper");
  EXPECT_EQ(preset("responsive")->selection, SelectionMethod::Intent);
  ASSERT_TRUE(set_setting(settings, "selection", "intent").ok());
  EXPECT_EQ(settings.selection, SelectionMethod::Intent);
  const auto read =
      parse_settings(R"({"selection": "intent", "switch-margin": 0.05})", Settings{}, "mine.json");
  ASSERT_TRUE(read.ok());
  EXPECT_EQ(read->selection, SelectionMethod::Intent);
  EXPECT_EQ(read->switch_margin, 0.05);
}

TEST(Settings, EachMethodOfSelectionHasItsOwnWeightsAndTheRestIsOfBoth) {
  Settings paper, intent;
  intent.selection = SelectionMethod::Intent;
  for (const SettingInfo& info : all_settings()) {
    const bool of_paper = info.key == "continuations";
    const bool of_continuous =
        info.key == "transition-time" || info.key == "place-rate" || info.key == "hold-weight";
    if (of_continuous) {
      EXPECT_FALSE(applies(paper, info.key)) << info.key;
      EXPECT_TRUE(applies(*preset("responsive"), info.key)) << info.key;
      continue;
    }
    const bool of_intent = info.key == "switch-margin" || info.key == "leader-weight" ||
                           info.key == "move-weight" || info.key == "meant-weight";
    EXPECT_EQ(applies(paper, info.key), !of_intent) << info.key;
    EXPECT_EQ(applies(intent, info.key), !of_paper) << info.key;
  }
}

TEST(Settings, OneThatDoesNotApplySaysWhatItNeeds) {
  const Settings paper = *preset("paper"), responsive = *preset("responsive");
  EXPECT_EQ(why_it_does_not_apply(paper, "switch-margin"), "Only with the method intent; it is paper now");
  EXPECT_EQ(why_it_does_not_apply(paper, "place-rate"),
            "Only with the playback continuous; it is frames now");
  EXPECT_EQ(why_it_does_not_apply(responsive, "velocity-form"),
            "Only with a velocity weight above 0; it is 0 now");
  EXPECT_EQ(why_it_does_not_apply(responsive, "continuations"),
            "Only with the method paper and the playback frames; it is intent and continuous now");
}

TEST(Settings, AnUnknownKeyInAFileIsAnError) {
  const auto parsed = parse_settings(R"({"alhpa": 0.3})", Settings{}, "mine.json");
  ASSERT_FALSE(parsed);
  EXPECT_NE(parsed.error().text().find("alhpa"), std::string::npos);
  EXPECT_NE(parsed.error().text().find("mine.json"), std::string::npos);
  for (const SettingInfo& info : all_settings())
    EXPECT_NE(parsed.error().text().find(info.key), std::string::npos) << "what there is: " << info.key;
}

TEST(VelocityWeight, IsAsGivenAtFifteenStepsPerSecond) {
  EXPECT_NEAR(velocity_weight_at(*preset("paper"), 1.0 / 15), 0.2, 1e-12);
}

TEST(VelocityWeight, TheVelocityFormKeepsItsLagAtEveryRate) {
  // One coordinate that follows x* = t: minimising k/2 (x - x*)^2 + w/2 (x - x_before)^2 step by step.
  const Settings settings = *preset("paper");
  constexpr double k = 0.7;
  const auto lag_at = [&](double rate) {
    const double w = velocity_weight_at(settings, 1 / rate);
    double x = 0;
    const int steps = static_cast<int>(20 * rate);
    for (int i = 1; i <= steps; ++i) x = (k * (i / rate) + w * x) / (k + w);
    return steps / rate - x;
  };
  EXPECT_NEAR(lag_at(60), lag_at(15), 1e-6);
  EXPECT_NEAR(lag_at(120), lag_at(15), 1e-6);
}

}  // namespace
}  // namespace abrazo::settings_test
