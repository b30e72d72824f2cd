// The keys of the scene, and the one selection of all views, in the whole window.
#include <gtest/gtest.h>

#include <QApplication>
#include <QElapsedTimer>
#include <QLineEdit>
#include <QLineF>
#include <QMouseEvent>
#include <QPushButton>
#include <QTemporaryDir>
#include <QTest>
#include <QToolButton>

#include "core/base/atomic_file.hpp"
#include "core/motion/body/joint_set.hpp"
#include "tests/support/humanoid_rig.hpp"
#include "tests/workbench/demo_window.hpp"
#include "widgets/candidates/candidate_list.hpp"
#include "widgets/candidates/candidate_table.hpp"
#include "widgets/common/entry_frame.hpp"
#include "widgets/common/message_bar.hpp"
#include "widgets/common/selection_model.hpp"
#include "widgets/plots/plot_panel.hpp"
#include "widgets/scene/panel/character_rows.hpp"
#include "widgets/scene/panel/scalar_legend.hpp"
#include "widgets/scene/panel/scene_tree.hpp"
#include "widgets/scene/values/cut_handles.hpp"
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
  EXPECT_GT(std::remainder(scene().options().cut_azimuth_rad - azimuth, 6.283185307), 0);
  press(Qt::Key_Up, Qt::AltModifier);
  EXPECT_GT(scene().options().cut_elevation_rad, 0);
  press(Qt::Key_PageUp, Qt::AltModifier);
  EXPECT_NEAR(scene().options().cut_m, 0.05, 1e-12);
  press(Qt::Key_R);
  EXPECT_TRUE(scene().options().shows_reference_beside);
}

/// A new plane of the world with its handles.
class CuttingPlane : public SceneKeys {
 protected:
  void SetUp() override {
    SceneKeys::SetUp();
    press(Qt::Key_C);
    press(Qt::Key_C, Qt::ShiftModifier);
    window().undoStack().clear();
    m_before = scene().options();
  }
  static QWidget& surface() { return *scene().childAt(scene().rect().center()); }
  static widgets::CutHandles handles() {
    return {scene().options().plane(), scene().camera(), static_cast<double>(surface().width()),
            static_cast<double>(surface().height())};
  }
  static QPointF knob() { return {handles().knob->x, handles().knob->y}; }
  /// Of the shaft, where it is held to move the plane.
  static QPointF shaft() { return 0.4 * QPointF(handles().middle->x, handles().middle->y) + 0.6 * knob(); }
  static void send(QEvent::Type type, QPointF place, Qt::MouseButton button) {
    QMouseEvent event(type, place, surface().mapToGlobal(place.toPoint()), button,
                      type == QEvent::MouseButtonRelease ? Qt::NoButton : Qt::LeftButton, {});
    QApplication::sendEvent(&surface(), &event);
  }
  static void take(QPointF from, QPointF to) {
    surface().setFocus();
    send(QEvent::MouseButtonPress, from, Qt::LeftButton);
    for (const double share : {0.25, 0.5, 0.75, 1.0})
      send(QEvent::MouseMove, from + share * (to - from), Qt::NoButton);
  }
  static void letGo(QPointF place) {
    send(QEvent::MouseButtonRelease, place, Qt::LeftButton);
    turn();
  }
  widgets::SceneOptions m_before;
};

TEST_F(CuttingPlane, IsDraggedAlongItsNormalByItsShaftAndUndoTakesItBack) {
  const widgets::OrbitCamera camera = scene().camera();
  const QPointF from = shaft(), along = knob() - from;
  take(from, from + along);
  EXPECT_GT(scene().options().cut_m, m_before.cut_m + 0.05);
  EXPECT_EQ(scene().options().cut_azimuth_rad, m_before.cut_azimuth_rad);
  letGo(from + along);
  EXPECT_EQ(scene().camera(), camera) << "the drag is the plane's, not the camera's";
  EXPECT_FALSE(selection()) << "nor a click";
  EXPECT_NEAR(QLineF(shaft(), from + along).length(), 0, 3) << "what was held stays under the pointer";
  EXPECT_EQ(window().undoStack().count(), 1) << "one drag is one step";
  EXPECT_EQ(window().undoStack().undoText(), "move cutting plane") << "the history says which change it was";
  press(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_TRUE(scene().options().has_cut_of(m_before));
  press(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
  EXPECT_GT(scene().options().cut_m, m_before.cut_m + 0.05);
}

TEST_F(CuttingPlane, StandsUprightAndTurnedFromTheEyeWhenItIsNew) {
  const widgets::CutPlane plane = m_before.plane();
  const Vec3 to_eye = (scene().camera().position() - scene().camera().focus()).normalized();
  EXPECT_NEAR(plane.normal.y(), 0, 1e-9);
  EXPECT_LT(plane.normal.dot(to_eye), std::cos(0.5236)) << "by 30 degrees or more";
  EXPECT_GT(plane.normal.dot(to_eye), 0) << "it takes away what is nearer";
}

/// Its outline ran away from the pointer, by metres for some pixels.
TEST_F(CuttingPlane, IsMovedFinelyByItsOutlineWhereItFacesTheEye) {
  widgets::SceneOptions facing = m_before;
  facing.cut_azimuth_rad = scene().camera().azimuth_rad;
  facing.cut_elevation_rad = scene().camera().elevation_rad;
  scene().setOptions(facing);
  const widgets::CutHandles shown = handles();
  const double pixel_m =
      1 / widgets::PictureProjection(scene().camera(), surface().width(), surface().height())
              .pixels_per_metre(shown.middle->depth_m);
  const QPointF lower_edge(0.5 * (shown.outline[0]->x + shown.outline[1]->x),
                           0.5 * (shown.outline[0]->y + shown.outline[1]->y));
  const QPointF to = lower_edge + QPointF(0, 20);
  take(lower_edge, to);
  letGo(to);
  const double moved_m = scene().options().cut_m - facing.cut_m;
  EXPECT_GT(moved_m, 0.5 * 20 * pixel_m) << "downwards is nearer";
  EXPECT_LT(moved_m, 2.1 * 20 * pixel_m);
}

TEST_F(CuttingPlane, IsTurnedByItsKnobAboutItsMiddle) {
  const Vec3 middle = m_before.plane().point, normal = m_before.plane().normal;
  const QPointF from = knob(), to = from + QPointF(20, -30);
  take(from, to);
  letGo(to);
  EXPECT_NEAR(QLineF(knob(), to).length(), 0, 3) << "the knob follows the pointer";
  EXPECT_LT(scene().options().plane().normal.dot(normal), 0.99);
  EXPECT_NEAR((scene().options().plane().point - middle).norm(), 0, 1e-9);
  press(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_TRUE(scene().options().has_cut_of(m_before));
}

TEST_F(CuttingPlane, EscapeLeavesTheDragAsItWasBefore) {
  window().selection().select(Selection::joint(3));
  const QPointF from = knob();
  take(from, from + QPointF(25, 10));
  ASSERT_FALSE(scene().options().has_cut_of(m_before));
  QTest::keyClick(&surface(), Qt::Key_Escape);
  EXPECT_TRUE(scene().options().has_cut_of(m_before));
  letGo(from + QPointF(25, 10));
  EXPECT_TRUE(scene().options().has_cut_of(m_before)) << "the button is still down, the drag is over";
  EXPECT_FALSE(window().undoStack().canUndo());
  EXPECT_EQ(selection(), Selection::joint(3)) << "Escape left the drag, not the selection";
}

TEST_F(CuttingPlane, ASecondButtonDoesNotEndTheDrag) {
  const QPointF from = knob(), half = from + QPointF(10, -15), to = from + QPointF(20, -30);
  take(from, half);
  const widgets::OrbitCamera camera = scene().camera();
  send(QEvent::MouseButtonPress, half, Qt::RightButton);
  send(QEvent::MouseMove, to, Qt::NoButton);
  send(QEvent::MouseButtonRelease, to, Qt::RightButton);
  EXPECT_NEAR(QLineF(knob(), to).length(), 0, 3);
  EXPECT_EQ(scene().camera(), camera);
  EXPECT_FALSE(window().undoStack().canUndo()) << "it is still in the hand";
  letGo(to);
  EXPECT_EQ(window().undoStack().count(), 1);
}

TEST_F(CuttingPlane, SwitchingItOffIsTakenBackBeforeTheDragThatCameFirst) {
  const QPointF from = knob(), to = from + QPointF(20, -30);
  take(from, to);
  letGo(to);
  const widgets::SceneOptions dragged = scene().options();
  press(Qt::Key_C);
  ASSERT_FALSE(scene().options().cuts);
  press(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_TRUE(scene().options().has_cut_of(dragged)) << "on again, where it was";
  press(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_TRUE(scene().options().has_cut_of(m_before));
}

TEST_F(CuttingPlane, KeysThatMoveItAreTakenBackTogether) {
  for (int step = 0; step < 3; ++step) press(Qt::Key_PageUp, Qt::AltModifier);
  EXPECT_NEAR(scene().options().cut_m, m_before.cut_m + 0.15, 1e-9);
  press(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_TRUE(scene().options().has_cut_of(m_before));
}

TEST_F(CuttingPlane, IsNotInPicturesThatAreSaved) {
  const QImage with = scene().picture();
  ASSERT_TRUE(scene().findChild<QWidget*>("cut handles")->isVisible());
  QTest::mouseMove(&surface(), shaft().toPoint());
  turn();
  EXPECT_EQ(scene().picture(), with);
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

TEST_F(SceneKeys, TheFilterCoversNoPairAndEscapeClosesItAndKeepsTheSelection) {
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
  const QRect shown(popup->mapToGlobal(QPoint(0, 0)), popup->size());
  EXPECT_FALSE(shown.intersects({legend->mapToGlobal(QPoint(0, 0)), legend->size()}));
  const int third = scene().width() / 3;
  const QRect middle(scene().mapToGlobal(QPoint(third, 0)), QSize(third, scene().height()));
  EXPECT_FALSE(shown.intersects(middle)) << "the pair that is filtered stays in view";
  EXPECT_FALSE(
      shown.intersects({window().candidates().mapToGlobal(QPoint(0, 0)), window().candidates().size()}));
  QTest::keyClick(popup, Qt::Key_Escape);
  turn();
  EXPECT_FALSE(popup->isVisible());
  EXPECT_EQ(selection(), Selection::joint(0));
}

/// A message pushed the scene down: a click on a button landed on another one.
TEST_F(SceneKeys, AMessageMovesNoButtonOfTheSceneAndCoversNone) {
  const auto controls = [] {
    std::vector<QRect> found;
    for (QToolButton* chip : scene().findChildren<QToolButton*>("chip"))
      if (chip->isVisible()) found.emplace_back(chip->mapToGlobal(QPoint(0, 0)), chip->size());
    for (QWidget* legend : scene().findChildren<widgets::ScalarLegend*>())
      if (legend->isVisible()) found.emplace_back(legend->mapToGlobal(QPoint(0, 0)), legend->size());
    return found;
  };
  widgets::MessageBar& bar = window().messages();
  for (const QSize size : {QSize(640, 400), QSize(900, 600), QSize(1280, 720)}) {
    window().resize(size);
    turn();
    const std::vector<QRect> before = controls();
    const QRect of_scene = scene().geometry();
    bar.showError("take.bvh: " + QString("a joint is missing. ").repeated(4));
    turn();
    ASSERT_TRUE(bar.isVisible());
    EXPECT_EQ(scene().geometry(), of_scene) << size.width();
    EXPECT_EQ(controls(), before) << size.width();
    const QRect told(bar.mapToGlobal(QPoint(0, 0)), bar.size());
    for (const QRect& control : before) EXPECT_FALSE(told.intersects(control)) << size.width();
    EXPECT_FALSE(bar.visibleRegion().isEmpty()) << size.width();
    EXPECT_EQ(bar.visibleRegion().boundingRect(), bar.rect()) << "all of it is seen, " << size.width();
    bar.findChild<QToolButton*>()->click();
    turn();
    EXPECT_FALSE(bar.isVisible());
  }
}

/// Escape did nothing there, and neither "legend" nor "colour map" was found among the commands.
TEST_F(SceneKeys, EscapeEmptiesTheFieldThatFindsPartsAndThenLeavesIt) {
  auto* field = window().sceneTree().findChild<QLineEdit*>();
  window().selection().select(Selection::joint(0));
  field->setFocus();
  QTest::keyClicks(field, "elbow");
  QTest::keyClick(field, Qt::Key_Escape);
  EXPECT_EQ(field->text(), QString());
  EXPECT_TRUE(field->hasFocus());
  QTest::keyClick(field, Qt::Key_Escape);
  EXPECT_FALSE(field->hasFocus());
  EXPECT_EQ(selection(), Selection::joint(0)) << "it is not the Escape of the scene";
}

TEST_F(SceneKeys, TheRangeAndTheMapOfTheLegendAreCommands) {
  action("Colour map cividis")->trigger();
  EXPECT_EQ(scene().options().map, widgets::ColourMap::Cividis);
  action("Logarithmic colours")->trigger();
  EXPECT_TRUE(scene().options().is_logarithmic);
  action("Logarithmic colours")->trigger();
  action("Colour map viridis")->trigger();
  EXPECT_EQ(scene().options().map, widgets::ColourMap::Viridis);
  action("Set the range of the legend…")->trigger();
  auto* entry = window().findChild<widgets::EntryFrame*>();
  ASSERT_TRUE(entry);
  EXPECT_TRUE(entry->isVisible());
  QTest::keyClick(entry->findChild<QLineEdit*>(), Qt::Key_Escape);
}

TEST_F(SceneKeys, TheRangeOfTheLegendIsTakenBack) {
  const auto* legend = scene().findChild<widgets::ScalarLegend*>();
  const auto upper = [legend] { return legend->scale().upper; };
  const double adapted = upper();
  ASSERT_GT(adapted, 0);
  const auto type = [](const QString& range) {
    action("Set the range of the legend…")->trigger();
    auto* field = window().findChild<widgets::EntryFrame*>()->findChild<QLineEdit*>();
    field->setText(range);
    QTest::keyClick(field, Qt::Key_Return);
    turn();
  };
  QToolButton* lock = nullptr;
  for (auto* button : legend->findChildren<QToolButton*>())
    if (button->isCheckable()) lock = button;
  ASSERT_TRUE(lock);
  const auto kept = [] { return scene().memory().ranges[static_cast<std::size_t>(scene().scalar())]; };
  type("5000");
  ASSERT_TRUE(kept());
  EXPECT_EQ(kept()->upper, 5000);
  EXPECT_TRUE(lock->isChecked());
  type("7000");
  EXPECT_EQ(upper(), 7000);
  EXPECT_EQ(window().undoStack().undoText(), "set the range of colours");
  press(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(upper(), 5000);
  press(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_FALSE(kept()) << "it adapts, as before";
  EXPECT_FALSE(lock->isChecked());
  EXPECT_EQ(upper(), adapted);
  press(Qt::Key_Y, Qt::ControlModifier);
  EXPECT_EQ(upper(), 5000);
  lock->click();
  EXPECT_FALSE(kept());
  EXPECT_EQ(window().undoStack().undoText(), "adapt the range of colours");
  press(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(upper(), 5000);
  EXPECT_TRUE(lock->isChecked());
  press(Qt::Key_Z, Qt::ControlModifier);
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

TEST_F(SceneKeys, ACharacterIsWornUntilItIsTakenOff) {
  const QTemporaryDir folder;
  const std::string file = folder.filePath("ana.vrm").toStdString();
  ASSERT_TRUE(write_whole_file(file, test::skinned_rig(test::Naming::Vrm1)));
  scene().setOptions([&] {
    widgets::SceneOptions options;
    options.character_files[1] = file;
    return options;
  }());
  EXPECT_TRUE(until([] { return scene().characters()[1] != nullptr; }));
  EXPECT_EQ(scene().characters()[0], nullptr);
  auto& rows = window().sceneTree().characters();
  EXPECT_EQ(rows.findChildren<QPushButton*>()[1]->text(), "ana.vrm");
  rows.findChildren<QToolButton*>()[1]->click();
  EXPECT_EQ(scene().characters()[1], nullptr);
  EXPECT_EQ(scene().options().character_files[1], "");
}

TEST_F(SceneKeys, ACharacterThatCannotBeShownIsNamedAndLeft) {
  widgets::SceneOptions options;
  options.character_files[0] = "/no/such/place/ana.vrm";
  scene().setOptions(options);
  EXPECT_TRUE(until([] { return scene().options().character_files[0].empty(); }));
  EXPECT_TRUE(window().messages().text().contains("ana.vrm")) << window().messages().text().toStdString();
}

TEST_F(SceneKeys, RememberHowTheSceneIsDrawnAndNotWhatASessionHides) {
  widgets::SceneOptions options;
  options.map = widgets::ColourMap::Cividis;
  scene().setOptions(options);
  press(Qt::Key_2, Qt::AltModifier);
  ASSERT_FALSE(shows(ScenePart::Leader));
  EXPECT_TRUE(until([] {
    return widgets::scene_memory_of(remembered().scene()).options.map == widgets::ColourMap::Cividis;
  }));
  MainWindow next(remembered());
  add_all_actions(next);
  EXPECT_EQ(next.scene().options().map, widgets::ColourMap::Cividis);
  EXPECT_EQ(next.scene().visibility(), widgets::default_visibility);
}

}  // namespace
}  // namespace abrazo::app::scene_actions_test
