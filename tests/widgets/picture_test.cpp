// Each view draws a known frame; looked at are colours and places, not single pixels.
#include <gtest/gtest.h>

#include <QCheckBox>
#include <QSignalSpy>
#include <QTest>
#include <algorithm>

#include "core/session/frames/frame_history.hpp"
#include "tests/widgets/pictures.hpp"
#include "tests/widgets/synthetic_frames.hpp"
#include "widgets/candidates/candidate_list.hpp"
#include "widgets/candidates/candidate_table.hpp"
#include "widgets/common/theme.hpp"
#include "widgets/plots/plot_panel.hpp"

namespace abrazo::widgets::picture_test {
namespace {

using test::difference;
using test::picture_of;
using test::pixels_like;
using test::pixels_of_hue;
using test::synthetic_frame;
using test::two_take_library;

const Palette& dark() {
  return palette_of(Theme::Dark);
}

/// The style of Qt draws the frame of an empty box in a shade of the window, which a dark one swallows.
TEST(Theme, AnUntickedBoxCanBeSeenInBothThemes) {
  for (const Theme theme : {Theme::Dark, Theme::Light}) {
    const Palette& palette = palette_of(theme);
    QWidget window;
    window.setStyleSheet(style_sheet(palette));
    QCheckBox box("for files like this one", &window);
    window.resize(240, 40);
    const QImage picture = picture_of(window).copy(0, 0, 16, 40);  // without its words
    double most = 0;
    for (int y = 0; y < picture.height(); ++y)
      for (int x = 0; x < picture.width(); ++x)
        most = std::max(most, contrast(picture.pixelColor(x, y), palette.window));
    EXPECT_GE(most, 3) << (palette.dark ? "dark" : "light");
  }
}

TEST(CandidateTable, PaintsTheThreeTermsInTheirColours) {
  CandidateTable table;
  table.setLibrary(two_take_library());
  table.resize(400, 300);
  table.showFrame(synthetic_frame(0, 0));
  const QImage picture = picture_of(table).copy(150, 34, 250, 200);
  EXPECT_GT(pixels_like(picture, dark().user), 500);
  EXPECT_GT(pixels_like(picture, dark().active), 60);
  EXPECT_GT(pixels_like(picture, dark().passive), 150);
  EXPECT_TRUE(table.reason().startsWith("Winner by"));
}

TEST(CandidateTable, TellsWhichCandidateIsUnderThePointer) {
  CandidateList list;
  list.resize(400, 200);
  list.setRows(candidate_rows(*synthetic_frame(0, 0), *two_take_library()));
  QSignalSpy hovered(&list, &CandidateList::candidateHovered);
  QMouseEvent move(QEvent::MouseMove, QPointF(60, 24 + 5), QPointF(60, 24 + 5), Qt::NoButton, Qt::NoButton,
                   {});
  QApplication::sendEvent(&list, &move);
  ASSERT_EQ(hovered.size(), 1);
  EXPECT_EQ(hovered[0][0].toInt(), list.rows()[1].candidate);
}

/// Ten seconds of frames, and a playback parked in their middle.
struct TenSeconds {
  FrameHistory history;
  Playback playback;
  TenSeconds() {
    for (std::uint64_t i = 0; i < 300; ++i) history.append(synthetic_frame(i, static_cast<double>(i) / 30));
    playback.extend(history.span().first_s, history.span().last_s);
    playback.seek(5);
  }
};

TEST(PlotPanel, DrawsItsCurvesAndTheCursor) {
  TenSeconds data;
  PlotPanel panel;
  panel.resize(900, 170);
  panel.show();
  Playback live = data.playback;
  live.follow();
  panel.refresh(data.history, live, data.history.at(10));
  panel.refresh(data.history, data.playback, data.history.at(5));
  const QImage picture = picture_of(panel);
  EXPECT_GT(pixels_of_hue(picture.copy(0, 30, 300, 140), dark().energy_constraint), 60);
  EXPECT_GT(pixels_of_hue(picture.copy(300, 30, 300, 140), dark().residual_penetration), 40);
  const int x = static_cast<int>(panel.cursorX());
  EXPECT_GT(pixels_like(picture.copy(x - 2, 40, 5, 110), QColor("#c7ccd6"), 40), 60);
}

}  // namespace
}  // namespace abrazo::widgets::picture_test
