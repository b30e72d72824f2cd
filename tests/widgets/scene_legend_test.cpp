// Colours of the mesh, their ranges and their legend.
#include <gtest/gtest.h>

#include <QLineEdit>
#include <QTest>
#include <QToolButton>

#include <set>

#include "tests/widgets/pictures.hpp"
#include "tests/widgets/scene_fixture.hpp"
#include "tests/widgets/synthetic_frames.hpp"
#include "widgets/common/entry_frame.hpp"
#include "widgets/scene/panel/scalar_legend.hpp"
#include "widgets/scene/view/scene_view.hpp"

namespace abrazo::widgets::scene_legend_test {
namespace {

using scene_fixture::middle_of;
using scene_fixture::Scene;
using test::difference;
using test::picture_of;
using test::pixels_like;
using test::pixels_of_hue;
using test::synthetic_frame;

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

/// A bar of colours without a name was over the empty scene.
TEST(ScalarLegend, IsEmptyBeforeTheFirstScale) {
  QWidget ground;
  ground.setStyleSheet("background: #101010");
  ground.resize(220, 90);
  ScalarLegend legend(&ground);
  ground.show();
  const auto colours = [&ground] {
    const QImage picture = ground.grab().toImage();
    std::set<QRgb> seen;
    for (int x = 0; x < picture.width(); ++x)
      for (int y = 0; y < picture.height(); ++y) seen.insert(picture.pixel(x, y));
    return seen.size();
  };
  EXPECT_EQ(colours(), 1U);
  legend.show(scalar_legend(MeshScalar::Residual, ColourScale{}, false));
  EXPECT_GT(colours(), 8U);
}

/// The end of the scale could not be read in front of a head.
TEST(ScalarLegend, IsReadableOverABody) {
  for (const Theme theme : {Theme::Dark, Theme::Light}) {
    const Palette& palette = palette_of(theme);
    for (const QColor& body : {palette.active, palette.passive, palette.secondary}) {
      QWidget ground;
      ground.setStyleSheet("background: " + body.name());
      ground.resize(220, 90);
      ScalarLegend legend(&ground);
      legend.setColours(palette);
      ground.show();
      legend.show(scalar_legend(MeshScalar::Residual, {20}, false));
      const QPoint beside_the_low_end(80, 49);
      EXPECT_GT(contrast(palette.secondary, ground.grab().toImage().pixelColor(beside_the_low_end)), 3)
          << body.name().toStdString() << " in the " << (palette.dark ? "dark" : "light") << " theme";
    }
  }
}

TEST(ScalarLegend, HasNoButtonsInAPicture) {
  ScalarLegend legend(nullptr);
  const auto buttons = [&legend] {
    int seen = 0;
    for (const auto* button : legend.findChildren<QToolButton*>()) seen += button->isVisibleTo(&legend);
    return seen;
  };
  legend.show(scalar_legend(MeshScalar::Residual, {20}, false));
  EXPECT_EQ(buttons(), 1) << "the other one comes under the pointer";
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
  EXPECT_NE(set("30 to 24").find("as in 0 to 24"), std::string::npos) << "numbers of this scale";
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

TEST(SceneView, KeepsARangeLockForEachScalar) {
  Scene scene({ScenePart::MeshBetween});
  auto* lock = scene.view.findChild<ScalarLegend*>()->findChild<QToolButton*>();
  lock->click();
  scene.view.setScalar(MeshScalar::EnergyShare);
  EXPECT_FALSE(lock->isChecked());
  scene.view.setScalar(MeshScalar::Residual);
  EXPECT_TRUE(lock->isChecked());
}

TEST(SceneView, LimitsOfAValueEndWithItAndLimitsOfTheLengthStay) {
  Scene scene({ScenePart::MeshBetween});
  scene.change([](SceneOptions& options) {
    options.least_value = 5;
    options.most_value = 20;
    options.longest_m = 2;
  });
  scene.view.setScalar(MeshScalar::Residual);
  EXPECT_EQ(scene.view.options().least_value, 5) << "the same value";
  scene.view.setScalar(MeshScalar::Weight);
  EXPECT_EQ(scene.view.options().least_value, 0);
  EXPECT_EQ(scene.view.options().most_value, MeshFilter::no_limit);
  EXPECT_EQ(scene.view.options().longest_m, 2);
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
}  // namespace abrazo::widgets::scene_legend_test
