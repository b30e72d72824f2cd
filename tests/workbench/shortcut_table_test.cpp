#include "app/workbench/keys/shortcut_table.hpp"

#include <gtest/gtest.h>

#include "app/workbench/base/action_id.hpp"

namespace abrazo::app::shortcut_table_test {
namespace {

using Keys = std::vector<std::string>;

/// As a toolkit would: knows a few keys, and writes them in one way.
std::string normal(const std::string& key) {
  if (key == "ctrl+k") return "Ctrl+K";
  for (const char* known : {"A", "B", "Space", "Ctrl+K", "F1", "Home"})
    if (key == known) return key;
  return {};
}

ShortcutTable table() {
  ShortcutTable made;
  made.add({"play.play", "Play", "Play or pause", {"Space"}, {"Space"}});
  made.add({"compare.freeze", "Compare", "Freeze", {"A"}, {"A"}});
  made.add({"view.nothing", "View", "Select nothing", {"B"}, {"B"}, KeyPlace::Scene});
  made.add({"timeline.edge", "Timeline", "Next edge", {"B"}, {"B"}, KeyPlace::Timeline});
  made.add({"scene.all", "", "Show all", {"Home"}, {"Home"}, KeyPlace::Scene, true});
  return made;
}

Keys ids(const std::vector<const Shortcut*>& found) {
  Keys result;
  for (const Shortcut* each : found) result.push_back(each->id);
  return result;
}

TEST(ShortcutTable, TheSameKeyInTheSceneAndInTheTimelineIsNoClash) {
  EXPECT_TRUE(table().clashes("view.nothing", "B").empty());
  EXPECT_EQ(ids(table().clashes("play.play", "B")), (Keys{"view.nothing", "timeline.edge"}))
      << "but a key of the whole window is both";
  EXPECT_TRUE(table().clashes("play.play", "Space").empty()) << "nobody clashes with himself";
}

TEST(ShortcutTable, AKeyThatIsGivenIsTakenFromWhoHadIt) {
  ShortcutTable keys = table();
  keys.give("compare.freeze", "Space");
  EXPECT_EQ(keys.find("compare.freeze")->keys, (Keys{"A", "Space"}));
  EXPECT_TRUE(keys.find("play.play")->keys.empty());
  EXPECT_TRUE(keys.find("play.play")->is_changed());
}

TEST(ShortcutTable, AViewKeepsItsOwnKeyAndThatIsTold) {
  ShortcutTable keys = table();
  EXPECT_EQ(ids(keys.clashes("play.play", "Home")), Keys{"scene.all"});
  keys.give("play.play", "Home");
  EXPECT_EQ(keys.find("scene.all")->keys, Keys{"Home"});
  EXPECT_EQ(keys.find("play.play")->keys, (Keys{"Space", "Home"}));
  keys.take("scene.all", "Home");
  EXPECT_EQ(keys.find("scene.all")->keys, Keys{"Home"});
}

TEST(ShortcutTable, TheUsualKeysComeBackForOneAndForAll) {
  ShortcutTable keys = table();
  keys.give("compare.freeze", "Space");
  keys.reset("play.play");
  EXPECT_EQ(keys.find("play.play")->keys, Keys{"Space"});
  EXPECT_EQ(keys.find("compare.freeze")->keys, Keys{"A"}) << "it had the key only meanwhile";
  keys.take("compare.freeze", "A");
  keys.give("play.play", "F1");
  keys.reset_all();
  for (const Shortcut& each : keys.all()) EXPECT_FALSE(each.is_changed()) << each.id;
}

TEST(ShortcutTable, WhatIsWrittenIsReadAgain) {
  ShortcutTable keys = table();
  keys.give("compare.freeze", "Space");
  keys.take("view.nothing", "B");
  ShortcutTable again = table();
  EXPECT_TRUE(again.read(keys.text(), normal).empty());
  for (std::size_t i = 0; i < keys.all().size(); ++i)
    EXPECT_EQ(again.all()[i].keys, keys.all()[i].keys) << keys.all()[i].id;
}

TEST(ShortcutTable, OnlyWhatDiffersIsWritten) {
  EXPECT_EQ(table().text().find("play.play"), std::string::npos);
}

TEST(ShortcutTable, WhatCannotBeUsedIsToldAndKeptInTheFile) {
  ShortcutTable keys = table();
  const std::string text =
      R"({"abrazo_shortcuts": 1, "keys": {"play.play": ["Nonsense"], "gone.action": ["F1"],)"
      R"( "compare.freeze": ["ctrl+k"], "timeline.edge": "F1"}})";
  const std::vector<std::string> told = keys.read(text, normal);
  ASSERT_EQ(told.size(), 3U);
  EXPECT_NE(told[0].find("'Nonsense' is not a key"), std::string::npos);
  EXPECT_NE(told[1].find("no such action"), std::string::npos);
  EXPECT_NE(told[2].find("not a list"), std::string::npos);
  EXPECT_EQ(keys.find("play.play")->keys, Keys{"Space"});
  EXPECT_EQ(keys.find("compare.freeze")->keys, Keys{"Ctrl+K"}) << "the good one is in use";
  for (const char* kept : {"Nonsense", "gone.action", "timeline.edge"})
    EXPECT_NE(keys.text().find(kept), std::string::npos) << kept;
  keys.give("play.play", "F1");
  EXPECT_EQ(keys.text().find("Nonsense"), std::string::npos) << "until a person chose another";
  keys.reset_all();
  EXPECT_NE(keys.text().find("gone.action"), std::string::npos) << "another version may know it";
}

TEST(ShortcutTable, OfTwoChosenForTheSameKeyTheLaterIsLeftOut) {
  ShortcutTable keys = table();
  const auto told = keys.read(
      R"({"abrazo_shortcuts": 1, "keys": {"compare.freeze": ["F1"], "play.play": ["F1"]}})", normal);
  ASSERT_EQ(told.size(), 1U);
  EXPECT_NE(told[0].find("'Play or pause'"), std::string::npos);
  EXPECT_EQ(keys.find("play.play")->keys, Keys{"F1"});
  EXPECT_EQ(keys.find("compare.freeze")->keys, Keys{"A"});
}

TEST(ShortcutTable, AChosenKeyWinsOverAUsualOne) {
  ShortcutTable keys = table();
  EXPECT_TRUE(keys.read(R"({"abrazo_shortcuts": 1, "keys": {"compare.freeze": ["Space"]}})", normal).empty());
  EXPECT_EQ(keys.find("compare.freeze")->keys, Keys{"Space"});
  EXPECT_TRUE(keys.find("play.play")->keys.empty());
}

TEST(ShortcutTable, TwoActionsMaySwapTheirKeys) {
  ShortcutTable keys = table();
  EXPECT_TRUE(
      keys.read(R"({"abrazo_shortcuts": 1, "keys": {"compare.freeze": ["Space"], "play.play": ["A"]}})",
                normal)
          .empty());
  EXPECT_EQ(keys.find("compare.freeze")->keys, Keys{"Space"});
  EXPECT_EQ(keys.find("play.play")->keys, Keys{"A"});
}

TEST(ShortcutTable, SomethingElseThanAListOfShortcutsIsTold) {
  for (const char* text : {"", "[1, 2]", "{\"abrazo_shortcuts\": 1}", "{\"keys\": {}"}) {
    ShortcutTable keys = table();
    ASSERT_EQ(keys.read(text, normal).size(), 1U) << text;
    EXPECT_FALSE(keys.find("play.play")->is_changed());
  }
}

TEST(ShortcutId, IsMadeOfMenuAndWords) {
  EXPECT_EQ(action_id("View > Layouts", "Save layout…"), "view_layouts.save_layout");
  EXPECT_EQ(action_id("Play", "Play or pause"), "play.play_or_pause");
  EXPECT_EQ(action_id("Timeline > Play", "Play or pause"), "play.play_or_pause")
      << "wherever its menu stands";
}

}  // namespace
}  // namespace abrazo::app::shortcut_table_test
