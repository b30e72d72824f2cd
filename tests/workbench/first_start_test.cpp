// What a person sees who starts the program for the first time, in two sizes of the window.
#include <QAbstractButton>
#include <QAbstractSpinBox>
#include <QComboBox>
#include <QHeaderView>
#include <QLineEdit>
#include <QMenuBar>
#include <QSplitterHandle>
#include <QTabBar>
#include <QTableWidget>

#include "app/workbench/document/live_session.hpp"
#include "app/workbench/labels/annotation_desk.hpp"
#include "app/workbench/shell/layouts.hpp"
#include "app/workbench/shell/panel_area.hpp"
#include "app/workbench/shell/work_split.hpp"
#include "tests/workbench/demo_window.hpp"
#include "widgets/annotation/annotation_panel.hpp"
#include "widgets/candidates/candidate_list.hpp"
#include "widgets/candidates/candidate_table.hpp"
#include "widgets/common/selection_model.hpp"
#include "widgets/common/value_slider.hpp"
#include "widgets/scene/panel/scalar_legend.hpp"
#include "widgets/scene/values/picture_projection.hpp"
#include "widgets/settings/setting_row.hpp"
#include "widgets/settings/settings_panel.hpp"
#include "widgets/timeline/timeline_view.hpp"
#include "widgets/timeline/whole_lanes.hpp"

namespace abrazo::app::first_start_test {
namespace {

/// A home folder of its own, the generated dance, and the preset that the window starts with.
class FirstStart : public DemoWindow {
 protected:
  void SetUp() override {}
  void TearDown() override { TearDownTestSuite(); }
  static void start(QSize size) {
    showDemo(size);
    QTest::qWait(200);  // the candidates' foot has its lines, and room was made for them
    ASSERT_EQ(window().size(), size);
  }

  /// Of which nothing is hidden.
  static int settings_in_view() {
    int rows = 0;
    for (const auto* row : window().settings().findChildren<widgets::SettingRow*>())
      rows += row->visibleRegion().boundingRect().height() == row->height();
    return rows;
  }
  static int candidates_in_view() {
    const auto* list = window().candidates().findChild<widgets::CandidateList*>();
    return list->visibleRegion().boundingRect().height() / widgets::CandidateList::row_height;
  }
  static bool all_lanes_in_view() {
    return window().timeline().height() >= window().timeline().sizeHint().height();
  }
  /// The number of a slider is one with it.
  static bool of_slider(const QWidget& field) {
    return field.parentWidget()->findChild<widgets::ValueSlider*>() != nullptr;
  }
  /// What can be clicked and is in view: buttons, choices, sliders, fields, tabs and menus; a list is one.
  static QStringList clickable() {
    QStringList names;
    for (const QAction* menu : window().menuBar()->actions())
      if (menu->isVisible()) names << "menu " + menu->text();
    for (const QWidget* each : window().findChildren<QWidget*>()) {
      if (each->window() != &window() || each->visibleRegion().isEmpty()) continue;
      const QString name = QString(each->metaObject()->className()) + " " + each->accessibleName() + " " +
                           each->toolTip().section('\n', 0, 0).left(30);
      if (const auto* tabs = qobject_cast<const QTabBar*>(each))
        for (int tab = 0; tab < tabs->count(); ++tab) names << "tab " + tabs->tabText(tab);
      const bool is_part = qobject_cast<const QComboBox*>(each->parentWidget()) ||
                           qobject_cast<const QAbstractSpinBox*>(each->parentWidget()) ||
                           qobject_cast<const QTabBar*>(each->parentWidget()) ||
                           (qobject_cast<const QLineEdit*>(each) && of_slider(*each));
      const bool is_one =
          qobject_cast<const QAbstractButton*>(each) || qobject_cast<const QComboBox*>(each) ||
          qobject_cast<const QLineEdit*>(each) || qobject_cast<const QAbstractSpinBox*>(each) ||
          qobject_cast<const widgets::ValueSlider*>(each) ||
          (qobject_cast<const QAbstractItemView*>(each) && !qobject_cast<const QHeaderView*>(each));
      if (is_one && !is_part) names << name;
    }
    return names;
  }
  static WorkSplit& split() { return *window().findChild<WorkSplit*>(); }
  static void drag_border(int by) {
    QSplitterHandle* border = split().handle(1);
    const QPoint from = border->rect().center();
    QTest::mousePress(border, Qt::LeftButton, {}, from);
    QMouseEvent move(QEvent::MouseMove, from + QPoint(0, by), border->mapToGlobal(from + QPoint(0, by)),
                     Qt::LeftButton, Qt::LeftButton, {});
    QApplication::sendEvent(border, &move);
    QTest::mouseRelease(border, Qt::LeftButton, {}, border->rect().center());
    turn();
  }
};

TEST_F(FirstStart, FiveSettingsAndAllLanesAreInViewAt1600x1000) {
  start({1600, 1000});
  EXPECT_GE(settings_in_view(), 5);
  EXPECT_GE(candidates_in_view(), 8);
  EXPECT_TRUE(all_lanes_in_view());
}

/// There were 95.
TEST_F(FirstStart, EachTaskOffersWhatItNeeds) {
  showWindow({1600, 1000}, false);  // a clip is what one starts with
  window().openDemo();
  ASSERT_TRUE(until([] { return ticker().shown() && ticker().shown()->index > 30; }));
  EXPECT_LE(window().menuBar()->actions().size(), 9);
  for (const QString& task : Layouts::builtIn()) {
    ASSERT_TRUE(window().findChild<Layouts*>()->choose(task));
    QTest::qWait(300);
    const QStringList names = clickable();
    EXPECT_LE(names.size(), 45) << task.toStdString() << "\n" << names.join("\n").toStdString();
  }
}

TEST_F(FirstStart, FiveSettingsAreInViewAt1280x720) {
  start({1280, 720});
  EXPECT_GE(settings_in_view(), 5);
  EXPECT_GE(candidates_in_view(), 3);
}

/// After the labels of a take, one setting was left in view and the scene was half as high.
TEST_F(FirstStart, TheRoomForLabelsGoesWithTheirLanes) {
  start({1280, 720});
  const int before = split().sizes().back();
  auto& desk = *window().findChild<AnnotationDesk*>();
  desk.showSubject(window().session()->material().library->takes().front().name);
  ASSERT_TRUE(until([&] { return split().sizes().back() > before; }));
  EXPECT_FALSE(split().chosenHeight()) << "nobody moved the border";
  desk.showSubject({});
  EXPECT_TRUE(window().document().subject().empty());
  window().panels().want("annotation", false);
  EXPECT_TRUE(window().timeline().lanes().tiers().empty());
  EXPECT_TRUE(until([&] { return split().sizes().back() == before; }, 10'000)) << split().sizes().back();
  EXPECT_GE(settings_in_view(), 5);
}

/// Two lanes were in view, and the panels needed all the rest: the border could not be moved.
TEST_F(FirstStart, ThreeLanesAreInViewAt1100x640AndTheirBorderCanBeDragged) {
  start({1100, 640});
  const auto lanes_in_view = [] {
    const widgets::TimelineLanes& lanes = window().timeline().lanes();
    std::size_t count = 0;
    while (count < 8 && widgets::first_lanes_px(lanes, count + 1) <= window().timeline().height()) ++count;
    return count;
  };
  EXPECT_GE(lanes_in_view(), 3U);
  for (const bool with_takes : {false, true}) {
    window().panels().want("recording", with_takes);
    QTest::qWait(80);
    EXPECT_GE(lanes_in_view(), 3U);
    const int before = split().sizes().back();
    drag_border(-20);
    EXPECT_GT(split().sizes().back(), before) << (with_takes ? "with the takes" : "");
    drag_border(20);
    split().choose({});
  }
}

/// Only Source and Markers were in view, and the tier that is annotated was not.
TEST_F(FirstStart, TheTierThatIsAnnotatedIsInViewInASmallWindow) {
  start({1600, 1000});
  window().findChild<AnnotationDesk*>()->showSubject(
      window().session()->material().library->takes().front().name);
  const AnnotationTier& move = *window().document().annotations().first_of(TierKind::Move);
  window().document().chooseTier(move.id);
  const widgets::TimelineLanes& lanes = window().timeline().lanes();
  for (const QSize size : {QSize(1100, 640), QSize(640, 400), QSize(1100, 640)}) {
    window().resize(size);
    QTest::qWait(80);
    EXPECT_GE(lanes.top_of_tier(move.id), lanes.top_px()) << size.width();
    EXPECT_LE(lanes.top_of_tier(move.id) + widgets::TimelineLanes::tier_px, lanes.bottom_px())
        << size.width();
  }
  const AnnotationTier& note = *window().document().annotations().first_of(TierKind::Note);
  window().document().chooseTier(note.id);
  EXPECT_LE(lanes.top_of_tier(note.id) + widgets::TimelineLanes::tier_px, lanes.bottom_px());
}

/// Source and Moves were scrolled away, and stayed so when the panel was closed.
TEST_F(FirstStart, EmptyLanesOfAnnotationDoNotScrollThoseOfTheSessionAway) {
  start({1100, 640});
  auto& desk = *window().findChild<AnnotationDesk*>();
  const widgets::TimelineLanes& lanes = window().timeline().lanes();
  for (const QSize size : {QSize(1100, 640), QSize(640, 400)}) {
    window().resize(size);
    for (const bool open : {true, false}) {
      window().panels().want("annotation", open);
      QTest::qWait(80);
      EXPECT_EQ(lanes.tiers().empty(), !open);
      EXPECT_EQ(lanes.scroll_px(), 0) << size.width() << (open ? " open" : " closed");
    }
  }
  desk.showSubject(window().session()->material().library->takes().front().name);
  window().document().chooseTier(window().document().annotations().first_of(TierKind::Note)->id);
  QTest::qWait(80);
  ASSERT_GT(lanes.scroll_px(), 0) << "a take has its active tier in view";
  desk.showSubject({});
  QTest::qWait(80);
  EXPECT_EQ(lanes.scroll_px(), 0) << "back in the session";
  Annotations next = window().document().annotations();
  const int move = next.first_of(TierKind::Move)->id;
  ASSERT_TRUE(next.draw(move, 0, 0.2, "turn", Conflict::Replace, desk.range()));
  window().document().changeAnnotations(next, "draw turn");
  EXPECT_LE(lanes.top_of_tier(move) + widgets::TimelineLanes::tier_px, lanes.bottom_px())
      << "what was annotated is in view";
}

/// Below the tiers no label was in view at 1280x720, while the settings had most of the column.
TEST_F(FirstStart, ALabelIsInViewWhileATakeIsAnnotatedAndTheSettingsGetTheirHeightBack) {
  start({1280, 720});
  auto& desk = *window().findChild<AnnotationDesk*>();
  desk.showSubject(window().session()->material().library->takes().front().name);
  QTest::qWait(80);
  const QTableWidget& table = window().findChild<widgets::AnnotationPanel*>()->table();
  EXPECT_GE(table.viewport()->visibleRegion().boundingRect().height(), table.rowHeight(0));
  const int lent = window().settings().height();
  desk.showSubject({});
  window().panels().want("annotation", false);
  QTest::qWait(80);
  EXPECT_GT(window().settings().height(), lent);
}

/// The legend lay over the heads while the welcome page was beside the scene.
TEST_F(FirstStart, ThePairIsBetweenTheControlsOfTheSceneBesideTheWelcomePage) {
  start({1280, 720});
  action("Welcome")->trigger();
  QTest::qWait(200);
  ASSERT_LT(window().scene().width(), 400);
  window().scene().resetView();
  QTest::qWait(300);
  const auto* legend = window().scene().findChild<widgets::ScalarLegend*>();
  const widgets::PictureProjection picture(window().scene().camera(), window().scene().width(),
                                           window().scene().height());
  const PairPose pair = ticker().shown()->result.result;
  for (int vertex = 0; vertex < pair_vertex_count; ++vertex) {
    const auto place = picture.project(pair.row(vertex).transpose());
    ASSERT_TRUE(place) << vertex;
    EXPECT_GT(place->y, legend->geometry().bottom()) << vertex;
  }
}

/// It was cut off at the left.
TEST_F(FirstStart, TheCardOfACandidateIsWholeBesideTheWelcomePage) {
  start({1280, 720});
  action("Welcome")->trigger();
  QTest::qWait(200);
  ASSERT_LT(window().scene().width(), 400);
  ticker().pause();
  turn();
  const FrameResult& result = ticker().shown()->result;
  window().selection().select(widgets::Selection::candidate(result.candidates.front().pair));
  turn();
  const auto* card = window().scene().findChild<QWidget*>("selected");
  ASSERT_TRUE(card->isVisible());
  EXPECT_TRUE(window().scene().rect().contains(card->geometry())) << card->x();
  EXPECT_FALSE(card->geometry().intersects(window().scene().findChild<widgets::ScalarLegend*>()->geometry()));
}

/// At 1280x720 three settings were, because the tabs of the candidates were not counted and every lane of the
/// timeline had room.
TEST_F(FirstStart, NoLaneOfTheTimelineIsCutInASmallWindow) {
  for (const QSize size : {QSize(1280, 720), QSize(1280, 760), QSize(1366, 768)}) {
    start(size);
    const widgets::TimelineView& timeline = window().timeline();
    EXPECT_EQ(timeline.height(),
              static_cast<int>(widgets::whole_lanes_px(timeline.lanes(), timeline.height())))
        << size.height();
  }
}

TEST_F(FirstStart, TheTimelineHasItsLanesAsSoonAsTheWindowHasRoomForThem) {
  start({1280, 720});
  window().resize(1600, 1000);
  turn();
  EXPECT_TRUE(all_lanes_in_view());
  EXPECT_GE(settings_in_view(), 5);
  window().resize(1280, 720);
  turn();
  EXPECT_GE(settings_in_view(), 5);
}

TEST_F(FirstStart, AHeightOfTheTimelineThatAPersonChoseStays) {
  start({1280, 720});
  const int before = window().timeline().height();
  drag_border(-60);  // the scene's parts and the library, which cannot give way, leave some 75
  const int chosen = window().timeline().height();
  ASSERT_NEAR(chosen, before + 60, 3) << "the settings give way to it";
  window().resize(1600, 1000);
  turn();
  EXPECT_NEAR(window().timeline().height(), chosen, 1);
  const WindowLayout layout = window().layoutOfPanels();
  window().resetLayout();
  turn();
  EXPECT_TRUE(all_lanes_in_view());
  ASSERT_TRUE(window().setLayoutOfPanels(layout));
  turn();
  EXPECT_NEAR(window().timeline().height(), chosen, 1) << "also in a saved arrangement";
}

}  // namespace
}  // namespace abrazo::app::first_start_test
