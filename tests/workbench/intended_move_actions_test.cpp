// The user's role and the intended move in the whole window.
#include <QListWidget>
#include <QToolButton>

#include "app/workbench/solve/intended_move_desk.hpp"
#include "tests/workbench/demo_window.hpp"
#include "widgets/candidates/candidate_table.hpp"
#include "widgets/intended/intended_move_popup.hpp"
#include "widgets/settings/settings_panel.hpp"
#include "widgets/timeline/timeline_view.hpp"
#include "widgets/timeline/transport_bar.hpp"

namespace abrazo::app::intended_move_actions_test {
namespace {

class IntendedMoveActions : public DemoWindow {
 protected:
  static void SetUpTestSuite() { showDemo({1400, 900}); }
  static IntendedMoveDesk& desk() { return *window().findChild<IntendedMoveDesk*>(); }
  static FrameSnapshotPtr newest() { return window().session()->latest().newest(); }
};

TEST_F(IntendedMoveActions, ADigitChoosesAndFromThenOnOnlyThatMoveIsSelected) {
  press(Qt::Key_W);
  ASSERT_TRUE(desk().popup().isVisible());
  ASSERT_FALSE(desk().popup().choices().empty());
  const widgets::IntendedMoveChoice first = desk().popup().choices().front();
  EXPECT_FALSE(first.is_take()) << "moves come before takes";
  EXPECT_GE(first.distance_m, 0);
  QTest::keyClick(desk().popup().findChild<QListWidget*>(), Qt::Key_1);
  EXPECT_FALSE(desk().popup().isVisible());
  ASSERT_TRUE(window().document().decisions().meant);
  EXPECT_EQ(window().document().decisions().meant->label, first.label);
  EXPECT_TRUE(desk().chip().isVisible());
  EXPECT_TRUE(desk().chip().text().startsWith("intended: "));
  EXPECT_TRUE(until([] { return newest()->decisions && newest()->decisions->meant; }));
  const auto& library = *window().session()->material().library;
  const FrameSnapshotPtr frame = newest();
  ASSERT_GE(frame->result.selected, 0);
  const int pair = frame->result.candidates[static_cast<std::size_t>(frame->result.selected)].pair;
  EXPECT_EQ(library.label(pair), first.label);
  press(Qt::Key_W);
  EXPECT_FALSE(window().document().decisions().meant) << "again takes it back";
  EXPECT_FALSE(desk().chip().isVisible());
  EXPECT_TRUE(until([] { return !newest()->decisions || !newest()->decisions->meant; }));
}

TEST_F(IntendedMoveActions, EscapeLeavesItAndUndoTakesItBack) {
  desk().offer();
  QTest::keyClick(desk().popup().findChild<QListWidget*>(), Qt::Key_Escape);
  EXPECT_FALSE(desk().popup().isVisible());
  EXPECT_FALSE(window().document().decisions().meant);
  desk().offer();
  QTest::keyClick(desk().popup().findChild<QListWidget*>(), Qt::Key_Return);
  ASSERT_TRUE(window().document().decisions().meant);
  window().undoStack().undo();
  EXPECT_FALSE(window().document().decisions().meant);
}

TEST_F(IntendedMoveActions, TheRoleIsSwitchedByKeyAndShown) {
  ASSERT_TRUE(window().transport().roleText().startsWith("user leads"))
      << window().transport().roleText().toStdString();
  press(Qt::Key_U);
  EXPECT_TRUE(until([] { return newest()->settings.user_role == UserRole::Passive; }));
  EXPECT_TRUE(until([] { return window().transport().roleText().startsWith("user follows"); }));
  EXPECT_TRUE(until([] {
    const auto& roles = window().timeline().tracks().user_roles();
    return !roles.empty() && roles.back().key == 0;
  }));
  press(Qt::Key_U);
  EXPECT_TRUE(until([] { return newest()->settings.user_role == UserRole::Active; }));
}

TEST_F(IntendedMoveActions, WhoDecidesAboutTheRoleIsChosenAndTheHandTakesItBack) {
  action("Role by who leads")->trigger();
  EXPECT_TRUE(
      until([] { return newest()->decisions && newest()->decisions->role_control == RoleControl::Leader; }));
  EXPECT_TRUE(until([] { return window().transport().roleText().contains("by who leads"); }));
  EXPECT_TRUE(action("Role by who leads")->isChecked());
  press(Qt::Key_U);
  EXPECT_TRUE(action("Role by hand")->isChecked());
  window().document().changeSetting("user-role", "active");
}

}  // namespace
}  // namespace abrazo::app::intended_move_actions_test
