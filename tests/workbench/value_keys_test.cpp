// The keys of values, pressed in the whole window.
#include <QLineEdit>
#include <QTimer>
#include <QTreeView>

#include "app/workbench/labels/annotation_desk.hpp"
#include "tests/workbench/annotating_window.hpp"
#include "widgets/timeline/timeline_view.hpp"

namespace abrazo::app::value_keys_test {
namespace {

using annotating_window::Annotating;

TEST_F(Annotating, AKeyAtAStandingCursorSaysItFromThereOn) {
  ticker().seek(2);
  turn();
  key(Qt::Key_1);
  ASSERT_EQ(labels().size(), 1u);
  EXPECT_NEAR(labels()[0].end_s, desk().range().last_s, 1e-9);
  ticker().seek(5);
  turn();
  key(Qt::Key_2);
  ASSERT_EQ(labels().size(), 2u);
  EXPECT_NEAR(labels()[0].end_s, labels()[1].start_s, 1e-9);
  EXPECT_EQ(labels()[1].value, "two");
  ticker().seek(3);
  turn();
  key(Qt::Key_2);
  EXPECT_NEAR(labels()[1].end_s, 5, 0.02) << "to where the next one begins";
}

TEST_F(Annotating, AKeyGivesTheSelectedLabelItsValue) {
  const int id = add(3, 5, "one");
  window().document().selectLabel(id);
  key(Qt::Key_2);
  EXPECT_EQ(label(id).value, "two");
  EXPECT_EQ(labels().size(), 1u);
}

TEST_F(Annotating, AHeldKeyLabelsWhileTheTakePlays) {
  ticker().seek(2);
  ticker().toggle();
  turn();
  QTest::keyPress(&timeline(), Qt::Key_1);
  const double from = ticker().playback().cursor_s;
  until([from] { return ticker().playback().cursor_s > from + 0.4; });
  EXPECT_FALSE(timeline().tiers().running.empty());
  let_go_of_the_label_from(from);
  ASSERT_FALSE(labels().empty());
  EXPECT_TRUE(on_frame(labels()[0].start_s));
  EXPECT_TRUE(timeline().tiers().running.empty());
}

/// As a keyboard reports a key that is held. @param flagged  whether the window system says what it is
void repeat(QWidget& to, bool flagged) {
  QKeyEvent up(QEvent::KeyRelease, Qt::Key_1, {}, "1", flagged);
  QApplication::sendEvent(&to, &up);
  QKeyEvent may_be_kept(QEvent::ShortcutOverride, Qt::Key_1, {}, "1", flagged);
  may_be_kept.ignore();
  QApplication::sendEvent(&to, &may_be_kept);
  QKeyEvent down(QEvent::KeyPress, Qt::Key_1, {}, "1", flagged);
  QApplication::sendEvent(&to, &down);
}

/// A busy machine reported the repetition as releases and presses, which drew three labels.
TEST_F(Annotating, AHeldKeyDrawsOneLabelHoweverTheKeyboardRepeatsIt) {
  ticker().seek(2);
  ticker().toggle();
  turn();
  const auto play_on = [] {
    const double here = ticker().playback().cursor_s;
    ASSERT_TRUE(until([here] { return ticker().playback().cursor_s > here + 0.1; }));
  };
  QTest::keyPress(&timeline(), Qt::Key_1);
  const double from = ticker().playback().cursor_s;
  for (const bool flagged : {true, false, false, true}) {
    play_on();
    repeat(timeline(), flagged);
  }
  play_on();
  bool pressed = false;
  QTest::keyRelease(&timeline(), Qt::Key_1);
  QTimer::singleShot(0, &timeline(), [&pressed] {
    QTest::keyPress(&timeline(), Qt::Key_1);
    pressed = true;
  });
  ASSERT_TRUE(until([&pressed] { return pressed; })) << "in another turn of the window";
  play_on();
  EXPECT_TRUE(labels().empty());
  let_go_of_the_label_from(from);
}

/// After a click into the scene a digit turned the camera and labelled nothing.
TEST_F(Annotating, ValueKeysWorkWhereverTheFocusIsButInAField) {
  widgets::SceneView& scene = window().scene();
  QWidget* view = nullptr;
  for (QWidget* child : scene.findChildren<QWidget*>())
    if (!view && child->focusPolicy() == Qt::StrongFocus && child->isVisible()) view = child;
  ASSERT_TRUE(view);
  QTreeView list(&window());
  list.show();
  double at_s = 1;
  for (QWidget* place : {view, static_cast<QWidget*>(&list)}) {
    empty();
    ticker().seek(at_s += 1);
    place->setFocus(Qt::MouseFocusReason);
    turn();
    QTest::keyClick(place, Qt::Key_2);
    turn();
    ASSERT_EQ(labels().size(), 1u) << place->metaObject()->className();
    EXPECT_EQ(labels()[0].value, "two");
    EXPECT_NEAR(labels()[0].start_s, at_s, 0.05);
  }
  QLineEdit field(&window());
  field.show();
  field.setFocus();
  QTest::keyClick(&field, Qt::Key_1);
  turn();
  EXPECT_EQ(field.text(), "1");
  EXPECT_EQ(labels().size(), 1u);
  EXPECT_EQ(labels()[0].value, "two");
}

TEST_F(Annotating, TappingEndsTheLastAndBeginsTheNext) {
  QAction* taps = action("Tap mode: each key starts the next label");
  ASSERT_TRUE(taps);
  taps->trigger();
  ticker().seek(2);
  ticker().toggle();
  turn();
  key(Qt::Key_1);
  double here = ticker().playback().cursor_s;
  until([here] { return ticker().playback().cursor_s > here + 0.3; });
  key(Qt::Key_2);
  here = ticker().playback().cursor_s;
  until([here] { return ticker().playback().cursor_s > here + 0.3; });
  ticker().pause();
  until([] { return labels().size() == 2; });
  taps->trigger();
  ASSERT_EQ(labels().size(), 2u);
  EXPECT_NEAR(labels()[0].end_s, labels()[1].start_s, 1e-9);
  EXPECT_EQ(labels()[1].value, "two");
}

TEST_F(Annotating, ALoopThatStartsOverEndsWhatIsHeld) {
  ticker().setRange(2, 2.5);
  ticker().setLoop(true);
  ticker().seek(2.2);
  ticker().toggle();
  turn();
  QTest::keyPress(&timeline(), Qt::Key_1);
  until([] { return !labels().empty(); });
  QTest::keyRelease(&timeline(), Qt::Key_1);
  ticker().pause();
  ASSERT_EQ(labels().size(), 1u);
  EXPECT_NEAR(labels()[0].end_s, 2.5, 0.03);
}

}  // namespace
}  // namespace abrazo::app::value_keys_test
