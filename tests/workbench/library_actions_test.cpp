// The library browser and the building of libraries in the whole window.
#include <gtest/gtest.h>

#include <QAction>
#include <QElapsedTimer>
#include <QPushButton>
#include <QTemporaryDir>
#include <QTest>
#include <fstream>

#include "app/workbench/library/library_build.hpp"
#include "app/workbench/library/library_desk.hpp"
#include "app/workbench/shell/actions.hpp"
#include "app/workbench/shell/main_window.hpp"
#include "core/motion/bvh/bvh.hpp"
#include "tests/support/libraries.hpp"
#include "tests/widgets/pictures.hpp"
#include "tests/workbench/until.hpp"
#include "widgets/candidates/candidate_table.hpp"
#include "widgets/library/take_list.hpp"
#include "widgets/library/take_model.hpp"
#include "widgets/scene/view/scene_view.hpp"

namespace abrazo::app::library_actions_test {
namespace {

/// One window on the generated dance for all tests: opening it takes seconds.
class LibraryActions : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    s_home = new QTemporaryDir;
    qputenv("ABRAZO_HOME", s_home->path().toUtf8());
    s_remembered = new UserSettings;
    s_window = new MainWindow(*s_remembered);
    s_window->setTheme(widgets::Theme::Dark);
    s_window->resize(1280, 900);
    add_all_actions(*s_window);
    s_window->show();
    s_window->openDemo();
    until([] { return s_window->ticker().shown() && s_window->ticker().shown()->index > 30; });
  }
  static void TearDownTestSuite() {
    delete s_window;
    delete s_remembered;
    delete s_home;
  }
  void SetUp() override {
    ASSERT_TRUE(until([] { return bool(s_window->ticker().shown()); })) << "nothing was solved";
  }

  static widgets::TakeList& takes() { return s_window->takes(); }
  static LibraryDesk& desk() { return *s_window->findChild<LibraryDesk*>(); }
  static std::string input() { return s_window->session()->material().input.name; }
  static QStringList written_couple() {
    const PairedTake take = test::swinging_take("t", 60, 1);
    QStringList files;
    for (const auto& [name, clip] : {std::pair("x_leader.bvh", &take.a), {"x_follower.bvh", &take.b}}) {
      files << s_home->filePath(name);
      std::ofstream(files.back().toStdString()) << *write_bvh(std::vector<Clip>{*clip});
    }
    return files;
  }
  static inline MainWindow* s_window = nullptr;
  static inline UserSettings* s_remembered = nullptr;
  static inline QTemporaryDir* s_home = nullptr;
};

TEST_F(LibraryActions, CoverageGrowsWithTheSessionAndIsMeasured) {
  EXPECT_TRUE(until([] { return takes().coverageText().contains("%"); }))
      << takes().coverageText().toStdString();
  EXPECT_GT(takes().model().coverage().user_frames(), 10);
  EXPECT_TRUE(until([] { return takes().model().sourceTake() >= 0; })) << "the shown source is marked";
}

TEST_F(LibraryActions, ATakeThatIsPlayedAppearsAsAGhost) {
  s_window->ticker().pause();
  QTest::qWait(100);
  const auto ghost = [] {
    return test::pixels_of_hue(test::picture_of(s_window->scene()), s_window->colours().ghost_passive);
  };
  const int before = ghost();
  takes().setSelectedTake(0);
  takes().togglePlay();
  EXPECT_TRUE(takes().isPlaying());
  QTest::qWait(60);
  EXPECT_GT(ghost(), before + 60);
  takes().togglePlay();
  EXPECT_FALSE(takes().isPlaying());
  EXPECT_LT(ghost(), before + 60);
  s_window->ticker().follow();
}

TEST_F(LibraryActions, AnExcludedTakeIsNotSelectedFromUntilItIsUsedAgain) {
  const auto source = [] { return takes().model().sourceTake(); };
  ASSERT_TRUE(until([&] { return source() >= 0; }));
  const int take = source();
  desk().toggleVeto(take);
  EXPECT_TRUE(until([&] { return source() >= 0 && source() != take; }));
  EXPECT_TRUE(until([&] { return takes().model().isVetoed(take); }));
  s_window->undoStack().undo();
  EXPECT_TRUE(until([&] { return !takes().model().isVetoed(take); })) << "a step of undo";
}

TEST_F(LibraryActions, ATakeCanPlayTheUserAndIsThenNotAnsweredFrom) {
  const std::string name = takes().model().row(0).name;
  takes().setSelectedTake(0);
  takes().dance();
  ASSERT_TRUE(until([&] { return input() == name; }));
  EXPECT_TRUE(until([] { return takes().model().isUsers(0); }));
  EXPECT_TRUE(
      until([] { return s_window->ticker().shown() && takes().model().coverage().user_frames() > 20; }));
  EXPECT_EQ(takes().model().coverage().times_selected(0), 0);
}

TEST_F(LibraryActions, TwoMotionsAskWhatTheyAreForAndBecomeALibrary) {
  s_window->openFiles(written_couple());
  ASSERT_NE(desk().building(), nullptr);
  LibraryBuild& build = *desk().building();
  ASSERT_TRUE(until([&] { return !build.isBusy(); }));
  EXPECT_TRUE(build.dialog().isVisible());
  for (auto* button : build.dialog().findChildren<QPushButton*>())
    if (button->text() == "Build") button->click();
  ASSERT_TRUE(until([] { return s_window->session()->material().library->name() == "library"; }));
  EXPECT_EQ(takes().model().row(0).name, "x");
  EXPECT_TRUE(until([] { return desk().building() == nullptr; }));
}

TEST_F(LibraryActions, OneMotionStaysTheUser) {
  const QStringList files = written_couple();
  s_window->openFiles({files[0]});
  EXPECT_EQ(desk().building(), nullptr);
  EXPECT_TRUE(until([] { return input() == "x_leader"; }));
}

TEST_F(LibraryActions, AClosedDialogLeavesWhatIsOpen) {
  const std::string before = input();
  s_window->openFiles(written_couple());
  ASSERT_NE(desk().building(), nullptr);
  ASSERT_TRUE(until([] { return !desk().building()->isBusy(); }));
  desk().building()->dialog().reject();
  EXPECT_EQ(desk().building(), nullptr);
  EXPECT_EQ(input(), before);
}

}  // namespace
}  // namespace abrazo::app::library_actions_test
