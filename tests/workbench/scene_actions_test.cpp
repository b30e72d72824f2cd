// The keys of the scene, and the one selection of all views, in the whole window.
#include <gtest/gtest.h>

#include <QApplication>
#include <QElapsedTimer>
#include <QTest>
#include <QToolButton>

#include "core/motion/body/joint_set.hpp"
#include "tests/workbench/demo_window.hpp"
#include "widgets/candidates/candidate_list.hpp"
#include "widgets/candidates/candidate_table.hpp"
#include "widgets/common/selection_model.hpp"
#include "widgets/plots/plot_panel.hpp"
#include "widgets/scene/panel/scalar_legend.hpp"
#include "widgets/scene/panel/scene_tree.hpp"
#include "widgets/scene/values/scene_memory.hpp"
#include "widgets/scene/view/scene_view.hpp"

namespace abrazo::app::scene_actions_test {
namespace {

using widgets::ScenePart;
using widgets::Selection;

/// One window on the generated dance, parked.
class SceneKeys : public DemoWindow {
 protected:
  static void SetUpTestSuite() {
    showDemo({1280, 720}, 31);
    ticker().pause();
  }
  void SetUp() override {
    ASSERT_TRUE(window().ticker().shown()) << "the demo did not start";
    DemoWindow::SetUp();
    window().selection().select({});
    scene().setOptions({});
    scene().setVisibility(widgets::default_visibility);
    turn();
  }
  static widgets::SceneView& scene() { return window().scene(); }
  static const Selection& selection() { return window().selection().selection(); }
  static bool shows(ScenePart part) { return scene().visibility()[static_cast<std::size_t>(part)]; }
  static widgets::CandidateList& candidates() {
    return *window().candidates().findChild<widgets::CandidateList*>();
  }
};

TEST_F(SceneKeys, SwitchPartsAndWaysOfShowing) {
  press(Qt::Key_T);
  EXPECT_TRUE(shows(ScenePart::Tetrahedra));
  press(Qt::Key_T);
  EXPECT_FALSE(shows(ScenePart::Tetrahedra));
  press(Qt::Key_5);
  EXPECT_TRUE(scene().options().is_parallel);
  press(Qt::Key_C);
  EXPECT_TRUE(scene().options().cuts);
  press(Qt::Key_C, Qt::ShiftModifier);
  EXPECT_TRUE(scene().options().cut_in_world);
  const double azimuth = scene().options().cut_azimuth_rad;
  press(Qt::Key_Right, Qt::AltModifier);
  EXPECT_GT(scene().options().cut_azimuth_rad, azimuth);
  press(Qt::Key_Up, Qt::AltModifier);
  EXPECT_GT(scene().options().cut_elevation_rad, 0);
  press(Qt::Key_PageUp, Qt::AltModifier);
  EXPECT_NEAR(scene().options().cut_m, 0.05, 1e-12);
  press(Qt::Key_R);
  EXPECT_TRUE(scene().options().shows_reference_beside);
}

TEST_F(SceneKeys, AltAndADigitShowOrHideARowOfTheTree) {
  press(Qt::Key_1, Qt::AltModifier);
  EXPECT_FALSE(shows(ScenePart::User));
  press(Qt::Key_2, Qt::AltModifier);
  EXPECT_FALSE(shows(ScenePart::Leader));
  EXPECT_FALSE(shows(ScenePart::Follower));
  press(Qt::Key_9, Qt::AltModifier);
  EXPECT_TRUE(shows(ScenePart::Tetrahedra));
}

TEST_F(SceneKeys, DigitsLookFromASideAndWithCtrlFromTheOpposite) {
  const auto sees = [](double azimuth, double elevation) {
    return until([=] {
      const auto& camera = scene().camera();
      return std::abs(std::remainder(camera.azimuth_rad - azimuth, 6.283185307)) < 1e-6 &&
             std::abs(camera.elevation_rad - elevation) < 1e-6;
    });
  };
  press(Qt::Key_1);
  EXPECT_TRUE(sees(0, 0.05));
  press(Qt::Key_1, Qt::ControlModifier);
  EXPECT_TRUE(sees(3.14159265, 0.05));
  press(Qt::Key_3, Qt::KeypadModifier);
  EXPECT_TRUE(sees(1.57079633, 0.05)) << "those of the keypad, too";
  press(Qt::Key_7);
  EXPECT_TRUE(sees(0, 1.57079633));
  press(Qt::Key_9);
  EXPECT_TRUE(sees(0.78539816, 0.61547971));
  press(Qt::Key_Z, Qt::AltModifier);
  EXPECT_TRUE(sees(0, 1.57079633)) << "the view before";
  press(Qt::Key_Z, Qt::AltModifier | Qt::ShiftModifier);
  EXPECT_TRUE(sees(0.78539816, 0.61547971));
  press(Qt::Key_0);
  EXPECT_FALSE(window().undoStack().canUndo()) << "looking is no edit";
}

TEST_F(SceneKeys, BackquoteGoesToTheOtherCharacterAndEscapeToNothing) {
  press(Qt::Key_QuoteLeft);
  EXPECT_EQ(selection(), Selection::joint(0));
  press(Qt::Key_QuoteLeft);
  EXPECT_EQ(selection(), Selection::joint(joint_count));
  QWidget* surface = scene().childAt(scene().rect().center());
  surface->setFocus();
  QTest::keyClick(surface, Qt::Key_Escape);
  turn();
  EXPECT_EQ(selection(), Selection());
}

TEST_F(SceneKeys, EscapeClosesTheFilterAndKeepsTheSelection) {
  press(Qt::Key_QuoteLeft);
  QToolButton* filter = nullptr;
  for (QToolButton* button : scene().findChildren<QToolButton*>())
    if (button->text().startsWith("Filter")) filter = button;
  ASSERT_TRUE(filter);
  filter->click();
  turn();
  QWidget* popup = QApplication::activePopupWidget();
  ASSERT_TRUE(popup);
  const QWidget* legend = scene().findChild<widgets::ScalarLegend*>();
  const QRect shown(popup->mapToGlobal({0, 0}), popup->size());
  EXPECT_FALSE(shown.intersects({legend->mapToGlobal({0, 0}), legend->size()}));
  EXPECT_FALSE(shown.intersects({window().candidates().mapToGlobal({0, 0}), window().candidates().size()}));
  QTest::keyClick(popup, Qt::Key_Escape);
  turn();
  EXPECT_FALSE(popup->isVisible());
  EXPECT_EQ(selection(), Selection::joint(0));
}

TEST_F(SceneKeys, XIsolatesHHidesAltHShowsFFrames) {
  window().selection().select(Selection::joint(joints::Head));
  press(Qt::Key_X);
  EXPECT_TRUE(scene().options().isolates);
  press(Qt::Key_H);
  EXPECT_EQ(scene().hidden().size(), 1U);
  EXPECT_EQ(selection(), Selection());
  press(Qt::Key_H, Qt::AltModifier);
  EXPECT_TRUE(scene().hidden().empty());
  EXPECT_FALSE(scene().options().isolates);
  window().selection().select(Selection::joint(joints::Head));
  press(Qt::Key_F);
  const Vec3 head = window().ticker().shown()->result.result.row(joints::Head);
  EXPECT_TRUE(until([&] { return (scene().camera().target - head).norm() < 1e-6; }));
  press(Qt::Key_0);
}

TEST_F(SceneKeys, CommaAndPeriodStepThroughTheMorph) {
  const int last = scene().morphStep();
  ASSERT_GT(last, 2);
  press(Qt::Key_Comma);
  press(Qt::Key_Comma);
  EXPECT_EQ(scene().morphStep(), last - 2);
  press(Qt::Key_Period);
  press(Qt::Key_Period);
  EXPECT_EQ(scene().morphStep(), last);
}

/// What each view has as its selection.
void expect_everywhere(MainWindow& window, const Selection& wanted, const char* setter) {
  EXPECT_EQ(window.selection().selection(), wanted) << setter;
  EXPECT_EQ(window.scene().selection(), wanted) << setter;
  EXPECT_EQ(window.plots().selection(), wanted) << setter;
  EXPECT_EQ(window.sceneTree().list().selection(), wanted) << setter;
  const auto* row = window.candidates().findChild<widgets::CandidateList*>()->current();
  EXPECT_EQ(row ? row->pair : -1, wanted.kind == widgets::SelectionKind::Candidate ? wanted.pair : -1)
      << setter;
}

TEST_F(SceneKeys, AreAboutOneSelectionThatEveryViewSetsAndShows) {
  emit scene().selectionRequested(Selection::edge({3, 40}));
  expect_everywhere(window(), Selection::edge({3, 40}), "scene");
  EXPECT_GE(window().plots().selectionPane(), 0);

  widgets::SceneTreeList& tree = window().sceneTree().list();
  tree.setOpen(0, true);
  QTest::mouseClick(&tree, Qt::LeftButton, {}, {60, 22 * 3 + 11});
  expect_everywhere(window(), Selection::joint(0), "tree");

  QTest::mouseClick(&candidates(), Qt::LeftButton, {}, {80, 24 + 11});
  ASSERT_TRUE(candidates().current());
  expect_everywhere(window(), Selection::candidate(candidates().current()->pair), "candidates");
  EXPECT_EQ(window().plots().selectionPane(), -1);

  window().selection().select(Selection::joint(5));
  window().plots().removePane(window().plots().selectionPane());
  expect_everywhere(window(), {}, "plots");
}

TEST_F(SceneKeys, RememberHowTheSceneIsSetUp) {
  widgets::SceneOptions options;
  options.map = widgets::ColourMap::Cividis;
  scene().setOptions(options);
  press(Qt::Key_T);
  EXPECT_TRUE(until([] {
    const auto memory = widgets::scene_memory_of(remembered().scene());
    return memory.options.map == widgets::ColourMap::Cividis &&
           memory.visibility[static_cast<std::size_t>(ScenePart::Tetrahedra)];
  }));
  MainWindow next(remembered());
  add_all_actions(next);
  EXPECT_EQ(next.scene().options().map, widgets::ColourMap::Cividis);
  EXPECT_TRUE(next.scene().visibility()[static_cast<std::size_t>(ScenePart::Tetrahedra)]);
}

}  // namespace
}  // namespace abrazo::app::scene_actions_test
