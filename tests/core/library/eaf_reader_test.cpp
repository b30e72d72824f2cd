#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/library/takes/tier_file.hpp"

namespace abrazo::eaf_reader_test {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::UnorderedElementsAre;

std::string slot(int n, const char* ms) {
  return "<TIME_SLOT TIME_SLOT_ID=\"ts" + std::to_string(n) + "\"" +
         (*ms ? std::string(" TIME_VALUE=\"") + ms + "\"" : "") + "/>";
}

std::string aligned(const char* id, int from, int to, const char* value, const char* more = "") {
  return std::string("<ANNOTATION><ALIGNABLE_ANNOTATION ANNOTATION_ID=\"") + id + "\" TIME_SLOT_REF1=\"ts" +
         std::to_string(from) + "\" TIME_SLOT_REF2=\"ts" + std::to_string(to) + "\" " + more +
         "><ANNOTATION_VALUE>" + value + "</ANNOTATION_VALUE></ALIGNABLE_ANNOTATION></ANNOTATION>";
}

std::string referring(const char* id, const char* parent, const char* value, const char* previous = "") {
  return std::string("<ANNOTATION><REF_ANNOTATION ANNOTATION_ID=\"") + id + "\" ANNOTATION_REF=\"" + parent +
         "\"" + (*previous ? std::string(" PREVIOUS_ANNOTATION=\"") + previous + "\"" : "") +
         "><ANNOTATION_VALUE>" + value + "</ANNOTATION_VALUE></REF_ANNOTATION></ANNOTATION>";
}

std::string document(const std::string& slots, const std::string& tiers, const std::string& rest = "",
                     const char* format = "3.0", const char* header = "TIME_UNITS=\"milliseconds\"") {
  return std::string(
             "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<ANNOTATION_DOCUMENT AUTHOR=\"\" "
             "DATE=\"2015-01-01T00:00:00+01:00\" FORMAT=\"") +
         format + "\" VERSION=\"" + format + "\"><HEADER MEDIA_FILE=\"\" " + header + "/><TIME_ORDER>" +
         slots + "</TIME_ORDER>" + tiers + rest + "</ANNOTATION_DOCUMENT>";
}

TierDocument read(const std::string& eaf) {
  auto document = parse_tiers(eaf, "x.eaf", {});
  if (!document) ADD_FAILURE() << document.error().text();
  return document ? *document : TierDocument{};
}

TEST(EafReader, ReadsVocabulariesOfBefore28) {
  const TierDocument found = read(document(
      slot(1, "0") + slot(2, "1500"),
      "<TIER LINGUISTIC_TYPE_REF=\"moves\" TIER_ID=\"Move\">" + aligned("a1", 1, 2, "vuelta") + "</TIER>",
      "<LINGUISTIC_TYPE CONTROLLED_VOCABULARY_REF=\"cv\" LINGUISTIC_TYPE_ID=\"moves\" "
      "TIME_ALIGNABLE=\"true\"/>"
      "<CONTROLLED_VOCABULARY CV_ID=\"cv\" DESCRIPTION=\"\"><CV_ENTRY DESCRIPTION=\"a "
      "turn\">vuelta</CV_ENTRY>"
      "<CV_ENTRY>salida</CV_ENTRY></CONTROLLED_VOCABULARY>",
      "2.7"));
  EXPECT_EQ(found.tiers,
            (std::vector<Tier>{
                {"Move", {{0, 1.5, "vuelta"}}, {{"vuelta", "a turn"}, {"salida"}}, TierKind::Move}}));
  EXPECT_THAT(found.warnings, IsEmpty());
}

TEST(EafReader, WhatDividesItsParentMeetsWithoutAGapOrAnOverlap) {
  for (int end_ms = 1001; end_ms < 1400; end_ms += 7)
    for (int parts = 2; parts < 9; ++parts) {
      std::string children;
      for (int i = 0; i < parts; ++i)
        children += referring(("c" + std::to_string(i)).c_str(), "a1", std::to_string(i).c_str(),
                              i == 0 ? "" : ("c" + std::to_string(i - 1)).c_str());
      const TierDocument found = read(document(
          slot(1, "3") + slot(2, std::to_string(end_ms).c_str()),
          "<TIER LINGUISTIC_TYPE_REF=\"t\" TIER_ID=\"p\">" + aligned("a1", 1, 2, "whole") +
              "</TIER><TIER LINGUISTIC_TYPE_REF=\"s\" PARENT_REF=\"p\" TIER_ID=\"c\">" + children + "</TIER>",
          "<LINGUISTIC_TYPE LINGUISTIC_TYPE_ID=\"t\"/>"
          "<LINGUISTIC_TYPE CONSTRAINTS=\"Symbolic_Subdivision\" LINGUISTIC_TYPE_ID=\"s\"/>"));
      ASSERT_EQ(found.tiers.size(), 2U);
      const auto& intervals = found.tiers[1].intervals;
      ASSERT_EQ(intervals.size(), static_cast<std::size_t>(parts));
      for (std::size_t i = 1; i < intervals.size(); ++i)
        EXPECT_EQ(intervals[i - 1].end_s, intervals[i].start_s);
      EXPECT_EQ(intervals.back().end_s, end_ms / 1000.0);
    }
}

TEST(EafReader, CommentsAndCdataDoNotCutAValue) {
  const TierDocument found =
      read(document(slot(1, "0") + slot(2, "1500"),
                    "<TIER LINGUISTIC_TYPE_REF=\"t\" TIER_ID=\"Move\">" +
                        aligned("a1", 1, 2, "turn<!-- checked --> to the <![CDATA[<left>]]>") + "</TIER>",
                    "<LINGUISTIC_TYPE LINGUISTIC_TYPE_ID=\"t\"/>"));
  ASSERT_EQ(found.tiers.size(), 1U);
  ASSERT_EQ(found.tiers[0].intervals.size(), 1U);
  EXPECT_EQ(found.tiers[0].intervals[0].value, "turn to the <left>");
}

/// A vocabulary in two languages, and a tier that may say which is its own.
std::string bilingual(const char* value, const char* tier_language) {
  const std::string language =
      *tier_language ? std::string(" LANG_REF=\"") + tier_language + "\"" : std::string();
  return document(
      slot(1, "0") + slot(2, "1500"),
      "<TIER LINGUISTIC_TYPE_REF=\"moves\" TIER_ID=\"m\"" + language + ">" +
          aligned("a1", 1, 2, value, "CVE_REF=\"v0\"") + "</TIER>",
      "<LINGUISTIC_TYPE CONTROLLED_VOCABULARY_REF=\"cv\" LINGUISTIC_TYPE_ID=\"moves\"/>"
      "<LANGUAGE LANG_ID=\"eng\"/><LANGUAGE LANG_ID=\"spa\"/><CONTROLLED_VOCABULARY CV_ID=\"cv\">"
      "<CV_ENTRY_ML CVE_ID=\"v0\"><CVE_VALUE LANG_REF=\"eng\" DESCRIPTION=\"round\">turn</CVE_VALUE>"
      "<CVE_VALUE LANG_REF=\"spa\">vuelta</CVE_VALUE></CV_ENTRY_ML>"
      "<CV_ENTRY_ML CVE_ID=\"v1\"><CVE_VALUE LANG_REF=\"eng\">basic</CVE_VALUE></CV_ENTRY_ML>"
      "</CONTROLLED_VOCABULARY>");
}

TEST(EafReader, TakesTheLanguageThatTheTierIsIn) {
  EXPECT_EQ(read(bilingual("turn", "")).tiers[0].vocabulary,
            (std::vector<VocabularyEntry>{{"turn", "round"}, {"basic"}}));
  const TierDocument spanish = read(bilingual("vuelta", ""));
  EXPECT_EQ(spanish.tiers[0].vocabulary, (std::vector<VocabularyEntry>{{"vuelta"}}));
  EXPECT_THAT(spanish.warnings, ElementsAre(HasSubstr("1 vocabulary entry without a word")));
  EXPECT_EQ(read(bilingual("turn", "spa")).tiers[0].vocabulary, (std::vector<VocabularyEntry>{{"vuelta"}}));
}

TEST(EafReader, SlotsWithoutAValueLieEvenlyBetweenTheirNeighbours) {
  const TierDocument found =
      read(document(slot(1, "0") + slot(2, "") + slot(3, "") + slot(4, "900"),
                    "<TIER LINGUISTIC_TYPE_REF=\"t\" TIER_ID=\"m\">" + aligned("a1", 1, 2, "a") +
                        aligned("a2", 2, 3, "b") + aligned("a3", 3, 4, "c") + "</TIER>",
                    "<LINGUISTIC_TYPE LINGUISTIC_TYPE_ID=\"t\"/>"));
  ASSERT_EQ(found.tiers[0].intervals.size(), 3u);
  EXPECT_NEAR(found.tiers[0].intervals[1].start_s, 0.3, 1e-12);
  EXPECT_NEAR(found.tiers[0].intervals[1].end_s, 0.6, 1e-12);
  EXPECT_THAT(found.warnings, ElementsAre(HasSubstr("2 time slots without a value")));
}

TEST(EafReader, SlotsOfOneTierDoNotPlaceThoseOfAnother) {
  const TierDocument found = read(document(
      slot(1, "0") + slot(2, "100") + slot(3, "") + slot(4, "200") + slot(5, "1000"),
      "<TIER LINGUISTIC_TYPE_REF=\"t\" TIER_ID=\"m\">" + aligned("a1", 1, 3, "a") + aligned("a2", 3, 5, "b") +
          "</TIER><TIER LINGUISTIC_TYPE_REF=\"t\" TIER_ID=\"n\">" + aligned("a3", 2, 4, "x") + "</TIER>",
      "<LINGUISTIC_TYPE LINGUISTIC_TYPE_ID=\"t\"/>"));
  EXPECT_EQ(found.tiers[0].intervals, (std::vector<TierInterval>{{0, 0.5, "a"}, {0.5, 1, "b"}}));
}

TEST(EafReader, SymbolicChildrenAreWhenTheirParentsAre) {
  const TierDocument found =
      read(document(slot(1, "1000") + slot(2, "4000"),
                    "<TIER LINGUISTIC_TYPE_REF=\"t\" TIER_ID=\"m\">" + aligned("a1", 1, 2, "turn") +
                        "</TIER><TIER LINGUISTIC_TYPE_REF=\"sub\" PARENT_REF=\"m\" TIER_ID=\"steps\">" +
                        referring("a4", "a1", "three", "a3") + referring("a2", "a1", "one") +
                        referring("a3", "a1", "two", "a2") +
                        "</TIER><TIER LINGUISTIC_TYPE_REF=\"ass\" PARENT_REF=\"steps\" TIER_ID=\"foot\">" +
                        referring("a5", "a3", "left") + "</TIER>",
                    "<LINGUISTIC_TYPE LINGUISTIC_TYPE_ID=\"t\"/><LINGUISTIC_TYPE LINGUISTIC_TYPE_ID=\"sub\" "
                    "CONSTRAINTS=\"Symbolic_Subdivision\"/><LINGUISTIC_TYPE LINGUISTIC_TYPE_ID=\"ass\" "
                    "CONSTRAINTS=\"Symbolic_Association\"/>"));
  ASSERT_EQ(found.tiers.size(), 3u);
  EXPECT_EQ(found.tiers[1].intervals,
            (std::vector<TierInterval>{{1, 2, "one"}, {2, 3, "two"}, {3, 4, "three"}}));
  EXPECT_EQ(found.tiers[2].intervals, (std::vector<TierInterval>{{2, 3, "left"}}));
}

TEST(EafReader, FramesOfTelevisionAreTimes) {
  const std::string tier =
      "<TIER LINGUISTIC_TYPE_REF=\"t\" TIER_ID=\"m\">" + aligned("a1", 1, 2, "a") + "</TIER>";
  const std::string slots = slot(1, "0") + slot(2, "30"),
                    type = "<LINGUISTIC_TYPE LINGUISTIC_TYPE_ID=\"t\"/>";
  EXPECT_NEAR(
      read(document(slots, tier, type, "2.7", "TIME_UNITS=\"PAL-frames\"")).tiers[0].intervals[0].end_s, 1.2,
      1e-12);
  EXPECT_NEAR(
      read(document(slots, tier, type, "2.7", "TIME_UNITS=\"NTSC-frames\"")).tiers[0].intervals[0].end_s,
      1.001, 1e-12);
}

TEST(EafReader, CountsWhatItLeavesOut) {
  const TierDocument found = read(document(
      slot(1, "0") + slot(2, "1500") + slot(3, "1500"),
      "<TIER LINGUISTIC_TYPE_REF=\"lost\" TIER_ID=\"m\">" + aligned("a1", 1, 2, "a", "EXT_REF=\"er1\"") +
          aligned("a2", 2, 3, "nothing") + "</TIER><TIER LINGUISTIC_TYPE_REF=\"far\" TIER_ID=\"n\"/>",
      "<LINGUISTIC_TYPE LINGUISTIC_TYPE_ID=\"far\" CONTROLLED_VOCABULARY_REF=\"cv\"/>"
      "<CONTROLLED_VOCABULARY CV_ID=\"cv\" EXT_REF=\"er2\"/>"
      "<REF_LINK_SET LINK_SET_ID=\"s\"><CROSS_REF_LINK/><GROUP_REF_LINK/></REF_LINK_SET>",
      "3.1"));
  EXPECT_EQ(found.tiers[0].intervals, (std::vector<TierInterval>{{0, 1.5, "a"}}));
  EXPECT_THAT(found.warnings,
              UnorderedElementsAre(HasSubstr("format 3.1"), HasSubstr("1 annotation without length"),
                                   HasSubstr("1 tier has a linguistic type that the file does not have"),
                                   HasSubstr("1 tier has its vocabulary in another file"),
                                   HasSubstr("1 reference to something outside"),
                                   HasSubstr("2 links between annotations")));
}

TEST(EafReader, ColoursStayWithTheWordsThatElanLeft) {
  const std::vector<Tier> tiers = {{"move",
                                    {{0, 1, "basic"}},
                                    {{"basic", "", 0x112233, '1'}, {"turn", "", 0x445566, '2'}},
                                    TierKind::Move}};
  std::string eaf = write_tiers(tiers, "x.eaf", {})->text;
  eaf.replace(eaf.find(">turn<"), 6, ">spin<");
  const Tier found = read(eaf).tiers.at(0);
  EXPECT_EQ(found.vocabulary, (std::vector<VocabularyEntry>{{"basic", "", 0x112233, '1'}, {"spin"}}));
  EXPECT_EQ(found.kind, TierKind::Move);
}

TEST(EafReader, TiersOfTheNamesOfChildTiersAreKeptApart) {
  const std::vector<Tier> tiers = {{"move", {{0, 1, "basic", "slow"}}, {{"basic"}}, TierKind::Move},
                                   {"move detail", {{0, 1, "mine"}}, {{"mine"}}, TierKind::Note},
                                   {"detail of annotation", {{0, 1, "x", "y", "z"}}, {{"x"}}, TierKind::Note},
                                   {"free text", {{2, 3, "x"}}, {{"x"}}, TierKind::Note}};
  EXPECT_EQ(read(write_tiers(tiers, "x.eaf", {})->text).tiers, tiers);
}

TEST(EafReader, ReadsOtherEncodings) {
  std::string latin =
      document(slot(1, "0") + slot(2, "1500"),
               "<TIER LINGUISTIC_TYPE_REF=\"t\" TIER_ID=\"m\">" + aligned("a1", 1, 2, "sal\xF3n") + "</TIER>",
               "<LINGUISTIC_TYPE LINGUISTIC_TYPE_ID=\"t\"/>");
  latin.replace(latin.find("UTF-8"), 5, "ISO-8859-1");
  EXPECT_EQ(read(latin).tiers[0].intervals[0].value, "sal\xC3\xB3n");
}

TEST(EafReader, TimesBetweenKnownOnesFollowTheOrderOfTheSlotsNotOfTheAnnotations) {
  // Slots 2 and 3 have no time; the later annotation is listed first.
  const TierDocument found = read(document(
      slot(1, "0") + "<TIME_SLOT TIME_SLOT_ID=\"ts2\"/><TIME_SLOT TIME_SLOT_ID=\"ts3\"/>" + slot(4, "3000"),
      "<TIER LINGUISTIC_TYPE_REF=\"moves\" TIER_ID=\"Move\">" + aligned("a3", 3, 4, "c") +
          aligned("a1", 1, 2, "a") + aligned("a2", 2, 3, "b") + "</TIER>",
      "<LINGUISTIC_TYPE LINGUISTIC_TYPE_ID=\"moves\" TIME_ALIGNABLE=\"true\"/>"));
  EXPECT_EQ(found.tiers.at(0).intervals, (std::vector<TierInterval>{{0, 1, "a"}, {1, 2, "b"}, {2, 3, "c"}}));
}

}  // namespace
}  // namespace abrazo::eaf_reader_test
