// The scene draws a known frame; looked at are colours and places, not single pixels.
#include <gtest/gtest.h>

#include <QLabel>
#include <QSlider>
#include <QTest>
#include <QThread>
#include <QTimer>
#include <QWheelEvent>
#include <algorithm>
#include <vector>

#include "core/motion/body/joint_set.hpp"
#include "core/session/frames/frame_history.hpp"
#include "tests/support/libraries.hpp"
#include "tests/widgets/pictures.hpp"
#include "tests/widgets/scene_fixture.hpp"
#include "tests/widgets/synthetic_frames.hpp"
#include "widgets/scene/panel/morph_strip.hpp"
#include "widgets/scene/values/picture_projection.hpp"
#include "widgets/scene/view/scene_view.hpp"

namespace abrazo::widgets::scene_picture_test {
namespace {

using scene_fixture::dark;
using scene_fixture::middle_of;
using scene_fixture::Scene;
using test::difference;
using test::picture_of;
using test::pixels_of_hue;
using test::synthetic_frame;

/// Cells around one that went through itself: the follower's right hand is carried through the leader.
FrameSnapshotPtr frame_with_inverted_cells() {
  auto frame = std::make_shared<FrameSnapshot>(*synthetic_frame(3, 0.05));
  frame->result.result.row(joint_count + joints::right_hand).z() -= 1.2;
  return frame;
}

/// Two arms pressed into one another by 2 cm.
FrameSnapshotPtr frame_with_collision() {
  auto frame = std::make_shared<FrameSnapshot>(*synthetic_frame(3, 0.05));
  frame->result.collisions = {{{19, 20}, {44, 45}, 0.020, 0.003}};
  return frame;
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

TEST(SceneView, DrawsAShorterCharacterThinnerInProportion) {
  for (const ScenePart who : {ScenePart::Leader, ScenePart::Follower}) {
    Scene scene({who});
    const QColor colour = who == ScenePart::Leader ? dark().active : dark().passive;
    const auto area = [&scene, &colour] {
      return static_cast<double>(pixels_of_hue(middle_of(picture_of(scene.view)), colour));
    };
    const double of_the_library = area();
    auto shorter = std::make_shared<FrameSnapshot>(*synthetic_frame(4, 0.10));
    shorter->result.result *= 0.7;
    scene.view.showFrame(shorter);
    const double share = area() / of_the_library;  // 0.7 * 0.7, and the outline, which is as wide as before
    EXPECT_GT(share, 0.49) << colour.name().toStdString();
    EXPECT_LT(share, 0.62) << colour.name().toStdString();
  }
}

/// As in a film of a trace.
TEST(SceneView, WithoutALibraryDrawsACharacterShorterThanTheRecordedOneThinner) {
  for (const ScenePart who : {ScenePart::Leader, ScenePart::Follower}) {
    SceneView view;
    PartVisibility only_one{};
    only_one[static_cast<std::size_t>(who)] = true;
    const QColor colour = who == ScenePart::Leader ? dark().active : dark().passive;
    view.resize(640, 480);
    view.setVisibility(only_one);
    view.show();
    const auto area_at = [&view, &colour](std::uint64_t index, double recorded, double shown) {
      auto frame =
          std::make_shared<FrameSnapshot>(*synthetic_frame(index, 0.02 * static_cast<double>(index)));
      frame->result.selected_pair *= recorded;
      frame->result.result *= shown;
      view.showFrame(frame);
      return static_cast<double>(pixels_of_hue(middle_of(picture_of(view)), colour));
    };
    const double as_recorded = area_at(4, 1, 1), thinner = area_at(5, 1, 0.7), small = area_at(6, 0.7, 0.7);
    EXPECT_LT(thinner / as_recorded, 0.62) << colour.name().toStdString();
    EXPECT_LT(thinner, 0.95 * small) << "the radii are those of whoever was recorded; "
                                     << colour.name().toStdString();
  }
}

/// Its lines have a rim of another colour, which covered them.
TEST(SceneView, DrawsAComparedBodyInItsColour) {
  Scene scene({ScenePart::Comparison});
  const auto frame = synthetic_frame(3, 0.05);
  scene.view.showFrame(frame);
  PairPose other = frame->result.result;
  other.bottomRows<joint_count>().col(0).array() += 0.3;
  scene.view.showComparison(std::nullopt, other);
  scene.view.renderSharp();
  const QImage picture = middle_of(picture_of(scene.view));
  EXPECT_GT(pixels_of_hue(picture, dark().passive), 1500);
  EXPECT_EQ(pixels_of_hue(picture, dark().active), 0) << "is as in the frame";
}

/// A driver compiles its programs at the first picture, and a window that waits for that does not answer.
TEST(SceneView, PreparesItsFirstPictureInSeveralTurnsAndShowsItWhole) {
  Scene scene({ScenePart::Leader, ScenePart::Follower, ScenePart::MeshBetween});
  scene.view.show();
  int turns = 0;
  while (scene.view.renderedFrames() == 0 && turns < 1000) {
    QApplication::processEvents();
    ++turns;
  }
  EXPECT_GT(turns, 3);
  const QImage whole = picture_of(scene.view);
  EXPECT_GT(pixels_of_hue(whole, dark().active), 6000);
  EXPECT_GT(pixels_of_hue(whole, dark().passive), 6000);
}

TEST(SceneView, WhoeverGrabsItDoesNotWaitForTheNextTurn) {
  Scene scene({ScenePart::Leader, ScenePart::Follower});
  scene.view.show();
  const QImage picture = scene.view.grab().toImage().convertToFormat(QImage::Format_RGB32);
  EXPECT_GT(pixels_of_hue(picture, dark().active), 6000);
}

TEST(SceneView, DrawsNothingButTheFloorBeforeTheFirstFrame) {
  const auto empty = [](const PartVisibility& parts) {
    SceneView view;
    view.setLibrary(test::two_take_library());
    view.resize(640, 480);
    view.setVisibility(parts);
    view.show();
    view.renderSharp();
    return middle_of(picture_of(view));
  };
  PartVisibility floor{};
  floor[static_cast<std::size_t>(ScenePart::Floor)] = true;
  PartVisibility bodies = floor;
  for (const ScenePart part :
       {ScenePart::User, ScenePart::Leader, ScenePart::Follower, ScenePart::SelectedPair, ScenePart::Bones,
        ScenePart::Joints, ScenePart::FootLocks, ScenePart::Trails})
    bodies[static_cast<std::size_t>(part)] = true;
  EXPECT_EQ(difference(empty(bodies), empty(floor)), 0);
}

/// The first picture on the screen has no smoothed edges, so that it comes soon.
TEST(SceneView, SmoothsTheEdgesOfAFirstPictureThatStaysByItself) {
  Scene shown({ScenePart::Leader}), other({ScenePart::Leader});
  ASSERT_TRUE(QTest::qWaitFor([&shown] { return shown.view.renderedFrames() > 0; }, 30'000));
  other.view.renderSharp();
  const QImage smooth = middle_of(picture_of(other.view));
  EXPECT_TRUE(QTest::qWaitFor([&] { return middle_of(picture_of(shown.view)) == smooth; }, 30'000));
}

/// Notes the newest frame when the scene is painted, which takes at least `paint_ms`.
class SlowPaint : public QObject {
 public:
  static constexpr int paint_ms = 5;
  std::uint64_t newest = 0;
  std::vector<std::uint64_t> painted;

  bool eventFilter(QObject*, QEvent* event) override {
    if (event->type() != QEvent::Paint) return false;
    painted.push_back(newest);
    QThread::msleep(paint_ms);
    return false;
  }
};

/// The next frame comes while a picture is painted, before its time is told.
TEST(SceneView, TellsOfAPictureItsOwnFrameAndTimeThoughTheNextOneIsDue) {
  Scene scene({ScenePart::Leader});
  (void)picture_of(scene.view);
  SlowPaint paint;
  scene.surface()->installEventFilter(&paint);
  QTimer frames;
  QObject::connect(&frames, &QTimer::timeout, [&] {
    ++paint.newest;
    scene.view.showFrame(synthetic_frame(paint.newest, 0.05 + 0.01 * static_cast<double>(paint.newest)));
  });
  std::vector<std::uint64_t> drawn;
  QObject::connect(&scene.view, &SceneView::pictureDrawn, [&](const FrameSnapshotPtr& frame, double took_ms) {
    EXPECT_GE(took_ms, SlowPaint::paint_ms);
    drawn.push_back(frame->index);
  });
  frames.start(1);
  ASSERT_TRUE(QTest::qWaitFor([&drawn] { return drawn.size() > 4; }, 30'000));
  for (const std::uint64_t index : drawn)
    EXPECT_TRUE(std::ranges::find(paint.painted, index) != paint.painted.end()) << index;
  scene.surface()->removeEventFilter(&paint);
}

TEST(SceneView, ShowsTheSameAfterItHadOtherSizes) {
  Scene scene({ScenePart::Leader, ScenePart::Follower, ScenePart::MeshBetween});
  const auto picture = [&scene](const QSize& size) {
    scene.view.resize(size);
    QTest::qWait(50);  // until the controls over it have their places
    scene.view.frameAll();
    QTest::qWait(300);  // until a camera that glides has arrived
    return scene.view.grab().toImage();
  };
  const QImage first = picture({640, 480});
  for (const QSize& other : {QSize(1000, 700), QSize(900, 180), QSize(200, 150)}) {
    picture(other);
    EXPECT_LT(test::difference(picture({640, 480}), first), 0.001) << other.width();
  }
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

TEST(SceneView, DrawsLimbsThatOverlapAsThickAsTheShownBody) {
  Scene scene({ScenePart::Contacts});
  scene.view.setFollowing(false);  // the camera would move between the two pictures, by the clock
  const auto area = [&scene](double height) {
    const auto apart = std::make_shared<FrameSnapshot>(*frame_with_collision());
    apart->result.result *= height;
    const auto overlapping = std::make_shared<FrameSnapshot>(*apart);
    apart->result.collisions.clear();
    const auto picture = [&scene](const FrameSnapshotPtr& frame) {
      scene.view.showFrame(frame);
      scene.view.renderSharp();  // all with smoothed edges, not only where pictures are quick
      // As large as before; hidden, they would be shown with the next picture.
      for (QLabel* depth : scene.view.findChildren<QLabel*>("depth")) depth->setFixedSize(0, 0);
      return middle_of(picture_of(scene.view));
    };
    return difference(picture(apart), picture(overlapping));
  };
  const double tall = area(1), half = area(0.5);
  EXPECT_LT(half / tall, 0.4) << "half as long and half as thick, and an outline as wide as before";
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

/// A session that is opened brings its library before its first frame; until then the old frame is looked at.
TEST(SceneView, LooksUpNoPairOfAnotherLibrary) {
  const auto library = test::small_library(), other = test::two_take_library();
  Scene scene({ScenePart::LookAhead});
  scene.view.setLibrary(library);
  PartCounts counts{};
  QObject::connect(&scene.view, &SceneView::countsChanged, [&counts](const PartCounts& c) { counts = c; });
  const auto shown_ms = [&counts] { return counts[static_cast<std::size_t>(ScenePart::LookAhead)]; };
  auto frame = std::make_shared<FrameSnapshot>(*recorded_frame(*library, 0, 4));
  frame->library = library;
  scene.view.showFrame(frame);
  ASSERT_GT(shown_ms(), 0);
  scene.view.setLibrary(other);
  scene.view.showSelection(Selection::joint(joints::Head));
  EXPECT_EQ(shown_ms(), 0) << "the pair of that number is another movement";
  scene.view.setLibrary(library);
  scene.view.showFrame(frame);
  EXPECT_GT(shown_ms(), 0);
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

}  // namespace
}  // namespace abrazo::widgets::scene_picture_test
