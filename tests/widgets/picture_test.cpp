// Each view draws a known frame; looked at are colours and places, not single pixels.
#include <gtest/gtest.h>

#include <QSignalSpy>
#include <QTest>

#include "core/session/frame_history.hpp"
#include "tests/widgets/pictures.hpp"
#include "tests/widgets/synthetic_frames.hpp"
#include "widgets/candidates/candidate_list.hpp"
#include "widgets/candidates/candidate_table.hpp"
#include "widgets/library/take_list.hpp"
#include "widgets/plots/plot_panel.hpp"
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
  EXPECT_LT(pixels_of_hue(picture_of(scene.view).copy(0, 60, 640, 420), dark().active), 40);
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
  EXPECT_GT(pixels_of_hue(picture.copy(0, 30, 450, 140), dark().energy_constraint), 60);
  EXPECT_GT(pixels_of_hue(picture.copy(450, 30, 450, 140), dark().residual_penetration), 40);
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
