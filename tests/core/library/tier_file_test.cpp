#include "core/library/takes/tier_file.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>
#include <filesystem>

#include "core/base/atomic_file.hpp"
#include "core/library/takes/csv_text.hpp"
#include "core/library/takes/manifest.hpp"

namespace abrazo::tier_file_test {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

std::vector<Tier> rich_tiers() {
  return {{"role", {{0, 1.5, "a"}, {1.5, 4, "b"}}, {{"a"}, {"b"}}, TierKind::Role},
          {"move",
           {{0.1, 1.25, "basic", "to the <left>", "high"},
            {1.25, 3.001, "turn"},
            {3.5, 4, "odd, \"one\"", "", "low"}},
           {{"basic", "the basic step", 0x336699, 'b'}, {"turn", "", {}, '2'}, {"never used"}},
           TierKind::Move},
          {"what I saw", {{0.5, 0.75, "two\nlines & more"}}, {}, TierKind::Note},
          {"still empty", {}, {{"x"}}, TierKind::Move}};
}

TierDocument back(const std::vector<Tier>& tiers, const std::string& name, const TierWriting& writing = {},
                  const TierReading& reading = {}) {
  const auto text = write_tiers(tiers, name, writing);
  if (!text) {
    ADD_FAILURE() << text.error().text();
    return {};
  }
  auto document = parse_tiers(text->text, name, reading);
  if (!document) ADD_FAILURE() << document.error().text() << "\n" << text->text;
  return document ? *document : TierDocument{};
}

/// What CSV has no place for, taken away.
std::vector<Tier> plain(std::vector<Tier> tiers) {
  std::erase_if(tiers, [](const Tier& tier) { return tier.intervals.empty(); });
  for (Tier& tier : tiers) {
    tier.vocabulary.clear();
    tier.kind = kind_of_name(tier.name);
  }
  return tiers;
}

// As Excel in German, Excel elsewhere, and pandas write them.
TEST(TierCsv, TablesOfOtherProgramsAreReadByTheirSeparator) {
  const auto frames = [](const std::string& csv) {
    const auto labels = parse_labels(csv, "one", "x.csv");
    if (!labels) return labels.error().text();
    std::string text;
    for (const LabelInterval& label : *labels)
      text += fmt::format("{}-{} {};", label.start, label.end, label.label);
    return text;
  };
  const std::string expected = "0-12 turn, left;20-30 basic;";
  EXPECT_EQ(frames("take,start_frame,end_frame,label\none,0,12,\"turn, left\"\none,20,30,basic\n"), expected);
  EXPECT_EQ(frames("take;start_frame;end_frame;label\r\none;0;12;turn, left\r\n;;;\r\none;20;30;basic\r\n"),
            expected);
  EXPECT_EQ(
      frames("take\tstart_frame\tend_frame\tlabel\none\t0\t12\tturn, left\none\t20\t30\tbasic\n\t\t\t\n"),
      expected);
  EXPECT_EQ(frames("sep=;\r\none;0;12;turn, left\r\none;20;30;basic\r\n"), expected);
  EXPECT_EQ(frames("one,0.0,12.0,\"turn, left\"\none,20.0,30.0,basic\n,,,\n"), expected);
  EXPECT_THAT(frames("one,0.5,12,turn\n"), HasSubstr("expected start_frame as a frame number"));
  const auto document = parse_tiers("tier;start;end;value\nmove;0,5;1,25;basic\n", "x.csv", {});
  ASSERT_TRUE(document) << document.error().text();
  EXPECT_EQ(document->tiers.front().intervals.front().start_s, 0.5);
  EXPECT_EQ(document->tiers.front().intervals.front().end_s, 1.25);
  EXPECT_EQ(parse_csv("a;\"1,5\";1,5\n", "x.csv")->front().fields,
            (std::vector<std::string>{"a", "1,5", "1.5"}))
      << "what stands in quotes is a text";
}

// As a spreadsheet would run it.
TEST(TierCsv, TextsThatBeginLikeAFormulaStandBehindAnApostropheAndComeBack) {
  for (const std::string text : {"=1+1", "+1", "-turn", "@cmd", "'=1", "''-x", "turn", "a-b", "'tis"}) {
    const std::string field = csv_field(text);
    EXPECT_THAT(field, testing::Not(testing::ContainsRegex("^[=+@-]"))) << text;
    const auto rows = parse_csv(field + ",1\n", "x.csv");
    ASSERT_TRUE(rows);
    EXPECT_EQ(rows->front().fields, (std::vector<std::string>{text, "1"}));
  }
  EXPECT_EQ(csv_field("turn"), "turn");
  EXPECT_EQ(parse_csv("-1.5\n", "x.csv")->front().fields.front(), "-1.5") << "a number is none";
}

TEST(TierFile, EafKeepsEverything) {
  const TierDocument document = back(rich_tiers(), "x.eaf");
  EXPECT_EQ(document.tiers, rich_tiers());
  EXPECT_THAT(document.warnings, IsEmpty());
}

TEST(TierFile, EafKeepsTheKindOfANoteWithATellingName) {
  const std::vector<Tier> tiers = {{"moves", {{0, 1, "a"}}, {}, TierKind::Note}};
  EXPECT_EQ(back(tiers, "x.eaf").tiers, tiers);
}

TEST(TierFile, JsonKeepsEverything) {
  EXPECT_EQ(back(rich_tiers(), "x.json").tiers, rich_tiers());
}

TEST(TierFile, JsonKeepsTheColourOrTheKeyOfAValueWithoutDescription) {
  const std::vector<Tier> tiers = {{"m", {{0, 1, "a"}}, {{"a", "", 0x336699}, {"b", "", {}, 'b'}, {"c"}}}};
  EXPECT_EQ(back(tiers, "x.json").tiers, tiers);
}

TEST(TierFile, CsvKeepsIntervalsAndSaysWhatItLeavesOut) {
  EXPECT_EQ(back(rich_tiers(), "x.csv").tiers, plain(rich_tiers()));
  EXPECT_THAT(write_tiers(rich_tiers(), "x.csv", {})->warnings,
              ElementsAre("1 empty tier was left out", HasSubstr("the vocabulary of 3 tiers was left out")));
}

TEST(TierFile, WhatIsRoundedToMillisecondsIsCounted) {
  const std::vector<Tier> tiers = {{"m", {{0, 1.0 / 3, "a"}, {1.0 / 3, 1, "b"}}}};
  EXPECT_THAT(write_tiers(tiers, "x.eaf", {})->warnings,
              Contains("2 of 4 times were rounded to whole milliseconds"));
  EXPECT_THAT(write_tiers(tiers, "x.json", {})->warnings, IsEmpty());
}

TEST(TierFile, FramesOfCommonRatesComeBackThroughMilliseconds) {
  for (const double fps : {24.0, 25.0, 30000 / 1001.0, 30.0, 50.0, 60000 / 1001.0, 60.0, 120.0, 240.0}) {
    Tier tier{"move", {}, {}, TierKind::Move};
    for (int frame = 0; frame < 3000; frame += 1 + frame % 3)
      tier.intervals.push_back({frame / fps, (frame + 1) / fps, "m"});
    for (const char* name : {"x.eaf", "x.TextGrid", "x.txt"}) {
      const TierDocument document = back({tier}, name, {}, {fps, ""});
      ASSERT_EQ(document.tiers.size(), 1u) << name << " at " << fps;
      ASSERT_EQ(document.tiers[0].intervals, tier.intervals) << name << " at " << fps;
    }
  }
}

TEST(TierFile, TimesThatMeanNoFrameStayAsTheyAre) {
  const TierDocument document = parse_tiers("0.110\t0.200\tx\n", "x.txt", {10, ""}).value();
  EXPECT_EQ(document.tiers[0].intervals[0].start_s, 0.11);
}

TEST(TierFile, ALabelFileIsTheTierMoveInFrames) {
  const std::string csv =
      "take,start_frame,end_frame,label,detail,confidence\none,0,30,basic,,\none,30,90,\"turn, "
      "slow\",d,low\ntwo,0,9,x,,\n";
  const auto document = parse_tiers(csv, "x.csv", {60, "one"});
  ASSERT_TRUE(document) << document.error().text();
  EXPECT_EQ(document->take, "one");
  EXPECT_EQ(document->tiers,
            (std::vector<Tier>{
                {"move", {{0, 0.5, "basic"}, {0.5, 1.5, "turn, slow", "d", "low"}}, {}, TierKind::Move}}));
  TierWriting writing;
  writing.take = "one";
  writing.fps = 60;
  const auto written = write_tiers(document->tiers, "y.csv", writing);
  ASSERT_TRUE(written);
  EXPECT_EQ(written->text, csv.substr(0, csv.find("two")));
}

TEST(TierFile, ALabelFileCountsWhatItCannotHold) {
  TierWriting writing;
  writing.take = "one";
  writing.fps = 10;
  const std::vector<Tier> tiers = {
      {"move", {{0, 0.04, "short"}, {1, 2, ""}, {2, 3, "x"}}, {}, TierKind::Move}, {"note", {}}};
  const auto written = write_tiers(tiers, "y.csv", writing);
  ASSERT_TRUE(written);
  EXPECT_THAT(written->text, HasSubstr("one,20,30,x,,"));
  EXPECT_THAT(written->warnings,
              ElementsAre(HasSubstr("2 of 3 intervals were left out"), HasSubstr("here 'move'; 1 left out")));
  writing.fps = 0;
  EXPECT_EQ(write_tiers(tiers, "y.csv", writing).error().hint, Hint::SetFrameRate);
}

TEST(TierFile, OtherPeoplesTablesAreReadByTheirHeader) {
  const auto document = parse_tiers("\xEF\xBB\xBFTier;x\n", "x.csv", {});
  EXPECT_FALSE(document) << "semicolons";
  const auto table =
      parse_tiers("label,end_s,tier,start_s,annotator\nturn,2,move,1,me\nbasic,1,move,0.5,me\n", "x.csv", {});
  ASSERT_TRUE(table) << table.error().text();
  EXPECT_EQ(table->tiers,
            (std::vector<Tier>{{"move", {{0.5, 1, "basic"}, {1, 2, "turn"}}, {}, TierKind::Move}}));
  EXPECT_THAT(table->warnings, ElementsAre(HasSubstr("annotator")));
}

TEST(TierFile, SpacesAndTabsMayPrecedeAQuotedFieldOfATable) {
  const auto table = parse_tiers("tier,start,end,value\nmove,0,1,\t \"turn, slow\"\n", "x.csv", {});
  ASSERT_TRUE(table) << table.error().text();
  EXPECT_EQ(table->tiers, (std::vector<Tier>{{"move", {{0, 1, "turn, slow"}}, {}, TierKind::Move}}));
}

TEST(TierFile, ATableIsReadNoFartherThanItsEnd) {
  const std::string_view behind = "tier,start,end,value\nmove,0,1, \"not of it\"";
  const auto table = parse_tiers(behind.substr(0, behind.find(" \"not")), "x.csv", {});
  ASSERT_TRUE(table) << table.error().text();
  EXPECT_EQ(table->tiers, (std::vector<Tier>{{"move", {{0, 1, ""}}, {}, TierKind::Move}}));
}

TEST(TierFile, ARowWithTooFewFieldsIsRefused) {
  const auto table = parse_tiers("tier,start,end,value\nmove,0,1,turn\nmove,1,2\n", "x.csv", {});
  ASSERT_FALSE(table);
  EXPECT_THAT(table.error().text(), HasSubstr("x.csv:3"));
  EXPECT_THAT(table.error().text(), HasSubstr("has 3 fields, the header 4"));
}

TEST(TierFile, IntervalsWithoutLengthAreNotWrittenButCounted) {
  const auto written = write_tiers(std::vector<Tier>{{"m", {{1, 1, "a"}, {1, 2, "b"}}}}, "x.csv", {});
  ASSERT_TRUE(written) << written.error().text();
  EXPECT_EQ(written->text, "tier,start,end,value,detail,confidence\nm,1,2,b,,\n");
  EXPECT_THAT(written->warnings, ElementsAre("1 interval without length was left out"));
}

TEST(TierFile, WhatCannotBeWrittenIsRefused) {
  const auto refusal = [](const std::vector<Tier>& tiers, const char* name) {
    const auto written = write_tiers(tiers, name, {});
    return written ? "written" : written.error().text();
  };
  EXPECT_THAT(refusal({{"m", {{0, 2, "a"}, {1, 3, "b"}}}}, "x.json"), HasSubstr("overlaps"));
  EXPECT_THAT(refusal({{"m", {{0, std::nan(""), "a"}}}}, "x.csv"), HasSubstr("finite"));
  EXPECT_THAT(refusal({{" ", {}}}, "x.csv"), HasSubstr("no name"));
  EXPECT_THAT(refusal({{"m", {{0, 1, "\xFF"}, {1, 2, "b"}}}}, "x.json"), HasSubstr("not UTF-8"))
      << "though what follows is";
  EXPECT_THAT(refusal({{"m", {{0, 1, "a\tb"}}}}, "x.txt"), HasSubstr("no tabs and line ends"));
  EXPECT_THAT(refusal({{"m", {}}, {"n", {}}}, "x.txt"), HasSubstr("has no labels to write"));
  EXPECT_THAT(refusal({{"m", {{0, 1, "a\x01"}}}}, "x.eaf"), HasSubstr("control character"));
  EXPECT_THAT(refusal({}, "x.doc"), HasSubstr(".eaf, .csv, .json, .TextGrid, .txt"));
}

TEST(TierFile, AnythingComesBackFromEveryFormat) {
  EXPECT_TRUE(rc::check("round trips", [] {
    std::vector<Tier> tiers;
    const int tier_count = *rc::gen::inRange(1, 4);
    for (int t = 0; t < tier_count; ++t) {
      Tier tier{"tier " + std::to_string(t), {}, {}, TierKind::Note};
      double at_s = t;
      for (int i = *rc::gen::inRange(1, 6); i > 0; --i) {
        const double end_s = at_s + *rc::gen::inRange(1, 5000) / 1000.0;
        const auto letters =
            rc::gen::container<std::string>(rc::gen::elementOf(std::string("ab,\"<>&;[]:-'\n")));
        const std::string value = "v" + *letters + "v";
        tier.intervals.push_back({at_s, end_s, value});
        at_s = end_s + *rc::gen::inRange(0, 2) / 2.0;
      }
      tiers.push_back(tier);
    }
    for (const char* name : {"x.eaf", "x.csv", "x.json", "x.TextGrid"}) {
      const auto text = write_tiers(tiers, name, {});
      RC_ASSERT(text.ok());
      const auto document = parse_tiers(text->text, name, {1000, ""});
      RC_ASSERT(document.ok());
      RC_ASSERT(document->tiers.size() == tiers.size());
      for (std::size_t t = 0; t < tiers.size(); ++t) {
        RC_ASSERT(document->tiers[t].intervals.size() == tiers[t].intervals.size());
        for (std::size_t i = 0; i < tiers[t].intervals.size(); ++i) {
          const TierInterval &is = document->tiers[t].intervals[i], &was = tiers[t].intervals[i];
          RC_ASSERT(is.value == was.value);
          RC_ASSERT(std::abs(is.start_s - was.start_s) < 1e-6);
          RC_ASSERT(std::abs(is.end_s - was.end_s) < 1e-6);
        }
      }
    }
  }));
}

TEST(TierFile, AnyBytesAreReadOrRefused) {
  EXPECT_TRUE(rc::check("bytes", [] {
    const auto bytes = *rc::gen::container<std::string>(rc::gen::arbitrary<char>());
    for (const char* name : {"x.eaf", "x.csv", "x.json", "x.TextGrid", "x.txt"}) {
      (void)parse_tiers(bytes, name, {60, ""});
      (void)parse_tiers("\"ooTextFile\" \"TextGrid\" 0 1 <exists> 1 " + bytes, name, {60, ""});
      (void)parse_tiers("a\t1\t2\tx\n" + bytes, name, {60, ""});
      (void)parse_tiers("tier,start,end,value\n" + bytes, name, {});
    }
  }));
}

TEST(TierFile, EveryBeginningOfAFileIsReadOrRefused) {
  for (const char* name : {"x.eaf", "x.csv", "x.json", "x.TextGrid", "x.txt"}) {
    const auto written = write_tiers(
        std::string_view(name) == "x.txt" ? std::vector{rich_tiers()[0]} : rich_tiers(), name, {});
    ASSERT_TRUE(written) << written.error().text();
    const std::string text = written->text;
    for (std::size_t length = 0; length < text.size(); ++length)
      (void)parse_tiers(text.substr(0, length), name, {});
  }
}

}  // namespace
}  // namespace abrazo::tier_file_test
