// The view of the scene: camera, projection, cutting plane.
#include <gtest/gtest.h>

#include <QTest>
#include <QToolButton>

#include "tests/support/libraries.hpp"
#include "tests/widgets/pictures.hpp"
#include "tests/widgets/scene_fixture.hpp"
#include "tests/widgets/synthetic_frames.hpp"
#include "widgets/common/tabular.hpp"
#include "widgets/common/theme.hpp"
#include "widgets/scene/panel/scalar_legend.hpp"
#include "widgets/scene/panel/scene_overlay.hpp"
#include "widgets/scene/view/scene_pictures.hpp"
#include "widgets/scene/view/scene_view.hpp"

namespace abrazo::widgets::scene_camera_test {
namespace {

using scene_fixture::dark;
using scene_fixture::middle_of;
using scene_fixture::Scene;
using test::difference;
using test::picture_of;
using test::pixels_of_hue;

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

/// A label that is drawn or changed gives the library other labels; the view jumped each time.
TEST(SceneView, StaysWhereItWasTurnedToWhenTheLibraryGetsOtherLabels) {
  Scene scene({ScenePart::Leader});
  picture_of(scene.view);
  QWidget* surface = scene.view.childAt(320, 240);
  QTest::mousePress(surface, Qt::LeftButton, {}, {320, 240});
  QMouseEvent move(QEvent::MouseMove, QPointF(400, 240), QPointF(400, 240), Qt::NoButton, Qt::LeftButton, {});
  QApplication::sendEvent(surface, &move);
  QTest::mouseRelease(surface, Qt::LeftButton, {}, {400, 240});
  const double turned_rad = scene.view.camera().azimuth_rad;
  scene.view.extendLibrary(test::small_library());
  scene.view.showFrame(test::synthetic_frame(4, 0.07));
  EXPECT_DOUBLE_EQ(scene.view.camera().azimuth_rad, turned_rad);
}

/// "inverted" was cut behind its first letters, and nothing said what it was.
TEST(FrameFacts, SaysItBrieflyWhereTheWholeDoesNotFit) {
  FrameFacts facts(nullptr);
  const FrameFacts::Line line{"frame 1201 · 20.02 s · 3 of 96 tetrahedra inverted",
                              "frame 1201 · 20.02 s · 3 inverted"};
  facts.show(line, {}, {});
  facts.resize(900, facts.height());
  EXPECT_EQ(facts.firstLine(), line.whole);
  while (facts.firstLine() == line.whole && facts.width() > 0)
    facts.resize(facts.width() - 4, facts.height());
  EXPECT_EQ(facts.firstLine(), line.brief) << "at " << facts.width() << " pixels";
}

/// Digits are drawn as wide as the widest: the end of a line that was measured otherwise was cut.
TEST(FrameFacts, LeavesOutWholeFactsInAnyWidth) {
  FrameFacts facts(nullptr);
  const QString brief = "frame 11111 · 111.111 s · step 1 + 1 / 1 + 1 · 11 inverted";
  facts.show({"frame 11111 · 111.111 s · morph step 1 + 1 / 1 + 1 · 11 of 111 tetrahedra inverted", brief},
             {}, {});
  for (int width = 900; width > 200; width -= 7) {
    facts.resize(width, facts.height());
    const QString line = facts.firstLine();
    EXPECT_LE(tabular_width(interface_font(13), line), width - 8) << width;
    EXPECT_FALSE(line.contains("…")) << line.toStdString();
    EXPECT_TRUE(line.startsWith("frame 11111"));
  }
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

/// At 1280x720 with the welcome page beside the scene, the legend lay over the heads.
TEST(SceneView, DrawsThePairBetweenTheControlsWhereTheViewIsNarrow) {
  Scene scene({ScenePart::Leader, ScenePart::Follower, ScenePart::MeshBetween});
  scene.view.resize(330, 500);
  scene.view.resetView();
  QTest::qWait(300);  // the camera has moved
  const auto* legend = scene.view.findChild<ScalarLegend*>();
  const auto* facts = scene.view.findChild<FrameFacts*>();
  const auto frame = test::synthetic_frame(3, 0.05);
  for (int vertex = 0; vertex < pair_vertex_count; ++vertex) {
    const int y = scene_fixture::place_of(scene.view, frame, vertex).y();
    EXPECT_GT(y, legend->geometry().bottom()) << vertex;
    EXPECT_LT(y, facts->geometry().top()) << vertex;
  }
  const QImage picture = picture_of(scene.view);
  const int head_y = scene_fixture::place_of(scene.view, frame, joints::Head).y();
  EXPECT_EQ(pixels_of_hue(
                picture.copy(0, legend->geometry().bottom(), 330, head_y - 40 - legend->geometry().bottom()),
                dark().active),
            0)
      << "the picture agrees with the projection";
  scene.view.resize(640, 480);
  EXPECT_EQ(scene.view.camera().lowered, 0) << "beside the controls of a wide view";
}

/// Else the third row of chips and the legend took a third of the picture.
TEST(SceneView, TheLegendIsBesideTheLastRowOfChipsThatLeavesRoom) {
  Scene scene({ScenePart::Leader, ScenePart::MeshBetween});
  const auto* chips = scene.view.findChild<ScalarChips*>();
  const auto* legend = scene.view.findChild<ScalarLegend*>();
  for (const int width : {250, 330, 420, 640, 900}) {
    scene.view.resize(width, 480);
    for (const auto* chip : chips->findChildren<QToolButton*>(QString(), Qt::FindDirectChildrenOnly)) {
      const QRect place(chip->mapTo(&scene.view, QPoint(0, 0)), chip->size());
      EXPECT_FALSE(place.intersects(legend->geometry())) << width << " " << chip->text().toStdString();
    }
    EXPECT_LE(legend->y(), chips->geometry().bottom() + 8) << width;
  }
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

/// A pair that walks 6 m, in a film of each shape: the camera stood still, and they left the picture.
TEST(ScenePictures, AFilmKeepsBothBodiesWholeInPicturesOfEveryShape) {
  constexpr int steps = 60;
  constexpr double step_m = 0.1;
  ScenePictures::Look look;
  look.library = test::two_take_library();
  look.visibility = {};
  for (const ScenePart part : {ScenePart::Leader, ScenePart::Follower})
    look.visibility[static_cast<std::size_t>(part)] = true;
  for (const QSize size : {QSize(360, 640), QSize(320, 320), QSize(640, 360), QSize(800, 300)}) {
    ScenePictures film(size, look);
    for (int step = 0; step < steps; ++step) {
      auto frame = std::make_shared<FrameSnapshot>(*test::synthetic_frame(3, 0.05));
      frame->index = static_cast<std::uint64_t>(step);
      frame->time_s = step / 15.0;
      frame->result.result.col(0).array() += step * step_m;
      const QImage picture = film.picture(frame);
      if (step % 10 != 9) continue;
      const QColor colours[] = {dark().active, dark().passive};
      for (const QColor& body : colours) {
        EXPECT_GT(pixels_of_hue(picture, body), size.width() * size.height() / 400) << step;
        for (const QRect edge : {QRect(0, 0, 2, size.height()), QRect(size.width() - 2, 0, 2, size.height())})
          EXPECT_EQ(pixels_of_hue(picture.copy(edge), body), 0) << step << " at " << size.width();
      }
    }
  }
}

}  // namespace
}  // namespace abrazo::widgets::scene_camera_test
