// Each view draws a known frame; looked at are colours and places, not single pixels.
#include <gtest/gtest.h>

#include <QDoubleSpinBox>
#include <QSignalSpy>
#include <QTest>
#include <QToolButton>

#include "core/session/frame_history.hpp"
#include "tests/widgets/pictures.hpp"
#include "tests/widgets/synthetic_frames.hpp"
#include "widgets/candidates/candidate_list.hpp"
#include "widgets/candidates/candidate_table.hpp"
#include "widgets/library/take_list.hpp"
#include "widgets/plots/plot_panel.hpp"
#include "widgets/scene/picture_projection.hpp"
#include "widgets/scene/scene_options_panel.hpp"
#include "widgets/scene/scene_overlay.hpp"
#include "widgets/scene/scene_tree.hpp"
#include "widgets/scene/scene_view.hpp"
#include "widgets/timeline/timeline_view.hpp"
#include "widgets/timeline/transport_bar.hpp"

namespace abrazo::widgets {
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
  SceneView view;
  explicit Scene(std::initializer_list<ScenePart> parts) {
    PartVisibility visible{};
    for (const ScenePart part : parts) visible[static_cast<std::size_t>(part)] = true;
    view.setLibrary(two_take_library());
    view.resize(640, 480);
    view.setVisibility(visible);
    view.show();
    view.showFrame(synthetic_frame(3, 0.05));
  }
};

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
  EXPECT_GT(pixels_of_hue(picture, QColor(39, 173, 129), 25), 300) << "the middle of the map";
  EXPECT_GT(pixels_of_hue(picture, QColor(71, 44, 122), 25), 30) << "its low end";
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
  EXPECT_LT(pixels_of_hue(after.copy(0, 120, 640, 300), QColor("#ff3fb4"), 8), 30) << "none is turned over";
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
  QSignalSpy changed(&scene.view, &SceneView::pickedChanged);
  const QPoint place = place_of(scene.view, synthetic_frame(3, 0.05), joints::Head);
  QTest::mouseClick(scene.view.childAt(320, 240), Qt::LeftButton, {}, place);
  ASSERT_EQ(changed.size(), 1);
  EXPECT_EQ(scene.view.picked(), PickedItem::joint(joints::Head));
  auto* card = scene.view.findChild<QWidget*>("selected");
  ASSERT_TRUE(card->isVisible());
  EXPECT_GT(difference(before, picture_of(scene.view)), 0.01) << "the mark and the card";
  scene.view.showFrame(synthetic_frame(9, 0.15));
  EXPECT_EQ(scene.view.picked(), PickedItem::joint(joints::Head));
  scene.view.select({});
  EXPECT_EQ(changed.size(), 2);
  EXPECT_FALSE(card->isVisible());
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
  EXPECT_FALSE(scene.view.picked()) << "pointing selects nothing";
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

TEST(SceneOptionsPanel, AsksForWhatIsSetAndLeavesTheRest) {
  SceneOptionsPanel panel(nullptr);
  SceneOptions start, asked;
  start.navigation = NavigationStyle::Maya;
  panel.setOptions(start);
  QObject::connect(&panel, &SceneOptionsPanel::optionsRequested,
                   [&asked](const SceneOptions& options) { asked = options; });
  panel.findChildren<QDoubleSpinBox*>().front()->setValue(0.4);
  EXPECT_DOUBLE_EQ(asked.shortest_m, 0.4);
  EXPECT_EQ(asked.longest_m, MeshFilter::no_limit);
  EXPECT_EQ(asked.navigation, NavigationStyle::Maya);
}

TEST(SceneTree, AsksToHideWhatIsClicked) {
  SceneTree tree;
  tree.resize(260, 400);
  PartVisibility asked{};
  QObject::connect(&tree, &SceneTree::visibilityRequested, [&asked](const PartVisibility& v) { asked = v; });
  QTest::mouseClick(&tree, Qt::LeftButton, {}, {40, 22 + 11});  // "Result": both characters
  EXPECT_FALSE(asked[static_cast<std::size_t>(ScenePart::Leader)]);
  EXPECT_FALSE(asked[static_cast<std::size_t>(ScenePart::Follower)]);
  EXPECT_TRUE(asked[static_cast<std::size_t>(ScenePart::Floor)]);
}

TEST(CandidateTable, PaintsTheThreeTermsInTheirColours) {
  CandidateTable table;
  table.setLibrary(two_take_library());
  table.resize(400, 300);
  table.showFrame(synthetic_frame(0, 0));
  const QImage picture = picture_of(table).copy(150, 34, 250, 200);
  EXPECT_GT(pixels_like(picture, dark().user), 500);
  EXPECT_GT(pixels_like(picture, dark().active), 60);
  EXPECT_GT(pixels_like(picture, dark().passive), 150);
  EXPECT_TRUE(table.reason().startsWith("Winner by"));
}

TEST(CandidateTable, TellsWhichCandidateIsUnderThePointer) {
  CandidateList list;
  list.resize(400, 200);
  list.setRows(candidate_rows(*synthetic_frame(0, 0), *two_take_library()));
  QSignalSpy hovered(&list, &CandidateList::candidateHovered);
  QMouseEvent move(QEvent::MouseMove, QPointF(60, 24 + 5), QPointF(60, 24 + 5), Qt::NoButton, Qt::NoButton,
                   {});
  QApplication::sendEvent(&list, &move);
  ASSERT_EQ(hovered.size(), 1);
  EXPECT_EQ(hovered[0][0].toInt(), list.rows()[1].candidate);
}

/// Ten seconds of frames, and a playback parked in their middle.
struct TenSeconds {
  FrameHistory history;
  Playback playback;
  TenSeconds() {
    for (std::uint64_t i = 0; i < 300; ++i) history.append(synthetic_frame(i, static_cast<double>(i) / 30));
    playback.extend(history.span().first_s, history.span().last_s);
    playback.seek(5);
  }
};

TEST(TimelineView, DrawsTheCursorWhereItsAxisSays) {
  TenSeconds data;
  TimelineView view;
  view.setLibrary(two_take_library());
  view.resize(900, view.height());
  view.show();
  view.refresh(data.history, data.playback);
  const QImage picture = picture_of(view);
  const int x = static_cast<int>(view.axis().x(5));
  EXPECT_GT(pixels_like(picture.copy(x - 2, 10, 5, picture.height() - 12), Qt::white), picture.height() - 30);
  EXPECT_LT(pixels_like(picture.copy(x + 30, 10, 40, picture.height() - 12), Qt::white, 8), 10);
}

TEST(TimelineView, AsksToGoWhereItIsDragged) {
  TenSeconds data;
  TimelineView view;
  view.setLibrary(two_take_library());
  view.resize(900, view.height());
  view.show();
  view.refresh(data.history, data.playback);
  QSignalSpy asked(&view, &TimelineView::seekRequested);
  QTest::mouseClick(&view, Qt::LeftButton, {}, {static_cast<int>(view.axis().x(7)), 10});
  ASSERT_EQ(asked.size(), 1);
  EXPECT_NEAR(asked[0][0].toDouble(), 7, 2 * view.axis().seconds_per_pixel());
}

TEST(TimelineView, ShowsSourcesAndMovesOfTheSelectedPairs) {
  TenSeconds data;
  TimelineView view;
  view.setLibrary(two_take_library());
  view.resize(900, view.height());
  view.show();
  view.refresh(data.history, data.playback);
  const QImage picture = picture_of(view);
  EXPECT_GT(pixels_like(picture, take_colour(dark(), 0), 6), 1500);
  EXPECT_GT(pixels_like(picture, mixed(label_colour(dark(), "turn"), dark().panel, 0.26), 6), 1000);
}

TEST(PlotPanel, DrawsItsCurvesAndTheCursor) {
  TenSeconds data;
  PlotPanel panel;
  panel.resize(900, 170);
  panel.show();
  Playback live = data.playback;
  live.follow();
  panel.refresh(data.history, live, data.history.at(10));
  panel.refresh(data.history, data.playback, data.history.at(5));
  const QImage picture = picture_of(panel);
  EXPECT_GT(pixels_of_hue(picture.copy(0, 30, 300, 140), dark().energy_constraint), 60);
  EXPECT_GT(pixels_of_hue(picture.copy(300, 30, 300, 140), dark().residual_penetration), 40);
  const int x = static_cast<int>(panel.cursorX());
  EXPECT_GT(pixels_like(picture.copy(x - 2, 40, 5, 110), QColor("#c7ccd6"), 40), 60);
}

TEST(TransportBar, TellsTheStateInWords) {
  TransportBar bar;
  Playback playback;
  playback.extend(0, 35);
  bar.showPlayback(playback, 10);
  EXPECT_TRUE(bar.stateText().contains("LIVE"));
  playback.seek(11.5);
  bar.showPlayback(playback, 10);
  EXPECT_EQ(bar.stateText(), QString("PARKED −23.5 s"));
  playback.play();
  bar.showPlayback(playback, 10);
  EXPECT_TRUE(bar.stateText().startsWith("PLAYING"));
}

TEST(TransportBar, WritesTimesWithHoursOnlyWhenThereAreAny) {
  EXPECT_EQ(clock_text(11.5), QString("00:11.500"));
  EXPECT_EQ(clock_text(3671.25), QString("1:01:11.250"));
}

TEST(TakeList, PaintsBothBodiesOfATake) {
  TakeList list;
  list.setLibrary(two_take_library());
  list.resize(260, 100);
  const QImage picture = picture_of(list);
  EXPECT_GT(pixels_of_hue(picture.copy(0, 0, 50, 42), dark().active), 20);
  EXPECT_GT(pixels_of_hue(picture.copy(0, 0, 50, 42), dark().passive), 20);
}

}  // namespace
}  // namespace abrazo::widgets
