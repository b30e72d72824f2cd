#include "core/library/takes/eaf_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <pugixml.hpp>

namespace abrazo::eaf_file_test {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

const EafFacts facts = {"abrazo", "2026-11-21T20:15:00Z"};

/// What stands in a document, read with its references followed: tier, start and end [ms], value.
std::vector<std::string> annotations(const std::string& eaf) {
  pugi::xml_document document;
  const auto outcome = document.load_string(eaf.c_str(), pugi::parse_default | pugi::parse_ws_pcdata_single);
  EXPECT_TRUE(outcome) << outcome.description();
  std::map<std::string, std::string> slots;
  for (const auto& slot : document.select_nodes("//TIME_SLOT"))
    slots[slot.node().attribute("TIME_SLOT_ID").value()] = slot.node().attribute("TIME_VALUE").value();
  std::vector<std::string> found;
  for (const auto& one : document.select_nodes("//ALIGNABLE_ANNOTATION")) {
    const pugi::xml_node annotation = one.node();
    found.push_back(std::string(annotation.parent().parent().attribute("TIER_ID").value()) + " " +
                    slots.at(annotation.attribute("TIME_SLOT_REF1").value()) + "-" +
                    slots.at(annotation.attribute("TIME_SLOT_REF2").value()) + " " +
                    annotation.child_value("ANNOTATION_VALUE"));
  }
  return found;
}

std::string written(const std::vector<Tier>& tiers) {
  const auto eaf = write_eaf(tiers, facts);
  if (!eaf) ADD_FAILURE() << eaf.error().text();
  return eaf ? *eaf : std::string();
}

std::string refusal(const std::vector<Tier>& tiers) {
  const auto eaf = write_eaf(tiers, facts);
  return eaf ? "written" : eaf.error().text();
}

TEST(EafFile, HoldsTheIntervalsOfItsTiers) {
  const std::string eaf =
      written({{"role", {{0, 1.5, "active"}, {1.5, 4, "passive"}}, {{"active"}, {"passive"}}},
               {"move", {{0.25, 2, "basic"}}, {}}});
  EXPECT_THAT(annotations(eaf),
              ElementsAre("role 0-1500 active", "role 1500-4000 passive", "move 250-2000 basic"));
}

TEST(EafFile, TimeSlotsAreInTheOrderOfTime) {
  const std::string eaf = written({{"a", {{1, 5, "x"}}, {}}, {"b", {{0, 2, "y"}, {2, 3, "z"}}, {}}});
  pugi::xml_document document;
  ASSERT_TRUE(document.load_string(eaf.c_str()));
  std::vector<int> times;
  for (const auto& slot : document.select_nodes("//TIME_SLOT"))
    times.push_back(slot.node().attribute("TIME_VALUE").as_int());
  EXPECT_THAT(times, ElementsAre(0, 1000, 2000, 2000, 3000, 5000));
}

TEST(EafFile, ElementsAreInTheOrderOfTheSchema) {
  const std::string eaf =
      written({{"role", {{0, 1, "active"}}, {{"active"}, {"passive"}}}, {"note", {}, {}}});
  pugi::xml_document document;
  ASSERT_TRUE(document.load_string(eaf.c_str()));
  const pugi::xml_node root = document.child("ANNOTATION_DOCUMENT");
  std::vector<std::string> names;
  for (const pugi::xml_node child : root.children()) names.emplace_back(child.name());
  EXPECT_THAT(names, ElementsAre("HEADER", "TIME_ORDER", "TIER", "TIER", "LINGUISTIC_TYPE", "LINGUISTIC_TYPE",
                                 "LANGUAGE", "CONTROLLED_VOCABULARY"));
  EXPECT_STREQ(root.attribute("FORMAT").value(), "3.0");
  EXPECT_STREQ(root.attribute("DATE").value(), "2026-11-21T20:15:00Z");
  EXPECT_STREQ(root.child("HEADER").attribute("TIME_UNITS").value(), "milliseconds");
}

TEST(EafFile, AVocabularyIsReferredTo) {
  const std::string eaf = written({{"role", {{0, 1, "passive"}, {1, 2, "odd"}}, {{"active"}, {"passive"}}}});
  pugi::xml_document document;
  ASSERT_TRUE(document.load_string(eaf.c_str()));
  const auto entry = document.select_node("//CV_ENTRY_ML[CVE_VALUE='passive']").node();
  ASSERT_TRUE(entry);
  const auto first = document.select_node("//ALIGNABLE_ANNOTATION[@ANNOTATION_ID='a1']").node();
  EXPECT_STREQ(first.attribute("CVE_REF").value(), entry.attribute("CVE_ID").value());
  EXPECT_FALSE(document.select_node("//ALIGNABLE_ANNOTATION[@ANNOTATION_ID='a2']/@CVE_REF"));
  const auto type = document.select_node("//LINGUISTIC_TYPE[@LINGUISTIC_TYPE_ID='role']").node();
  EXPECT_STREQ(type.attribute("CONTROLLED_VOCABULARY_REF").value(),
               document.select_node("//CONTROLLED_VOCABULARY/@CV_ID").attribute().value());
}

TEST(EafFile, WordsOfAnyKindComeBack) {
  const std::string eaf = written({{"a <b> \"c\"", {{0, 1, "vuelta & salida <1> ñ  "}}, {}}});
  EXPECT_THAT(annotations(eaf), ElementsAre("a <b> \"c\" 0-1000 vuelta & salida <1> ñ  "));
}

TEST(EafFile, WhatRoundsToNothingTakesTheNextMillisecond) {
  const std::string eaf = written({{"m", {{1.0, 1.0004, "a"}, {1.0004, 1.0008, "b"}, {1.0008, 3, "c"}}, {}}});
  EXPECT_THAT(annotations(eaf), ElementsAre("m 1000-1001 a", "m 1001-1002 b", "m 1002-3000 c"));
}

TEST(EafFile, WhatItCannotHoldIsRefused) {
  EXPECT_THAT(refusal({{"m", {}, {}}, {"m", {}, {}}}), HasSubstr("m: two tiers of one name"));
  EXPECT_THAT(refusal({{"m", {{0, 2, "a"}, {1, 3, "b"}}, {}}}), HasSubstr("'b' at 1.0"));
  EXPECT_THAT(refusal({{"m", {{2, 1, "a"}}, {}}}), HasSubstr("runs backwards"));
  EXPECT_THAT(refusal({{"m", {{-1, 1, "a"}}, {}}}), HasSubstr("0 to 49 days"));
  EXPECT_THAT(refusal({{"m", {{0, 1e9, "a"}}, {}}}), HasSubstr("0 to 49 days"));
  EXPECT_THAT(refusal({{"m", {{0, std::nan(""), "a"}}, {}}}), HasSubstr("0 to 49 days"));
}

TEST(Tier, ValuesAreListedOnceInTheirOrder) {
  const std::vector<TierInterval> intervals = {{0, 1, "b"}, {1, 2, "a"}, {3, 4, "b"}};
  EXPECT_THAT(values_of(intervals), ElementsAre("b", "a"));
}

TEST(Tier, JsonHasTimesToTheLastBit) {
  const std::vector<Tier> tiers = {{"move", {{0.1, 1.0 / 3, "a\"b"}}, {{"a\"b"}}}};
  EXPECT_EQ(tiers_json(tiers),
            "{\"tiers\":[{\"name\":\"move\",\"kind\":\"note\",\"vocabulary\":[\"a\\\"b\"],\"intervals\":[{"
            "\"start_s\":0.1,"
            "\"end_s\":0.3333333333333333,\"value\":\"a\\\"b\"}]}]}\n");
}

}  // namespace
}  // namespace abrazo::eaf_file_test
