// The candidate table at work: keys, marks, menus, the map. Draws under a display of its own.
#include <gtest/gtest.h>

#include <QApplication>
#include <QElapsedTimer>
#include <QMenu>
#include <QScrollArea>
#include <QScrollBar>
#include <QTest>
#include <QToolButton>

#include "core/session/frames/frame_in_library.hpp"
#include "tests/widgets/pictures.hpp"
#include "tests/widgets/synthetic_frames.hpp"
#include "widgets/candidates/candidate_header.hpp"
#include "widgets/candidates/candidate_list.hpp"
#include "widgets/candidates/candidate_table.hpp"
#include "widgets/candidates/decision_bar.hpp"
#include "widgets/candidates/feature_map.hpp"
#include "widgets/common/theme.hpp"

namespace abrazo::widgets::candidate_table_test {
namespace {

using test::frame_by_intent;
using test::picture_of;
using test::pixels_like;
using test::synthetic_frame;
using test::two_take_library;

/// A table that does at once what it asks for.
struct Table {
  CandidateTable table;
  std::vector<QString> asked;
  Decisions decided;
  std::vector<std::pair<int, int>> jumps;
  std::vector<int> hovered;
  CandidateList* list = table.findChild<CandidateList*>();
  FeatureMap* map = table.findChild<FeatureMap*>();

  explicit Table(Theme theme = Theme::Dark) {
    table.setColours(palette_of(theme));
    QObject::connect(&table, &CandidateTable::decisionsRequested, &table,
                     [this](const Decisions& next, const QString& what) {
                       asked.push_back(what);
                       decided = next;
                       table.showDecisions(next);
                     });
    QObject::connect(&table, &CandidateTable::jumpRequested, &table,
                     [this](int take, int frame) { jumps.emplace_back(take, frame); });
    QObject::connect(&table, &CandidateTable::candidateHovered, &table,
                     [this](int candidate) { hovered.push_back(candidate); });
    table.setLibrary(two_take_library());
    table.resize(406, 460);
    table.show();
    table.showFrame(synthetic_frame(0, 0));
  }
  bool waitForMap() {
    QElapsedTimer clock;
    clock.start();
    while (!map->isReady() && clock.elapsed() < 20'000)
      QApplication::processEvents(QEventLoop::AllEvents, 10);
    return map->isReady();
  }
};

TEST(CandidateKeys, ChooseARowAndItIsShownInTheScene) {
  Table t;
  QTest::keyClick(t.list, Qt::Key_Down);
  QTest::keyClick(t.list, Qt::Key_Down);
  ASSERT_TRUE(t.list->current());
  EXPECT_EQ(t.list->current()->rank, 2);
  EXPECT_TRUE(t.list->accessibleDescription().startsWith("Rank 2 of 5, salsa_01 frame 1, turn"));
  QTest::keyClick(t.list, Qt::Key_PageDown);
  EXPECT_EQ(t.list->current()->rank, 5);
  QTest::keyClick(t.list, Qt::Key_Escape);
  EXPECT_FALSE(t.list->current());
}

TEST(CandidateKeys, ReturnAndADoubleClickGoToTakeAndFrame) {
  Table t;
  QTest::keyClick(t.list, Qt::Key_PageDown);
  QTest::keyClick(t.list, Qt::Key_Return);
  QTest::mouseDClick(t.list, Qt::LeftButton, {}, {80, 2 * CandidateList::row_height + 8});
  EXPECT_EQ(t.jumps, (std::vector<std::pair<int, int>>{{1, 0}, {0, 2}}));
}

TEST(CandidateTable, KeepsTheChosenPairWhenTheOrderChanges) {
  Table t;
  t.list->setCurrent(1);
  const int pair = t.list->current()->pair;
  t.table.sortBy(CandidateColumn::Rank);
  EXPECT_EQ(t.list->rows().front().rank, 5) << "descending";
  EXPECT_EQ(t.list->current()->pair, pair);
  EXPECT_TRUE(t.list->rows().back().selected) << "the winner stays marked";
}

/// It said "Nothing selected yet", as if it were not known why.
TEST(CandidateTable, SaysWithWhichLibraryAFrameWasDancedThatIsNotOpenAndHowToOpenIt) {
  Table t;
  auto foreign = std::make_shared<FrameSnapshot>(*synthetic_frame(1, 0.03));
  foreign->library = nullptr;
  foreign->noted_pairs = std::make_shared<const NotedPairs>(NotedPairs{"waltz", "/captures/waltz.h5", {}});
  t.table.showFrame(in_library(foreign, two_take_library()));
  EXPECT_TRUE(t.table.rows().empty());
  EXPECT_EQ(
      t.list->accessibleDescription(),
      "Danced with library “waltz”, which is not open. To see its candidates open the session and waltz.h5 "
      "together: File > Open…, both files at once.");
  EXPECT_GT(t.list->height(), CandidateList::row_height) << "all of it is in view";
  EXPECT_GT(pixels_like(picture_of(*t.list), palette_of(Theme::Dark).secondary), 50);
  t.table.showFrame(synthetic_frame(2, 0.06));
  EXPECT_EQ(t.table.rows().size(), 5U);
  EXPECT_EQ(t.list->height(), 5 * CandidateList::row_height);
}

TEST(CandidateTable, AsksForTheSelectionAndShowsThatOfOtherViews) {
  Table t;
  std::vector<Selection> asked;
  QObject::connect(&t.table, &CandidateTable::selectionRequested, &t.table,
                   [&](const Selection& selection) { asked.push_back(selection); });
  QTest::mouseClick(t.list, Qt::LeftButton, {}, {80, 2 * CandidateList::row_height + 8});
  ASSERT_EQ(asked.size(), 1U);
  EXPECT_EQ(asked[0], Selection::candidate(t.list->rows()[2].pair));
  t.table.showSelection(Selection::candidate(4));
  EXPECT_EQ(t.list->current()->pair, 4);
  t.table.showSelection(Selection::joint(3));
  EXPECT_FALSE(t.list->current());
  EXPECT_EQ(asked.size(), 1U) << "what it is shown it does not ask for";
}

TEST(CandidateTable, KeepsASelectedPairThatIsNoCandidateForAWhile) {
  Table t;
  t.table.showSelection(Selection::candidate(4));
  auto without = std::make_shared<FrameSnapshot>(*synthetic_frame(1, 0.03));
  without->result.candidates.resize(2);
  t.table.showFrame(without);
  EXPECT_FALSE(t.list->current());
  t.table.togglePin();
  EXPECT_EQ(t.decided.pinned, 4) << "keys are about what is selected, not about the winner";
  t.table.showFrame(synthetic_frame(2, 0.06));
  ASSERT_TRUE(t.list->current());
  EXPECT_EQ(t.list->current()->pair, 4);
}

TEST(FeatureMap, SelectsACandidateThatIsClicked) {
  Table t;
  ASSERT_TRUE(t.waitForMap());
  t.table.showFrame(synthetic_frame(0, 0));
  std::vector<Selection> asked;
  QObject::connect(&t.table, &CandidateTable::selectionRequested, &t.table,
                   [&](const Selection& selection) { asked.push_back(selection); });
  const QPointF place = t.map->placeOf(4).value();
  QTest::mouseClick(t.map, Qt::LeftButton, {}, place.toPoint());
  ASSERT_EQ(asked.size(), 1U);
  EXPECT_EQ(asked[0].kind, SelectionKind::Candidate);
}

TEST(CandidateTable, SortsByAClickOnAColumn) {
  Table t;
  auto* header = t.table.findChild<CandidateHeader*>();
  QTest::mouseClick(header, Qt::LeftButton, {}, header->area(CandidateColumn::Distance).center().toPoint());
  EXPECT_EQ(t.table.order(), (CandidateOrder{CandidateColumn::Distance, false}));
  QTest::mouseClick(header, Qt::LeftButton, {}, header->area(CandidateColumn::Distance).center().toPoint());
  EXPECT_TRUE(t.table.order().descending);
  EXPECT_EQ(t.list->rows().front().candidate, 4);
  EXPECT_EQ(header->accessibleDescription(), QString("Sorted by feature distance, descending"));
}

TEST(CandidateHeader, HasRoomForItsColumnsInEveryWidthOfThePanel) {
  CandidateHeader header;
  header.show();
  for (const SelectionMethod method : {SelectionMethod::Paper, SelectionMethod::Intent}) {
    header.setMethod(method);
    for (const int width : {300, 340, 406, 420, 700}) {
      header.resize(width, header.height());
      std::vector<QRectF> areas;
      for (const CandidateColumn column : candidate_columns(method)) {
        const QRectF area = header.area(column);
        EXPECT_FALSE(area.isEmpty()) << width << " px, " << column_title(column);
        EXPECT_TRUE(QRectF(header.rect()).adjusted(0, 0, 9, 0).contains(area))
            << width << " px, " << column_title(column);
        for (const QRectF& other : areas)
          EXPECT_FALSE(other.adjusted(0.5, 0, -0.5, 0).intersects(area))
              << width << " px, " << column_title(column);
        areas.push_back(area);
      }
    }
  }
}

/// What a person reads in the panel: the sentence's number is the difference of two figures of the list.
TEST(CandidateTable, NamesADifferenceThatTheListBearsOut) {
  Table t;
  auto frame = std::make_shared<FrameSnapshot>(*frame_by_intent(1, 0.03));
  frame->result.candidates[0].intent = IntentCost{0.1504, 0, 0, 0, 0, 0.1504, 0};
  frame->result.candidates[1].intent = IntentCost{0.0796, 0, 0, 0, 0.1, 0.1796, 0};
  t.table.showFrame(frame);
  QStringList totals;
  for (int row = 0; row < 2; ++row) {
    t.list->setCurrent(row);
    totals << t.list->accessibleDescription().section("total cost ", 1).section(',', 0, 0);
  }
  EXPECT_EQ(totals, QStringList({"0.150 m", "0.180 m"}));
  EXPECT_EQ(t.table.reason(),
            QString("Continues: #2 costs 0.030 m more, because of the 0.100 m for the change"));
}

TEST(CandidateTable, SpeaksTheTermsOfTheMethodThatDecidedTheShownFrame) {
  Table t;
  auto* header = t.table.findChild<CandidateHeader*>();
  t.table.showFrame(frame_by_intent(1, 0.03));
  EXPECT_EQ(t.table.reason(),
            QString("Continues: #2 costs 0.010 m more, because of the 0.030 m for the change"));
  EXPECT_TRUE(header->area(CandidateColumn::Pose).isEmpty());
  EXPECT_FALSE(header->area(CandidateColumn::Partner).isEmpty());
  QTest::keyClick(t.list, Qt::Key_Down);
  EXPECT_EQ(t.list->accessibleDescription(),
            QString("Rank 1 of 5, salsa_01 frame 0, turn, total cost 0.190 m, selected, continues"));
  t.table.showFrame(synthetic_frame(2, 0.06));
  EXPECT_TRUE(t.table.reason().startsWith("Winner by"));
  EXPECT_TRUE(header->area(CandidateColumn::Partner).isEmpty());
}

TEST(CandidateTable, StaysWithTheMethodOverAFrameWithoutCandidates) {
  Table t;
  t.table.showFrame(frame_by_intent(1, 0.03));
  auto failed = std::make_shared<FrameSnapshot>(*frame_by_intent(2, 0.06));
  failed->result.candidates.clear();
  failed->result.selected = -1;
  t.table.showFrame(failed);
  EXPECT_FALSE(t.table.findChild<CandidateHeader*>()->area(CandidateColumn::Partner).isEmpty());
}

TEST(CandidateTable, HidesTheMapUntilThereIsRoomBelowEightRows) {
  Table t;
  auto* button = t.table.findChild<QToolButton*>();
  ASSERT_EQ(button->text(), "Map");
  EXPECT_TRUE(t.map->isVisible());
  t.table.resize(406, t.table.minimumSizeHint().height() + 60);
  EXPECT_FALSE(t.map->isVisible());
  EXPECT_FALSE(button->isEnabled());
  EXPECT_TRUE(button->toolTip().contains("a taller panel")) << button->toolTip().toStdString();
  t.table.resize(406, 460);
  EXPECT_TRUE(t.map->isVisible()) << "it is still wanted";
  button->click();
  t.table.resize(406, 500);
  EXPECT_FALSE(t.map->isVisible()) << "and not when it was closed";
}

TEST(CandidateTable, NeedsNoMoreHeightForADecisionInForce) {
  Table t;
  const int before = t.table.minimumSizeHint().height();
  Decisions decisions;
  decisions.pinned = 0;
  t.table.showDecisions(decisions);
  QTest::qWait(20);
  ASSERT_TRUE(t.table.findChild<DecisionBar*>()->isVisible());
  EXPECT_LE(t.table.minimumSizeHint().height(), before);
}

TEST(CandidateTable, KeepsTheSortingAndTheScrollWhenTheMethodChanges) {
  Table t;
  t.table.showMap(false);
  (void)picture_of(t.table);
  t.table.resize(406, 190);
  (void)picture_of(t.table);
  auto* scroll = t.table.findChild<QScrollArea*>()->verticalScrollBar();
  t.table.sortBy(CandidateColumn::Distance);
  t.table.sortBy(CandidateColumn::Distance);
  scroll->setValue(scroll->maximum());
  const int before = scroll->value();
  EXPECT_GT(before, 0);
  t.table.showFrame(frame_by_intent(1, 0.03));
  (void)picture_of(t.table);
  EXPECT_EQ(t.list->rows().front().candidate, 4) << "both have distances";
  EXPECT_EQ(scroll->value(), before);
  t.table.sortBy(CandidateColumn::Leader);
  EXPECT_EQ(t.list->rows().front().candidate, 1);
  t.table.showFrame(synthetic_frame(2, 0.06));
  EXPECT_EQ(t.list->rows().front().rank, 1) << "by rank where there is no such column";
  t.table.showFrame(frame_by_intent(3, 0.09));
  EXPECT_EQ(t.list->rows().front().candidate, 1) << "as it was asked for";
}

TEST(CandidateTable, SaysQuietlyThatTheMethodIsStillBeingLearned) {
  Table t;
  EXPECT_EQ(t.table.belief(), QString());
  auto learning = std::make_shared<FrameSnapshot>(*synthetic_frame(1, 0.03));
  learning->is_learning = true;
  t.table.showFrame(learning);
  EXPECT_EQ(t.table.belief(), QString("Learning the library; Eq. 7 selects meanwhile"));
  EXPECT_TRUE(t.table.reason().startsWith("Winner by"));
  t.table.showFrame(frame_by_intent(2, 0.06));
  EXPECT_EQ(t.table.belief(), QString()) << "of a frame from a file nobody knows the moves";
}

TEST(CandidateTable, MenuOffersTheColumnsOfTheMethod) {
  Table t;
  t.table.showFrame(frame_by_intent(1, 0.03));
  QContextMenuEvent event(QContextMenuEvent::Mouse, {80, 30}, t.list->mapToGlobal(QPoint(80, 30)));
  QApplication::sendEvent(t.list, &event);
  QStringList offered;
  for (const QMenu* menu : t.table.findChildren<QMenu*>())
    if (menu->title() == "Sort by")
      for (const QAction* action : menu->actions()) offered << action->text();
  EXPECT_TRUE(offered.contains("expected distance of the partner")) << offered.join(", ").toStdString();
  EXPECT_FALSE(offered.contains("pose cost"));
  t.table.findChild<QMenu*>()->close();
}

TEST(CandidateTable, PaintsTheTermsOfIntentAndMarksWhatGoesOn) {
  auto without = std::make_shared<FrameSnapshot>(*frame_by_intent(1, 0.03));
  without->result.candidates[0].continuation = false;
  without->result.intent.continued = -1;
  for (const Theme theme : {Theme::Dark, Theme::Light}) {
    Table t(theme);
    const Palette& colours = palette_of(theme);
    t.table.showFrame(without);
    const QImage plain = picture_of(*t.list);
    t.table.showFrame(frame_by_intent(1, 0.03));
    const QImage picture = picture_of(*t.list);
    for (const CostTerm term : {CostTerm::Partner, CostTerm::Leader, CostTerm::Move, CostTerm::Change})
      EXPECT_GT(pixels_like(picture, colour_of(term, colours), 8), 100) << info_of(term).name;
    const QRect names(50, 0, 134, CandidateList::row_height);
    EXPECT_GT(test::difference(picture.copy(names), plain.copy(names)), 0.003) << "the arrow";
    EXPECT_EQ(test::difference(picture.copy(names.translated(0, CandidateList::row_height)),
                               plain.copy(names.translated(0, CandidateList::row_height))),
              0);
  }
}

TEST(CandidateTable, PinsAndVetoesTheChosenRowAndOneClickLiftsIt) {
  Table t;
  t.list->setCurrent(4);
  t.table.togglePin();
  EXPECT_EQ(t.decided.pinned, 4);
  EXPECT_TRUE(t.list->rows()[4].pinned);
  t.table.toggleVeto(Reach::Take);
  EXPECT_FALSE(t.decided.pinned);
  EXPECT_TRUE(t.list->rows()[4].vetoed);
  EXPECT_EQ(t.asked, (std::vector<QString>{"use salsa_02 0", "veto take salsa_02"}));
  const auto& buttons = t.table.findChild<DecisionBar*>()->buttons();
  ASSERT_EQ(buttons.size(), 1U);
  EXPECT_EQ(buttons[0]->accessibleName(), QString("Remove the veto: take salsa_02"));
  QTest::keyClick(buttons[0], Qt::Key_Return);
  EXPECT_TRUE(is_neutral(t.decided));
}

TEST(CandidateTable, WithoutAChosenRowDecidesAboutTheWinner) {
  Table t;
  t.table.toggleVeto(Reach::Pair);
  EXPECT_EQ(t.decided.vetoes.pairs, std::set<int>{0});
}

TEST(CandidateTable, AClickBesideTheRankPinsAndLetsGo) {
  Table t;
  QTest::mouseClick(t.list, Qt::LeftButton, {}, {8, CandidateList::row_height + 12});
  EXPECT_EQ(t.decided.pinned, 1);
  QTest::mouseClick(t.list, Qt::LeftButton, {}, {8, CandidateList::row_height + 12});
  EXPECT_TRUE(is_neutral(t.decided));
}

TEST(CandidateTable, ItsMenuHasEveryDecisionAndColumn) {
  Table t;
  QContextMenuEvent event(QContextMenuEvent::Mouse, {80, 30}, t.list->mapToGlobal(QPoint(80, 30)));
  QApplication::sendEvent(t.list, &event);
  auto* menu = t.table.findChild<QMenu*>();
  ASSERT_TRUE(menu);
  QStringList texts;
  for (const QAction* action : menu->actions()) texts << action->text().section('\t', 0, 0);
  for (const char* wanted : {"Use this one", "Veto salsa_01 1", "Veto take salsa_01", "Veto all turn",
                             "Go to its take and frame", "Sort by"})
    EXPECT_TRUE(texts.contains(wanted)) << wanted;
  menu->actions().front()->trigger();
  EXPECT_EQ(t.decided.pinned, 1);
  menu->close();
}

TEST(CandidateTable, MarksPinAndVetoInDarkAndLight) {
  for (const Theme theme : {Theme::Dark, Theme::Light}) {
    Table t(theme);
    const Palette& colours = palette_of(theme);
    const QRect gutter(3, 0, 13, 5 * CandidateList::row_height);
    const int before = pixels_like(picture_of(*t.list).copy(gutter), colours.warning, 60);
    const int bars = pixels_like(picture_of(*t.list), colours.user, 6);
    t.list->setCurrent(1);
    t.table.togglePin();
    EXPECT_GT(pixels_like(picture_of(*t.list).copy(gutter), colours.warning, 60), before + 15);
    t.table.toggleVeto(Reach::Label);
    EXPECT_LT(pixels_like(picture_of(*t.list), colours.user, 6), bars / 2) << "vetoed bars are faint";
  }
}

TEST(FeatureMap, DrawsTheWinnersRingAndTheUserAndLinksWithTheTable) {
  for (const Theme theme : {Theme::Dark, Theme::Light}) {
    Table t(theme);
    ASSERT_TRUE(t.waitForMap());
    t.table.showFrame(synthetic_frame(0, 0));
    const QImage picture = picture_of(*t.map);
    EXPECT_GT(pixels_like(picture, palette_of(theme).warning, 50), 15);
    const auto place = t.map->placeOf(4);
    ASSERT_TRUE(place);
    QMouseEvent move(QEvent::MouseMove, *place, Qt::NoButton, Qt::NoButton, {});
    QApplication::sendEvent(t.map, &move);
    ASSERT_FALSE(t.hovered.empty());
    EXPECT_GE(t.hovered.back(), 0);
    EXPECT_LT((*t.map->placeOf(t.hovered.back()) - *place).manhattanLength(), 1)
        << "or one at the same place";
  }
}

}  // namespace
}  // namespace abrazo::widgets::candidate_table_test
