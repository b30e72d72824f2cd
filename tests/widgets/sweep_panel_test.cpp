#include "widgets/sweep/sweep_panel.hpp"

#include <gtest/gtest.h>

#include <QApplication>
#include <QComboBox>
#include <QLabel>
#include <QMouseEvent>
#include <QPushButton>
#include <QSignalSpy>
#include <QStandardItemModel>
#include <QTest>

#include "tests/widgets/pictures.hpp"
#include "widgets/sweep/heat_map.hpp"
#include "widgets/sweep/sweep_form.hpp"

namespace abrazo::widgets::sweep_panel_test {
namespace {

using State = SweepCell::State;

/// Three columns, two rows; values rise from the lower left, one cell failed, one has no value.
SweepGrid some_grid() {
  SweepGrid grid({"alpha", "\u03b1", "", {"0", "0.5", "1"}},
                 {"velocity-weight", "w_\u0394", "", {"0.1", "0.2"}}, "partner.mean_joint_error_m",
                 SweepGoal::Lowest);
  grid.set(0, {State::Measured, 0.1, {}});
  grid.set(1, {State::Measured, 0.2, {}});
  grid.set(2, {State::Measured, 0.3, {}});
  grid.set(3, {State::Failed, 0, "no step could be solved"});
  grid.set(4, {State::Undefined, 0, {}});
  return grid;
}

struct Map {
  HeatMap map;
  Map() {
    map.setColours(palette_of(Theme::Dark));
    map.resize(560, 380);
    map.showGrid(some_grid());
    map.show();
    (void)QTest::qWaitForWindowExposed(&map, 1000);
  }
  QPoint middle(int point) const { return map.cellRect(point).center().toPoint(); }
};

QColor near_corner(const QImage& picture, const QRectF& cell) {
  const double scale = picture.devicePixelRatio();
  return picture.pixelColor((cell.topLeft() * scale + QPointF(6, 6)).toPoint());
}

TEST(HeatMap, ColoursRunFromTheLowestToTheHighestAndYGrowsUpwards) {
  Map m;
  const QImage picture = test::picture_of(m.map);
  const auto like = [](const QColor& a, const std::array<double, 3>& b) {
    return std::abs(a.redF() - b[0]) + std::abs(a.greenF() - b[1]) + std::abs(a.blueF() - b[2]) < 0.1;
  };
  EXPECT_TRUE(like(near_corner(picture, m.map.cellRect(0)), sweep_colour(0)));
  EXPECT_TRUE(like(near_corner(picture, m.map.cellRect(1)), sweep_colour(0.5)));
  EXPECT_TRUE(like(near_corner(picture, m.map.cellRect(2)), sweep_colour(1)));
  EXPECT_GT(m.map.cellRect(0).top(), m.map.cellRect(3).top());
}

TEST(HeatMap, ARingMarksTheBestAndHatchingWhatHasNoValue) {
  Map m;
  const QImage marked = test::picture_of(m.map);
  SweepGrid other = some_grid();
  other.set(1, {State::Measured, 0.05, {}});
  other.set(3, {State::Waiting, 0, {}});
  m.map.showGrid(other);
  const QImage moved = test::picture_of(m.map);
  const double scale = marked.devicePixelRatio();
  const auto part = [&](const QImage& picture, int point) {
    const QRectF cell = m.map.cellRect(point);
    return picture.copy(QRectF(cell.topLeft() * scale, cell.size() * scale).toRect());
  };
  EXPECT_GT(test::pixels_like(part(marked, 0), Qt::white), test::pixels_like(part(moved, 0), Qt::white) + 40);
  EXPECT_GT(test::pixels_of_hue(part(marked, 3), palette_of(Theme::Dark).warning), 60);
  EXPECT_EQ(test::pixels_of_hue(part(moved, 3), palette_of(Theme::Dark).warning), 0);
}

TEST(HeatMap, AClickSelectsAndTheArrowKeysMoveOverTheCells) {
  Map m;
  QSignalSpy chosen(&m.map, &HeatMap::selectionChanged), adopted(&m.map, &HeatMap::adoptRequested);
  QTest::mouseClick(&m.map, Qt::LeftButton, {}, m.middle(1));
  EXPECT_EQ(m.map.selected(), 1);
  QTest::keyClick(&m.map, Qt::Key_Right);
  EXPECT_EQ(m.map.selected(), 2);
  QTest::keyClick(&m.map, Qt::Key_Up);
  EXPECT_EQ(m.map.selected(), 5);
  QTest::keyClick(&m.map, Qt::Key_Up);
  EXPECT_EQ(m.map.selected(), 5);
  QTest::keyClick(&m.map, Qt::Key_Left);
  QTest::keyClick(&m.map, Qt::Key_Down);
  EXPECT_EQ(m.map.selected(), 1);
  EXPECT_EQ(chosen.count(), 5);
  QTest::keyClick(&m.map, Qt::Key_Return);
  ASSERT_EQ(adopted.count(), 1);
  EXPECT_EQ(adopted[0][0].toInt(), 1);
  EXPECT_TRUE(m.map.accessibleDescription().contains("0.2 m")) << m.map.accessibleDescription().toStdString();
}

TEST(HeatMap, TheFirstKeyGoesToTheBestCell) {
  Map m;
  QTest::keyClick(&m.map, Qt::Key_Right);
  EXPECT_EQ(m.map.selected(), 0);
}

TEST(HeatMap, ThePointerTellsTheCellUnderIt) {
  Map m;
  QSignalSpy hovered(&m.map, &HeatMap::hovered);
  QMouseEvent move(QEvent::MouseMove, QPointF(m.middle(2)), QPointF(m.middle(2)), Qt::NoButton, {}, {});
  QApplication::sendEvent(&m.map, &move);
  ASSERT_EQ(hovered.count(), 1);
  EXPECT_EQ(hovered[0][0].toInt(), 2);
}

TEST(HeatMap, AGridOfAnotherSizeDropsTheSelection) {
  Map m;
  m.map.select(4);
  SweepGrid same = some_grid();
  m.map.showGrid(same);
  EXPECT_EQ(m.map.selected(), 4);
  m.map.showGrid(SweepGrid({"alpha", "", "", {"1"}}, {"k", "", "", {"1"}}, "moves.rate", SweepGoal::Highest));
  EXPECT_EQ(m.map.selected(), -1);
}

TEST(SweepForm, AsksForWhatIsChosen) {
  SweepForm form;
  form.setMetrics({"moves.rate", "partner.lag_ms"}, "partner.lag_ms");
  form.setTakes({"one", "two"});
  Settings settings = *preset("paper");
  form.setSettings(settings);
  SweepRequest request = form.request();
  EXPECT_EQ(request.x, "alpha=0:2:5");
  EXPECT_EQ(request.y, "velocity-weight=0:0.8:5");
  EXPECT_EQ(request.metric, "partner.lag_ms");
  EXPECT_TRUE(request.takes.empty()) << "all";
  form.setColumns("velocity-weight");
  request = form.request();
  EXPECT_TRUE(QString::fromStdString(request.x).startsWith("velocity-weight="));
  EXPECT_TRUE(QString::fromStdString(request.y).startsWith("alpha=")) << "the sides change places";
  form.setColumns("edge-weights");
  EXPECT_EQ(form.request().x, "edge-weights=inverse,inverse-mean,uniform");
}

TEST(SweepForm, DoesNotOfferASettingWithoutEffectAndSaysWhy) {
  SweepForm form;
  auto* columns = form.findChild<QComboBox*>();
  const auto item = [columns](const char* key) {
    return qobject_cast<QStandardItemModel*>(columns->model())->item(columns->findData(key));
  };
  form.setSettings(*preset("paper"));
  EXPECT_FALSE(item("switch-margin")->isEnabled());
  EXPECT_TRUE(item("switch-margin")->toolTip().contains("Only with the method intent"));
  EXPECT_TRUE(item("alpha")->isEnabled());
  form.setColumns("morph-steps");
  form.setSettings(*preset("responsive"));
  EXPECT_TRUE(item("switch-margin")->isEnabled());
  EXPECT_TRUE(item("switch-margin")->toolTip().isEmpty());
  EXPECT_TRUE(item("alpha")->isEnabled()) << "the temporal terms of both methods";
  EXPECT_FALSE(item("morph-steps")->isEnabled());
  bool said = false;
  for (const QLabel* label : form.findChildren<QLabel*>()) said = said || label->text() == "no effect now";
  EXPECT_TRUE(said) << "it was chosen before";
}

TEST(SweepPanel, StartsWhatTheFormAsksForAndTheButtonCancelsWhileItRuns) {
  SweepPanel panel;
  int started = 0;
  QObject::connect(&panel, &SweepPanel::startRequested, [&started](const SweepRequest&) { ++started; });
  QSignalSpy cancelled(&panel, &SweepPanel::cancelRequested);
  auto* start = panel.findChild<QPushButton*>("startSweep");
  panel.showEstimate("give two settings", false);
  EXPECT_FALSE(start->isEnabled());
  panel.showEstimate("25 cells", true);
  start->click();
  EXPECT_EQ(started, 1);
  panel.setRunning(true);
  EXPECT_EQ(start->text(), "Cancel");
  start->click();
  EXPECT_EQ(cancelled.count(), 1);
  for (QComboBox* list : panel.form().findChildren<QComboBox*>())
    EXPECT_EQ(list->isEnabled(), list->accessibleName().contains("Figure"))
        << "only the figure can be changed";
}

TEST(SweepPanel, OffersToAdoptOnceACellIsSelectedAndToExportOnceThereIsAValue) {
  SweepPanel panel;
  auto* adopt = panel.findChild<QPushButton*>("adoptCell");
  auto* save = panel.findChild<QPushButton*>("exportSweep");
  EXPECT_FALSE(adopt->isEnabled());
  EXPECT_FALSE(save->isEnabled());
  panel.showGrid(some_grid());
  EXPECT_FALSE(adopt->isEnabled());
  EXPECT_TRUE(save->isEnabled());
  panel.map().select(2);
  EXPECT_TRUE(adopt->isEnabled());
  QSignalSpy adopted(&panel, &SweepPanel::adoptRequested);
  adopt->click();
  ASSERT_EQ(adopted.count(), 1);
  EXPECT_EQ(adopted[0][0].toInt(), 2);
}

TEST(SweepPanel, EveryControlOfTheFormHasAName) {
  SweepPanel panel;
  for (QWidget* control : panel.findChildren<QWidget*>()) {
    const bool is_control = control->inherits("QComboBox") || control->inherits("QAbstractSpinBox") ||
                            (control->inherits("QLineEdit") && !control->parent()->inherits("QSpinBox"));
    EXPECT_TRUE(!is_control || !control->accessibleName().isEmpty()) << control->metaObject()->className();
  }
  EXPECT_FALSE(panel.map().accessibleName().isEmpty());
}

}  // namespace
}  // namespace abrazo::widgets::sweep_panel_test
