// Moves that can be intended: their order, their words, and how one is chosen.
#include <gtest/gtest.h>

#include <QListWidget>
#include <QSignalSpy>
#include <QTest>
#include <QVBoxLayout>

#include "tests/widgets/pictures.hpp"
#include "widgets/intended/intended_move_choice.hpp"
#include "widgets/intended/intended_move_popup.hpp"

namespace abrazo::widgets::intended_move_test {
namespace {

TEST(IntendedMoveChoice, IsAMoveOrATakeForSoLong) {
  const IntendedMove turn = meant_move({"turn", "", 20, 0.1}, IntendedMoveSpan::FiveSeconds, 12);
  EXPECT_EQ(turn.label, "turn");
  EXPECT_FALSE(turn.take);
  EXPECT_DOUBLE_EQ(turn.until_s, 17);
  EXPECT_FALSE(turn.until_done);
  const IntendedMove take = meant_move({"", "salsa_02", 20, 0.1}, IntendedMoveSpan::UntilDone, 12);
  EXPECT_EQ(take.take, "salsa_02");
  EXPECT_FALSE(take.label);
  EXPECT_LT(take.until_s, 0);
  EXPECT_TRUE(take.until_done);
  EXPECT_LT(meant_move({"turn", "", 20, 0.1}, IntendedMoveSpan::UntilTakenBack, 12).until_s, 0);
}

TEST(IntendedMoveChoice, MovesComeBeforeTakesAndTheNearestFirst) {
  const auto ordered = in_order({{"", "salsa_01", 9, 0.1},
                                 {"hold", "", 9, -1},
                                 {"turn", "", 9, 0.4},
                                 {"walk", "", 9, 0.2},
                                 {"", "salsa_02", 9, -1}});
  std::vector<std::string> titles;
  for (const IntendedMoveChoice& choice : ordered) titles.push_back(choice_title(choice));
  EXPECT_EQ(titles, (std::vector<std::string>{"walk", "turn", "hold", "take salsa_01", "take salsa_02"}));
}

TEST(IntendedMoveChoice, IsWrittenInWords) {
  EXPECT_EQ(choice_title({"cross_body_lead", "", 1, 0}), "cross body lead");
  EXPECT_EQ(choice_title({"", "", 1, 0}), "no label");
  EXPECT_EQ(distance_text(0.1234), "0.12 m");
  EXPECT_EQ(distance_text(0.0123), "0.012 m");
  EXPECT_EQ(distance_text(-1), "");
}

TEST(IntendedMoveChoice, HasADigitUpToTheNinth) {
  EXPECT_EQ(choice_of_digit(1, 3), 0U);
  EXPECT_EQ(choice_of_digit(3, 3), 2U);
  EXPECT_FALSE(choice_of_digit(4, 3));
  EXPECT_FALSE(choice_of_digit(0, 3));
}

class IntendedMovePopupTest : public testing::Test {
 protected:
  IntendedMovePopupTest() : scene(&window), popup(&window) {
    window.resize(900, 600);
    scene.setGeometry(100, 50, 700, 500);
    popup.setColours(palette_of(Theme::Dark));
    popup.setChoices({{"turn", "", 20, 0.1}, {"hold", "", 40, 0.3}, {"", "salsa_01", 60, 0.2}});
    window.show();
    popup.openOver(scene);
  }
  QListWidget* list() { return popup.findChild<QListWidget*>(); }

  QWidget window, scene;
  IntendedMovePopup popup;
};

TEST_F(IntendedMovePopupTest, OpensOverTheSceneAndADigitChooses) {
  EXPECT_TRUE(popup.isVisible());
  EXPECT_TRUE(scene.geometry().contains(popup.geometry()));
  QSignalSpy chosen(&popup, &IntendedMovePopup::chosen);
  popup.setSpan(IntendedMoveSpan::TenSeconds);
  QTest::keyClick(list(), Qt::Key_2);
  ASSERT_EQ(chosen.count(), 1);
  EXPECT_EQ(chosen[0][0].value<IntendedMoveChoice>().label, "hold");
  EXPECT_EQ(chosen[0][1].value<IntendedMoveSpan>(), IntendedMoveSpan::TenSeconds);
  EXPECT_FALSE(popup.isVisible());
}

TEST_F(IntendedMovePopupTest, AnEmptyDigitChoosesNothingAndEscapeLeaves) {
  QSignalSpy chosen(&popup, &IntendedMovePopup::chosen);
  QTest::keyClick(list(), Qt::Key_9);
  EXPECT_TRUE(popup.isVisible());
  QTest::keyClick(list(), Qt::Key_Escape);
  EXPECT_FALSE(popup.isVisible());
  EXPECT_EQ(chosen.count(), 0);
}

TEST_F(IntendedMovePopupTest, TheMarkedRowStaysTheSameChoice) {
  list()->setCurrentRow(1);
  popup.setChoices({{"hold", "", 40, 0.05}, {"turn", "", 20, 0.1}, {"", "salsa_01", 60, 0.2}});
  EXPECT_EQ(list()->currentRow(), 0);
  QSignalSpy chosen(&popup, &IntendedMovePopup::chosen);
  QTest::keyClick(list(), Qt::Key_Return);
  EXPECT_EQ(chosen[0][0].value<IntendedMoveChoice>().label, "hold");
}

TEST_F(IntendedMovePopupTest, RowsAreDrawnWithTheColourOfTheirMove) {
  const QImage picture = test::picture_of(popup);
  EXPECT_GT(test::pixels_like(picture, label_colour(palette_of(Theme::Dark), "turn")), 20);
}

}  // namespace
}  // namespace abrazo::widgets::intended_move_test
