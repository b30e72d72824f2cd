#include "core/session/export/session_export.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "core/library/build/motion_library_builder.hpp"
#include "core/library/store/motion_library_file.hpp"
#include "core/library/takes/manifest.hpp"
#include "core/session/export/export_plan.hpp"
#include "core/session/export/session_tiers.hpp"
#include "core/session/file/library_reference.hpp"
#include "core/session/file/project.hpp"
#include "core/session/file/recorded_frames.hpp"
#include "core/synthesis/frames/trace.hpp"
#include "tests/core/session/recorded_session.hpp"
#include "tests/support/bodies.hpp"

namespace abrazo::session_export_test {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

/// Two takes whose frames have moves.
std::shared_ptr<const MotionLibrary> labelled_library() {
  static const auto library = [] {
    std::vector<PairedTake> takes = {test::swinging_take("first", 180, 1),
                                     test::swinging_take("second", 150, 2)};
    takes[0].labels = {{0, 90, "basic", "", ""}, {90, 180, "turn", "", ""}};
    takes[1].labels = {{0, 150, "dip", "", ""}};
    return std::make_shared<const MotionLibrary>(
        std::move(*build_library("labelled", std::move(takes), {}, {})));
  }();
  return library;
}

/// Solved frames, made by hand, in a session file.
class SessionExport : public ::testing::Test, protected test::TemporaryFolder {
 protected:
  SessionExport() {
    RecordingFacts facts = test::session_facts();
    facts.library = labelled_library();
    facts.library_name = "labelled";
    recorder = *Recorder::open(path, facts);
  }

  /// A frame at a time that follows a pair of the library.
  void solved(double time_s, int pair = -1, const Settings& settings = {},
              std::shared_ptr<const Decisions> decisions = nullptr) {
    const Pose user = test::swinging_take("user", 200, 4).a.poses[index % 200];
    auto frame = std::make_shared<FrameSnapshot>();
    frame->index = index++;
    frame->time_s = time_s;
    frame->elapsed_s = 0;
    frame->user = user;
    frame->result.result << user, test::moved(user, 3, Vec3(0, 0, 1));
    frame->result.status = StepStatus::Ok;
    frame->library = library;
    frame->settings = settings;
    frame->decisions = std::move(decisions);
    if (pair >= 0) {
      frame->result.candidates.push_back({});
      frame->result.candidates.back().pair = pair;
      frame->result.selected = 0;
    }
    frames.push_back(frame);
    recorder->frame_solved(frame);
  }

  const SessionFile& file() {
    if (!file_) {
      EXPECT_TRUE(recorder->finish());
      auto opened = SessionFile::open(path);
      EXPECT_TRUE(opened) << opened.error().text();
      file_ = *opened;
    }
    return *file_;
  }
  SessionRange all() { return *session_range(file(), {}); }
  int pair_of(const char* take, int frame) { return labelled_library()->find_pair(take, frame, false); }

  std::string path = TemporaryFolder::file("s.abrazo");
  std::shared_ptr<Recorder> recorder;
  std::vector<FrameSnapshotPtr> frames;
  std::uint64_t index = 0;
  std::shared_ptr<const MotionLibrary> library = labelled_library();  ///< of the next frame

 private:
  std::shared_ptr<const SessionFile> file_;
};

constexpr std::array<SessionBody, 3> all_bodies = {SessionBody::User, SessionBody::Active,
                                                   SessionBody::Passive};

TEST_F(SessionExport, EvenFramesKeepTheirPoses) {
  for (int i = 0; i < 60; ++i) solved(2 + i / 60.0);
  const auto motion = session_motion(file(), all(), all_bodies, 0);
  ASSERT_TRUE(motion) << motion.error().text();
  ASSERT_THAT(motion->clips, SizeIs(3));
  EXPECT_EQ(motion->clips[0].name, "user");
  EXPECT_EQ(motion->clips[1].fps, 60);
  EXPECT_TRUE(motion->timing.unchanged);
  EXPECT_EQ(motion->timing.first_s, 2);
  ASSERT_THAT(motion->clips[2].poses, SizeIs(60));
  EXPECT_EQ(motion->clips[0].poses[17], frames[17]->user);
  EXPECT_EQ(motion->clips[1].poses[17], frames[17]->result.active());
  EXPECT_EQ(motion->clips[2].poses[17], frames[17]->result.passive());
}

TEST_F(SessionExport, AnotherRateIsBlended) {
  for (int i = 0; i < 61; ++i) solved(i / 60.0);
  const auto motion = session_motion(file(), all(), all_bodies, 30);
  ASSERT_TRUE(motion);
  ASSERT_THAT(motion->clips[1].poses, SizeIs(31));
  EXPECT_LT((motion->clips[1].poses[10] - Pose(frames[20]->result.active())).norm(), 1e-9);
}

TEST_F(SessionExport, AGapIsSaid) {
  for (int i = 0; i < 30; ++i) solved(i / 60.0);
  for (int i = 0; i < 30; ++i) solved(2 + i / 60.0);
  const auto motion = session_motion(file(), all(), all_bodies, 0);
  ASSERT_TRUE(motion);
  EXPECT_EQ(motion->timing.gaps, 1U);
  EXPECT_EQ(motion->timing.bridged, 90U);
  EXPECT_NEAR(motion->timing.longest_gap_s, 2 - 29 / 60.0, 1e-9);
}

/// Two takes with a second between them, the later one at half the rate of the earlier.
TEST_F(SessionExport, ThePlanHasTheFramesThatAreWritten) {
  std::vector<double> times_s;
  for (int i = 0; i < 120; ++i) times_s.push_back(i / 60.0);
  for (int i = 0; i < 40; ++i) times_s.push_back(3 + i / 30.0);
  for (const double time_s : times_s) solved(time_s);
  for (const double rate_hz : {0.0, 25.0}) {
    const auto motion = session_motion(file(), all(), all_bodies, rate_hz);
    ASSERT_TRUE(motion) << motion.error().text();
    ExportWish wish;
    wish.bodies = {SessionBody::Active};
    wish.rate_hz = rate_hz;
    wish.output = "a.csv";
    const auto plan = plan_export(wish, times_s);
    ASSERT_TRUE(plan) << plan.error().text();
    for (const Clip& clip : motion->clips) EXPECT_EQ(clip.poses.size(), plan->frames) << rate_hz;
    EXPECT_EQ(motion->clips[0].fps, plan->rate_hz);
    EXPECT_EQ(plan->rate_hz, rate_hz > 0 ? rate_hz : 60) << "the usual one";
    EXPECT_EQ(plan->gaps, 1U);
    EXPECT_EQ(plan->bridged, motion->timing.bridged);
  }
}

TEST_F(SessionExport, AHistoryKnowsTheTimesOfItsFramesOnDiskWithoutReadingThem) {
  for (int i = 0; i < 50; ++i) solved(1 + i / 50.0);
  FrameHistory history;
  for (std::size_t i = 30; i < 50; ++i) history.append(frames[i]);
  ASSERT_TRUE(recorder->finish());
  history.set_store(*RecordedFrames::open(path));
  std::vector<double> times_s;
  for (std::size_t i = 10; i < 45; ++i) times_s.push_back(frames[i]->time_s);
  EXPECT_EQ(history.times(frames[10]->time_s, frames[44]->time_s), times_s);
}

TEST_F(SessionExport, ATakeIsAPartOfIt) {
  for (int i = 0; i < 90; ++i) {
    if (i == 30) recorder->begin_take("waltz");
    if (i == 60) recorder->end_take();
    solved(i / 60.0);
  }
  const auto range = session_range(file(), {"waltz", {}, {}});
  ASSERT_TRUE(range) << range.error().text();
  EXPECT_EQ(range->first_frame, 30U);
  EXPECT_EQ(range->last_frame, 59U);
  const auto part = session_range(file(), {"waltz", 0.6, 100.0});
  ASSERT_TRUE(part);
  EXPECT_EQ(part->first_frame, 36U);
}

TEST_F(SessionExport, WhatIsNotThereIsSaidWithWhatIs) {
  recorder->begin_take("waltz");
  for (int i = 0; i < 30; ++i) solved(5 + i / 60.0);
  recorder->end_take();
  const auto said = [&](const SessionPart& part) {
    const auto range = session_range(file(), part);
    return range ? std::string("found") : range.error().text();
  };
  EXPECT_THAT(said({"tango", {}, {}}), HasSubstr("has no take 'tango'; there are 'waltz'"));
  EXPECT_THAT(said({{}, 7.0, 9.0}), HasSubstr("they go from 5.000 to 5.483 s"));
  EXPECT_THAT(said({{}, 9.0, 7.0}), HasSubstr("nothing lies between"));
}

TEST_F(SessionExport, TwoTakesOfOneNameAreNotGuessedBetween) {
  for (int i = 0; i < 40; ++i) {
    if (i % 20 == 0) recorder->begin_take("waltz");
    if (i % 20 == 10) recorder->end_take();
    solved(i / 60.0);
  }
  const auto range = session_range(file(), {"waltz", {}, {}});
  ASSERT_FALSE(range);
  EXPECT_THAT(range.error().text(), HasSubstr("two takes named 'waltz'"));
}

TEST_F(SessionExport, ReceivedPosesComeAtTheSendersPace) {
  const auto take = test::swinging_take("sent", 60, 8);
  for (int i = 0; i < 60; ++i) {
    const double jitter_s = i % 3 * 0.004;
    ReceivedPose pose =
        test::received("Ana", 3 + i / 60.0 + jitter_s, take.a.poses[static_cast<std::size_t>(i)]);
    pose.sender_time_s = 100 + i / 60.0;
    recorder->pose_received(pose);
    pose.performer = "Bo";
    recorder->pose_received(pose);
  }
  solved(3);
  const auto motion = performer_motion(file(), {}, "Ana", 0);
  ASSERT_TRUE(motion) << motion.error().text();
  EXPECT_EQ(motion->clips[0].fps, 60);
  EXPECT_EQ(motion->clips[0].name, "Ana");
  ASSERT_THAT(motion->clips[0].poses, SizeIs(60));
  EXPECT_LT((motion->clips[0].poses[41] - take.a.poses[41]).norm(), 1e-6);
  const auto nobody = performer_motion(file(), {}, "Cy", 0);
  ASSERT_FALSE(nobody);
  EXPECT_THAT(nobody.error().text(), HasSubstr("no performer 'Cy'; there are 'Ana', 'Bo'"));
}

const Tier* find(const std::vector<Tier>& tiers, const std::string& name) {
  for (const Tier& tier : tiers)
    if (tier.name == name) return &tier;
  return nullptr;
}

std::vector<std::string> values(const Tier& tier) {
  std::vector<std::string> all;
  for (const TierInterval& interval : tier.intervals) all.push_back(interval.value);
  return all;
}

TEST_F(SessionExport, MovesThatWereFollowedBecomeIntervals) {
  for (int i = 0; i < 30; ++i) solved(i / 60.0, pair_of("first", 60 + i));
  for (int i = 30; i < 60; ++i) solved(i / 60.0, pair_of("first", 60 + i));
  for (int i = 60; i < 80; ++i) solved(i / 60.0);
  for (int i = 80; i < 90; ++i) solved(i / 60.0, pair_of("second", i));
  const auto tiers = session_tiers(file(), all());
  ASSERT_TRUE(tiers) << tiers.error().text();
  const Tier* moves = find(*tiers, "move followed");
  ASSERT_TRUE(moves);
  ASSERT_THAT(values(*moves), ElementsAre("basic", "turn", "dip"));
  EXPECT_NEAR(moves->intervals[0].start_s, 0, 1e-9);
  EXPECT_NEAR(moves->intervals[0].end_s, 0.5, 1e-9);
  EXPECT_NEAR(moves->intervals[1].end_s, 1.0, 1e-9);
  EXPECT_NEAR(moves->intervals[2].start_s, 80 / 60.0, 1e-9);
  EXPECT_NEAR(moves->intervals[2].end_s, 1.5, 1e-9);  // the last frame lasts as long as the others
  EXPECT_THAT(values(*find(*tiers, "take followed")), ElementsAre("first", "second"));
}

TEST_F(SessionExport, AnIntervalEndsAtAPause) {
  for (int i = 0; i < 30; ++i) solved(i / 60.0, pair_of("second", i));
  for (int i = 0; i < 30; ++i) solved(4 + i / 60.0, pair_of("second", i));
  const auto tiers = session_tiers(file(), all());
  const Tier* moves = find(*tiers, "move followed");
  ASSERT_THAT(moves->intervals, SizeIs(2));
  EXPECT_NEAR(moves->intervals[0].end_s, 0.5, 1e-9);
}

TEST_F(SessionExport, RolesMeantMovesTakesAndMarkersAreTiers) {
  Settings passive;
  passive.user_role = UserRole::Passive;
  Decisions meant;
  meant.meant = IntendedMove{"dip", std::nullopt, -1};
  for (int i = 0; i < 60; ++i) {
    if (i == 10) recorder->begin_take("waltz");
    if (i == 50) recorder->end_take();
    solved(i / 60.0, -1, i < 20 ? Settings() : passive,
           i < 40 ? nullptr : std::make_shared<const Decisions>(meant));
  }
  Markers markers;
  markers.add(0.25, "here");
  recorder->set_markers(markers);
  const auto tiers = session_tiers(file(), all());
  ASSERT_TRUE(tiers);
  const Tier* role = find(*tiers, "user role");
  ASSERT_THAT(values(*role), ElementsAre("active", "passive"));
  EXPECT_NEAR(role->intervals[1].start_s, 20 / 60.0, 1e-9);
  EXPECT_NEAR(role->intervals[1].end_s, 1, 1e-6);
  EXPECT_THAT(role->vocabulary, ElementsAre(VocabularyEntry{"active"}, VocabularyEntry{"passive"}));
  ASSERT_TRUE(find(*tiers, "meant"));
  EXPECT_EQ(find(*tiers, "meant")->intervals[0].value, "dip");
  EXPECT_NEAR(find(*tiers, "meant")->intervals[0].start_s, 40 / 60.0, 1e-9);
  EXPECT_THAT(values(*find(*tiers, "take")), ElementsAre("waltz"));
  EXPECT_THAT(values(*find(*tiers, "marker")), ElementsAre("here"));
}

TEST_F(SessionExport, WhatAPersonAnnotatedIsExportedAndWhatIsOnlySuggestedIsNot) {
  for (int i = 0; i < 60; ++i) solved(i / 60.0);
  ASSERT_TRUE(recorder->finish());
  const Tier moves{
      "move", {{0.1, 0.5, "push", "with both hands", "high"}}, {{"push"}, {"pull"}}, TierKind::Move};
  Project project;
  project.annotations[""] = *annotations_of(std::vector{moves, Tier{"remarks", {{0, 1, "too fast"}}}});
  Annotations& said = project.annotations[""];
  said.suggest(std::vector{said.tiers()[0].id},
               {{0, said.tiers()[0].id, 0.6, 0.9, "pull", 0.5, "it looks so"}});
  project.annotations["another take"] = *annotations_of(std::vector{Tier{"elsewhere", {{0, 1, "x"}}}});
  ASSERT_TRUE(save_project(path, project));
  const auto opened = SessionFile::open(path);
  const auto tiers = session_tiers(**opened, *session_range(**opened, {}));
  ASSERT_TRUE(tiers);
  ASSERT_TRUE(find(*tiers, "move"));
  EXPECT_EQ(*find(*tiers, "move"), moves);
  EXPECT_THAT(values(*find(*tiers, "remarks")), ElementsAre("too fast"));
  EXPECT_THAT(find(*tiers, "remarks")->vocabulary, SizeIs(0));  // free text stays so
  EXPECT_FALSE(find(*tiers, "elsewhere"));
  const auto csv = session_labels_csv(**opened, *session_range(**opened, {}), 0);
  EXPECT_THAT(csv->text, HasSubstr("s,6,30,push,with both hands,high\n"));
  EXPECT_THAT(csv->warnings, ElementsAre("a label file holds one tier, here 'move'; 1 left out"));
}

TEST_F(SessionExport, TheLabelFileCountsFramesFromEachTake) {
  for (int i = 0; i < 120; ++i) {
    if (i == 30) recorder->begin_take("one");
    if (i == 60) recorder->begin_take("two");
    solved(i / 60.0, pair_of("first", 30 + i));  // "turn" from frame 60 on
  }
  const auto csv = session_labels_csv(file(), all(), 0);
  ASSERT_TRUE(csv) << csv.error().text();
  const auto one = parse_labels(csv->text, "one", "labels");
  ASSERT_TRUE(one) << one.error().text();
  ASSERT_THAT(*one, SizeIs(1));
  EXPECT_EQ((*one)[0].start, 0);
  EXPECT_EQ((*one)[0].end, 30);
  EXPECT_EQ((*one)[0].label, "basic");
  const auto half = session_labels_csv(file(), *session_range(file(), {{}, 0.75, {}}), 30);
  const auto both = parse_labels(half->text, "one", "labels");
  ASSERT_THAT(*both, SizeIs(1));
  EXPECT_EQ((*both)[0].end, 8);  // 15 frames of 60 Hz from 0.75 s on are 8 of 30 Hz
  EXPECT_EQ((*parse_labels(half->text, "two", "labels"))[0].label, "turn");
}

TEST_F(SessionExport, TheLabelFileKeepsCommasAndCountsMovesThatItCannotHold) {
  for (int i = 0; i < 60; ++i) solved(i / 60.0);
  ASSERT_TRUE(recorder->finish());
  Project project;
  project.annotations[""] = *annotations_of(std::vector{
      Tier{"move",
           {{0.1, 0.3, "push, then pull", "a \"firm\" one", "0.5"}, {0.4, 0.5, ""}, {0.61, 0.612, "dip"}},
           {},
           TierKind::Move}});
  ASSERT_TRUE(save_project(path, project));
  const auto opened = SessionFile::open(path);
  const auto csv = session_labels_csv(**opened, *session_range(**opened, {}), 0);
  ASSERT_TRUE(csv) << csv.error().text();
  const auto back = parse_labels(csv->text, "s", "labels");
  ASSERT_TRUE(back) << back.error().text();
  ASSERT_THAT(*back, SizeIs(1));
  EXPECT_EQ((*back)[0].label, "push, then pull");
  EXPECT_EQ((*back)[0].detail, "a \"firm\" one");
  EXPECT_EQ((*back)[0].confidence, "0.5");
  ASSERT_THAT(csv->warnings, SizeIs(1));
  EXPECT_THAT(csv->warnings[0], HasSubstr("2 of 3 moves were left out"));
}

TEST_F(SessionExport, FramesThatWouldFillAllMemoryAreNotMade) {
  for (int i = 0; i < 60; ++i) solved(i / 60.0);
  const auto motion = session_motion(file(), all(), all_bodies, 1e12);
  ASSERT_FALSE(motion);
  EXPECT_THAT(motion.error().text(), HasSubstr("more than 10000000; choose a shorter part"));
}

TEST_F(SessionExport, APartOfTheSessionIsOfOneLibrary) {
  for (int i = 0; i < 10; ++i) solved(i / 60.0);
  const auto segments = session_segments(file(), all());
  ASSERT_TRUE(segments);
  ASSERT_THAT(*segments, SizeIs(1));
  EXPECT_EQ((*segments)[0].library->name, "labelled");
  EXPECT_EQ((*segments)[0].range.last_frame, 9U);
}

TEST(SessionTrace, IsThatOfTheLiveSession) {
  test::TemporaryFolder folder;
  test::DrivenSession session;
  session.keeper->recorder = *Recorder::open(folder.file("s.abrazo"), test::session_facts());
  session.run_until(2);
  ASSERT_TRUE(session.keeper->recorder->finish());
  const auto file = SessionFile::open(folder.file("s.abrazo"));
  ASSERT_TRUE(file);
  const auto range = session_range(**file, {});
  std::vector<std::string> lines;
  const auto replay =
      session_trace(**file, test::session_library(), *range, [&](const std::string& line) -> Status {
        lines.push_back(line.substr(0, line.find("\"timing_us\"")));
        return Done{};
      });
  ASSERT_TRUE(replay) << replay.error().text();
  EXPECT_EQ(replay->differ, 0U);
  ASSERT_EQ(lines.size(), session.keeper->frames.size());
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const FrameSnapshot& live = *session.keeper->frames[i];
    const std::string expected =
        trace_frame_line(live.result, *test::session_library(), live.input_frame, live.time_s);
    ASSERT_EQ(lines[i], expected.substr(0, expected.find("\"timing_us\""))) << "frame " << i;
  }
  const auto header = session_trace_header(**file, "small.h5", *range);
  ASSERT_TRUE(header);
  EXPECT_THAT(*header, HasSubstr("\"input\":\"clip:user.bvh\""));
  EXPECT_THAT(*header, HasSubstr("\"fps\":60"));
}

}  // namespace
}  // namespace abrazo::session_export_test
