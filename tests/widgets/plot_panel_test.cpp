// The plots driven by mouse and keys; looked at are colours and places, not single pixels.
#include "widgets/plots/plot_panel.hpp"

#include <gtest/gtest.h>

#include <QApplication>
#include <QMenu>
#include <QMouseEvent>
#include <QPainter>
#include <QScrollBar>
#include <QSignalSpy>
#include <QTest>
#include <QToolButton>
#include <QWheelEvent>

#include "core/session/frames/frame_history.hpp"
#include "tests/widgets/pictures.hpp"
#include "tests/widgets/synthetic_frames.hpp"
#include "widgets/plots/plot_head.hpp"
#include "widgets/plots/plot_menu.hpp"
#include "widgets/plots/plot_pane.hpp"

namespace abrazo::widgets::plot_panel_test {
namespace {

using test::picture_of;
using test::pixels_like;
using test::pixels_of_hue;
using test::synthetic_frame;

/// Made once: each has a mesh of its own.
const std::vector<FrameSnapshotPtr>& forty_seconds() {
  static const std::vector<FrameSnapshotPtr> frames = [] {
    std::vector<FrameSnapshotPtr> made;
    for (std::uint64_t i = 0; i < 1200; ++i) made.push_back(synthetic_frame(i, static_cast<double>(i) / 30));
    return made;
  }();
  return frames;
}

/// These in a panel that follows their end.
class Plots : public testing::Test {
 protected:
  void SetUp() override {
    for (const FrameSnapshotPtr& frame : forty_seconds()) history.append(frame);
    playback.extend(history.span().first_s, history.span().last_s);
    playback.follow();
    panel.resize(930, 170);
    panel.show();
    refresh();
  }
  void refresh() { panel.refresh(history, playback, history.at(playback.cursor_s)); }
  QWidget& surface(int pane) { return *panel.pane(pane).findChild<QWidget*>("curves"); }
  QPoint at(int pane, double time_s) {
    return {static_cast<int>(std::lround(panel.pane(pane).xOf(time_s))) - surface(pane).x(), 40};
  }
  void drag(int pane, QPoint from, QPoint to) {
    QTest::mousePress(&surface(pane), Qt::LeftButton, {}, from);
    QMouseEvent move(QEvent::MouseMove, to, surface(pane).mapToGlobal(to), Qt::NoButton, Qt::LeftButton, {});
    QApplication::sendEvent(&surface(pane), &move);
    QTest::mouseRelease(&surface(pane), Qt::LeftButton, {}, to);
  }
  void turnWheel(int pane, QPoint where, QPoint angle, Qt::KeyboardModifiers keys = {}) {
    QWheelEvent wheel(where, surface(pane).mapToGlobal(where), {}, angle, Qt::NoButton, keys,
                      Qt::NoScrollPhase, false);
    QApplication::sendEvent(&surface(pane), &wheel);
  }

  FrameHistory history;
  Playback playback;
  PlotPanel panel;
};

TEST_F(Plots, HaveAPaneForWhatIsSelectedWhileItIs) {
  const int before = panel.paneCount();
  panel.showSelection(Selection::joint(20));
  EXPECT_EQ(panel.paneCount(), before + 1);
  EXPECT_EQ(panel.selectionPane(), before);
  EXPECT_EQ(panel.arrangement().size(), static_cast<std::size_t>(before)) << "it is not remembered";
  EXPECT_EQ(panel.pane(before).accessibleName(), QString("Plot of leader lhand [mm]"));
  refresh();
  EXPECT_TRUE(panel.readout(38).contains("selected joint from the selected pair"));
  EXPECT_FALSE(panel.readout(38).contains("–</td>")) << "read for frames that came before the selection";
  panel.showSelection(Selection::candidate(3));
  EXPECT_EQ(panel.paneCount(), before);
  EXPECT_EQ(panel.selectionPane(), -1);
}

TEST_F(Plots, AskToSelectNothingWhenThePaneOfTheSelectionIsRemoved) {
  QSignalSpy asked(&panel, &PlotPanel::selectionRequested);
  panel.showSelection(Selection::tetrahedron(forty_seconds()[0]->result.tetrahedra[3]));
  panel.removePane(panel.selectionPane());
  ASSERT_EQ(asked.size(), 1);
  EXPECT_EQ(asked[0][0].value<Selection>(), Selection());
}

TEST_F(Plots, ShowEnergiesResidualsAndCostAtFirstInBothThemes) {
  for (const Theme theme : {Theme::Dark, Theme::Light}) {
    const Palette& p = palette_of(theme);
    panel.setColours(p);
    refresh();
    const QImage picture = picture_of(panel);
    EXPECT_GT(pixels_of_hue(picture.copy(0, 30, 310, 140), p.energy_constraint), 60);
    EXPECT_GT(pixels_of_hue(picture.copy(310, 30, 310, 140), p.residual_penetration), 40);
    EXPECT_GT(pixels_of_hue(picture.copy(620, 30, 310, 140), p.passive), 40);
  }
}

TEST(PlotsOfARecordingWithAGap, DrawNoLineAcrossIt) {
  FrameHistory history;
  for (const FrameSnapshotPtr& frame : forty_seconds()) {
    auto late = std::make_shared<FrameSnapshot>(*frame);
    late->time_s = 0.25 * frame->time_s + (frame->index < 600 ? 0 : 6);
    history.append(late);
  }
  Playback playback;
  playback.extend(history.span().first_s, history.span().last_s);
  playback.follow();
  PlotPanel panel;
  panel.resize(930, 170);
  panel.show();
  panel.refresh(history, playback, history.at(playback.cursor_s));
  const auto line = [&panel](double from_s, double to_s) {
    const int left = static_cast<int>(panel.pane(0).x() + panel.pane(0).xOf(from_s)),
              right = static_cast<int>(panel.pane(0).x() + panel.pane(0).xOf(to_s));
    return pixels_of_hue(picture_of(panel).copy(left, 34, right - left, 130),
                         palette_of(Theme::Dark).energy_constraint);
  };
  EXPECT_GT(line(1, 4.5), 10);
  EXPECT_EQ(line(5.5, 10.5), 0);
  EXPECT_GT(line(11.5, 15), 10);
}

TEST_F(Plots, AClickGoesThereAndADragMovesTheWindow) {
  QSignalSpy asked(&panel, &PlotPanel::seekRequested);
  QTest::mouseClick(&surface(1), Qt::LeftButton, {}, at(1, 30));
  ASSERT_EQ(asked.size(), 1);
  EXPECT_NEAR(asked[0][0].toDouble(), 30, 0.15);
  const double before = panel.window().to_s();
  drag(1, at(1, 30), at(1, 35));
  EXPECT_EQ(asked.size(), 1) << "a drag is no click";
  EXPECT_NEAR(panel.window().to_s(), before - 5, 0.3);
  history.append(synthetic_frame(1200, 40.5));
  playback.extend(0, 40.5);
  refresh();
  EXPECT_NEAR(panel.window().to_s(), before - 5, 0.3) << "what comes in does not move it";
}

TEST_F(Plots, TheCursorIsScrubbedWhereItIsTakenHoldOf) {
  playback.seek(30);
  refresh();
  QSignalSpy asked(&panel, &PlotPanel::seekRequested);
  drag(0, at(0, 30), at(0, 25));
  ASSERT_EQ(asked.size(), 1);
  EXPECT_NEAR(asked[0][0].toDouble(), 25, 0.15);
}

TEST_F(Plots, TheWheelZoomsWhileLiveAndADoubleClickFollows) {
  turnWheel(0, at(0, 30), {0, 120});
  EXPECT_NEAR(panel.window().span_s(), 20 * 0.85, 1e-9);
  EXPECT_TRUE(panel.window().follows());
  turnWheel(0, at(0, 30), {0, 120}, Qt::ShiftModifier);
  EXPECT_TRUE(panel.window().detached());
  QSignalSpy asked(&panel, &PlotPanel::followRequested);
  QTest::mouseDClick(&surface(0), Qt::LeftButton, {}, at(0, 30));
  EXPECT_EQ(asked.size(), 1);
  EXPECT_TRUE(panel.window().follows());
}

TEST_F(Plots, KeysZoomMoveAndOpenTheMenu) {
  PlotPane& pane = panel.pane(0);
  QTest::keyClick(&pane, Qt::Key_Plus);
  EXPECT_NEAR(panel.window().span_s(), 17, 1e-9);
  QTest::keyClick(&pane, Qt::Key_Minus);
  EXPECT_NEAR(panel.window().span_s(), 20, 1e-9);
  const double before = panel.window().to_s();
  QTest::keyClick(&pane, Qt::Key_PageUp);
  EXPECT_NEAR(panel.window().to_s(), before - 4, 1e-9);
  QTest::keyClick(&pane, Qt::Key_PageDown);
  EXPECT_TRUE(panel.window().follows());
  QTest::keyClick(&pane, Qt::Key_Return);
  auto* menu = qobject_cast<QMenu*>(QApplication::activePopupWidget());
  ASSERT_TRUE(menu);
  menu->close();
}

TEST_F(Plots, EachPaneHasAnAccessibleName) {
  EXPECT_EQ(panel.pane(0).accessibleName(), QString("Plot of Energy [m²]"));
  EXPECT_EQ(panel.pane(1).findChild<QToolButton*>()->accessibleName(),
            QString("Series of the plot of Residuals [mm]"));
  EXPECT_EQ(panel.pane(0).focusPolicy(), Qt::StrongFocus);
}

TEST_F(Plots, PanesAreAddedMovedAndRemoved) {
  QSignalSpy changed(&panel, &PlotPanel::arrangementChanged);
  panel.addPane(usual_series("Step time"));
  panel.movePane(3, -1);
  panel.removePane(0);
  EXPECT_EQ(text_of(panel.arrangement()),
            "residual.foot_lock,residual.excess_penetration;"
            "time.retarget,time.select,time.mesh,time.solve,time.total;cost.pose,cost.leader,cost.follower");
  EXPECT_EQ(changed.size(), 3);
  panel.removePane(0);
  panel.removePane(0);
  panel.removePane(0);
  EXPECT_EQ(panel.paneCount(), 1) << "the last one stays";
}

TEST_F(Plots, ThatHaveNoRoomAreReachedByScrolling) {
  auto* scroll = panel.findChild<QScrollBar*>();
  EXPECT_FALSE(scroll->isVisible());
  panel.resize(430, 110);
  for (const char* group : {"Step time", "Cost", "Residuals", "Energy"}) panel.addPane(usual_series(group));
  ASSERT_EQ(panel.paneCount(), 7);
  EXPECT_TRUE(scroll->isVisible());
  EXPECT_TRUE(panel.pane(6).isVisible()) << "what was added is in view";
  EXPECT_FALSE(panel.pane(0).isVisible());
  scroll->setValue(0);
  EXPECT_TRUE(panel.pane(0).isVisible());
  EXPECT_FALSE(panel.pane(6).isVisible());
  for (int p = 0; p < 3; ++p)
    EXPECT_LE(panel.pane(p).geometry().right(), scroll->x()) << "the bar covers no plot";
  panel.showSelection(Selection::joint(joints::left_hand));
  EXPECT_TRUE(panel.pane(panel.selectionPane()).isVisible()) << "what was just selected is in view";
}

/// So many frames that those of the beginning are thinned, all with this energy.
void show_a_long_session(PlotPanel& panel, double energy) {
  FrameHistory history;
  Playback playback;
  std::vector<FrameSnapshotPtr> some;
  for (std::uint64_t index = 0; index < 100'000; ++index) {
    auto frame = std::make_shared<FrameSnapshot>();
    frame->index = index;
    frame->time_s = static_cast<double>(index) / 120;
    frame->result.status = StepStatus::Ok;
    frame->result.energy.deformation = energy;
    history.append(std::move(frame));
    if (history.span().frames < 10'000) continue;
    playback.extend(0, history.span().last_s);
    panel.refresh(history, playback, history.at(history.span().last_s));
    history.clear();
  }
}

TEST_F(Plots, ANewSessionShowsNoValueOfTheFrameOfThatIndexInTheOneBefore) {
  const auto energy_in_frame_ten = [this](double energy) {
    panel.clear();
    show_a_long_session(panel, energy);
    auto tenth = std::make_shared<FrameSnapshot>();
    tenth->index = 10;
    tenth->time_s = 10.0 / 120;
    tenth->result.status = StepStatus::Ok;
    tenth->result.energy.deformation = energy;
    Playback parked;
    parked.extend(0, 100'000 / 120.0);
    panel.refresh(FrameHistory(), parked, tenth);
    return panel.pane(0).shownValues().value()[static_cast<std::size_t>(Series::DeformationEnergy)];
  };
  EXPECT_EQ(energy_in_frame_ten(1), 1);
  EXPECT_EQ(energy_in_frame_ten(2), 2);
}

TEST_F(Plots, APaneTakesSeriesOfItsUnitOnly) {
  EXPECT_TRUE(panel.setShown(1, Series::HoldChange, true));
  EXPECT_FALSE(panel.setShown(1, Series::SolveTime, true));
  EXPECT_TRUE(panel.setShown(1, Series::FootLock, false));
  EXPECT_EQ(panel.arrangement()[1], (PaneSeries{Series::ExcessPenetration, Series::HoldChange}));
}

TEST_F(Plots, TheMenuGreysSeriesOfAnotherUnitAndSaysWhatToDo) {
  QMenu menu;
  fill_pane_menu(menu, panel, 1);
  const auto series = menu.actions().front()->menu()->actions();
  const auto entry = [&](const QString& name) -> QAction& {
    for (QAction* action : series)
      if (action->text() == name) return *action;
    throw std::out_of_range(name.toStdString());
  };
  EXPECT_TRUE(entry("foot lock [mm]").isChecked());
  EXPECT_FALSE(entry("solve [ms]").isEnabled());
  EXPECT_EQ(entry("solve [ms]").toolTip(), QString("'solve' is in ms, this pane in mm; add a pane for it"));
  entry("penetration [mm]").trigger();
  EXPECT_EQ(panel.arrangement()[1],
            (PaneSeries{Series::FootLock, Series::ExcessPenetration, Series::Penetration}));
}

TEST_F(Plots, TheReadoutHasEverySeriesThatIsDrawn) {
  const QString text = panel.readout(20.01);
  EXPECT_TRUE(text.contains("20.000 s")) << text.toStdString();
  EXPECT_TRUE(text.contains("frame 600"));
  for (const PaneSeries& pane : panel.arrangement())
    for (const Series series : pane)
      EXPECT_TRUE(text.contains(QString::fromStdString(std::string(info_of(series).name))));
  EXPECT_TRUE(panel.readout(-5).isEmpty());
}

TEST_F(Plots, TheHeightDoesNotJumpWithWhatComesIn) {
  const double before = panel.pane(0).upperEnd();
  for (std::uint64_t i = 1200; i < 1230; ++i) {
    auto frame = std::make_shared<FrameSnapshot>(*synthetic_frame(i, static_cast<double>(i) / 30));
    frame->result.energy.deformation *= 0.9 + 0.005 * static_cast<double>(i % 7);
    history.append(frame);
    playback.extend(0, frame->time_s);
    refresh();
    EXPECT_EQ(panel.pane(0).upperEnd(), before);
  }
}

/// The same energies in two panes had two scales and could not be compared.
TEST_F(Plots, PanesOfOneQuantityHaveOneScale) {
  panel.resize(930, 400);
  panel.setArrangement({{Series::DeformationEnergy}, {Series::FootLock}});
  for (std::uint64_t i = 1200; i < 1230; ++i) {  // a while with much larger ones
    auto frame = std::make_shared<FrameSnapshot>(*synthetic_frame(i, static_cast<double>(i) / 30));
    frame->result.energy.deformation *= 40;
    history.append(frame);
    playback.extend(0, frame->time_s);
    refresh();
  }
  panel.addPane({Series::DeformationEnergy});
  panel.addPane({Series::ConstraintEnergy});
  refresh();
  EXPECT_EQ(panel.pane(2).upperEnd(), panel.pane(0).upperEnd()) << "of the same series";
  EXPECT_EQ(panel.pane(3).upperEnd(), panel.pane(0).upperEnd()) << "of another energy";
  EXPECT_NE(panel.pane(1).axis(), panel.pane(0).axis()) << "another quantity has its own scale";
  panel.removePane(3);
  ASSERT_TRUE(panel.setShown(0, Series::ConstraintEnergy, true));
  refresh();
  EXPECT_EQ(panel.pane(2).upperEnd(), panel.pane(0).upperEnd()) << "also with one series more";
}

/// Recorded takes are not solved. Their axes said "7.5·10⁻⁷".
TEST(PlotPane, WhereAllIsZeroTheAxisHasNumbersThatCanBeRead) {
  PlotPane pane(nullptr);
  pane.resize(300, 160);
  SampleTable table;
  PlotView view;
  view.to_s = 5;
  for (const Series series :
       {Series::DeformationEnergy, Series::FootLock, Series::TotalCost, Series::BoneLength}) {
    pane.setSeries({series});
    pane.read(table, view);
    pane.draw();
    EXPECT_EQ(pane.upperEnd(), 1) << info_of(series).name;
  }
}

TEST_F(Plots, OnlyHeadsStayWhereThePanelIsLow) {
  panel.resize(930, 40);
  EXPECT_TRUE(panel.pane(0).isCollapsed());
  EXPECT_FALSE(surface(0).isVisible());
  const QImage picture = picture_of(panel);
  EXPECT_GT(pixels_like(picture.copy(0, 0, 310, 30), palette_of(Theme::Dark).energy_constraint), 40);
}

TEST_F(Plots, TheLastPaneOfTheTopRowSaysThatItFollows) {
  const Palette& p = palette_of(Theme::Dark);
  EXPECT_GT(pixels_of_hue(picture_of(panel).copy(820, 0, 110, 30), p.live, 6), 12);
  panel.zoom(0.9);
  drag(0, at(0, 30), at(0, 35));
  EXPECT_LT(pixels_of_hue(picture_of(panel).copy(820, 0, 110, 30), p.live, 6), 4);
}

/// With four panes in 900 pixels the title went, and the unit with it.
TEST(PlotHead, KeepsItsTitleAboveTheNamesWhereItIsNarrow) {
  const Palette& p = palette_of(Theme::Dark);
  const PaneSeries series = usual_series("Residuals");
  const std::optional<SeriesValues> values;
  const auto painted = [&](int width) {
    QImage image(width, 30, QImage::Format_RGB32);
    image.fill(p.panel);
    QPainter painter(&image);
    paint_plot_head(painter, image.rect(), {series, values, p, PlotMark::Detached});
    return image;
  };
  const QImage narrow = painted(190), wide = painted(600);
  EXPECT_GT(pixels_like(narrow.copy(0, 0, 110, 16), p.text), 40) << "Residuals [mm]";
  EXPECT_GT(pixels_of_hue(narrow.copy(0, 14, 190, 16), p.residual_penetration), 20) << "its names below";
  EXPECT_GT(pixels_like(wide.copy(0, 0, 110, 30), p.text), 40);
}

/// "leader lowerneck — leader rclavicle [mm]" ended at the button, with "217" below and no unit.
TEST(PlotHead, KeepsTheUnitOfATitleThatIsTooLong) {
  const Palette& p = palette_of(Theme::Dark);
  const PaneSeries series = usual_series("Residuals");
  const std::optional<SeriesValues> values;
  const auto right_of_title = [&](const std::string& title) {
    QImage image(190, 30, QImage::Format_RGB32);
    image.fill(p.panel);
    QPainter painter(&image);
    paint_plot_head(painter, image.rect(), {series, values, p, PlotMark::None, title});
    return image.copy(150, 0, 40, 14);
  };
  EXPECT_EQ(right_of_title("a joint with a very long name — another one with a long name [mm]"),
            right_of_title("a joint with a very long name — another one with a longer name [mm]"))
      << "both end with the unit at the same place";
  EXPECT_NE(right_of_title("a joint with a very long name — another one with a long name [mm]"),
            right_of_title("a joint with a very long name — another one with a long name"));
}

TEST_F(Plots, ThePictureHasTwoPixelsAPointAndAllPanes) {
  for (int more = 0; more < 3; ++more) panel.addPane(usual_series("Metrics"));
  panel.resize(930, 40);  // collapsed on the screen, whole in the file
  const QImage picture = panel.picture(2);
  EXPECT_EQ(picture.size(), QSize(1860, 600));
  const Palette& p = palette_of(Theme::Dark);
  EXPECT_GT(pixels_of_hue(picture.copy(0, 60, 620, 240), p.energy_constraint), 200);
  EXPECT_GT(pixels_of_hue(picture.copy(1240, 360, 620, 240), p.energy_velocity), 100);
}

TEST_F(Plots, TheDrawingIsSvgWithWordsAndCurvesWithinTheirBorder) {
  auto spike = std::make_shared<FrameSnapshot>(*synthetic_frame(1200, 40.1));
  spike->result.energy.deformation = 1e6;
  history.append(spike);
  playback.extend(0, 40.1);
  refresh();
  const QString svg = QString::fromUtf8(panel.svg());
  EXPECT_TRUE(svg.startsWith("<?xml"));
  EXPECT_TRUE(svg.contains("Residuals [mm]"));
  EXPECT_TRUE(svg.contains("<polyline") || svg.contains("<path"));
  EXPECT_FALSE(svg.contains("e+")) << "a coordinate far outside";
}

TEST_F(Plots, TheSamplesAreThoseInTheWindow) {
  const std::string csv = panel.csv();
  const auto lines = std::count(csv.begin(), csv.end(), '\n');
  EXPECT_NEAR(static_cast<double>(lines), 20 * 30 + 2, 1);
}

}  // namespace
}  // namespace abrazo::widgets::plot_panel_test
