// The library browser and the building of libraries in the whole window.
#include <gtest/gtest.h>

#include <QAction>
#include <QElapsedTimer>
#include <QPushButton>
#include <QTest>
#include <fstream>

#include "app/workbench/library/library_build.hpp"
#include "app/workbench/library/library_desk.hpp"
#include "core/motion/bvh/bvh.hpp"
#include "tests/support/libraries.hpp"
#include "tests/widgets/pictures.hpp"
#include "tests/workbench/demo_window.hpp"
#include "widgets/candidates/candidate_table.hpp"
#include "widgets/library/take_list.hpp"
#include "widgets/library/take_model.hpp"
#include "widgets/scene/view/scene_view.hpp"

namespace abrazo::app::library_actions_test {
namespace {

/// One window on the generated dance for all tests: opening it takes seconds.
class LibraryActions : public DemoWindow {
 protected:
  static void SetUpTestSuite() { showDemo({1280, 900}, 31); }
  void SetUp() override {
    ASSERT_TRUE(until([] { return bool(window().ticker().shown()); })) << "nothing was solved";
  }

  static widgets::TakeList& takes() { return window().takes(); }
  static LibraryDesk& desk() { return *window().findChild<LibraryDesk*>(); }
  static std::string input() { return window().session()->material().input.name; }
  static QStringList written_couple() {
    const PairedTake take = test::swinging_take("t", 60, 1);
    QStringList files;
    for (const auto& [name, clip] : {std::pair("x_leader.bvh", &take.a), {"x_follower.bvh", &take.b}}) {
      files << home().filePath(name);
      std::ofstream(files.back().toStdString()) << *write_bvh(std::vector<Clip>{*clip});
    }
    return files;
  }
};

TEST_F(LibraryActions, CoverageGrowsWithTheSessionAndIsMeasured) {
  EXPECT_TRUE(until([] { return takes().coverageText().contains("%"); }))
      << takes().coverageText().toStdString();
  EXPECT_GT(takes().model().coverage().user_frames(), 10);
  EXPECT_TRUE(until([] { return takes().model().sourceTake() >= 0; })) << "the shown source is marked";
}

TEST_F(LibraryActions, ATakeThatIsPlayedAppearsAsAGhost) {
  window().ticker().pause();
  QTest::qWait(100);
  const auto ghost = [] {
    return test::pixels_of_hue(test::picture_of(window().scene()), window().colours().ghost_passive);
  };
  ASSERT_TRUE(until([&] { return ghost() == ghost(); })) << "a parked scene is still";
  const int before = ghost();
  const QSize size = window().scene().size();
  takes().setSelectedTake(0);
  takes().togglePlay();
  EXPECT_TRUE(takes().isPlaying());
  QTest::qWait(60);
  const int with = ghost();
  EXPECT_GT(with, before + 60);
  takes().togglePlay();
  EXPECT_FALSE(takes().isPlaying());
  EXPECT_LT(ghost() - before, (with - before) / 10);
  EXPECT_EQ(window().scene().size(), size) << "a button that says Stop makes no panel wider";
  window().ticker().follow();
}

TEST_F(LibraryActions, AnExcludedTakeIsNotSelectedFromUntilItIsUsedAgain) {
  const auto source = [] { return takes().model().sourceTake(); };
  ASSERT_TRUE(until([&] { return source() >= 0; }));
  const int take = source();
  desk().toggleVeto(take);
  EXPECT_TRUE(until([&] { return source() >= 0 && source() != take; }));
  EXPECT_TRUE(until([&] { return takes().model().isVetoed(take); }));
  window().undoStack().undo();
  EXPECT_TRUE(until([&] { return !takes().model().isVetoed(take); })) << "a step of undo";
}

TEST_F(LibraryActions, ATakeCanPlayTheUserAndIsThenNotAnsweredFrom) {
  const std::string name = takes().model().row(0).name;
  takes().setSelectedTake(0);
  takes().dance();
  ASSERT_TRUE(until([&] { return input() == name; }));
  EXPECT_TRUE(until([] { return takes().model().isUsers(0); }));
  EXPECT_TRUE(
      until([] { return window().ticker().shown() && takes().model().coverage().user_frames() > 20; }));
  EXPECT_EQ(takes().model().coverage().times_selected(0), 0);
}

TEST_F(LibraryActions, TwoMotionsAskWhatTheyAreForAndBecomeALibrary) {
  window().openFiles(written_couple());
  ASSERT_NE(desk().building(), nullptr);
  LibraryBuild& build = *desk().building();
  ASSERT_TRUE(until([&] { return !build.isBusy(); }));
  EXPECT_TRUE(build.dialog().isVisible());
  QTest::keyClick(&build.dialog(), Qt::Key_Escape);
  EXPECT_FALSE(build.dialog().isVisible());
  QTest::qWait(50);
  ASSERT_EQ(desk().building(), &build) << "closing the dialog keeps the plan";
  desk().offer({});
  EXPECT_TRUE(build.dialog().isVisible());
  EXPECT_EQ(build.dialog().model().rowCount(), 2);
  for (auto* button : build.dialog().findChildren<QPushButton*>())
    if (button->text() == "Build") button->click();
  ASSERT_TRUE(until([] { return window().session()->material().library->name() == "library"; }));
  EXPECT_EQ(takes().model().row(0).name, "x");
  EXPECT_TRUE(until([] { return desk().building() == nullptr; }));
}

TEST_F(LibraryActions, StartOverLeavesAnEmptyPlan) {
  desk().offer(written_couple());
  const QPointer<LibraryBuild> before = desk().building();
  const QPointer<BuildDialog> dialog = &before->dialog();
  QPushButton* start_over = nullptr;
  for (auto* button : dialog->findChildren<QPushButton*>())
    if (button->text() == "Start over") start_over = button;
  ASSERT_TRUE(start_over);
  ASSERT_TRUE(before->isBusy());
  EXPECT_FALSE(start_over->isEnabled()) << "what is running is cancelled first";
  ASSERT_TRUE(until([&] { return !before->isBusy(); }));
  ASSERT_EQ(dialog->model().rowCount(), 2);
  start_over->click();
  EXPECT_TRUE(until([&] { return !before && !dialog; })) << "nothing of it is kept";
  ASSERT_TRUE(desk().building());
  EXPECT_EQ(desk().building()->dialog().model().rowCount(), 0);
  QTest::keyClick(&desk().building()->dialog(), Qt::Key_Escape);
  EXPECT_TRUE(until([] { return desk().building() == nullptr; })) << "an empty plan is not kept";
}

TEST_F(LibraryActions, OneMotionStaysTheUser) {
  const QStringList files = written_couple();
  window().openFiles({files[0]}, MotionReading{});
  EXPECT_EQ(desk().building(), nullptr);
  EXPECT_TRUE(until([] { return input() == "x_leader"; }));
}

TEST_F(LibraryActions, AClosedDialogLeavesWhatIsOpen) {
  const std::string before = input();
  window().openFiles(written_couple());
  ASSERT_NE(desk().building(), nullptr);
  ASSERT_TRUE(until([] { return !desk().building()->isBusy(); }));
  desk().building()->dialog().reject();
  EXPECT_EQ(input(), before);
}

}  // namespace
}  // namespace abrazo::app::library_actions_test
