// The library browser with a small library and with one of a thousand takes.
#include <gtest/gtest.h>

#include <QAccessible>
#include <QHelpEvent>
#include <QLineEdit>
#include <QScrollBar>
#include <QSignalSpy>
#include <QTest>
#include <QToolButton>
#include <QToolTip>
#include <numeric>

#include "tests/support/libraries.hpp"
#include "tests/widgets/pictures.hpp"
#include "tests/widgets/synthetic_frames.hpp"
#include "widgets/library/take_delegate.hpp"
#include "widgets/library/take_list.hpp"
#include "widgets/library/take_model.hpp"
#include "widgets/library/take_view.hpp"

namespace abrazo::widgets::take_list_test {
namespace {

using test::difference;
using test::picture_of;
using test::pixels_like;
using test::pixels_of_hue;
using test::synthetic_frame;
using test::two_take_library;

/// The same two takes over and over under other names; only the first two have pairs.
std::shared_ptr<const MotionLibrary> thousand_takes(const MotionLibrary& library = *two_take_library()) {
  LibraryColumns columns = library.columns();
  for (int i = 2; i < 1000; ++i) {
    columns.takes.push_back(columns.takes[static_cast<std::size_t>(i % 2)]);
    columns.takes.back().name = "take_" + std::to_string(i);
  }
  return std::make_shared<const MotionLibrary>(std::move(columns));
}

/// A frame whose solver believes in one take of a library and in nothing else.
FrameIntent belief_in(const std::shared_ptr<const MotionLibrary>& library, std::uint32_t take) {
  std::vector<int> pairs(static_cast<std::size_t>(library->pair_count()));
  std::iota(pairs.begin(), pairs.end(), 0);
  FrameIntent intent;
  intent.model = IntentModel::learn(library, pairs);
  for (const BeliefBlock& block : intent.model->blocks())
    intent.belief.push_back(block.take == take ? 255 : 0);
  return intent;
}

class Browser : public testing::Test {
 protected:
  void open(std::shared_ptr<const MotionLibrary> library) {
    list.resize(262, 480);
    list.setLibrary(std::move(library));
    list.show();
    QTest::qWait(30);
  }
  QToolButton* button(const QString& name) {
    for (auto* one : list.findChildren<QToolButton*>())
      if (one->accessibleName() == name) return one;
    return nullptr;
  }
  /// Where a share of a row's strip is, in the view.
  QPoint on_strip(int row, double share) {
    const QRect strip = take_strip(list.view().visualRect(list.view().model()->index(row, 0)));
    return {strip.left() + static_cast<int>(share * strip.width()), strip.center().y()};
  }
  void key(int which, Qt::KeyboardModifiers modifiers = {}) {
    QTest::keyClick(&list.view(), static_cast<Qt::Key>(which), modifiers);
  }
  TakeList list;
};

TEST_F(Browser, ShowsMovesRolesAndUseOfATake) {
  open(two_take_library());
  const QRect row = list.view().visualRect(list.view().model()->index(0, 0));
  const auto picture = [&] { return picture_of(list.view()).copy(row); };
  const QImage before = picture();
  EXPECT_GT(pixels_of_hue(before, label_colour(palette_of(Theme::Dark), "turn"), 8), 300) << "its move";
  const QColor amber = palette_of(Theme::Dark).warning;
  EXPECT_EQ(pixels_like(before, amber), 0);
  FrameHistory history;
  history.append(synthetic_frame(0, 0));
  list.refresh(history);
  EXPECT_GT(pixels_like(picture(), amber), 4) << "what was selected";
}

TEST_F(Browser, PaintsBothBodiesOfATake) {
  open(two_take_library());
  const QRect row = list.view().visualRect(list.view().model()->index(0, 0));
  const QImage thumbnail = picture_of(list.view()).copy(row).copy(0, 0, 50, 42);
  EXPECT_GT(pixels_of_hue(thumbnail, palette_of(Theme::Dark).active), 20);
  EXPECT_GT(pixels_of_hue(thumbnail, palette_of(Theme::Dark).passive), 20);
}

TEST_F(Browser, SaysOfARowWhatItsStripShows) {
  open(two_take_library());
  const QString words = list.view().model()->index(0, 0).data(Qt::AccessibleTextRole).toString();
  for (const char* part : {"salsa_01", "frames", "moves", "lead", "selected 0 times"})
    EXPECT_TRUE(words.contains(part)) << part << " in " << words.toStdString();
  list.setUsersTake("salsa_01");
  list.setVetoedTakes({"salsa_02"});
  EXPECT_TRUE(
      list.view().model()->index(0, 0).data(Qt::AccessibleTextRole).toString().contains("plays the user"));
  EXPECT_TRUE(list.view().model()->index(1, 0).data(Qt::AccessibleTextRole).toString().contains("vetoed"));
}

TEST_F(Browser, FiltersByNameAndMoveAndSaysWhenNothingIsLeft) {
  open(two_take_library());
  auto* find = list.findChild<QLineEdit*>();
  find->setText("open hold");
  ASSERT_EQ(list.view().model()->rowCount(), 1);
  EXPECT_EQ(list.view().model()->index(0, 0).data().toString(), "salsa_02");
  find->setText("waltz");
  EXPECT_EQ(list.view().model()->rowCount(), 0);
  list.setSelectedTake(0);
  EXPECT_EQ(list.selectedTake(), 0) << "what is asked for is shown, whatever the filter";
}

TEST_F(Browser, ThePointerOnAStripShowsThatRecordedPair) {
  open(two_take_library());
  const QSignalSpy shown(&list, &TakeList::recordedShown);
  QTest::mouseMove(list.view().viewport(), on_strip(1, 0.5));
  ASSERT_TRUE(QTest::qWaitFor([&] { return !shown.isEmpty(); }, 2000));
  const int pair = shown.last()[0].toInt();
  ASSERT_GE(pair, 0);
  EXPECT_EQ(list.model().library()->source(pair).take, 1U);
  EXPECT_NEAR(list.model().library()->source(pair).frame, list.model().row(1).frames / 2, 1);
  QTest::mouseMove(list.view().viewport(), QPoint(20, 20));
  ASSERT_TRUE(QTest::qWaitFor([&] { return shown.last()[0].toInt() == -1; }, 2000));
}

TEST_F(Browser, ArrowsLookAlongTheChosenTake) {
  open(two_take_library());
  list.setSelectedTake(0);
  key(Qt::Key_Right);
  EXPECT_EQ(list.model().cursorTake(), 0);
  EXPECT_EQ(list.model().cursorFrame(), 0);
  key(Qt::Key_Right);
  EXPECT_EQ(list.model().cursorFrame(), 1);
  key(Qt::Key_Right, Qt::ShiftModifier);
  EXPECT_EQ(list.model().cursorFrame(), std::min(11, list.model().row(0).frames - 1));
  key(Qt::Key_Left);
  EXPECT_EQ(list.model().cursorFrame(), std::min(10, list.model().row(0).frames - 2));
  key(Qt::Key_Escape);
  EXPECT_EQ(list.model().cursorTake(), -1);
  key(Qt::Key_Down);
  EXPECT_EQ(list.selectedTake(), 1);
}

TEST_F(Browser, PlaysATakeFromTheMarkToItsEnd) {
  open(two_take_library());
  list.setSelectedTake(1);
  std::vector<int> pairs;
  std::vector<bool> in_motion;
  QObject::connect(&list, &TakeList::recordedShown, &list, [&](int pair, bool moves) {
    pairs.push_back(pair);
    in_motion.push_back(moves);
  });
  list.togglePlay();
  EXPECT_TRUE(list.isPlaying());
  EXPECT_EQ(button("Play the take as recorded")->text(), "Stop");
  ASSERT_TRUE(QTest::qWaitFor([&] { return !list.isPlaying(); }, 5000)) << "it ends with the take";
  ASSERT_GE(pairs.size(), 2U);
  EXPECT_FALSE(in_motion.front()) << "the first pair stands where the user is";
  EXPECT_EQ(pairs.back(), -1);
  for (std::size_t i = 1; i + 1 < pairs.size(); ++i) {
    EXPECT_GT(pairs[i], pairs[i - 1]);
    EXPECT_TRUE(in_motion[i]);
  }
}

TEST_F(Browser, AsksToDanceAndToExclude) {
  open(two_take_library());
  const QSignalSpy dance(&list, &TakeList::danceRequested), veto(&list, &TakeList::vetoRequested);
  list.setSelectedTake(1);
  key(Qt::Key_Return);
  QTest::mouseDClick(list.view().viewport(), Qt::LeftButton, {}, on_strip(0, 0.3));
  ASSERT_EQ(dance.count(), 2);
  EXPECT_EQ(dance[0][0].toInt(), 1);
  EXPECT_EQ(dance[1][0].toInt(), 0);
  list.setSelectedTake(1);
  button("Exclude the take from selection")->click();
  ASSERT_EQ(veto.count(), 1);
  EXPECT_EQ(veto[0][0].toInt(), 1);
  list.setVetoedTakes({"salsa_02"});
  EXPECT_EQ(button("Exclude the take from selection")->text(), "Use again");
}

TEST_F(Browser, TellsCoverageOnceItIsMeasured) {
  open(two_take_library());
  FrameHistory history;
  for (std::uint64_t i = 0; i < 10; ++i) history.append(synthetic_frame(i, 0.1 * static_cast<double>(i)));
  list.refresh(history);
  EXPECT_TRUE(list.coverageText().contains("being measured"));
  list.setTypicalDistance(0.2);  // the nearest candidate of a synthetic frame is 0.1 m away
  EXPECT_EQ(list.coverageText(), "Coverage 100 % of 10 frames");
  list.setTypicalDistance(0.05);
  EXPECT_EQ(list.coverageText(), "Coverage 0 % of 10 frames");
}

TEST_F(Browser, OfAThousandTakesMakesOnlyThePicturesThatAreSeen) {
  open(thousand_takes());
  (void)picture_of(list);
  EXPECT_EQ(list.view().model()->rowCount(), 1000);
  EXPECT_LT(list.model().picturesMade(), 20);
  list.view().verticalScrollBar()->setValue(list.view().verticalScrollBar()->maximum());
  (void)picture_of(list);
  EXPECT_LT(list.model().picturesMade(), 40);
  list.findChild<QLineEdit*>()->setText("take_99");
  EXPECT_EQ(list.view().model()->rowCount(), 19) << "99, 199 to 899, 990 to 999";
}

TEST_F(Browser, DrawsBeliefAsLightBelowTheMovesOfItsTake) {
  const auto library = test::small_library();
  open(library);
  const FrameIntent intent = belief_in(library, 1);
  const auto light = [&](int row) {
    const QRect place = list.view().visualRect(list.view().model()->index(row, 0));
    const QImage below = picture_of(list.view()).copy(place).copy(0, 54, place.width(), 6);
    return pixels_of_hue(below, palette_of(Theme::Dark).accent);
  };
  EXPECT_EQ(light(0) + light(1), 0);
  list.setBelief(intent);
  EXPECT_EQ(light(0), 0);
  EXPECT_GT(light(1), 300);
  list.setBelief({});
  EXPECT_EQ(light(1), 0) << "the paper's method believes nothing";
}

TEST_F(Browser, SaysWhatTheLightIsAndHowStrong) {
  const auto library = test::small_library();
  open(library);
  const auto tip = [&](int row) {
    return list.view().model()->index(row, 0).data(Qt::ToolTipRole).toString();
  };
  EXPECT_FALSE(tip(1).contains("belief"));
  list.setBelief(belief_in(library, 1));
  EXPECT_TRUE(tip(1).contains("Brightest in this take: 100 %")) << tip(1).toStdString();
  EXPECT_TRUE(tip(0).contains("None in this take")) << tip(0).toStdString();
  EXPECT_TRUE(list.view()
                  .model()
                  ->index(1, 0)
                  .data(Qt::AccessibleTextRole)
                  .toString()
                  .contains("belief 100 percent"));
  const QPoint at = on_strip(1, 0.5);
  QHelpEvent help(QEvent::ToolTip, at, list.view().viewport()->mapToGlobal(at));
  QApplication::sendEvent(list.view().viewport(), &help);
  EXPECT_TRUE(QToolTip::text().contains(": 100 %. Brightest")) << QToolTip::text().toStdString();
  QToolTip::hideText();
}

TEST_F(Browser, OfBeliefDrawsOnlyWhatChangesAndScrollsNowhere) {
  const auto library = thousand_takes(*test::small_library());
  open(library);
  QScrollBar* bar = list.view().verticalScrollBar();
  bar->setValue(bar->maximum() / 2);
  const int before = bar->value();
  const QSignalSpy drawn(&list.model(), &QAbstractItemModel::dataChanged);
  FrameIntent intent = belief_in(library, 0);
  list.setBelief(intent);
  EXPECT_EQ(drawn.count(), 1);
  list.setBelief(intent);
  EXPECT_EQ(drawn.count(), 1) << "nothing changed";
  EXPECT_EQ(bar->value(), before);
}

TEST_F(Browser, WithoutALibrarySaysHowToGetOne) {
  open(nullptr);
  const QImage empty = picture_of(list);
  EXPECT_EQ(list.view().model()->rowCount(), 0);
  EXPECT_FALSE(button("Play the take as recorded")->isEnabled());
  list.setLibrary(two_take_library());
  EXPECT_GT(difference(empty, picture_of(list)), 0.02);
}

}  // namespace
}  // namespace abrazo::widgets::take_list_test
