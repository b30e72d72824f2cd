// Labels in the whole window, by the mouse and the keys of a user.
#include <QApplication>
#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QTableWidget>
#include <QToolButton>

#include "app/workbench/document/library_feed.hpp"
#include "app/workbench/labels/annotation_desk.hpp"
#include "app/workbench/shell/panel_area.hpp"
#include "core/opening/file_kinds.hpp"
#include "tests/workbench/annotating_window.hpp"
#include "widgets/annotation/annotation_panel.hpp"
#include "widgets/annotation/problem_list.hpp"
#include "widgets/annotation/value_picker.hpp"
#include "widgets/common/message_bar.hpp"
#include "widgets/library/take_list.hpp"
#include "widgets/timeline/timeline_view.hpp"

namespace abrazo::app::annotation_actions_test {
namespace {

using annotating_window::Annotating;

TEST_F(Annotating, ATakeIsLookedAtFrameByFrameAndTheSessionComesBackAsItWas) {
  const LibraryTake about = library().takes().front();
  EXPECT_NEAR(ticker().playback().last_s, (about.frames - 1) / about.fps, 0.1);
  ticker().seek(100 / about.fps);
  turn();
  EXPECT_EQ(ticker().shown()->input_frame, 100);
  EXPECT_EQ(library().source(ticker().shown()->result.candidates[0].pair).frame, 100u);
  press(Qt::Key_End);
  EXPECT_EQ(ticker().playback().state, Playback::State::Parked) << "a take has no live end";
  desk().showSubject("");
  turn();
  EXPECT_FALSE(window().session()->looksElsewhere());
  EXPECT_GT(ticker().shown()->result.candidates.size(), 1u);
}

TEST_F(Annotating, EachSubjectKeepsItsMarkers) {
  press(Qt::Key_M);
  ASSERT_EQ(timeline().markers().all().size(), 1u);
  desk().showSubject("");
  EXPECT_TRUE(timeline().markers().empty());
  press(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_TRUE(timeline().markers().empty()) << "what was undone is of the take";
  desk().showSubject(take());
  EXPECT_TRUE(timeline().markers().empty());
}

TEST_F(Annotating, InAndOutOfATakeAreTakenBackAlsoWhileTheSessionIsShown) {
  ticker().seek(2);
  press(Qt::Key_I);
  ASSERT_TRUE(ticker().playback().in_set);
  desk().showSubject("");
  EXPECT_FALSE(ticker().playback().in_set) << "the session has its own";
  press(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(window().messages().text().toStdString(), "set in of " + take() + ", which is not shown");
  desk().showSubject(take());
  EXPECT_FALSE(ticker().playback().in_set);
}

TEST_F(Annotating, ADragDrawsAndADigitSaysWhat) {
  drag(2, 4);
  ASSERT_TRUE(open_picker());
  EXPECT_TRUE(labels().empty()) << "not before it says something";
  choose(Qt::Key_2);
  ASSERT_EQ(labels().size(), 1u);
  EXPECT_EQ(labels()[0].value, "two");
  EXPECT_NEAR(labels()[0].start_s, 2, 0.05);
  EXPECT_NEAR(labels()[0].end_s, 4, 0.05);
  EXPECT_TRUE(on_frame(labels()[0].start_s) && on_frame(labels()[0].end_s));
  EXPECT_EQ(window().undoStack().undoText(), "draw two");
  press(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_TRUE(labels().empty());
  press(Qt::Key_Y, Qt::ControlModifier);
  EXPECT_EQ(labels().size(), 1u);
}

/// "2" is the key of "two": at once it took the label, and the rest of the text were commands of the window.
TEST_F(Annotating, ATextMayBeginWithTheKeyOfAValue) {
  drag(2, 4);
  ASSERT_TRUE(open_picker());
  QTest::keyClicks(open_picker()->findChild<QLineEdit*>(), "2-step");
  ASSERT_TRUE(open_picker());
  EXPECT_EQ(open_picker()->value(), "2-step");
  type(Qt::Key_Return);
  ASSERT_EQ(labels().size(), 1u);
  EXPECT_EQ(labels()[0].value, "2-step");
  drag(5, 6);
  QTest::keyClick(open_picker()->findChild<QLineEdit*>(), Qt::Key_2);
  type(Qt::Key_Return);
  EXPECT_EQ(labels().back().value, "two") << "Return need not be waited for";
}

TEST_F(Annotating, AKeyIsNotLostWhenAClickFollowsIt) {
  drag(2, 4);
  QTest::keyClick(open_picker()->findChild<QLineEdit*>(), Qt::Key_2);
  window().takes().setFocus(Qt::MouseFocusReason);
  EXPECT_TRUE(until([] { return !open_picker(); }));
  ASSERT_EQ(labels().size(), 1u);
  EXPECT_EQ(labels()[0].value, "two");
}

TEST_F(Annotating, APlaceInATakeIsAFrame) {
  ticker().seek(100.4 * frame_s());
  turn();
  EXPECT_NEAR(ticker().playback().cursor_s, 100 * frame_s(), 1e-9);
  EXPECT_EQ(ticker().shown()->input_frame, 100);
  ticker().seek(100.6 * frame_s());
  turn();
  EXPECT_EQ(ticker().shown()->input_frame, 101) << "where an edge at the cursor would be";
}

TEST_F(Annotating, ALabelIsPlayedRoundAndRound) {
  const int id = add(3, 5, "one");
  window().document().selectLabel(id);
  key(Qt::Key_L, Qt::AltModifier);
  const Playback& playback = ticker().playback();
  EXPECT_EQ(playback.state, Playback::State::Playing);
  EXPECT_TRUE(playback.loop);
  EXPECT_NEAR(playback.in_s, label(id).start_s, 1e-9);
  EXPECT_NEAR(playback.out_s, label(id).end_s, 1e-9);
  ticker().pause();
  ticker().clearIn();
  ticker().clearOut();
  ticker().setLoop(false);
}

TEST_F(Annotating, EscapeAtTheQuestionDrawsNothing) {
  drag(2, 4);
  type(Qt::Key_Escape);
  EXPECT_FALSE(open_picker());
  EXPECT_TRUE(labels().empty());
}

/// It was made longer, and the name that was typed for the new one went to the keys of the session.
TEST_F(Annotating, ALabelThatIsBegunAtTheEndOfAnotherIsANewOne) {
  const int id = add(3, 5, "one");
  select(0);
  drag(5, 7);
  EXPECT_NEAR(label(id).end_s, 5, 1e-9);
  ASSERT_TRUE(open_picker()) << "what is typed now is its value";
  choose(Qt::Key_1);
  EXPECT_EQ(labels().size(), 2U);
}

TEST_F(Annotating, LettersOfOtherTasksDoNothingInTheTimeline) {
  add(3, 5, "one");
  const UserRole role = window().document().settings().user_role;
  timeline().setFocus();
  key(Qt::Key_U);
  EXPECT_EQ(window().document().settings().user_role, role);
  EXPECT_TRUE(window().messages().text().contains("does nothing while you annotate"));
  key(Qt::Key_I);
  EXPECT_TRUE(ticker().playback().in_set) << "keys of the timeline go on";
  ticker().clearIn();
}

TEST_F(Annotating, AnEdgeAndTheMiddleCanBeDragged) {
  const int id = add(3, 5, "one");
  select(id);
  drag(5, 7);
  EXPECT_NEAR(label(id).end_s, 7, 0.05);
  EXPECT_TRUE(on_frame(label(id).end_s));
  drag(4, 5);
  EXPECT_NEAR(label(id).start_s, 4, 0.05);
  EXPECT_NEAR(label(id).end_s, 8, 0.05);
  EXPECT_EQ(window().undoStack().undoText(), "move one");
}

TEST_F(Annotating, AnEdgeSnapsToTheCursorUnlessAltIsHeld) {
  const int id = add(3, 5, "one");
  select(id);
  ticker().seek(6.1);
  turn();
  const double near_s = 6.1 + 3 * timeline().axis().seconds_per_pixel();
  drag(5, near_s);
  EXPECT_DOUBLE_EQ(label(id).end_s, 6.1);
  drag(6.1, 6.1 + 6 * timeline().axis().seconds_per_pixel(), Qt::AltModifier);
  EXPECT_GT(label(id).end_s, 6.1 + 4 * timeline().axis().seconds_per_pixel());
}

TEST_F(Annotating, WhatIsInTheWayIsCutPushedOrRefuses) {
  const int first = add(3, 5, "one"), second = add(6, 8, "two");
  select(first);
  window().document().setConflict(Conflict::Refuse);
  drag(5, 7);
  EXPECT_NEAR(label(first).end_s, 5, 1e-9);
  window().document().setConflict(Conflict::Push);
  drag(5, 7);
  EXPECT_NEAR(label(second).start_s, 7, 0.05);
  EXPECT_NEAR(label(second).duration_s(), 2, 1e-6);
  press(Qt::Key_Z, Qt::ControlModifier);
  window().document().setConflict(Conflict::Replace);
  drag(5, 7);
  EXPECT_NEAR(label(second).start_s, 7, 0.05);
  EXPECT_NEAR(label(second).end_s, 8, 1e-6);
}

TEST_F(Annotating, ReturnEditsWhatIsSelectedAndDelRemovesIt) {
  const int id = add(3, 5, "one");
  QTest::mouseClick(&timeline(), Qt::LeftButton, {}, at(4, tier().id));
  turn();
  EXPECT_EQ(window().document().labels().selected(), id);
  EXPECT_NEAR(ticker().playback().cursor_s, 4, 0.05) << "a click goes there, as anywhere";
  key(Qt::Key_Return);
  choose(Qt::Key_2);
  EXPECT_EQ(label(id).value, "two");
  timeline().setFocus();
  key(Qt::Key_Delete);
  EXPECT_TRUE(labels().empty());
  press(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(labels().size(), 1u);
}

TEST_F(Annotating, WhatIsTypedIsCompletedFromTheVocabulary) {
  const int id = add(3, 5, "one");
  window().document().selectLabel(id);
  key(Qt::Key_F2);
  ASSERT_TRUE(open_picker());
  QTest::keyClicks(open_picker()->findChild<QLineEdit*>(), "tw");
  EXPECT_EQ(open_picker()->value(), "two");
  type(Qt::Key_Return);
  EXPECT_EQ(label(id).value, "two");
}

TEST_F(Annotating, KeysSplitMergeExtendAndNudge) {
  const int id = add(3, 5, "one");
  window().document().selectLabel(id);
  ticker().seek(4);
  turn();
  key(Qt::Key_S);
  ASSERT_EQ(labels().size(), 2u);
  window().document().selectLabel(id);
  key(Qt::Key_S, Qt::ShiftModifier);
  EXPECT_EQ(labels().size(), 1u);
  EXPECT_NEAR(label(id).end_s, 5, 1e-9);
  ticker().seek(6);
  turn();
  key(Qt::Key_E);
  EXPECT_NEAR(label(id).end_s, 6, 1e-9);
  key(Qt::Key_Right, Qt::ControlModifier | Qt::AltModifier);
  EXPECT_NEAR(label(id).start_s, 3 + frame_s(), 1e-9);
  EXPECT_NEAR(label(id).end_s, 6 + frame_s(), 1e-9);
  key(Qt::Key_Left, Qt::ControlModifier | Qt::ShiftModifier);
  EXPECT_NEAR(label(id).start_s, 3, 1e-9);
  key(Qt::Key_Left, Qt::AltModifier | Qt::ShiftModifier);
  EXPECT_NEAR(label(id).end_s, 6, 1e-9);
}

TEST_F(Annotating, NLabelsWhatIsBetweenInAndOut) {
  ticker().setRange(2, 3.5);
  turn();
  key(Qt::Key_N);
  choose(Qt::Key_1);
  ASSERT_EQ(labels().size(), 1u);
  EXPECT_NEAR(labels()[0].start_s, 2, 1e-6);
  EXPECT_NEAR(labels()[0].end_s, 3.5, 1e-6);
}

TEST_F(Annotating, TheRoleChangesAtTheCursor) {
  ticker().seek(3);
  turn();
  key(Qt::Key_U, Qt::ShiftModifier);
  ASSERT_EQ(labels(TierKind::Role).size(), 2u);
  EXPECT_EQ(labels(TierKind::Role)[0].value, "a");
  EXPECT_EQ(labels(TierKind::Role)[1].value, "b");
  EXPECT_NEAR(labels(TierKind::Role)[1].start_s, 3, 0.01);
  ticker().seek(6);
  turn();
  key(Qt::Key_U, Qt::ShiftModifier);
  ASSERT_EQ(labels(TierKind::Role).size(), 3u);
  EXPECT_EQ(labels(TierKind::Role)[2].value, "a");
}

TEST_F(Annotating, TheLibraryOfTheRunningSessionFollows) {
  Annotations next = window().document().annotations();
  ASSERT_TRUE(next.draw(tier().id, 0, 4, "one", Conflict::Replace, desk().range()));
  ASSERT_TRUE(next.draw(next.first_of(TierKind::Role)->id, 0, desk().range().last_s, "b", Conflict::Replace,
                        desk().range()));
  window().document().changeAnnotations(next, "label");
  until([] { return desk().feed().isIdle(); });
  const LibraryTake& about = library().takes().front();
  ASSERT_FALSE(about.labels.empty());
  EXPECT_EQ(about.labels.front().label, "one");
  ASSERT_FALSE(about.roles.empty());
  EXPECT_EQ(about.roles.front().active, ActivePerformer::B);
  EXPECT_GE(library().find_pair(take(), 10, true), 0) << "B is the active one of its pairs";
  EXPECT_EQ(window().session()->material().library->takes().front().labels.front().label, "one");
  turn();
  ASSERT_TRUE(ticker().shown());
  EXPECT_EQ(ticker().shown()->library, window().session()->material().library);
  press(Qt::Key_Z, Qt::ControlModifier);
  until([] { return desk().feed().isIdle(); });
  EXPECT_TRUE(library().takes().front().labels.empty());
}

TEST_F(Annotating, NoEditOfALabelMakesAFrameOfTheHeldSession) {
  SessionEngine& engine = window().session()->engine();
  const auto library_follows = [] { return until([] { return desk().feed().isIdle(); }); };
  ASSERT_TRUE(library_follows());
  ASSERT_TRUE(until([&] { return engine.is_held(); }));
  ASSERT_TRUE(ticker().playback().state == Playback::State::Parked);
  const double last_s = engine.history().span().last_s;
  drag(3, 5);
  choose(Qt::Key_1);
  ASSERT_TRUE(library_follows());
  turn();
  press(Qt::Key_Z, Qt::ControlModifier);
  ASSERT_TRUE(library_follows());
  turn();
  const double released_s = engine.clock().now_s();
  desk().showSubject("");
  ASSERT_TRUE(until([&] { return engine.history().span().last_s > last_s; }));
  const FrameSnapshotPtr next = engine.history().stepped(last_s, 1);
  EXPECT_GE(next->time_s, released_s) << "the first of after the hold";
  EXPECT_EQ(next->library, window().session()->material().library);
}

TEST_F(Annotating, UndoReachesIntoASubjectThatIsNotShown) {
  add(3, 5, "one");
  desk().showSubject("");
  turn();
  press(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(window().document().subject(), "") << "it does not take anybody away";
  const Annotations& of_take = window().document().live().annotations().of(take());
  EXPECT_TRUE(of_take.first_of(TierKind::Move)->annotations.empty());
  press(Qt::Key_Y, Qt::ControlModifier);
  EXPECT_EQ(of_take.first_of(TierKind::Move)->annotations.size(), 1u);
}

TEST_F(Annotating, TheSessionItselfIsLabelledWhileItIsLive) {
  desk().showSubject("");
  ticker().follow();
  turn();
  timeline().setFocus();
  const AnnotationTier& moves = *window().document().annotations().first_of(TierKind::Move);
  ASSERT_FALSE(moves.vocabulary.empty());
  QTest::keyPress(&timeline(), Qt::Key_1);
  const double from = ticker().playback().cursor_s;
  until([from] { return ticker().playback().cursor_s > from + 0.4; });
  QTest::keyRelease(&timeline(), Qt::Key_1);
  until([] { return !labels().empty(); });
  ASSERT_EQ(labels().size(), 1u);
  EXPECT_EQ(labels()[0].value, tier().vocabulary.front().value);
  EXPECT_NEAR(labels()[0].start_s, from, 0.1);
  press(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_TRUE(labels().empty());
}

TEST_F(Annotating, CtrlArrowsGoFromEdgeToEdge) {
  add(3, 5, "one");
  ticker().seek(4);
  turn();
  key(Qt::Key_Right, Qt::ControlModifier);
  EXPECT_NEAR(ticker().playback().cursor_s, 5, 1e-6);
  key(Qt::Key_Left, Qt::ControlModifier);
  EXPECT_NEAR(ticker().playback().cursor_s, 3, 1e-6);
}

TEST_F(Annotating, ThePanelListsTheLabelsAndTakesTypedTimes) {
  const int id = add(3, 5, "one");
  QTableWidget& table = desk().panel().table();
  ASSERT_EQ(table.rowCount(), 1);
  table.item(0, 1)->setText("6.5");
  EXPECT_NEAR(label(id).end_s, 6.5, 1e-9);
  table.item(0, 0)->setText("60 f");
  EXPECT_NEAR(label(id).start_s, 60 / desk().fps(), 1e-9);
  table.item(0, 0)->setText("soon");
  EXPECT_NEAR(label(id).start_s, 60 / desk().fps(), 1e-9);
}

/// In a window of the usual size the rows and "+ Value" were below the panel, and a refused name sounded as
/// if it had been taken.
TEST_F(Annotating, TheVocabularyIsInViewAndSaysBesideItWhyAnEditIsRefused) {
  widgets::AnnotationPanel& panel = desk().panel();
  window().panels().want("annotation", true);
  turn();
  const auto button = [&panel](const QString& words) {
    for (auto* each : panel.findChildren<QToolButton*>())
      if (each->text() == words) return each;
    return static_cast<QToolButton*>(nullptr);
  };
  QTest::mouseClick(button("Vocabulary"), Qt::LeftButton);
  turn();
  QTableWidget* table = nullptr;
  for (auto* each : panel.findChildren<QTableWidget*>())
    if (each->accessibleName() == "Vocabulary") table = each;
  ASSERT_TRUE(table);
  EXPECT_EQ(button("+ Value")->visibleRegion().boundingRect(), button("+ Value")->rect());
  const QRect last = table->visualItemRect(table->item(1, 2));
  EXPECT_TRUE(table->viewport()->visibleRegion().contains(last.center()));
  const auto says = [&panel](const QString& words) {
    for (const auto* each : panel.findChildren<QLabel*>())
      if (each->text() == words && !each->visibleRegion().isEmpty()) return true;
    return false;
  };
  table->item(1, 2)->setText("one");
  turn();
  const QString used = "Not changed: 'one' is already a value; choose another word";
  EXPECT_TRUE(says(used));
  EXPECT_EQ(window().messages().text(), used);
  EXPECT_EQ(table->item(1, 2)->text(), "two");
  table->item(1, 0)->setText("1");
  turn();
  EXPECT_TRUE(says("Not changed: the key 1 is already that of 'one'; choose another key for 'two'"));
  EXPECT_EQ(tier().entry("two")->key, '2');
}

TEST_F(Annotating, ALabelIsCompletedWhileItIsTypedInThePanel) {
  const int id = add(3, 5, "one");
  QTableWidget& table = desk().panel().table();
  const auto type = [&table](const QString& text) {
    table.setCurrentCell(0, 2);
    table.editItem(table.item(0, 2));
    auto* field = qobject_cast<QLineEdit*>(QApplication::focusWidget());
    ASSERT_TRUE(field);
    field->selectAll();
    QTest::keyClicks(field, text);
    QTest::keyClick(field, Qt::Key_Return);
    turn();
  };
  type("tw");
  EXPECT_EQ(label(id).value, "two") << "of the vocabulary";
  type("three");
  EXPECT_EQ(label(id).value, "three");
}

TEST_F(Annotating, AGapIsFilledByOneKeyInTheListOfProblems) {
  add(0, 3, "one");
  add(5, desk().range().last_s, "two");
  widgets::ProblemList& problems = desk().panel().problems();
  int gap = -1;
  for (int row = 0; row < problems.count(); ++row)
    if (problems.item(row)->text().startsWith("move: nothing")) gap = row;
  ASSERT_GE(gap, 0);
  problems.setCurrentRow(gap);
  QTest::keyClick(&problems, Qt::Key_Return);
  EXPECT_NEAR(labels()[0].end_s, 5, 1e-9);
}

TEST_F(Annotating, LabelFilesComeInAsOneStep) {
  const QString file = home().filePath("labels.csv");
  QFile out(file);
  ASSERT_TRUE(out.open(QIODevice::WriteOnly));
  out.write("tier,start,end,value\nmove,1,2,spin\nmove,2,4,one\n");
  out.close();
  ASSERT_EQ(kind_of_file(file.toStdString()), FileKind::Labels);
  window().openFiles({file});
  ASSERT_EQ(labels().size(), 2u);
  EXPECT_EQ(labels()[0].value, "spin");
  EXPECT_TRUE(tier().entry("spin")) << "its values are in the vocabulary";
  press(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_TRUE(labels().empty());
}

TEST_F(Annotating, TheListOfTakesAsksForATake) {
  emit window().takes().annotateRequested(1);
  EXPECT_EQ(window().document().subject(), library().takes()[1].name);
  press(Qt::Key_E, Qt::ControlModifier | Qt::ShiftModifier);
  EXPECT_EQ(window().document().subject(), "");
}

}  // namespace
}  // namespace abrazo::app::annotation_actions_test
