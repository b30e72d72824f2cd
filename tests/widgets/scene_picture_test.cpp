// The scene draws a known frame; looked at are colours and places, not single pixels.
#include <gtest/gtest.h>

#include <QLabel>
#include <QLineEdit>
#include <QSignalSpy>
#include <QSlider>
#include <QTest>
#include <QToolButton>
#include <QWheelEvent>
#include <functional>

#include "core/motion/body/joint_set.hpp"
#include "core/session/frames/frame_history.hpp"
#include "tests/support/libraries.hpp"
#include "tests/widgets/pictures.hpp"
#include "tests/widgets/synthetic_frames.hpp"
#include "widgets/common/entry_frame.hpp"
#include "widgets/scene/panel/morph_strip.hpp"
#include "widgets/scene/panel/scalar_legend.hpp"
#include "widgets/scene/values/picture_projection.hpp"
#include "widgets/scene/view/scene_view.hpp"

namespace abrazo::widgets::scene_picture_test {
namespace {

using test::difference;
using test::picture_of;
using test::pixels_like;
using test::pixels_of_hue;
using test::synthetic_frame;
using test::two_take_library;

const Palette& dark() {
  return palette_of(Theme::Dark);
}

/// A view that shows one frame, with only these parts.
struct Scene {
  SelectionModel model;
  SceneView view;
  explicit Scene(std::initializer_list<ScenePart> parts) {
    PartVisibility visible{};
    for (const ScenePart part : parts) visible[static_cast<std::size_t>(part)] = true;
    view.setLibrary(two_take_library());
    view.resize(640, 480);
    view.setVisibility(visible);
    view.show();
    view.showFrame(synthetic_frame(3, 0.05));
    QObject::connect(&view, &SceneView::selectionRequested, &model, &SelectionModel::select);
    QObject::connect(&model, &SelectionModel::selectionChanged, &view, &SceneView::showSelection);
  }
  QWidget* surface() { return view.childAt(320, 240); }
  void wheel(Qt::KeyboardModifiers keys) {
    QWheelEvent turn(QPointF(320, 240), surface()->mapToGlobal(QPoint(320, 240)), {}, {0, 120}, Qt::NoButton,
                     keys, Qt::NoScrollPhase, false);
    QApplication::sendEvent(surface(), &turn);
  }
  void change(const std::function<void(SceneOptions&)>& how) {
    SceneOptions options = view.options();
    how(options);
    view.setOptions(options);
  }
};

/// The middle of a picture, off chips, legend and facts.
QImage middle_of(const QImage& picture) {
  return picture.copy(0, 120, 640, 280);
}

TEST(SceneView, ShowsBothCharactersInTheirColours) {
  Scene scene({ScenePart::Leader, ScenePart::Follower});
  const QImage picture = picture_of(scene.view);
  EXPECT_GT(pixels_of_hue(picture, dark().active), 6000);
  EXPECT_GT(pixels_of_hue(picture, dark().passive), 6000);
}

TEST(SceneView, HidesACharacterThatIsSwitchedOff) {
  Scene scene({ScenePart::Follower});
  EXPECT_LT(pixels_of_hue(picture_of(scene.view).copy(0, 120, 640, 360), dark().active), 40);
}

TEST(SceneView, DrawsTheMeshInColoursOfTheScalarMap) {
  Scene scene({ScenePart::MeshBetween});
  const QImage picture = picture_of(scene.view).copy(0, 90, 640, 300);
  EXPECT_GT(pixels_of_hue(picture, QColor(68, 191, 112), 25), 300)
      << "the middle of the part of viridis that is bright enough for a dark scene, at 0.7";
  EXPECT_GT(pixels_of_hue(picture, QColor(42, 120, 142), 25), 30) << "its low end, at 0.4";
}

TEST(SceneView, DrawsEdgesWithinABodyGrey) {
  Scene with({ScenePart::MeshWithin}), without({});
  const QImage a = picture_of(with.view), b = picture_of(without.view);
  EXPECT_GT(difference(a, b), 0.003);
  EXPECT_LT(pixels_of_hue(a.copy(0, 90, 640, 300), QColor(39, 173, 129), 25), 20);
}

TEST(SceneView, GhostsChangeThePicture) {
  Scene with({ScenePart::SelectedPair}), without({});
  EXPECT_GT(difference(picture_of(with.view), picture_of(without.view)), 0.002);
}

TEST(SceneView, ShowsAHoveredCandidateInGhostColours) {
  Scene scene({});
  const int before = pixels_of_hue(picture_of(scene.view), dark().ghost_active);
  scene.view.showCandidate(4);
  EXPECT_GT(pixels_of_hue(picture_of(scene.view), dark().ghost_active), before + 200);
  scene.view.showCandidate(-1);
  EXPECT_LT(pixels_of_hue(picture_of(scene.view), dark().ghost_active), before + 20);
}

TEST(SceneView, MarksLockedFeetAndCollisions) {
  Scene scene({ScenePart::FootLocks, ScenePart::Contacts});
  const QImage picture = picture_of(scene.view).copy(0, 90, 640, 390);
  EXPECT_GT(pixels_of_hue(picture, dark().good), 60);
  EXPECT_GT(pixels_of_hue(picture, dark().warning), 20);
}

TEST(SceneView, TurnsWithTheMouseAndComesNearerWithTheWheel) {
  Scene scene({ScenePart::Leader});
  const QImage before = picture_of(scene.view);
  const OrbitCamera camera = scene.view.camera();
  QWidget* surface = scene.view.childAt(320, 240);
  QTest::mousePress(surface, Qt::LeftButton, {}, {320, 240});
  QMouseEvent move(QEvent::MouseMove, QPointF(400, 240), QPointF(400, 240), Qt::NoButton, Qt::LeftButton, {});
  QApplication::sendEvent(surface, &move);
  EXPECT_NE(scene.view.camera().azimuth_rad, camera.azimuth_rad);
  EXPECT_DOUBLE_EQ(scene.view.camera().elevation_rad, camera.elevation_rad);
  EXPECT_GT(difference(before, picture_of(scene.view)), 0.01);
}

TEST(SceneView, CountsWhatItShows) {
  SceneView view;
  PartCounts counts{};
  QObject::connect(&view, &SceneView::countsChanged, [&counts](const PartCounts& now) { counts = now; });
  view.showFrame(synthetic_frame(0, 0));
  const auto count = [&counts](ScenePart part) { return counts[static_cast<std::size_t>(part)]; };
  EXPECT_EQ(count(ScenePart::FootLocks), 2);
  EXPECT_EQ(count(ScenePart::Contacts), 1);
  EXPECT_EQ(static_cast<std::size_t>(count(ScenePart::MeshBetween) + count(ScenePart::MeshWithin)),
            synthetic_frame(0, 0)->result.edges.size());
}

/// Cells around one that went through itself: the follower's right hand is carried through the leader.
FrameSnapshotPtr frame_with_inverted_cells() {
  auto frame = std::make_shared<FrameSnapshot>(*synthetic_frame(3, 0.05));
  frame->result.result.row(joint_count + joints::right_hand).z() -= 1.2;
  return frame;
}

TEST(SceneView, DrawsTetrahedraWithoutMarkingThoseThatKeptTheirVolume) {
  auto unbent = std::make_shared<FrameSnapshot>(*synthetic_frame(3, 0.05));
  unbent->result.result = unbent->result.selected_pair;
  Scene without({}), with({ScenePart::Tetrahedra});
  for (Scene* scene : {&without, &with}) scene->view.showFrame(unbent);
  const QImage before = picture_of(without.view), after = picture_of(with.view);
  EXPECT_GT(difference(before.copy(0, 120, 640, 300), after.copy(0, 120, 640, 300)), 0.03);
  EXPECT_LT(pixels_of_hue(after.copy(0, 120, 640, 300), QColor("#ff3fb4"), 8), 30) << "none is inverted";
}

TEST(SceneView, MarksTetrahedraThatTurnedOverInMagenta) {
  Scene scene({ScenePart::Tetrahedra});
  scene.view.showFrame(frame_with_inverted_cells());
  EXPECT_GT(pixels_of_hue(picture_of(scene.view).copy(0, 120, 640, 300), QColor("#ff3fb4"), 8), 600);
}

TEST(SceneView, DrawsTrailsOfTheHandsInTheColoursOfTheBodies) {
  Scene scene({ScenePart::Trails});
  for (std::uint64_t i = 4; i < 40; ++i)
    scene.view.showFrame(synthetic_frame(i, 0.05 + 0.03 * static_cast<double>(i)));
  EXPECT_GT(pixels_of_hue(picture_of(scene.view).copy(0, 120, 640, 300), dark().passive), 30);
}

TEST(SceneView, MovesTetrahedraApart) {
  Scene scene({ScenePart::Tetrahedra});
  const QImage together = picture_of(scene.view);
  SceneOptions options;
  options.apart = 1;
  scene.view.setOptions(options);
  EXPECT_GT(difference(together, picture_of(scene.view)), 0.05);
}

TEST(SceneView, HidesEdgesThatAFilterLeavesOut) {
  Scene scene({ScenePart::MeshBetween});
  const QColor middle(39, 173, 129);
  ASSERT_GT(pixels_of_hue(picture_of(scene.view).copy(0, 90, 640, 300), middle, 25), 300);
  SceneOptions options;
  options.shortest_m = 2.9;
  scene.view.setOptions(options);
  EXPECT_LT(pixels_of_hue(picture_of(scene.view).copy(0, 90, 640, 300), middle, 25), 20);
  scene.view.setOptions({});
  EXPECT_GT(pixels_of_hue(picture_of(scene.view).copy(0, 90, 640, 300), middle, 25), 300);
}

TEST(SceneView, CutsAwayWhatIsNearerThanThePlane) {
  Scene scene({ScenePart::Leader, ScenePart::Follower});
  SceneOptions options;
  options.cuts = true;
  options.cut_m = -1.5;  // behind both
  scene.view.setOptions(options);
  EXPECT_LT(pixels_of_hue(picture_of(scene.view).copy(0, 120, 640, 300), dark().active), 40);
}

TEST(SceneView, ShowsParallelProjectionAtTheSameSize) {
  Scene scene({ScenePart::Leader, ScenePart::Follower});
  const int central = pixels_of_hue(picture_of(scene.view), dark().active);
  SceneOptions options;
  options.is_parallel = true;
  scene.view.setOptions(options);
  const int parallel = pixels_of_hue(picture_of(scene.view), dark().active);
  EXPECT_NEAR(parallel, central, 0.25 * central);
  EXPECT_NE(parallel, central);
}

/// Where a vertex is in the picture of the scene.
QPoint place_of(const SceneView& view, const FrameSnapshotPtr& frame, int vertex) {
  const auto at = PictureProjection(view.camera(), view.width(), view.height())
                      .project(frame->result.result.row(vertex).transpose())
                      .value();
  return {qRound(at.x), qRound(at.y)};
}

TEST(SceneView, SelectsTheJointThatIsClickedAndKeepsItInOtherFrames) {
  Scene scene({ScenePart::Joints});
  const QImage before = picture_of(scene.view);
  QSignalSpy changed(&scene.view, &SceneView::selectionRequested);
  const QPoint place = place_of(scene.view, synthetic_frame(3, 0.05), joints::Head);
  QTest::mouseClick(scene.view.childAt(320, 240), Qt::LeftButton, {}, place);
  ASSERT_EQ(changed.size(), 1);
  EXPECT_EQ(scene.view.selection(), Selection::joint(joints::Head));
  auto* card = scene.view.findChild<QWidget*>("selected");
  ASSERT_TRUE(card->isVisible());
  EXPECT_GT(difference(before, picture_of(scene.view)), 0.01) << "the mark and the card";
  scene.view.showFrame(synthetic_frame(9, 0.15));
  EXPECT_EQ(scene.view.selection(), Selection::joint(joints::Head));
  QTest::mouseClick(scene.surface(), Qt::LeftButton, {}, {8, 300});
  EXPECT_EQ(scene.view.selection(), Selection()) << "a click beside everything";
  EXPECT_FALSE(card->isVisible());
}

TEST(SceneView, AddsWithShiftAndTogglesWithCtrl) {
  Scene scene({ScenePart::Joints});
  picture_of(scene.view);
  const auto click = [&scene](int vertex, Qt::KeyboardModifiers keys) {
    const QPoint place = place_of(scene.view, synthetic_frame(3, 0.05), vertex);
    QTest::mouseClick(scene.surface(), Qt::LeftButton, keys, place);
  };
  click(joints::Head, {});
  click(joint_count + joints::Head, Qt::ShiftModifier);
  EXPECT_EQ(scene.model.selection().vertices,
            (std::vector<std::uint8_t>{joints::Head, joint_count + joints::Head}));
  click(joints::Head, Qt::ControlModifier);
  EXPECT_EQ(scene.model.selection(), Selection::joint(joint_count + joints::Head));
}

TEST(SceneView, PicksTheGhostOfTheSelectedPairAndSaysWhoseItIs) {
  Scene scene({ScenePart::SelectedPair});
  picture_of(scene.view);
  QSignalSpy hovered(&scene.view, &SceneView::candidateHovered);
  const PairPose& pair = synthetic_frame(3, 0.05)->result.selected_pair;
  const Vec3 knee = pair.row(joints::left_knee), hip = pair.row(joints::left_hip);
  const auto at = PictureProjection(scene.view.camera(), 640, 480).project(0.5 * (knee + hip)).value();
  QMouseEvent move(QEvent::MouseMove, QPointF(at.x, at.y), Qt::NoButton, Qt::NoButton, {});
  QApplication::sendEvent(scene.surface(), &move);
  ASSERT_EQ(hovered.size(), 1);
  EXPECT_EQ(hovered[0][0].toInt(), 0);
  QTest::mouseClick(scene.surface(), Qt::LeftButton, {}, {qRound(at.x), qRound(at.y)});
  EXPECT_EQ(scene.model.selection(), Selection::candidate(0));
}

TEST(SceneView, ShowsTheGhostOfASelectedCandidate) {
  Scene scene({});
  const int before = pixels_of_hue(picture_of(scene.view), dark().ghost_active);
  scene.model.select(Selection::candidate(4));
  EXPECT_GT(pixels_of_hue(picture_of(scene.view), dark().ghost_active), before + 200);
}

TEST(SceneView, HidesTheCardWhenThePointerLeaves) {
  Scene scene({ScenePart::Joints});
  picture_of(scene.view);
  const QPointF place = place_of(scene.view, synthetic_frame(3, 0.05), joints::Head);
  QMouseEvent move(QEvent::MouseMove, place, Qt::NoButton, Qt::NoButton, {});
  QApplication::sendEvent(scene.surface(), &move);
  auto* card = scene.view.findChild<QWidget*>("hovered");
  ASSERT_TRUE(card->isVisible());
  EXPECT_FALSE(card->geometry().contains(place.toPoint())) << "nor does it cover what it is about";
  QEvent leave(QEvent::Leave);
  QApplication::sendEvent(scene.surface(), &leave);
  EXPECT_FALSE(card->isVisible());
}

/// Two arms pressed into one another by 2 cm.
FrameSnapshotPtr frame_with_collision() {
  auto frame = std::make_shared<FrameSnapshot>(*synthetic_frame(3, 0.05));
  frame->result.collisions = {{{19, 20}, {44, 45}, 0.020, 0.003}};
  return frame;
}

TEST(SceneView, DrawsLimbsThatOverlapWithTheirDepth) {
  for (const Theme theme : {Theme::Dark, Theme::Light}) {
    Scene without({}), with({ScenePart::Contacts});
    for (Scene* scene : {&without, &with}) {
      scene->view.setColours(palette_of(theme));
      scene->view.showFrame(frame_with_collision());
    }
    EXPECT_GT(difference(middle_of(picture_of(without.view)), middle_of(picture_of(with.view))), 0.002);
    const auto labels = with.view.findChildren<QLabel*>("depth");
    ASSERT_EQ(labels.size(), 1);
    EXPECT_TRUE(labels[0]->isVisible());
    EXPECT_EQ(labels[0]->text(), QString("20 mm (recorded 3)"));
    with.view.showFrame(synthetic_frame(4, 0.1));
    EXPECT_EQ(labels[0]->text(), QString("4 mm (recorded 10)"));
  }
}

TEST(SceneView, StandsTheReferenceBesideTheResultAndMarksItThereToo) {
  Scene scene({ScenePart::MeshBetween});
  const QImage alone = picture_of(scene.view);
  scene.change([](SceneOptions& options) { options.shows_reference_beside = true; });
  EXPECT_TRUE(QTest::qWaitFor([&] { return scene.view.camera().shift_m > 0.3; }, 1000));
  scene.view.frameAll();
  QTest::qWait(300);
  const QImage both = picture_of(scene.view);
  EXPECT_GT(pixels_of_hue(both.copy(340, 120, 300, 280), dark().ghost_active), 150) << "at the right";
  EXPECT_GT(pixels_of_hue(both.copy(0, 120, 300, 280), QColor(39, 173, 129), 25), 30)
      << "the result at the left";
  // A click on the head of the reference selects the leader's head.
  const Vec3 head = synthetic_frame(3, 0.05)->result.selected_pair.row(joints::Head);
  const OrbitCamera& camera = scene.view.camera();
  const auto at =
      PictureProjection(camera, 640, 480).project(head + 2 * camera.shift_m * camera.right()).value();
  QTest::mouseClick(scene.surface(), Qt::LeftButton, {}, {qRound(at.x), qRound(at.y)});
  EXPECT_EQ(scene.model.selection(), Selection::joint(joints::Head));
  EXPECT_GT(difference(both, picture_of(scene.view)), 0.001);
  EXPECT_GT(difference(alone, both), 0.02);
}

TEST(SceneView, StepsThroughTheMorph) {
  Scene scene({ScenePart::Leader, ScenePart::Follower});
  auto* strip = scene.view.findChild<MorphStrip*>();
  EXPECT_FALSE(strip->isVisible());
  const QImage result = picture_of(scene.view);
  EXPECT_EQ(scene.view.morphStep(), 2);
  scene.view.stepMorph(-1);
  scene.view.stepMorph(-1);
  EXPECT_EQ(scene.view.morphStep(), 0);
  EXPECT_TRUE(strip->isVisible());
  EXPECT_GT(difference(middle_of(result), middle_of(picture_of(scene.view))), 0.01);
  scene.view.showFrame(synthetic_frame(5, 0.1));
  EXPECT_EQ(scene.view.morphStep(), 0) << "the same step of the next frame";
  strip->findChild<QSlider*>()->setValue(2);
  EXPECT_EQ(scene.view.morphStep(), 2);
  EXPECT_FALSE(strip->isVisible());
}

TEST(SceneView, CutsAlongAPlaneThatStaysInTheWorld) {
  Scene scene({ScenePart::Leader, ScenePart::Follower});
  const QImage whole = picture_of(scene.view);
  scene.change([](SceneOptions& options) { options.cuts = options.cut_in_world = true; });
  const QImage cut = picture_of(scene.view);
  EXPECT_GT(difference(middle_of(whole), middle_of(cut)), 0.02);
  const double azimuth = scene.view.options().cut_azimuth_rad;
  scene.view.lookFrom(azimuth + 1, 0.1);
  QTest::qWait(300);
  EXPECT_EQ(scene.view.options().cut_azimuth_rad, azimuth) << "it does not go with the eye";
  scene.view.moveCut(1, 0, 0);
  const QImage less = picture_of(scene.view);
  scene.view.moveCut(-2, 0, 0);
  const QImage nothing = picture_of(scene.view);
  EXPECT_GT(pixels_of_hue(middle_of(less), dark().passive), 2000);
  EXPECT_LT(pixels_of_hue(middle_of(nothing), dark().passive), 100) << "all of it lies beyond the plane";
}

TEST(SceneView, MovesAndTurnsThePlaneWithTheMouse) {
  Scene scene({ScenePart::Leader});
  scene.change([](SceneOptions& options) { options.cuts = options.cut_in_world = true; });
  scene.wheel(Qt::ControlModifier);
  EXPECT_NEAR(scene.view.options().cut_m, 0.05, 1e-12);
  const SceneOptions before = scene.view.options();
  const double eye = scene.view.camera().azimuth_rad;
  const Qt::KeyboardModifiers keys = Qt::ControlModifier | Qt::AltModifier;
  QTest::mousePress(scene.surface(), Qt::LeftButton, keys, {320, 240});
  QMouseEvent move(QEvent::MouseMove, QPointF(360, 240), QPointF(360, 240), Qt::NoButton, Qt::LeftButton,
                   keys);
  QApplication::sendEvent(scene.surface(), &move);
  EXPECT_NE(scene.view.options().cut_azimuth_rad, before.cut_azimuth_rad);
  EXPECT_EQ(scene.view.camera().azimuth_rad, eye);
}

TEST(SceneView, DrawsTrailsOfTheSelectedJointsAsLongAsAsked) {
  Scene scene({ScenePart::Trails});
  scene.model.select(Selection::joint(joint_count + joints::left_hand));
  const auto rising = [](std::uint64_t i) {
    auto frame = std::make_shared<FrameSnapshot>(*synthetic_frame(i, 0.05 + 0.03 * static_cast<double>(i)));
    frame->result.result(joint_count + joints::left_hand, 1) += 0.01 * static_cast<double>(i);
    return frame;
  };
  for (std::uint64_t i = 0; i < 60; ++i) scene.view.showFrame(rising(i));
  const int usual = pixels_of_hue(middle_of(picture_of(scene.view)), dark().passive);
  ASSERT_GT(usual, 20);
  const double length = scene.view.options().trail_s;
  scene.wheel(Qt::ShiftModifier);
  EXPECT_NEAR(scene.view.options().trail_s, 1.25 * length, 1e-12);
  for (int i = 0; i < 12; ++i) {
    QWheelEvent turn(QPointF(320, 240), scene.surface()->mapToGlobal(QPoint(320, 240)), {}, {0, -120},
                     Qt::NoButton, Qt::ShiftModifier, Qt::NoScrollPhase, false);
    QApplication::sendEvent(scene.surface(), &turn);
  }
  EXPECT_DOUBLE_EQ(scene.view.options().trail_s, shortest_trail_s);
  scene.view.showFrame(rising(60));
  EXPECT_LT(pixels_of_hue(middle_of(picture_of(scene.view)), dark().passive), usual / 2);
}

TEST(SceneView, FillsTrailsFromThePastAfterTheCursorWasMoved) {
  FrameHistory history;
  for (std::uint64_t i = 0; i < 90; ++i) history.append(synthetic_frame(i, static_cast<double>(i) / 30));
  Scene scene({ScenePart::Trails});
  scene.view.showFrame(history.at(2.5));
  const int alone = pixels_of_hue(middle_of(picture_of(scene.view)), dark().passive);
  scene.view.showPast(history);
  EXPECT_GT(pixels_of_hue(middle_of(picture_of(scene.view)), dark().passive), alone + 20);
}

/// A user who moves as somebody recorded, answered by that recorded pair.
FrameSnapshotPtr recorded_frame(const MotionLibrary& library, int pair, std::uint64_t index) {
  auto frame = std::make_shared<FrameSnapshot>(*synthetic_frame(index, 0.05));
  FrameResult& result = frame->result;
  result.query_root = library.root(pair);
  result.selected_pair = result.result = library.pair_in_world(pair, result.query_root);
  result.query_world = frame->user = result.active();
  result.candidates[0].pair = pair;
  return frame;
}

TEST(SceneView, DrawsWhereThePartnerGoesNextInThePartnersColour) {
  const auto library = test::small_library();
  Scene scene({ScenePart::LookAhead});
  scene.view.setLibrary(library);
  PartCounts counts{};
  QObject::connect(&scene.view, &SceneView::countsChanged, [&counts](const PartCounts& c) { counts = c; });
  const auto shown_ms = [&counts] { return counts[static_cast<std::size_t>(ScenePart::LookAhead)]; };
  const auto pixels = [&] { return pixels_of_hue(middle_of(picture_of(scene.view)), dark().passive); };

  scene.view.showFrame(recorded_frame(*library, library->find_pair("first", 30, false), 4));
  EXPECT_EQ(shown_ms(), 1000);
  const int whole = pixels();
  EXPECT_GT(whole, 60);
  EXPECT_LT(pixels_of_hue(middle_of(picture_of(scene.view)), dark().active), 20) << "not of the user";

  scene.view.showFrame(recorded_frame(*library, library->find_pair("first", 179 - 12, false), 5));
  EXPECT_EQ(shown_ms(), 200) << "the take ends";
  EXPECT_LT(pixels(), whole);

  auto failed = std::make_shared<FrameSnapshot>(*synthetic_frame(6, 0.1));
  failed->result.status = StepStatus::Failed;
  scene.view.showFrame(failed);
  EXPECT_LT(pixels(), 5);

  auto passive_user = std::make_shared<FrameSnapshot>(*recorded_frame(*library, 30, 7));
  passive_user->settings.user_role = UserRole::Passive;
  passive_user->result.query_world = passive_user->result.passive();
  passive_user->result.query_root = root_frame(passive_user->result.query_world);
  scene.view.showFrame(passive_user);
  EXPECT_GT(pixels_of_hue(middle_of(picture_of(scene.view)), dark().active), 60) << "the partner leads";
}

TEST(SceneView, IsolatesAndHidesTheSelection) {
  Scene scene({ScenePart::MeshBetween, ScenePart::MeshWithin});
  const QImage all = picture_of(scene.view);
  scene.model.select(Selection::joint(joints::Head));
  scene.change([](SceneOptions& options) { options.isolates = true; });
  const QImage isolated = picture_of(scene.view);
  EXPECT_GT(difference(middle_of(all), middle_of(isolated)), 0.01);
  scene.view.hideSelection();
  EXPECT_EQ(scene.model.selection(), Selection());
  EXPECT_EQ(scene.view.hidden().size(), 1U);
  scene.view.showHidden();
  EXPECT_TRUE(scene.view.hidden().empty());
  EXPECT_FALSE(scene.view.options().isolates);
  EXPECT_LT(difference(middle_of(all), middle_of(picture_of(scene.view))), 0.002);
}

TEST(SceneView, GoesToTheSelectionAndBackToTheViewBefore) {
  Scene scene({ScenePart::Leader});
  picture_of(scene.view);
  const OrbitCamera start = scene.view.camera();
  scene.model.select(Selection::joint(joints::Head));
  scene.view.frameSelection();
  const Vec3 head = synthetic_frame(3, 0.05)->result.result.row(joints::Head);
  EXPECT_TRUE(QTest::qWaitFor([&] { return (scene.view.camera().target - head).norm() < 1e-9; }, 2000));
  EXPECT_LT(scene.view.camera().distance_m, start.distance_m);
  scene.view.previousView();
  EXPECT_TRUE(QTest::qWaitFor([&] { return scene.view.camera() == start; }, 2000));
  scene.view.nextView();
  EXPECT_TRUE(QTest::qWaitFor([&] { return (scene.view.camera().target - head).norm() < 1e-9; }, 2000));
}

TEST(SceneView, ShowsAllWithHomeWhileItHasTheKeyboard) {
  Scene scene({ScenePart::Leader});
  picture_of(scene.view);
  scene.view.resetView();
  QTest::qWait(300);
  const double fits = scene.view.camera().distance_m;
  scene.wheel({});
  ASSERT_LT(scene.view.camera().distance_m, fits);
  QTest::keyClick(scene.surface(), Qt::Key_Home);
  EXPECT_TRUE(QTest::qWaitFor([&] { return std::abs(scene.view.camera().distance_m - fits) < 0.1; }, 2000));
}

TEST(ScalarLegend, TellsMapScaleAndTheColourOfMissingValues) {
  const LegendScale linear = scalar_legend(MeshScalar::Residual, {20}, false);
  EXPECT_EQ(linear.title, QString("Laplacian residual [mm]"));
  EXPECT_EQ(linear.low, QString("0"));
  const LegendScale logarithmic =
      scalar_legend(MeshScalar::Residual, {20, false, ColourMap::Cividis, true}, true);
  EXPECT_EQ(logarithmic.title, QString("Laplacian residual [mm] log"));
  EXPECT_EQ(logarithmic.low, QString("≤ 0.2"));
  EXPECT_EQ(logarithmic.middle, QString("2"));
  ScalarLegend legend(nullptr);
  legend.show(linear);
  const int height = legend.height();
  legend.show(logarithmic);
  EXPECT_GT(legend.height(), height) << "room for the key of missing values";
  const auto [r, g, b] = no_value_colour;
  EXPECT_GT(pixels_like(picture_of(legend), QColor(r, g, b), 4), 60);
}

TEST(ScalarLegend, HasNoButtonsInAPicture) {
  ScalarLegend legend(nullptr);
  const auto buttons = [&legend] {
    int seen = 0;
    for (const auto* button : legend.findChildren<QToolButton*>()) seen += button->isVisibleTo(&legend);
    return seen;
  };
  legend.show(scalar_legend(MeshScalar::Residual, {20}, false));
  EXPECT_EQ(buttons(), 2);
  legend.becomePicture();
  EXPECT_EQ(buttons(), 0);
  legend.show(scalar_legend(MeshScalar::Residual, {40}, false));
  EXPECT_EQ(buttons(), 0) << "nor with another range";
}

TEST(SceneView, KeepsTheRangeThatAPersonSetsInTheLegend) {
  Scene scene({ScenePart::MeshBetween});
  picture_of(scene.view);
  auto& legend = *scene.view.findChild<ScalarLegend*>();
  ASSERT_NE(legend.scale().high, QString("24"));
  const auto set = [&](const char* upper) {
    QTest::mouseDClick(&legend, Qt::LeftButton, {}, legend.rect().center());
    auto* entry = scene.view.findChild<EntryFrame*>();
    if (!entry) return std::string("nothing asks");
    auto& field = *entry->findChild<QLineEdit*>();
    field.setText(upper);
    QTest::keyClick(&field, Qt::Key_Return);
    return entry->complaint().toStdString();
  };
  EXPECT_NE(set("-3").find("above 0"), std::string::npos);
  EXPECT_EQ(set("24"), "");
  EXPECT_EQ(legend.scale().high, QString("24"));
  scene.view.showFrame(synthetic_frame(40, 30));
  picture_of(scene.view);
  EXPECT_EQ(legend.scale().high, QString("24")) << "it is kept over frames";
  EXPECT_NE(set("30 to 24").find("0.01 to 0.05"), std::string::npos) << "the lower end is above the upper";
  EXPECT_EQ(set("4 to 24"), "");
  EXPECT_EQ(legend.scale().low, QString("4"));
  auto* lock = legend.findChild<QToolButton*>();
  lock->setChecked(false);
  scene.view.showFrame(synthetic_frame(41, 31));
  picture_of(scene.view);
  EXPECT_EQ(legend.scale().low, QString("0")) << "a range that adapts begins at 0";
}

TEST(SceneView, KeepsTheRangeOfTheCellsThatAPersonSets) {
  Scene scene({ScenePart::Tetrahedra});
  picture_of(scene.view);
  const auto legends = scene.view.findChildren<ScalarLegend*>();
  const auto found = std::find_if(legends.begin(), legends.end(), [](const ScalarLegend* each) {
    return each->scale().title.startsWith("Volume");
  });
  ASSERT_NE(found, legends.end());
  QTest::mouseDClick(*found, Qt::LeftButton, {}, (*found)->rect().center());
  auto* entry = scene.view.findChild<EntryFrame*>();
  ASSERT_TRUE(entry);
  entry->findChild<QLineEdit*>()->setText("4");
  QTest::keyClick(entry->findChild<QLineEdit*>(), Qt::Key_Return);
  EXPECT_EQ((*found)->scale().high, QString("× 4"));
  EXPECT_EQ((*found)->scale().low, QString("× 0.25"));
}

TEST(SceneView, ColoursTheMeshByTheMapThatIsChosen) {
  Scene scene({ScenePart::MeshBetween});
  const QImage viridis = picture_of(scene.view);
  scene.change([](SceneOptions& options) { options.map = ColourMap::Cividis; });
  const QImage cividis = picture_of(scene.view);
  EXPECT_GT(pixels_of_hue(middle_of(viridis), QColor(39, 173, 129), 25), 200);
  EXPECT_LT(pixels_of_hue(middle_of(cividis), QColor(39, 173, 129), 25), 20);
}

TEST(SceneView, TellsAboutTheJointUnderThePointer) {
  Scene scene({ScenePart::Joints});
  picture_of(scene.view);
  auto* card = scene.view.findChild<QWidget*>("hovered");
  const auto point_at = [&scene](QPointF place) {
    QMouseEvent move(QEvent::MouseMove, place, place, Qt::NoButton, Qt::NoButton, {});
    QApplication::sendEvent(scene.view.childAt(320, 240), &move);
  };
  point_at(place_of(scene.view, synthetic_frame(3, 0.05), joints::Head));
  EXPECT_TRUE(card->isVisible());
  point_at({5, 300});
  EXPECT_FALSE(card->isVisible());
  EXPECT_FALSE(scene.view.selection()) << "pointing selects nothing";
}

TEST(SceneView, KeepsARangeLockForEachScalar) {
  Scene scene({ScenePart::MeshBetween});
  auto* lock = scene.view.findChild<ScalarLegend*>()->findChild<QToolButton*>();
  lock->click();
  scene.view.setScalar(MeshScalar::EnergyShare);
  EXPECT_FALSE(lock->isChecked());
  scene.view.setScalar(MeshScalar::Residual);
  EXPECT_TRUE(lock->isChecked());
}

TEST(SceneView, ColoursEdgesByTheirShareOfTheEnergy) {
  Scene scene({ScenePart::MeshBetween});
  const QImage residual = picture_of(scene.view);
  scene.view.setScalar(MeshScalar::EnergyShare);
  const QImage share = picture_of(scene.view);
  EXPECT_GT(difference(residual.copy(0, 90, 640, 300), share.copy(0, 90, 640, 300)), 0.005);
  EXPECT_GT(pixels_of_hue(share.copy(0, 90, 640, 300), QColor(39, 173, 129), 25), 30);
}

}  // namespace
}  // namespace abrazo::widgets::scene_picture_test
