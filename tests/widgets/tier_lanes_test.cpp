// Lanes of tiers, what lies under the pointer in them, drags, and what the panel computes: without a toolkit.
#include <gtest/gtest.h>

#include "widgets/annotation/annotation_rows.hpp"
#include "widgets/annotation/problem_fixes.hpp"
#include "widgets/timeline/tier_drag.hpp"
#include "widgets/timeline/whole_lanes.hpp"

namespace abrazo::widgets::tier_lanes_test {
namespace {

using Part = TierHit::Part;

/// 20 pixels a second from x = 100 at 10 s. Moves: hold 15-20, turn 20-25, walk 30-32; 60 frames a second.
struct Scene {
  TimelineAxis axis{100, 700, 10, 35};
  TimelineLanes lanes;
  Annotations annotations;
  int moves = 0, notes = 0, hold = 0, turn = 0, walk = 0;
  TierRules rules{Conflict::Replace, {0, 40}, 60};
  int selected = 0;

  Scene() {
    moves = *annotations.add_tier("move", TierKind::Move, {{"hold"}, {"turn"}, {"walk"}});
    notes = *annotations.add_tier("note", TierKind::Note, {});
    hold = *annotations.draw(moves, 15, 20, "hold", Conflict::Refuse, rules.range);
    turn = *annotations.draw(moves, 20, 25, "turn", Conflict::Refuse, rules.range);
    walk = *annotations.draw(moves, 30, 32, "walk", Conflict::Refuse, rules.range);
    lanes.set_tiers({{moves, "move"}, {notes, "note"}});
    lanes.set_height(lanes.whole_px());
  }
  double y(int tier) const { return lanes.top_of_tier(tier) + 10; }
  TierHit at(double time_s, double off_px = 0) const {
    return tier_hit(axis.x(time_s) + off_px, y(moves), axis, lanes, annotations, selected);
  }
  /// From one time to another, snapping within 0.2 s.
  TierDrag::Outcome dragged(double from_s, double to_s, double reach_s = 0.2, bool anew = false) const {
    const TierHit found = at(from_s);
    TierHit own = found;
    if (anew || found.part == Part::Empty) own = {};
    const TierDrag drag(annotations, found, from_s, rules, anew);
    return drag.to(to_s, snap_targets(annotations, own, rules.fps, 28.5, {27}), reach_s);
  }
};

TEST(TimelineLanes, LanesOfTiersStandBelowTheComputedOnes) {
  const Scene scene;
  EXPECT_DOUBLE_EQ(scene.lanes.top_of_tier(scene.moves),
                   scene.lanes.top_of(TimelineLane::Markers) + info_of(TimelineLane::Markers).height_px);
  EXPECT_DOUBLE_EQ(scene.lanes.top_of_tier(scene.notes),
                   scene.lanes.top_of_tier(scene.moves) + TimelineLanes::tier_px);
  EXPECT_EQ(scene.lanes.tier_at(scene.y(scene.notes)), scene.notes);
  EXPECT_EQ(scene.lanes.tier_at(scene.lanes.top_of(TimelineLane::Source) + 3), 0);
  TimelineLane lane{};
  EXPECT_FALSE(scene.lanes.lane_at(scene.y(scene.moves), lane));
}

TEST(TimelineLanes, AHiddenTierStaysSoByItsNameAndIsRemembered) {
  Scene scene;
  scene.lanes.set_tier_shown("move", false);
  EXPECT_EQ(scene.lanes.tier_at(scene.y(scene.notes)), scene.notes) << "it went up";
  TimelineLanes again;
  again.set_text(scene.lanes.text());
  EXPECT_FALSE(again.is_shown(TierLane{77, "move"}));
  EXPECT_TRUE(again.is_shown(TierLane{78, "note"}));
  EXPECT_TRUE(again.is_shown(TimelineLane::Moves)) << "another name";
}

TEST(TimelineLanes, AreRememberedWhateverTheTierIsCalled) {
  TimelineLanes lanes;
  lanes.set_tier_shown("left|right", false);
  lanes.set_tier_shown("50 %7C", false);
  TimelineLanes again;
  again.set_text(lanes.text());
  EXPECT_FALSE(again.is_shown(TierLane{1, "left|right"}));
  EXPECT_FALSE(again.is_shown(TierLane{2, "50 %7C"}));
  EXPECT_TRUE(again.is_shown(TierLane{3, "right"}));
}

TEST(TimelineLanes, OfAnEarlierVersionMayHaveAPercentSign) {
  TimelineLanes lanes;
  lanes.set_text("Source|50% speed");
  EXPECT_FALSE(lanes.is_shown(TierLane{1, "50% speed"}));
}

TEST(TimelineLanes, WhatWasRememberedBeforeThereWereTiersStillCounts) {
  TimelineLanes lanes;
  lanes.set_text("Source Energy");
  EXPECT_TRUE(lanes.is_shown(TimelineLane::Energy));
  EXPECT_FALSE(lanes.is_shown(TimelineLane::Moves));
  EXPECT_TRUE(lanes.is_shown(TierLane{1, "move"}));
}

TEST(TimelineLanes, OfATakeOnlyThoseThatSaySomethingOfIt) {
  TimelineLanes lanes;
  lanes.set_of_take(true);
  EXPECT_TRUE(lanes.is_shown(TimelineLane::Source));
  EXPECT_FALSE(lanes.is_shown(TimelineLane::Cost));
  lanes.set_of_take(false);
  EXPECT_TRUE(lanes.is_shown(TimelineLane::Cost)) << "as it was";
}

TEST(TierHit, TellsEdgesBodiesAndWhatIsEmpty) {
  Scene scene;
  EXPECT_EQ(scene.at(17), (TierHit{Part::Body, scene.moves, scene.hold}));
  scene.selected = scene.hold;
  EXPECT_EQ(scene.at(15, 4), (TierHit{Part::Start, scene.moves, scene.hold}));
  EXPECT_EQ(scene.at(15, -3), (TierHit{Part::Empty, scene.moves})) << "another one is drawn from there";
  scene.selected = scene.turn;
  EXPECT_EQ(scene.at(25, -4), (TierHit{Part::End, scene.moves, scene.turn}));
  EXPECT_EQ(scene.at(25, 3), (TierHit{Part::Empty, scene.moves}));
  EXPECT_EQ(scene.at(27), (TierHit{Part::Empty, scene.moves}));
  EXPECT_EQ(tier_hit(40, scene.y(scene.moves), scene.axis, scene.lanes, scene.annotations, 0),
            (TierHit{Part::Name, scene.moves}));
  EXPECT_EQ(tier_hit(300, 5, scene.axis, scene.lanes, scene.annotations, 0), TierHit{});
}

TEST(TierHit, OnlyTheEdgesOfTheSelectedLabelAreTakenHoldOf) {
  Scene scene;
  EXPECT_EQ(scene.at(25, 4), (TierHit{Part::Empty, scene.moves})) << "another label begins here";
  EXPECT_EQ(scene.at(25, -4), (TierHit{Part::Body, scene.moves, scene.turn}));
  scene.selected = scene.walk;
  EXPECT_EQ(scene.at(20).part, Part::Body) << "neither of the two that meet here is selected";
}

TEST(TierHit, TheEdgeThatTwoShareIsOfBoth) {
  Scene scene;
  scene.selected = scene.turn;
  for (const double off_px : {-3.0, 0.0, 3.0})
    EXPECT_EQ(scene.at(20, off_px), (TierHit{Part::Between, scene.moves, scene.hold, scene.turn})) << off_px;
}

TEST(TierHit, ANarrowLabelKeepsABodyToTakeHoldOf) {
  Scene scene;
  const int dot = *scene.annotations.draw(scene.moves, 27, 27.45, "hold", Conflict::Refuse, {0, 40});  // 9 px
  scene.selected = dot;
  EXPECT_EQ(scene.at(27.225), (TierHit{Part::Body, scene.moves, dot}));
  EXPECT_EQ(scene.at(27, 2).part, Part::Start);
  EXPECT_EQ(scene.at(27, -2).part, Part::Start);
  EXPECT_EQ(scene.at(27, -3).part, Part::Empty);
}

TEST(TierHit, AConfirmedLabelHidesASuggestion) {
  Scene scene;
  const int tiers[] = {scene.moves};
  scene.annotations.suggest(tiers, {{0, scene.moves, 19, 28, "walk", 0.7, "why"}});
  EXPECT_EQ(scene.at(22).part, Part::Body);
  EXPECT_EQ(scene.at(27).part, Part::Suggestion);
}

TEST(TierDrag, DrawsFromFrameToFrame) {
  const Scene scene;
  const auto drawn = scene.dragged(26.004, 26.71);
  EXPECT_NEAR(drawn.from_s, 26, 1e-9);
  EXPECT_NEAR(drawn.to_s, 1603 / 60.0, 1e-9);
  EXPECT_FALSE(drawn.snapped_s) << "a frame is everywhere";
  EXPECT_TRUE(drawn.refused.empty());
}

TEST(TierDrag, AnEdgeSnapsToTheCursorAMarkerAndAnEdgeOfAnotherAndShowsIt) {
  Scene scene;
  scene.selected = scene.turn;
  EXPECT_EQ(scene.dragged(25, 28.4).snapped_s, 28.5);
  EXPECT_EQ(scene.dragged(25, 27.1).snapped_s, 27.0);
  EXPECT_EQ(scene.dragged(25, 29.95).snapped_s, 30.0);
  EXPECT_FALSE(scene.dragged(25, 28.4, 0).snapped_s) << "Alt";
  EXPECT_NEAR(scene.dragged(25, 28.404, 0).to_s, 28.4, 1e-9) << "the frame, not the cursor beside it";
}

TEST(TierDrag, ACursorOrAMarkerBetweenFramesIsTheFrameThere) {
  const auto targets = snap_targets({}, {}, 60, 28.505, {27.004});
  EXPECT_NEAR(*targets.cursor_s, 28.5, 1e-9);
  EXPECT_NEAR(targets.others_s.at(0), 27, 1e-9);
  EXPECT_EQ(snap_targets({}, {}, 0, 28.505, {}).cursor_s, 28.505) << "no fixed rate";
}

TEST(TierDrag, MovesWholeAndTheNearerEndSnaps) {
  const Scene scene;
  const auto moved = scene.dragged(31, 27.56);  // 26.56 to 28.56: its end comes near the cursor
  EXPECT_NEAR(moved.to_s, 28.5, 1e-9);
  EXPECT_NEAR(moved.to_s - moved.from_s, 2, 1e-9);
  EXPECT_EQ(moved.snapped_s, 28.5);
}

TEST(TierDrag, TheSharedEdgeMovesBoth) {
  Scene scene;
  scene.selected = scene.turn;
  for (const double to : {18.0, 22.0}) {
    const auto moved = scene.dragged(20, to);
    EXPECT_NEAR(moved.annotations.find(scene.hold)->end_s, to, 1e-9);
    EXPECT_NEAR(moved.annotations.find(scene.turn)->start_s, to, 1e-9);
    EXPECT_NEAR(moved.annotations.find(scene.turn)->end_s, 25, 1e-9);
  }
}

TEST(TierDrag, AnEdgeStopsAFrameBeforeTheOther) {
  Scene scene;
  scene.selected = scene.hold;
  const auto shut = scene.dragged(15, 24);
  EXPECT_NEAR(shut.to_s - shut.from_s, 1 / 60.0, 1e-9);
  EXPECT_NEAR(scene.dragged(20, 39).annotations.find(scene.turn)->duration_s(), 1 / 60.0, 1e-9);
}

TEST(TierDrag, TellsWhatIsInTheWayBeforeItIsLetGo) {
  Scene scene;
  scene.selected = scene.turn;
  scene.rules.conflict = Conflict::Refuse;
  EXPECT_FALSE(scene.dragged(25, 31).refused.empty());
  EXPECT_TRUE(scene.dragged(25, 29).refused.empty());
  scene.rules.conflict = Conflict::Push;
  const auto pushed = scene.dragged(25, 31);
  EXPECT_NEAR(pushed.annotations.find(scene.walk)->start_s, 31, 1e-9);
  EXPECT_NEAR(pushed.annotations.find(scene.walk)->end_s, 33, 1e-9);
}

TEST(TierDrag, CtrlDrawsOverWhatIsThere) {
  const Scene scene;
  const auto drawn = scene.dragged(17, 18, 0, true);
  EXPECT_NEAR(drawn.from_s, 17, 1e-9);
  EXPECT_NEAR(drawn.to_s, 18, 1e-9);
}

TEST(AnnotationRows, ReadsTimesAsPeopleWriteThem) {
  EXPECT_EQ(typed_time("12.5", 60), 12.5);
  EXPECT_EQ(typed_time(" 12.5 s", 60), 12.5);
  EXPECT_EQ(typed_time("1:05.5", 60), 65.5);
  EXPECT_EQ(typed_time("750 f", 60), 12.5);
  EXPECT_EQ(typed_time("#750", 60), 12.5);
  EXPECT_EQ(typed_time("750 f", 0), std::nullopt) << "no frames to count by";
  EXPECT_EQ(typed_time("soon", 60), std::nullopt);
  EXPECT_EQ(typed_time("1:75", 60), std::nullopt);
  EXPECT_EQ(frame_text(12.5, 60), "750");
}

TEST(AnnotationRows, SaysHowMuchOfTheSubjectIsLabelled) {
  const Scene scene;
  EXPECT_EQ(coverage_text(*scene.annotations.tier(scene.moves), scene.rules.range),
            "3 labels, 30 % of 40.0 s");
}

AnnotationProblem first_problem(const Scene& scene, AnnotationProblem::Kind kind) {
  for (const AnnotationProblem& each : problems_of(scene.annotations, scene.rules.range, 60))
    if (each.kind == kind) return each;
  ADD_FAILURE() << "no such problem";
  return {};
}

TEST(ProblemFix, AGapIsFilledFromEitherSide) {
  Scene scene;
  AnnotationProblem gap;
  for (const AnnotationProblem& each : problems_of(scene.annotations, scene.rules.range, 60))
    if (each.kind == AnnotationProblem::Kind::Gap && each.start_s == 25) gap = each;
  ASSERT_EQ(gap.end_s, 30);
  EXPECT_EQ(fixes_of(gap, scene.annotations),
            (std::vector{ProblemFix::FillFromLeft, ProblemFix::FillFromRight}));
  const auto left = fixed(scene.annotations, gap, ProblemFix::FillFromLeft, scene.rules.range, 60);
  EXPECT_EQ(left->find(scene.turn)->end_s, 30);
  const auto right = fixed(scene.annotations, gap, ProblemFix::FillFromRight, scene.rules.range, 60);
  EXPECT_EQ(right->find(scene.walk)->start_s, 25);
}

TEST(ProblemFix, AnUnknownValueGoesIntoTheVocabulary) {
  Scene scene;
  ASSERT_TRUE(scene.annotations.say(scene.turn, {.value = "spin"}));
  const auto problem = first_problem(scene, AnnotationProblem::Kind::UnknownValue);
  ASSERT_EQ(fixes_of(problem, scene.annotations).front(), ProblemFix::AddToVocabulary);
  const auto next = fixed(scene.annotations, problem, ProblemFix::AddToVocabulary, scene.rules.range, 60);
  EXPECT_TRUE(next->tier(scene.moves)->entry("spin"));
}

TEST(ProblemFix, AnEdgeOffTheFramesGoesToTheNearest) {
  Scene scene;
  ASSERT_TRUE(scene.annotations.place(scene.walk, 30.003, 31.996, Conflict::Refuse, scene.rules.range));
  const auto problem = first_problem(scene, AnnotationProblem::Kind::OffFrame);
  const auto next = fixed(scene.annotations, problem, ProblemFix::ToFrames, scene.rules.range, 60);
  EXPECT_NEAR(next->find(scene.walk)->start_s, 30, 1e-9);
  EXPECT_NEAR(next->find(scene.walk)->end_s, 32, 1e-9);
}

TEST(WholeLanes, NoLaneInViewIsCut) {
  const Scene scene;
  const double all = scene.lanes.whole_px(), tier = TimelineLanes::tier_px;
  const double none = scene.lanes.top_px() + TimelineLanes::overview_px;
  const double source = info_of(TimelineLane::Source).height_px;
  EXPECT_EQ(whole_lanes_px(scene.lanes, all), all);
  EXPECT_EQ(whole_lanes_px(scene.lanes, all + 40), all) << "no more than there are";
  EXPECT_EQ(whole_lanes_px(scene.lanes, all - 1), all - tier);
  EXPECT_EQ(whole_lanes_px(scene.lanes, none + source + 5), none + source);
  EXPECT_EQ(whole_lanes_px(scene.lanes, none + source - 5), none + source - 5)
      << "better a part than nothing";
}

}  // namespace
}  // namespace abrazo::widgets::tier_lanes_test
