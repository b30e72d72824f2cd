#include <gtest/gtest.h>

#include <QAction>
#include <QDir>
#include <QFile>
#include <QImage>
#include <QTemporaryDir>

#include "app/workbench/shell/actions.hpp"
#include "app/workbench/shell/main_window.hpp"
#include "widgets/plots/plot_pane.hpp"
#include "widgets/plots/plot_panel.hpp"

namespace abrazo::app::plot_actions_test {
namespace {

using widgets::PlotExport;

/// A window without a session, its plots over ten seconds of empty frames.
class PlotActions : public testing::Test {
 protected:
  PlotActions() : home_is_set(qputenv("ABRAZO_HOME", home.path().toUtf8())) {}
  void SetUp() override {
    add_playback_actions(window);
    add_plot_actions(window);
    for (std::uint64_t i = 0; i < 100; ++i) {
      auto frame = std::make_shared<FrameSnapshot>();
      frame->index = i;
      frame->time_s = static_cast<double>(i) / 2;
      frame->result.status = StepStatus::Ok;
      history.append(frame);
    }
    playback.extend(0, 49.5);
    playback.follow();
    window.plots().refresh(history, playback, nullptr);
  }
  QAction* action(const QString& text) {
    for (QAction* one : window.actions())
      if (one->text() == text) return one;
    return nullptr;
  }

  QTemporaryDir home;
  bool home_is_set;
  UserSettings remembered;
  MainWindow window{remembered};
  FrameHistory history;
  Playback playback;
};

TEST_F(PlotActions, EachExportIsWrittenWhole) {
  const QString csv = home.filePath("plots.csv"), png = home.filePath("plots.png"),
                svg = home.filePath("plots.svg");
  EXPECT_EQ(save_plots(window, PlotExport::Csv, csv), QString());
  EXPECT_EQ(save_plots(window, PlotExport::Png, png), QString());
  EXPECT_EQ(save_plots(window, PlotExport::Svg, svg), QString());
  QFile table(csv), drawing(svg);
  ASSERT_TRUE(table.open(QIODevice::ReadOnly));
  EXPECT_TRUE(table.readAll().startsWith("time [s],frame,"));
  ASSERT_TRUE(drawing.open(QIODevice::ReadOnly));
  EXPECT_TRUE(drawing.readAll().trimmed().endsWith("</svg>"));
  EXPECT_EQ(QImage(png).width() % 2, 0);
  EXPECT_GE(QImage(png).width(), 600);
}

TEST_F(PlotActions, AnExportThatCannotBeWrittenSaysSoAndLeavesNothing) {
  const QString trouble = save_plots(window, PlotExport::Csv, home.filePath("no/such/place/plots.csv"));
  EXPECT_TRUE(trouble.contains("plots.csv")) << trouble.toStdString();
  EXPECT_FALSE(QDir(home.filePath("no")).exists());
}

TEST_F(PlotActions, PanesAreRememberedInTheirOrder) {
  window.plots().addPane(widgets::usual_series("Step time"));
  window.plots().movePane(3, -1);
  MainWindow next(remembered);
  add_plot_actions(next);
  EXPECT_EQ(next.plots().arrangement(), window.plots().arrangement());
  EXPECT_EQ(next.plots().paneCount(), 4);
}

TEST_F(PlotActions, EndTakesPlotsAlongThatWereMovedAway) {
  emit window.plots().pane(0).panRequested(-10);
  ASSERT_TRUE(window.plots().window().detached());
  action("Follow the live end")->trigger();
  EXPECT_TRUE(window.plots().window().follows());
  EXPECT_DOUBLE_EQ(window.plots().window().to_s(), 49.5);
}

}  // namespace
}  // namespace abrazo::app::plot_actions_test
