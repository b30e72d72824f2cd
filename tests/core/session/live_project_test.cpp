#include "core/session/edit/live_project.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/library/build/motion_library_builder.hpp"
#include "core/session/frames/decision_edits.hpp"
#include "tests/core/annotation/label_tiers.hpp"
#include "tests/support/libraries.hpp"

namespace abrazo::live_project_test {
namespace {

/// What a window does with a project: steps of undo, of which those of one gesture are one.
struct Worked {
  LiveProject live;
  std::vector<ProjectEdit> steps;

  bool change(const ProjectValue& value, const std::string& key = {}, int gesture = 0) {
    auto edit = live.edit(value, "edit");
    if (!edit) return false;
    edit->key = key;
    edit->gesture = gesture;
    live.put(edit->after);
    if (steps.empty() || !steps.back().absorb(*edit)) steps.push_back(*edit);
    if (steps.back().is_nothing()) steps.pop_back();
    return true;
  }
  bool set(const std::string& key, const std::string& text, int gesture = 0) {
    const auto next = live.with_setting(key, text);
    return next && change(*next, key, gesture);
  }
  void undo() {
    live.put(steps.back().before);
    steps.pop_back();
  }
  const Settings& settings() const { return live.project().settings; }
};

Markers marked(double time_s) {
  Markers markers;
  markers.add(time_s, "clap");
  return markers;
}

TEST(LiveProject, AnEntryIsOneSettingOfTheWholeValueAndCanBeUndone) {
  Worked work;
  EXPECT_TRUE(work.set("alpha", "0.7"));
  Settings wanted = *preset("paper");
  wanted.alpha = 0.7;
  EXPECT_EQ(work.settings(), wanted);
  EXPECT_EQ(work.live.preset().name, "paper") << "the preset that it is measured by stays";
  work.undo();
  EXPECT_EQ(work.settings(), *preset("paper"));
}

TEST(LiveProject, MovesOfOneGestureAreOneStepAndTwoGesturesAreTwo) {
  Worked work;
  for (const char* value : {"0.6", "0.7", "0.8"}) work.set("alpha", value, 1);
  EXPECT_EQ(work.steps.size(), 1U);
  work.set("alpha", "0.9", 2);
  EXPECT_EQ(work.steps.size(), 2U);
  work.set("velocity-weight", "0.9", 2);
  EXPECT_EQ(work.steps.size(), 3U) << "of another setting";
  work.undo(), work.undo(), work.undo();
  EXPECT_EQ(work.settings(), *preset("paper"));
}

TEST(LiveProject, AGestureThatEndsWhereItBeganIsNoStep) {
  Worked work;
  for (const char* value : {"0.6", "0.5"}) work.set("alpha", value, 1);
  EXPECT_TRUE(work.steps.empty());
}

TEST(LiveProject, AnEntryThatCannotBeUsedNamesItsSetting) {
  const auto next = LiveProject().with_setting("alpha", "much");
  ASSERT_FALSE(next);
  EXPECT_NE(next.error().text().find("alpha"), std::string::npos) << next.error().text();
}

TEST(LiveProject, UndoGoesBackToThePresetThatWasChosenToo) {
  Worked work;
  work.set("alpha", "0.7");
  work.change(*work.live.with_preset("responsive", false));
  EXPECT_EQ(work.live.preset().name, "responsive");
  work.undo();
  EXPECT_EQ(work.live.preset().name, "paper");
  EXPECT_EQ(work.settings().alpha, 0.7);
}

TEST(LiveProject, TheChosenBodiesStayWithAnotherPreset) {
  Worked work;
  work.set("active-body", "scale:1.2");
  work.change(*work.live.with_preset("responsive", false));
  EXPECT_EQ(work.live.preset().name, "responsive");
  EXPECT_EQ(setting_text(work.settings(), "active-body"), "scale:1.2");
  EXPECT_EQ(setting_text(work.settings(), "alpha"), setting_text(*preset("responsive"), "alpha"));
  Settings small = *preset("paper");
  small.active_body = *parse_body_choice("scale:0.8");
  work.live.put(std::vector<OwnPreset>{{"small", small}});
  work.change(*work.live.with_preset("small", true));
  EXPECT_EQ(setting_text(work.settings(), "active-body"), "scale:0.8") << "that of an own preset is taken";
}

TEST(LiveProject, AnOwnPresetThatIsGoneIsNotChosenAnyMore) {
  Worked work;
  Settings calm = *preset("paper");
  calm.alpha = 2;
  work.live.put(std::vector<OwnPreset>{{"calm", calm}});
  work.change(*work.live.with_preset("calm", true));
  EXPECT_EQ(work.settings(), calm);
  EXPECT_TRUE(work.live.preset().own);
  work.live.put(std::vector<OwnPreset>{});
  EXPECT_FALSE(work.live.preset().own);
  EXPECT_EQ(work.settings(), calm) << "the settings stay";
  EXPECT_FALSE(work.live.with_preset("calm", true));
}

TEST(LiveProject, SettingsThatArePresetsAreKnownAsSuch) {
  LiveProject live;
  EXPECT_EQ(live.with_settings(*preset("responsive")).preset.name, "responsive");
}

TEST(LiveProject, AStepOfDecisionsLeavesAloneWhoDecidesAboutTheRole) {
  Worked work;
  EXPECT_TRUE(work.change(with_pin_toggled({}, 3)));
  work.live.put(RoleControl::Leader);
  work.undo();
  EXPECT_FALSE(work.live.project().decisions.pinned);
  EXPECT_EQ(work.live.project().decisions.role_control, RoleControl::Leader);
  EXPECT_FALSE(work.change(Decisions{})) << "of the role alone nothing is to be undone";
}

TEST(LiveProject, MarkersOfTheSessionAndOfEachTakeAreTheirOwn) {
  Worked work;
  work.change(SubjectMarkers{"", marked(1)});
  work.change(SubjectMarkers{"salsa_01", marked(2)});
  EXPECT_EQ(work.live.project().markers, marked(1));
  EXPECT_EQ(work.live.markers("salsa_01"), marked(2));
  EXPECT_TRUE(work.live.markers("salsa_02").empty());
  work.undo();
  EXPECT_TRUE(work.live.project().take_markers.empty()) << "a take without any has no entry";
  EXPECT_EQ(work.live.markers(""), marked(1));
}

TEST(LiveProject, StepsOfMarkersEndWithTheirSessionAndThoseOfSettingsDoNot) {
  Worked work;
  work.set("alpha", "0.7");
  work.change(SubjectMarkers{"", marked(1)});
  work.live.begin_session(*test::small_library(), true);
  EXPECT_TRUE(work.live.markers("").empty());
  EXPECT_TRUE(work.live.is_valid(work.steps[0]));
  EXPECT_FALSE(work.live.is_valid(work.steps[1])) << "its times are others";
}

TEST(LiveProject, DecisionsStayInASessionOnTheSameLibraryAndGoWithAnother) {
  Worked work;
  work.change(with_pin_toggled({}, 3));
  work.live.begin_session(*test::small_library(), true);
  EXPECT_TRUE(work.live.is_valid(work.steps[0]));
  EXPECT_EQ(work.live.project().decisions.pinned, 3);
  work.live.put(RoleControl::Leader);
  work.live.begin_session(*test::small_library(), false);
  EXPECT_FALSE(work.live.is_valid(work.steps[0])) << "its pairs are others";
  EXPECT_FALSE(work.live.project().decisions.pinned);
  EXPECT_EQ(work.live.project().decisions.role_control, RoleControl::Leader);
}

TEST(LiveProject, AnotherLibraryInTheSameSessionKeepsWhatItHas) {
  const auto before = test::two_take_library(), after = test::small_library();
  Worked work;
  work.change(SubjectMarkers{"", marked(1)});
  Decisions decided = with_pin_toggled({}, 3);
  decided.vetoes.takes = {after->takes().front().name, "salsa_01"};
  work.change(decided);
  work.live.replace_library(*before, *after);
  EXPECT_FALSE(work.live.project().decisions.pinned);
  EXPECT_EQ(work.live.project().decisions.vetoes.takes, std::set<std::string>{after->takes().front().name});
  EXPECT_TRUE(work.live.is_valid(work.steps[0])) << "markers are of the session, which goes on";
  EXPECT_FALSE(work.live.is_valid(work.steps[1]));
}

TEST(LiveProject, WhatWasMeantWhenAProjectWasSavedIsNotMeantWhenItIsOpened) {
  Project saved;
  saved.settings.alpha = 2;
  saved.decisions.pinned = 4;
  saved.decisions.meant = IntendedMove{"turn", {}, 5, false};
  saved.markers = marked(1);
  saved.take_markers["salsa_01"] = marked(2);
  LiveProject live;
  live.open(saved);
  EXPECT_TRUE(is_same_work(live.project(), [&] {
    Project wanted = saved;
    wanted.decisions.meant.reset();
    return wanted;
  }()));
  EXPECT_FALSE(live.project().decisions.meant);
}

TEST(LiveProject, AVideoIsSavedWithAReferenceToItsFile) {
  VideoState video;
  video.id = 7;
  video.file = "/films/a.mp4";
  video.subject = "salsa_01";
  Worked work;
  EXPECT_TRUE(work.change(VideoStates{video}));
  ASSERT_EQ(work.live.project().videos.size(), 1U);
  EXPECT_EQ(work.live.project().videos[0].subject, "salsa_01");
  EXPECT_EQ(work.live.project().videos[0].data, 0);
  ASSERT_EQ(work.live.video_files().size(), 1U);
  EXPECT_EQ(work.live.video_files()[0].absolute_path, "/films/a.mp4");
  EXPECT_EQ(work.live.video_files()[0].use, DataReference::Use::Video);
  work.undo();
  EXPECT_TRUE(work.live.project().videos.empty());
}

TEST(LiveProject, StepsOfVideosEndWhenOthersComeInTheirPlace) {
  VideoState video;
  video.id = 1;
  Worked work;
  work.change(VideoStates{video});
  EXPECT_TRUE(work.live.is_valid(work.steps[0]));
  work.live.replace_videos({});
  EXPECT_TRUE(work.live.videos().empty());
  EXPECT_FALSE(work.live.is_valid(work.steps[0])) << "it would bring back one that was closed";
}

TEST(Project, IsTheSameWorkWhereverItsPanelsStandAndOtherWorkWithAnotherMarker) {
  Project a, b;
  b.view["camera"] = "1 0";
  EXPECT_TRUE(is_same_work(a, b));
  b.take_markers["salsa_01"] = marked(1);
  EXPECT_FALSE(is_same_work(a, b));
}

TEST(Project, IsOtherWorkWithAnyOtherThingThatAPersonDecided) {
  const std::vector<std::pair<const char*, std::function<void(Project&)>>> changes = {
      {"settings", [](Project& p) { p.settings.alpha = 0.9; }},
      {"pin", [](Project& p) { p.decisions.pinned = 3; }},
      {"vetoes",
       [](Project& p) {
         p.decisions.vetoes = {{3, 7}, {}, {}};
       }},
      {"role control", [](Project& p) { p.decisions.role_control = RoleControl::Leader; }},
      {"markers", [](Project& p) { p.markers = marked(1); }},
      {"markers of a take", [](Project& p) { p.take_markers["salsa_01"] = marked(1); }},
      {"videos",
       [](Project& p) {
         p.videos.push_back({0, "salsa_01", {}, {}, {}});
       }},
  };
  for (const auto& [what, change] : changes) {
    Project a, b;
    change(b);
    EXPECT_FALSE(is_same_work(a, b)) << what;
    change(a);
    EXPECT_TRUE(is_same_work(a, b)) << what;
  }
}

using test::label_texts;
using ::testing::ElementsAre;
using ::testing::IsEmpty;

MotionLibrary library_of(const std::string& name, const std::vector<std::string>& takes) {
  std::vector<PairedTake> recorded;
  for (const std::string& take : takes) {
    recorded.push_back(test::swinging_take(take, 30, 1));
    recorded.back().roles = {{0, 30, ActivePerformer::A}};
    recorded.back().labels = {{0, 12, "basic", "", ""}, {12, 30, "turn", "", ""}};
  }
  return *build_library(name, std::move(recorded), {}, {});
}

const MotionLibrary& library() {
  static const MotionLibrary two_takes = library_of("salsa", {"one", "two"});
  return two_takes;
}

const AnnotationTier& tier(const Annotations& annotations, TierKind kind = TierKind::Move) {
  return *annotations.first_of(kind);
}

/// The annotations of a live project, edited in undo steps.
class LiveAnnotationsTest : public testing::Test {
 protected:
  LiveAnnotationsTest() { live.begin_session(library(), false); }

  /// Draws a move in a subject, as a step that is done. @return the step
  ProjectEdit draw(const std::string& subject, double from_s, double to_s, const char* value) {
    Annotations next = live.annotations().of(subject);
    EXPECT_TRUE(next.draw(tier(next).id, from_s, to_s, value, Conflict::Replace, {0, 10}));
    const auto step = live.edit(SubjectAnnotations{subject, next}, "draw");
    EXPECT_TRUE(step);
    EXPECT_THAT(live.put(step->after), ElementsAre(ProjectPart::Annotations));
    return *step;
  }
  std::vector<std::string> moves(const std::string& subject) const {
    const Annotations& annotations = live.annotations().of(subject);
    return annotations.empty() ? std::vector<std::string>() : label_texts(annotations, tier(annotations).id);
  }
  const AnnotationBook& saved() const { return live.project().annotations; }

  LiveProject live;
};

TEST(BegunAnnotations, OfATakeAreTheLibrarysWithKeysAndATierForNotes) {
  const Annotations begun = begun_annotations(library(), "one");
  EXPECT_THAT(label_texts(begun, tier(begun).id), ElementsAre("0-0.2 basic", "0.2-0.5 turn"));
  EXPECT_EQ(tier(begun).entry("basic")->key, '1');
  EXPECT_EQ(tier(begun).entry("turn")->key, '2');
  EXPECT_EQ(tier(begun, TierKind::Role).entry("a")->key, 'a');
  ASSERT_TRUE(begun.tier_named("note"));
  EXPECT_EQ(begun.tier_named("note")->kind, TierKind::Note);
}

TEST(BegunAnnotations, OfTheSessionHaveTheTakesWordsAndSayNothing) {
  const Annotations begun = begun_annotations(library(), "");
  EXPECT_THAT(tier(begun).annotations, IsEmpty());
  EXPECT_TRUE(tier(begun).entry("turn"));
  EXPECT_EQ(tier(begun, TierKind::Role).entry("a")->description, "user leads");
}

TEST_F(LiveAnnotationsTest, ABegunTakeIsNotAChangeUntilSomethingElseIsSaid) {
  live.begin_annotations("one", library());
  EXPECT_THAT(moves("one"), ElementsAre("0-0.2 basic", "0.2-0.5 turn"));
  EXPECT_THAT(saved(), IsEmpty());
  draw("one", 0, 0.1, "turn");
  ASSERT_EQ(saved().size(), 1u);
  EXPECT_EQ(saved().begin()->first, "one");
}

TEST_F(LiveAnnotationsTest, AStepIsTakenBackAndDoneAgain) {
  const ProjectEdit step = draw("", 1, 2, "turn");
  EXPECT_THAT(moves(""), ElementsAre("1-2 turn"));
  live.put(step.before);
  EXPECT_THAT(moves(""), IsEmpty());
  EXPECT_THAT(saved(), IsEmpty()) << "nothing to save";
  live.put(step.after);
  EXPECT_THAT(moves(""), ElementsAre("1-2 turn"));
  EXPECT_FALSE(live.edit(SubjectAnnotations{"", live.annotations().of("")}, "nothing"))
      << "what is so already is no step";
}

TEST_F(LiveAnnotationsTest, AStepConcernsItsSubjectOnly) {
  live.begin_annotations("one", library());
  draw("", 1, 2, "turn");
  const ProjectEdit step = draw("one", 0, 0.1, "turn");
  live.put(step.before);
  EXPECT_THAT(moves("one"), ElementsAre("0-0.2 basic", "0.2-0.5 turn"));
  EXPECT_THAT(moves(""), ElementsAre("1-2 turn"));
}

TEST_F(LiveAnnotationsTest, StepsOfAnotherSessionOrProjectAreOfNoUse) {
  const ProjectEdit step = draw("", 1, 2, "turn");
  EXPECT_TRUE(live.is_valid(step));
  live.begin_session(library(), true);
  EXPECT_FALSE(live.is_valid(step));
  EXPECT_THAT(moves(""), IsEmpty());
  const ProjectEdit other = draw("", 1, 2, "turn");
  live.open_annotations({}, library());
  EXPECT_FALSE(live.is_valid(other));
}

TEST_F(LiveAnnotationsTest, TheNextSessionKeepsWhatWasSavedOfItsTakes) {
  draw("", 1, 2, "turn");
  for (const char* take : {"one", "two"}) {
    live.begin_annotations(take, library());
    draw(take, 0, 0.1, "turn");
  }
  live.note_saved(saved());
  draw("two", 0.3, 0.5, "basic");  // and is not saved any more
  live.begin_session(library_of("salsa", {"two", "three"}), false);
  EXPECT_THAT(moves(""), IsEmpty()) << "its times were another session's";
  EXPECT_THAT(moves("two"), ElementsAre("0-0.1 turn", "0.1-0.2 basic", "0.2-0.5 turn"));
  EXPECT_THAT(moves("one"), IsEmpty()) << "the library does not have it any more";
  ASSERT_EQ(saved().size(), 1u);
  EXPECT_EQ(saved().begin()->first, "two");
  live.begin_session(library_of("fights", {"two"}), false);
  EXPECT_THAT(moves("two"), IsEmpty()) << "another library's take of the same name";
  EXPECT_THAT(saved(), IsEmpty());
}

TEST_F(LiveAnnotationsTest, WhatWasNotSavedEndsWithItsSession) {
  live.begin_annotations("one", library());
  const Annotations as_begun = live.annotations().of("one");
  draw("one", 0, 0.1, "spin");
  live.begin_session(library(), true);
  EXPECT_THAT(saved(), IsEmpty());
  live.begin_annotations("one", library());
  EXPECT_EQ(live.annotations().of("one"), as_begun);
}

TEST_F(LiveAnnotationsTest, OfAProjectTheNextSessionKeepsWhatItsFileHas) {
  const AnnotationBook book = {{"two", begun_annotations(library(), "two")}};
  live.open_annotations(book, library());
  draw("two", 0, 0.1, "turn");
  live.begin_session(library(), true);
  EXPECT_EQ(live.annotations().of("two"), book.at("two"));
  live.open_annotations(book, library(), false);  // restored after a crash
  live.begin_session(library(), true);
  EXPECT_TRUE(live.annotations().of("two").empty());
}

TEST_F(LiveAnnotationsTest, ANewWordIsThereInOtherTakesAndLeavesTheKeysOfTheOthers) {
  live.begin_annotations("one", library());
  Annotations next = live.annotations().of("one");
  auto words = tier(next).vocabulary;
  words.push_back({"spin", "on one foot", {}, '5'});
  ASSERT_TRUE(next.set_vocabulary(tier(next).id, words));
  live.put(SubjectAnnotations{"one", next});
  draw("one", 0, 0.1, "dip");  // said without being a word of the vocabulary
  live.begin_annotations("two", library());
  words.push_back({"dip"});
  EXPECT_EQ(tier(live.annotations().of("two")).vocabulary, words);
}

TEST_F(LiveAnnotationsTest, ABookTakesThePlaceOfAllAndIsAChange) {
  draw("", 1, 2, "turn");
  const Annotations kept = begun_annotations(library(), "two");
  EXPECT_THAT(live.open_annotations({{"two", kept}}, library()), ElementsAre(ProjectPart::Annotations));
  EXPECT_THAT(moves(""), IsEmpty());
  EXPECT_FALSE(live.annotations().of("").empty()) << "the session has its tiers";
  EXPECT_THAT(saved(), ElementsAre(std::pair<const std::string, Annotations>("two", kept)))
      << "so that it is saved again";
}

}  // namespace
}  // namespace abrazo::live_project_test
