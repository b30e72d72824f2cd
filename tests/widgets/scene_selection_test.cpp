// What a person selects in the scene, and what is marked and shown of it.
#include <gtest/gtest.h>

#include <QSignalSpy>
#include <QTableView>
#include <QTest>
#include <algorithm>

#include "core/motion/body/joint_set.hpp"
#include "tests/widgets/pictures.hpp"
#include "tests/widgets/scene_fixture.hpp"
#include "tests/widgets/synthetic_frames.hpp"
#include "widgets/scene/panel/scalar_legend.hpp"
#include "widgets/scene/panel/scene_overlay.hpp"
#include "widgets/scene/pick/part_table_view.hpp"
#include "widgets/scene/values/picture_projection.hpp"
#include "widgets/scene/view/scene_view.hpp"

namespace abrazo::widgets::scene_selection_test {
namespace {

using scene_fixture::dark;
using scene_fixture::middle_of;
using scene_fixture::place_of;
using scene_fixture::Scene;
using test::difference;
using test::picture_of;
using test::pixels_of_hue;
using test::synthetic_frame;

TEST(PartTableView, ShowsMillimetresAndSharesToTheHundredthAndMetresToATenthOfAMillimetre) {
  PartTableView table;
  table.setKind(TableOf::Edges);
  table.showFrame(synthetic_frame(1, 0.1), nullptr);
  const QStringList lines = table.copied().split('\n', Qt::SkipEmptyParts);
  ASSERT_GT(lines.size(), 1);
  const QStringList names = lines[0].split('\t'), values = lines[1].split('\t');
  ASSERT_EQ(names.size(), values.size());
  for (int column = 1; column < names.size(); ++column) {
    if (values[column] == "–") continue;
    const int decimals = names[column].contains("[mm]") || names[column].contains("[%]") ? 2 : 4;
    EXPECT_EQ(values[column].section('.', 1).size(), decimals) << names[column].toStdString();
  }
}

TEST(PartTableView, SortsByNumbersAndTheChosenPartStaysChosen) {
  PartTableView table;
  table.setKind(TableOf::Edges);
  table.showFrame(synthetic_frame(1, 0.1), nullptr);
  const auto lengths = [&table] {
    std::vector<double> found;
    for (const PartTable::Row& row : table.shown().rows) found.push_back(row.values.front());
    return found;
  };
  table.table().sortByColumn(1, Qt::DescendingOrder);
  const std::vector<double> falling = lengths();
  EXPECT_TRUE(std::is_sorted(falling.rbegin(), falling.rend()));
  Selection asked;
  QObject::connect(&table, &PartTableView::selectionRequested,
                   [&asked](const Selection& selection) { asked = selection; });
  table.table().selectRow(2);
  EXPECT_EQ(asked, table.shown().rows[2].item);
  const std::string name = table.shown().rows[2].name;
  const auto chosen = [&table] {
    return table.shown()
        .rows[static_cast<std::size_t>(table.table().selectionModel()->selectedRows().at(0).row())]
        .name;
  };
  table.table().sortByColumn(1, Qt::AscendingOrder);
  const std::vector<double> rising = lengths();
  EXPECT_TRUE(std::is_sorted(rising.begin(), rising.end()));
  EXPECT_EQ(chosen(), name);
  table.showFrame(synthetic_frame(0, 0.05), nullptr);  // back in time: at once
  EXPECT_EQ(chosen(), name);
  EXPECT_EQ(asked, table.shown().rows[static_cast<std::size_t>(table.table().currentIndex().row())].item);
}

TEST(PartTableView, CopiesTheChosenRowsAndOtherwiseAll) {
  PartTableView table;
  table.setKind(TableOf::Edges);
  table.showFrame(synthetic_frame(1, 0.1), nullptr);
  const auto lines = [&table] { return table.copied().split('\n', Qt::SkipEmptyParts); };
  const QStringList all = lines();
  EXPECT_EQ(static_cast<std::size_t>(all.size()), 1 + table.shown().rows.size());
  int asked = 0;
  QObject::connect(&table, &PartTableView::selectionRequested, [&asked] { ++asked; });
  table.table().selectRow(1);
  EXPECT_EQ(lines(), QStringList({all[0], all[2]}));
  table.table().selectionModel()->select(table.table().model()->index(4, 0),
                                         QItemSelectionModel::Select | QItemSelectionModel::Rows);
  EXPECT_EQ(lines(), QStringList({all[0], all[2], all[5]}));
  EXPECT_EQ(asked, 1) << "several are not one selection of the scene";
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

/// The card of the selection lay over the words about the frame at the lower left.
TEST(SceneView, KeepsItsCardsOffTheWordsAboutTheFrame) {
  Scene scene({ScenePart::Joints});
  const auto* facts = scene.view.findChild<FrameFacts*>();
  const auto* selected = scene.view.findChild<QWidget*>("selected");
  const auto* hovered = scene.view.findChild<QWidget*>("hovered");
  scene.model.select(Selection::joint(joints::Head));
  for (const QSize size : {QSize(320, 220), QSize(330, 500), QSize(640, 480), QSize(1100, 300)}) {
    scene.view.resize(size);
    picture_of(scene.view);
    ASSERT_TRUE(selected->isVisible());
    EXPECT_FALSE(selected->geometry().intersects(facts->geometry())) << size.width() << "x" << size.height();
    EXPECT_GE(selected->y(), 0) << size.height();
    const QPoint foot = place_of(scene.view, synthetic_frame(3, 0.05), joints::left_toe_tip);
    QMouseEvent move(QEvent::MouseMove, foot, Qt::NoButton, Qt::NoButton, {});
    QApplication::sendEvent(scene.view.childAt(scene.view.rect().center()), &move);
    EXPECT_FALSE(hovered->isVisible() && hovered->geometry().intersects(facts->geometry())) << size.height();
  }
  EXPECT_TRUE(hovered->isVisible()) << "the last size shows the foot";
}

/// In a window of 640x400 the card lay over the legend, its range, its lock and its menu.
TEST(SceneView, KeepsTheCardOfTheSelectionOffLegendAndButtonsInALowPicture) {
  Scene scene({ScenePart::Joints});
  scene.model.select(Selection::joint(joints::Head));
  const auto* card = scene.view.findChild<QWidget*>("selected");
  int whole = 0;
  for (const QSize size : {QSize(1100, 600), QSize(640, 206), QSize(540, 420), QSize(800, 230)}) {
    scene.view.resize(size);
    picture_of(scene.view);
    ASSERT_TRUE(card->isVisible());
    whole = std::max(whole, card->height());
    for (const auto* legend : scene.view.findChildren<ScalarLegend*>()) {
      const bool covers = legend->isVisible() && card->geometry().intersects(legend->geometry());
      EXPECT_FALSE(covers) << size.width() << "x" << size.height();
    }
    EXPECT_FALSE(card->geometry().intersects(scene.view.findChild<ScalarChips*>()->geometry()))
        << size.width();
    EXPECT_FALSE(card->geometry().intersects(scene.view.findChild<FrameFacts*>()->geometry()))
        << size.width();
  }
  scene.view.resize(1100, 600);
  picture_of(scene.view);
  EXPECT_EQ(card->height(), whole) << "all lines where there is room";
}

/// In a window of 640x400 the card under the pointer lay over the legend.
TEST(SceneView, KeepsTheCardOfAnEdgeInsideThePictureAndOffTheLegend) {
  Scene scene({ScenePart::MeshBetween, ScenePart::MeshWithin});
  QWidget* surface = scene.surface();
  const auto* card = scene.view.findChild<QWidget*>("hovered");
  const FrameSnapshotPtr frame = synthetic_frame(3, 0.05);
  for (const QSize size : {QSize(640, 206), QSize(540, 420), QSize(320, 420)}) {
    scene.view.resize(size);
    picture_of(scene.view);
    int seen = 0;
    for (std::size_t e = 0; e < frame->result.edges.size(); e += 7) {
      const MeshEdge& edge = frame->result.edges[e];
      const QPointF middle =
          0.5 * QPointF(place_of(scene.view, frame, edge[0]) + place_of(scene.view, frame, edge[1]));
      QMouseEvent move(QEvent::MouseMove, middle, Qt::NoButton, Qt::NoButton, {});
      QApplication::sendEvent(surface, &move);
      if (!card->isVisible()) continue;
      ++seen;
      EXPECT_TRUE(scene.view.rect().contains(card->geometry())) << size.width();
      for (const auto* legend : scene.view.findChildren<ScalarLegend*>()) {
        const bool covers = legend->isVisible() && card->geometry().intersects(legend->geometry());
        EXPECT_FALSE(covers) << size.width() << "x" << size.height();
      }
    }
    EXPECT_GT(seen, 0) << size.width();
  }
}

/// It was cut off at the left.
TEST(SceneView, BreaksTheLinesOfACardThatIsWiderThanThePicture) {
  Scene scene({});
  const auto* card = scene.view.findChild<QWidget*>("selected");
  scene.model.select(Selection::candidate(0));
  scene.view.resize(800, 480);
  picture_of(scene.view);
  ASSERT_TRUE(card->isVisible());
  const QSize whole = card->size();
  ASSERT_GT(whole.width(), 300);
  scene.view.resize(320, 480);
  picture_of(scene.view);
  EXPECT_TRUE(scene.view.rect().contains(card->geometry()));
  EXPECT_GT(card->height(), whole.height()) << "no line is lost";
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

}  // namespace
}  // namespace abrazo::widgets::scene_selection_test
