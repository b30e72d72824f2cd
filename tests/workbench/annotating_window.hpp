#pragma once

#include <QLineEdit>
#include <cmath>

#include "app/workbench/labels/annotation_desk.hpp"
#include "tests/workbench/demo_window.hpp"
#include "widgets/annotation/value_picker.hpp"
#include "widgets/timeline/timeline_view.hpp"

namespace abrazo::app::annotating_window {

using widgets::TimelineView;
using widgets::ValuePicker;

/// The first take of the demo is annotated, without any label; the timeline has the focus.
class Annotating : public DemoWindow {
 protected:
  static void SetUpTestSuite() { showDemo({1500, 950}); }
  void SetUp() override {
    ASSERT_TRUE(until([] { return ticker().shown() != nullptr; }, 120'000)) << "the demo did not start";
    if (auto* picker = open_picker()) QTest::keyClick(picker->findChild<QLineEdit*>(), Qt::Key_Escape);
    desk().showSubject(take());
    empty();
    window().document().setConflict(Conflict::Replace);
    ticker().setRange(0, 0);
    ticker().setLoop(false);
    ticker().setSpeed(1);
    ticker().seek(1);
    DemoWindow::SetUp();
    timeline().showAll();
    timeline().setFocus(Qt::OtherFocusReason);
    turn();
  }

  static AnnotationDesk& desk() { return *window().findChild<AnnotationDesk*>(); }
  static TimelineView& timeline() { return window().timeline(); }
  static const MotionLibrary& library() { return *window().session()->material().library; }
  static std::string take() { return library().takes().front().name; }
  static const AnnotationTier& tier(TierKind kind = TierKind::Move) {
    return *window().document().annotations().first_of(kind);
  }
  static const std::vector<Annotation>& labels(TierKind kind = TierKind::Move) {
    return tier(kind).annotations;
  }
  /// No label in any tier; moves "one" and "two" have the keys 1 and 2, and are active.
  static void empty() {
    Annotations next = window().document().annotations();
    const auto tiers = next.tiers();
    for (const AnnotationTier& each : tiers)
      for (const Annotation& label : each.annotations) ASSERT_TRUE(next.remove(label.id));
    const int moves = next.first_of(TierKind::Move)->id;
    ASSERT_TRUE(next.set_vocabulary(moves, {{"one", "", {}, '1'}, {"two", "", {}, '2'}}));
    window().document().changeAnnotations(next, "empty");
    window().document().chooseTier(moves);
    window().document().selectLabel(0);
  }
  static int add(double from_s, double to_s, const std::string& value) {
    Annotations next = window().document().annotations();
    const auto id = next.draw(tier().id, from_s, to_s, value, Conflict::Replace, desk().range());
    EXPECT_TRUE(id);
    window().document().changeAnnotations(next, "draw");
    return *id;
  }
  static const Annotation& label(int id) { return *window().document().annotations().find(id); }

  static QPoint at(double time_s, int tier) {
    return {static_cast<int>(std::lround(timeline().axis().x(time_s))),
            static_cast<int>(timeline().lanes().top_of_tier(tier) + 13)};
  }
  static void drag(double from_s, double to_s, Qt::KeyboardModifiers held = {}) {
    const int id = tier().id;
    QTest::mousePress(&timeline(), Qt::LeftButton, held, at(from_s, id));
    for (int step = 1; step <= 4; ++step) {
      const QPoint place = at(from_s + (to_s - from_s) * step / 4, id);
      QMouseEvent move(QEvent::MouseMove, place, timeline().mapToGlobal(place), Qt::NoButton, Qt::LeftButton,
                       held);
      QApplication::sendEvent(&timeline(), &move);
    }
    QTest::mouseRelease(&timeline(), Qt::LeftButton, held, at(to_s, id));
    turn();
  }
  /// Its edges can be dragged then.
  static void select(int id) {
    window().document().selectLabel(id);
    turn();
  }
  static ValuePicker* open_picker() {
    auto* picker = window().findChild<ValuePicker*>();
    return picker && picker->isVisible() ? picker : nullptr;
  }
  static void type(int key) {
    ASSERT_TRUE(open_picker());
    QTest::keyClick(open_picker()->findChild<QLineEdit*>(), static_cast<Qt::Key>(key));
    turn();
  }
  /// The key of a value, after which nothing else is typed.
  static void choose(int key) {
    type(key);
    EXPECT_TRUE(until([] { return !open_picker(); }));
  }
  static void key(int key, Qt::KeyboardModifiers held = {}) {
    QTest::keyClick(&timeline(), static_cast<Qt::Key>(key), held);
    turn();
  }
  static double frame_s() { return 1 / desk().fps(); }
  static bool on_frame(double time_s) {
    return std::abs(time_s * desk().fps() - std::round(time_s * desk().fps())) < 1e-6;
  }
  /// Releases the key of a label that was begun then: it is the only one, and ends now.
  static void let_go_of_the_label_from(double from_s) {
    QTest::keyRelease(&timeline(), Qt::Key_1);
    const double to_s = ticker().playback().cursor_s;
    until([] { return !labels().empty(); });
    ticker().pause();
    ASSERT_EQ(labels().size(), 1u);
    EXPECT_NEAR(labels()[0].start_s, from_s, 0.05);
    EXPECT_NEAR(labels()[0].end_s, to_s, 0.05);
  }
};

}  // namespace abrazo::app::annotating_window
