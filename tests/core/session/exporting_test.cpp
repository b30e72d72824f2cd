#include "core/session/export/exporting.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <map>

#include "core/annotation/annotated_library.hpp"
#include "core/base/atomic_file.hpp"
#include "core/base/text.hpp"
#include "core/library/takes/tier_file.hpp"
#include "core/session/export/export_plan.hpp"
#include "tests/core/session/recorded_session.hpp"
#include "tests/support/humanoid_rig.hpp"

namespace abrazo::exporting_test {
namespace {

namespace fs = std::filesystem;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::StartsWith;

/// A running session of one second, and a library whose take has labels.
class Exporting : public ::testing::Test {
 protected:
  Exporting() {
    fs::create_directory(folder);
    session.run_until(1);
  }

  std::unique_ptr<ExportSource> source(std::vector<Tier> noted = {}) {
    RunningExport running;
    running.name = "session";
    running.frames = session.history.stretch(-1, 100);
    running.library = test::session_library();
    running.library_name = "small";
    running.input = "user";
    running.takes = {{1, "waltz", 0.25, 0.75, 0, 0, {}, false}};
    running.markers = {{1, 0.5, "here"}};
    running.noted = std::move(noted);
    return std::move(*export_of_history(std::move(running)));
  }
  ExportWish wish(ExportContent content, const std::string& name) const {
    ExportWish made;
    made.content = content;
    if (content == ExportContent::Motion) made.bodies = {SessionBody::Active, SessionBody::Passive};
    if (name.ends_with(".npy")) made.bodies = {SessionBody::Active};  // it holds no more
    made.output = (folder / name).string();
    return made;
  }
  static std::map<ExportContent, std::vector<std::string>> types() {
    std::map<ExportContent, std::vector<std::string>> all;
    for (const ExportContent content :
         {ExportContent::Motion, ExportContent::Mesh, ExportContent::Labels, ExportContent::Trace})
      all[content] = export_types(content);
    return all;
  }
  std::vector<std::string> files() const {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(folder))
      names.push_back(entry.path().filename().string());
    std::ranges::sort(names);
    return names;
  }
  std::string text(const std::string& name) const { return *read_whole_file(folder / name); }
  std::vector<std::string> lines_of(const std::string& name) const {
    const std::string all = text(name);
    const auto lines = split_lines(all);
    return {lines.begin(), lines.end()};
  }

  test::TemporaryFolder own;
  fs::path folder = own.file("out");
  test::DrivenSession session;
};

TEST_F(Exporting, MotionOfARunningSessionIsThatOfItsFrames) {
  const auto done = export_session(*source(), wish(ExportContent::Motion, "pair.csv"));
  ASSERT_TRUE(done) << done.error().text();
  const auto lines = lines_of("pair.csv");
  const auto frames = session.history.range(-1, 100);
  ASSERT_EQ(lines.size(), frames.size() + 1);
  const auto fields = split_fields(lines[31], ',');
  EXPECT_EQ(parse_number(fields[2]), frames[30]->result.result(0, 0));
  EXPECT_THAT(done->warnings, IsEmpty());
}

TEST_F(Exporting, EveryTypeOfEveryContentIsWritten) {
  for (const auto& [content, endings] : types())
    for (const std::string& ending : endings) {
      const auto done = export_session(*source(), wish(content, "out" + ending));
      ASSERT_TRUE(done) << ending << ": " << done.error().text();
      for (const std::string& file : done->files) EXPECT_GT(fs::file_size(file), 20U) << file;
    }
}

TEST_F(Exporting, ATakeIsAPartOfTheSession) {
  ExportWish of_take = wish(ExportContent::Motion, "take.csv");
  of_take.part.take = "waltz";
  ASSERT_TRUE(export_session(*source(), of_take));
  const auto frames = session.history.range(0.25, 0.75);
  EXPECT_EQ(lines_of("take.csv").size(), frames.size() + 1);
}

TEST_F(Exporting, AMeshIsOfTheFrameShownThen) {
  ExportWish one = wish(ExportContent::Mesh, "mesh.vtu");
  one.at_s = 0.5;
  const auto done = export_session(*source(), one);
  ASSERT_TRUE(done) << done.error().text();
  EXPECT_THAT(done->text, HasSubstr("at " + std::string("0.")));
  EXPECT_THAT(files(), ElementsAre("mesh.vtu"));
}

TEST_F(Exporting, AMeshOfNoFrameIsOfTheFirstAndSaysSo) {
  const auto done = export_session(*source(), wish(ExportContent::Mesh, "mesh.vtu"));
  ASSERT_TRUE(done) << done.error().text();
  ASSERT_EQ(done->warnings.size(), 1U);
  EXPECT_THAT(done->warnings[0].message, HasSubstr("only the first frame is written"));
  EXPECT_EQ(done->warnings[0].hint, Hint::ChooseFrames);
}

TEST_F(Exporting, ATraceOfARunningSessionIsThatOfItsFrames) {
  const auto done = export_session(*source(), wish(ExportContent::Trace, "t.jsonl"));
  ASSERT_TRUE(done) << done.error().text();
  EXPECT_EQ(lines_of("t.jsonl").size(), session.history.range(-1, 100).size() + 1);
  EXPECT_THAT(text("t.jsonl"), HasSubstr("\"library\":\"small\""));
}

TEST_F(Exporting, WhatAPersonSaidComesWithTheSessionsOwnTiers) {
  const Tier moves{"moves", {{0.1, 0.6, "turn"}}, {{"turn"}}, TierKind::Move};
  ASSERT_TRUE(export_session(*source({moves}), wish(ExportContent::Labels, "l.json")));
  const auto read = read_tiers(folder / "l.json", {});
  ASSERT_TRUE(read) << read.error().text();
  std::map<std::string, Tier> tiers;
  for (const Tier& tier : read->tiers) tiers[tier.name] = tier;
  ASSERT_TRUE(tiers.contains("moves"));
  EXPECT_EQ(tiers["moves"].intervals, moves.intervals);
  EXPECT_EQ(tiers["take"].intervals.at(0).value, "waltz");
  EXPECT_TRUE(tiers.contains("user role"));
  EXPECT_FALSE(tiers.contains("move (noted)")) << "once is enough";
  ASSERT_TRUE(export_session(*source({moves}), wish(ExportContent::Labels, "l.csv")));
  EXPECT_THAT(text("l.csv"), HasSubstr("waltz,0,"));
  EXPECT_THAT(text("l.csv"), HasSubstr(",turn,"));
}

TEST_F(Exporting, ATableOfAllTiersIsReadAgainAsWhatItWas) {
  const std::vector<Tier> noted = {
      {"role", {{0, 0.5, "a"}, {0.5, 1, "b"}}, {}, TierKind::Role},
      {"moves", {{0.1, 0.6, "turn, slowly", "with both hands", "high"}}, {{"turn, slowly"}}, TierKind::Move},
      {"steps of both", {{0.2, 0.3, "left"}, {0.3, 1 / 3.0, "right"}}, {}, TierKind::Note}};
  ExportWish table = wish(ExportContent::Labels, "l.csv");
  table.all_tiers = true;
  const auto made = source(noted);
  const auto done = export_session(*made, table);
  ASSERT_TRUE(done) << done.error().text();
  const auto read = read_tiers(folder / "l.csv", {});
  ASSERT_TRUE(read) << read.error().text();
  std::map<std::string, std::vector<TierInterval>> written, found;
  const auto tiers = made->tiers(*session_range(made->record(), {}));
  for (const Tier& tier : *tiers)
    if (!tier.intervals.empty()) written[tier.name] = tier.intervals;
  for (const Tier& tier : read->tiers) found[tier.name] = tier.intervals;
  EXPECT_EQ(found, written) << "to the bit";
  for (const char* name : {"role", "moves", "steps of both", "take", "user role", "marker"})
    EXPECT_TRUE(found.contains(name)) << name;
  EXPECT_THAT(done->text, HasSubstr("2 steps of both"));
}

TEST_F(Exporting, ATakeOfTheLibraryIsExportedAsItWasRecorded) {
  const auto library = test::session_library();
  const std::string take = library->takes().front().name;
  const auto recorded = export_of_take(library, take);
  ExportWish motion = wish(ExportContent::Motion, "take.csv");
  const auto done = export_session(*recorded, motion);
  ASSERT_TRUE(done) << done.error().text();
  const int pair = library->find_pair(take, 3, false);
  ASSERT_GE(pair, 0);
  const auto lines = lines_of("take.csv");
  const auto fields = split_fields(lines[4], ',');
  EXPECT_NEAR(parse_number(fields[2]).value(), library->pair_in_world(pair, library->root(pair))(0, 0),
              1e-12);
  EXPECT_TRUE(export_session(*recorded, wish(ExportContent::Mesh, "m.pvd")));
  const auto refused = export_session(*recorded, wish(ExportContent::Trace, "t.jsonl"));
  ASSERT_FALSE(refused);
  EXPECT_THAT(refused.error().message, HasSubstr("not solved"));
  EXPECT_THROW(export_of_take(library, "nothing"), std::invalid_argument);
}

TEST_F(Exporting, ATakeWhoseRolesChangeKeepsItsBodies) {
  const auto library = test::session_library();
  const LibraryTake& take = library->takes().front();
  const auto roles = with_annotations(
      *library,
      {{take.name, {{{0, 60, ActivePerformer::A}, {60, take.frames, ActivePerformer::B}}, take.labels}}});
  ASSERT_TRUE(roles) << roles.error().text();
  const auto changed = std::make_shared<const MotionLibrary>(*roles);
  ASSERT_TRUE(export_session(*export_of_take(library, take.name), wish(ExportContent::Motion, "before.csv")));
  ASSERT_TRUE(export_session(*export_of_take(changed, take.name), wish(ExportContent::Motion, "after.csv")));
  const auto before = lines_of("before.csv"), after = lines_of("after.csv");
  ASSERT_EQ(before.size(), after.size());
  for (std::size_t i = 1; i < before.size(); ++i)
    EXPECT_NEAR(*parse_number(split_fields(before[i], ',')[2]), *parse_number(split_fields(after[i], ',')[2]),
                1e-9)
        << "line " << i + 1;
}

TEST_F(Exporting, LabelsOfAPartOfATakeAreThoseOfThePart) {
  const auto library = test::session_library();
  const std::string take = library->takes().front().name;
  const auto moves = [&](std::optional<double> from_s, std::optional<double> to_s) {
    ExportWish labels = wish(ExportContent::Labels, "l.json");
    labels.part.from_s = from_s;
    labels.part.to_s = to_s;
    const auto done = export_session(*export_of_take(library, take), labels);
    EXPECT_TRUE(done) << done.error().text();
    const auto read = read_tiers(folder / "l.json", {});
    for (const Tier& tier : read->tiers)
      if (tier.kind == TierKind::Move) return tier.intervals;
    return std::vector<TierInterval>();
  };
  EXPECT_THAT(moves({}, {}), ElementsAre(TierInterval{0, 1.5, "open_hold"}, TierInterval{1.5, 3, "turn"}));
  const auto part = moves(1.0, 1.25);
  ASSERT_EQ(part.size(), 1u);
  EXPECT_EQ(part[0].value, "open_hold");
  EXPECT_NEAR(part[0].start_s, 1.0, 1e-9);
  EXPECT_NEAR(part[0].end_s, 1.25 + 1 / 60.0, 1e-9) << "the last frame lasts, too";
}

TEST_F(Exporting, AMeshSeriesHasAtMostTheWantedRate) {
  ExportWish series = wish(ExportContent::Mesh, "m.pvd");
  series.part.from_s = 0.2;
  series.part.to_s = 0.7;
  const auto all = export_session(*source(), series);
  ASSERT_TRUE(all) << all.error().text();
  for (const double rate_hz : {10.0, 1000.0}) {
    series.rate_hz = rate_hz;
    const auto some = export_session(*source(), series);
    ASSERT_TRUE(some) << some.error().text();
    EXPECT_EQ(some->files.size() - 1, rate_hz < 20 ? 6u : all->files.size() - 1) << rate_hz;
  }
}

TEST_F(Exporting, CancellingAtAnyMomentLeavesNothing) {
  for (const auto& [content, endings] : types())
    for (const std::string& ending : endings) {
      int reports = 0;
      const auto count = [&](double, std::string_view) { return ++reports > 0; };
      ASSERT_TRUE(export_session(*source(), wish(content, "whole" + ending), count));
      fs::remove_all(folder);
      fs::create_directory(folder);
      const int all = reports;
      for (const int until : {1, all / 2, all - 1}) {
        reports = 0;
        const auto stop = [&](double, std::string_view) { return ++reports < until; };
        if (until < 1) continue;
        const auto done = export_session(*source(), wish(content, "part" + ending), stop);
        if (done) continue;  // it was past the point where it can be stopped
        EXPECT_THAT(done.error().message, HasSubstr("cancelled")) << ending;
        EXPECT_THAT(files(), IsEmpty()) << ending << " at " << until << " of " << all;
      }
      fs::remove_all(folder);
      fs::create_directory(folder);
    }
}

TEST_F(Exporting, AFullDiskLeavesNothing) {
  const auto before = std::signal(SIGXFSZ, SIG_IGN);
  rlimit limit{};
  ASSERT_EQ(getrlimit(RLIMIT_FSIZE, &limit), 0);
  for (const auto& [content, endings] : types())
    for (const std::string& ending : endings) {
      const auto made = source();
      rlimit small = limit;
      small.rlim_cur = 16;
      ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &small), 0);
      const auto done = export_session(*made, wish(content, "full" + ending));
      ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &limit), 0);
      ASSERT_FALSE(done) << ending;
      EXPECT_THAT(done.error().message, HasSubstr("disk full")) << ending;
      EXPECT_THAT(files(), IsEmpty()) << ending;
    }
  std::signal(SIGXFSZ, before);
}

TEST_F(Exporting, AFolderThatIsGoneIsNamed) {
  fs::remove_all(folder);
  for (const auto& [content, endings] : types())
    for (const std::string& ending : endings) {
      const auto done = export_session(*source(), wish(content, "gone" + ending));
      ASSERT_FALSE(done) << ending;
      EXPECT_THAT(done.error().text(), HasSubstr("gone")) << ending;
      EXPECT_THAT(done.error().text(), HasSubstr("folder")) << ending;
    }
}

TEST_F(Exporting, WhatDoesNotFitTogetherIsRefused) {
  const auto refusal = [&](const ExportWish& wish) {
    const Status checked = check_export(wish);
    return checked ? std::string("fits") : checked.error().message;
  };
  ExportWish motion = wish(ExportContent::Motion, "a.bvh");
  EXPECT_EQ(refusal(motion), "fits");
  motion.bodies = {};
  EXPECT_THAT(refusal(motion), HasSubstr("no body"));
  motion.bodies = {SessionBody::User, SessionBody::User};
  EXPECT_THAT(refusal(motion), HasSubstr("twice"));
  EXPECT_THAT(refusal(wish(ExportContent::Mesh, "a.bvh")), HasSubstr("use .vtu or .pvd"));
  EXPECT_THAT(refusal(wish(ExportContent::Labels, "a.doc")), HasSubstr(".TextGrid or .txt"));
  ExportWish metres = wish(ExportContent::Motion, "a.glb");
  metres.space.units_per_metre = 100;
  EXPECT_THAT(refusal(metres), HasSubstr("metres with Y up"));
  ExportWish trace = wish(ExportContent::Trace, "a.jsonl");
  trace.rate_hz = 30;
  EXPECT_THAT(refusal(trace), HasSubstr("leave the rate out"));
  ExportWish series = wish(ExportContent::Mesh, "a.pvd");
  series.rate_hz = 1e18;
  EXPECT_THAT(refusal(series), HasSubstr("at most 1000 Hz"));
  series.rate_hz = 0;
  series.at_s = 1;
  EXPECT_THAT(refusal(series), HasSubstr("series"));
}

TEST_F(Exporting, ThePlanHasTheFramesThatAreWrittenAndNearlyTheirBytes) {
  for (const std::string name : {"a.bvh", "a.glb", "a.csv"}) {
    const ExportWish motion = wish(ExportContent::Motion, name);
    const auto done = export_session(*source(), motion);
    ASSERT_TRUE(done);
    const auto plan = plan_export(motion, session.history.times(-1, 100));
    ASSERT_TRUE(plan) << plan.error().text();
    EXPECT_THAT(done->text, StartsWith(std::to_string(plan->frames) + " frames at ")) << name;
    EXPECT_NEAR(static_cast<double>(plan->bytes), static_cast<double>(fs::file_size(motion.output)),
                0.25 * static_cast<double>(fs::file_size(motion.output)))
        << name;
  }
}

TEST_F(Exporting, ThePlanOfACharacterHasItsFileForEachBody) {
  ExportWish worn = wish(ExportContent::Motion, "a.vrm");
  worn.character = worn.output + ".rig";
  worn.rate_hz = 5;  // few frames, so that the file of the character counts
  ASSERT_TRUE(write_whole_file(worn.character, test::rig(test::Naming::Vrm1)));
  ASSERT_TRUE(export_session(*source(), worn));
  const auto plan = plan_export(worn, session.history.times(-1, 100));
  ASSERT_TRUE(plan) << plan.error().text();
  double written = 0;
  for (const std::string& file : worn.files()) written += static_cast<double>(fs::file_size(file));
  EXPECT_NEAR(static_cast<double>(plan->bytes), written, 0.25 * written);
}

}  // namespace
}  // namespace abrazo::exporting_test
