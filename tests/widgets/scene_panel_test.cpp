// The panels beside the scene: what they ask for.
#include <gtest/gtest.h>

#include <QDoubleSpinBox>
#include <QHelpEvent>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSlider>
#include <QTest>
#include <QToolButton>
#include <QToolTip>
#include <algorithm>

#include "core/motion/body/joint_set.hpp"
#include "widgets/scene/panel/character_rows.hpp"
#include "widgets/scene/panel/scene_options_panel.hpp"
#include "widgets/scene/panel/scene_tree.hpp"

namespace abrazo::widgets::scene_panel_test {
namespace {

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

TEST(SceneOptionsPanel, AsksForARangeOfValuesInTheirUnit) {
  SceneOptionsPanel panel(nullptr);
  SceneOptions asked;
  QObject::connect(&panel, &SceneOptionsPanel::optionsRequested,
                   [&asked](const SceneOptions& options) { asked = options; });
  for (auto* box : panel.findChildren<QDoubleSpinBox*>())
    if (box->accessibleName() == "Least value") {
      panel.setUnit("mm");
      EXPECT_EQ(box->text().toStdString(), "any");
      box->setValue(4.5);
      EXPECT_EQ(box->text().toStdString(), "4.50 mm");
    }
  EXPECT_DOUBLE_EQ(asked.least_value, 4.5);
  EXPECT_EQ(asked.most_value, MeshFilter::no_limit) << "the upper end is open";
  EXPECT_TRUE(asked.filters());
}

TEST(SceneOptionsPanel, SaysTheValueBesideEachSlider) {
  SceneOptionsPanel panel(nullptr);
  SceneOptions options;
  options.apart = 0.4;
  options.cuts = options.cut_in_world = true;
  options.cut_m = 0.25;
  options.cut_azimuth_rad = 0.5235987756;
  panel.setOptions(options);
  const auto says = [&panel](const QString& text) {
    return std::ranges::any_of(panel.findChildren<QLabel*>(),
                               [&](const QLabel* label) { return label->text() == text; });
  };
  EXPECT_TRUE(says("40 %"));
  EXPECT_TRUE(says("+0.25 m"));
  EXPECT_TRUE(says("30°"));
  EXPECT_TRUE(says("0°"));
  panel.findChildren<QSlider*>().front()->setValue(150);
  EXPECT_TRUE(says("150 %"));
}

TEST(CharacterRows, NameTheFileAndTakeItOff) {
  CharacterRows rows;
  rows.show();
  const auto names = rows.findChildren<QPushButton*>();
  const auto off = rows.findChildren<QToolButton*>();
  ASSERT_EQ(names.size(), 2);
  EXPECT_EQ(names[1]->text(), "Character…");
  EXPECT_FALSE(off[1]->isVisible());
  rows.setFiles({"", "/figures/ana.vrm"});
  EXPECT_EQ(names[0]->text(), "Character…");
  EXPECT_EQ(names[1]->text(), "ana.vrm");
  EXPECT_TRUE(off[1]->isVisible());
  int chosen = -1, taken = -1;
  QObject::connect(&rows, &CharacterRows::characterRequested, [&](int body) { chosen = body; });
  QObject::connect(&rows, &CharacterRows::capsulesRequested, [&](int body) { taken = body; });
  names[0]->click();
  off[1]->click();
  EXPECT_EQ(chosen, 0);
  EXPECT_EQ(taken, 1);
  EXPECT_EQ(names[1]->text(), "ana.vrm") << "it only asks";
}

TEST(SceneTree, OpensACharacterAndSelectsItsJoints) {
  SceneTree tree;
  tree.resize(260, 500);
  tree.show();
  std::vector<Selection> asked;
  QObject::connect(&tree, &SceneTree::selectionRequested, [&](const Selection& s) {
    asked.push_back(s);
    tree.showSelection(s);
  });
  const auto click = [&tree](int x, int row, Qt::KeyboardModifiers keys = {}) {
    QTest::mouseClick(&tree.list(), Qt::LeftButton, keys, {x, 22 * row + 11});
  };
  click(tree.list().width() - 8, 2);  // the arrow of the leader
  ASSERT_EQ(tree.list().rows()[3].vertex, 0);
  click(60, 3);
  click(60, 5, Qt::ShiftModifier);
  ASSERT_EQ(asked.size(), 2U);
  EXPECT_EQ(asked[0], Selection::joint(0));
  EXPECT_EQ(asked[1].vertices, (std::vector<std::uint8_t>{0, 2}));
  tree.findChild<QLineEdit*>()->setText("follower lhand");
  ASSERT_EQ(tree.list().rows().size(), 1U);
  click(60, 0);
  EXPECT_EQ(asked.back(), Selection::joint(joint_count + joints::left_hand));
}

TEST(SceneTree, IsWorkedByKeysAndSaysTheRow) {
  SceneTree tree;
  tree.resize(260, 500);
  tree.show();
  PartVisibility asked{};
  QObject::connect(&tree, &SceneTree::visibilityRequested, [&asked](const PartVisibility& v) { asked = v; });
  QTest::keyClick(&tree.list(), Qt::Key_Down);
  QTest::keyClick(&tree.list(), Qt::Key_Down);
  QTest::keyClick(&tree.list(), Qt::Key_Down);
  EXPECT_EQ(tree.list().accessibleDescription(), QString("Leader, shown"));
  QTest::keyClick(&tree.list(), Qt::Key_Return);
  EXPECT_FALSE(asked[static_cast<std::size_t>(ScenePart::Leader)]);
  QTest::keyClick(&tree.list(), Qt::Key_Plus);
  EXPECT_EQ(tree.list().rows().size(), part_rows().size() + joint_count);
}

TEST(SceneTree, ExplainsTheRowUnderThePointer) {
  SceneTree tree;
  tree.resize(260, 500);
  tree.show();
  const auto& rows = tree.list().rows();
  const auto row = std::ranges::find(rows, std::string("Look-ahead"), &TreeRow::name) - rows.begin();
  const QPoint at(60, static_cast<int>(row) * SceneTreeList::row_height + 11);
  QHelpEvent help(QEvent::ToolTip, at, tree.list().mapToGlobal(at));
  QApplication::sendEvent(&tree.list(), &help);
  EXPECT_TRUE(QToolTip::text().contains("next second")) << QToolTip::text().toStdString();
  QToolTip::hideText();
}

TEST(SceneTree, AsksToHideWhatIsClicked) {
  SceneTree tree;
  tree.resize(260, 500);
  tree.show();
  PartVisibility asked{};
  QObject::connect(&tree, &SceneTree::visibilityRequested, [&asked](const PartVisibility& v) { asked = v; });
  QTest::mouseClick(&tree.list(), Qt::LeftButton, {}, {40, 22 + 11});  // "Result": both characters
  EXPECT_FALSE(asked[static_cast<std::size_t>(ScenePart::Leader)]);
  EXPECT_FALSE(asked[static_cast<std::size_t>(ScenePart::Follower)]);
  EXPECT_TRUE(asked[static_cast<std::size_t>(ScenePart::Floor)]);
}

}  // namespace
}  // namespace abrazo::widgets::scene_panel_test
