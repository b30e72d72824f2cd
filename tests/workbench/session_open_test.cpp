// A recorded session in the window again: the same frames, takes and markers, and it can go on.
#include <gmock/gmock.h>

#include <QCoreApplication>
#include <QFile>
#include <QProcess>
#include <QPushButton>

#include "app/workbench/document/session_places.hpp"
#include "app/workbench/takes/take_desk.hpp"
#include "core/opening/session_material.hpp"
#include "core/session/file/session_database.hpp"
#include "core/session/file/session_edit.hpp"
#include "core/session/file/session_file.hpp"
#include "tests/workbench/demo_window.hpp"
#include "widgets/candidates/candidate_table.hpp"
#include "widgets/common/message_bar.hpp"
#include "widgets/takes/leftover_bar.hpp"
#include "widgets/takes/take_panel.hpp"
#include "widgets/timeline/timeline_view.hpp"

namespace abrazo::app::session_open_test {
namespace {

/// A second of the generated dance, recorded and opened again.
class SessionOpen : public DemoWindow {
 protected:
  static void SetUpTestSuite() {
    showDemo({1400, 900});
    desk().toggle();
    until([] { return !desk().takes().empty() && desk().takes().all().back().frames > 60; });
    desk().toggle();
    until([] { return !desk().finishing(); });
    s_take = desk().takes().all().back();
    for (const FrameSnapshotPtr& frame : history().range(s_take.from_s, s_take.to_s))
      if (frame->time_s > (s_take.from_s + s_take.to_s) / 2 && !s_middle) s_middle = frame;
    s_file = desk().file();
    window().openFiles({s_file});
    until([] { return window().session()->material().recorded && ticker().shown(); });
  }
  static void TearDownTestSuite() {
    s_middle.reset();
    DemoWindow::TearDownTestSuite();
  }
  void SetUp() override {
    DemoWindow::SetUp();
    ASSERT_TRUE(window().session()->material().recorded) << window().messages().text().toStdString();
  }
  static TakeDesk& desk() { return *window().findChild<TakeDesk*>(); }
  static const FrameHistory& history() { return window().session()->history(); }
  /// A copy of the session in which the frames of this condition are damaged.
  static std::string copy_without(const std::string& frames) {
    const std::string copy = s_file.toStdString() + "-copy.abrazo";
    QFile::remove(QString::fromStdString(copy));
    EXPECT_TRUE(copy_session(s_file.toStdString(), copy));
    auto database = SessionDatabase::open(copy, SessionDatabase::Access::Write);
    EXPECT_TRUE(database && database->execute("UPDATE frames SET active = zeroblob(10) WHERE " + frames) &&
                database->close());
    return copy;
  }
  static inline RecordedTake s_take;
  static inline FrameSnapshotPtr s_middle;
  static inline QString s_file;
};

TEST_F(SessionOpen, StandsAtItsBeginningAndSaysWhatItIs) {
  EXPECT_EQ(ticker().playback().state, Playback::State::Parked);
  EXPECT_TRUE(window().windowTitle().contains("session "));
  EXPECT_TRUE(window().messages().openErrors().isEmpty());
  ASSERT_EQ(desk().takes().all().size(), 1U);
  EXPECT_EQ(desk().takes().all()[0].name, s_take.name);
  EXPECT_EQ(window().timeline().takes().size(), 1U);
}

TEST_F(SessionOpen, ShowsTheRecordedFrameWhereTheCursorIs) {
  ASSERT_TRUE(s_middle);
  ticker().seek(s_middle->time_s + 1e-4);
  ASSERT_TRUE(until([] { return ticker().shown() && ticker().shown()->index == s_middle->index; }))
      << ticker().shown()->time_s << " for " << s_middle->time_s;
  const FrameSnapshot& shown = *ticker().shown();
  EXPECT_EQ(shown.user, s_middle->user);
  EXPECT_EQ(shown.result.result, s_middle->result.result);
  EXPECT_EQ(shown.result.candidates.size(), s_middle->result.candidates.size());
  EXPECT_EQ(shown.result.edges, s_middle->result.edges) << "the mesh comes from the library";
  EXPECT_EQ(shown.settings, s_middle->settings);
  EXPECT_FALSE(window().candidates().rows().empty());
}

TEST_F(SessionOpen, TheTimelineHasItsLanes) {
  ASSERT_TRUE(until([] { return !window().timeline().tracks().sources().empty(); }));
  EXPECT_NEAR(window().timeline().tracks().sources().front().from_s, history().span().first_s, 0.2);
  EXPECT_NEAR(window().timeline().tracks().sources().back().to_s, history().span().last_s, 0.2);
}

TEST_F(SessionOpen, ItsFramesCanBeSolvedAgainWithOtherSettings) {
  auto again = history().solvable_again(s_take.to_s - 0.1, s_take.to_s);
  const FrameSnapshotPtr first = again.run_up.empty() ? again.frames.next() : again.run_up.front();
  ASSERT_TRUE(first);
  EXPECT_NE(first->before, nullptr);
}

TEST_F(SessionOpen, DamagedFramesArePassedOverAndSaidAndNothingIsOpenedWhenNoneIsLeft) {
  const auto opened_without = [&](const std::string& frames) -> Result<Material> {
    auto opened = open_session(copy_without(frames));
    if (!opened) return opened.error();
    SessionWish wish;
    wish.open = window().session()->material();
    return material_of(*opened, wish, {});
  };
  const auto some = opened_without("frame % 3 = 0");
  ASSERT_TRUE(some) << some.error().text();
  EXPECT_THAT(some->warnings, testing::Contains(testing::HasSubstr("frames are damaged and passed over")));
  const auto none = opened_without("1");
  ASSERT_FALSE(none);
  EXPECT_NE(none.error().text().find("frames can be read"), std::string::npos) << none.error().text();
}

TEST_F(SessionOpen, AProgramThatIsToTakeAPictureOfADamagedOneEnds) {
  const QString picture = s_file + "-picture.png";
  const auto says = [&](const std::string& session) {
    QProcess program;
    program.start(QCoreApplication::applicationDirPath() + "/abrazo-workbench",
                  {QString::fromStdString(session), "--screenshot", picture, "--after", "0.1"});
    EXPECT_TRUE(program.waitForFinished(-1)) << program.errorString().toStdString();  // ctest has the limit
    return std::pair(program.exitCode(), program.readAllStandardError().toStdString());
  };
  const auto none = says(copy_without("1"));
  EXPECT_EQ(none.first, 1);
  EXPECT_THAT(none.second, testing::HasSubstr("frames can be read"));
  EXPECT_FALSE(QFile::exists(picture));
  const auto some = says(copy_without("frame % 3 = 0"));
  EXPECT_EQ(some.first, 0) << some.second;
  EXPECT_TRUE(QFile::exists(picture));
}

TEST_F(SessionOpen, ATakeInWhichNothingMovedIsNotKept) {
  desk().toggle();
  EXPECT_TRUE(desk().isRecording());
  desk().toggle();
  EXPECT_EQ(desk().takes().all().size(), 1U);
  EXPECT_TRUE(window().messages().text().contains("no frames"));
  EXPECT_EQ(desk().file(), s_file) << "recorded into the same file";
}

TEST(SessionPlaces, ASessionGetsAFileOfItsOwn) {
  const QTemporaryDir folder;
  const QDateTime now(QDate(2026, 11, 21), QTime(14, 3));
  const QString first = new_session_file(folder.path(), now);
  EXPECT_TRUE(first.endsWith("/session 2026-11-21 14-03.abrazo"));
  QFile made(first);
  ASSERT_TRUE(made.open(QIODevice::WriteOnly));
  EXPECT_TRUE(new_session_file(folder.path(), now).endsWith("14-03 (2).abrazo"));
  EXPECT_TRUE(unclosed_sessions(folder.path()).isEmpty());
  QFile log(first + "-wal");
  ASSERT_TRUE(log.open(QIODevice::WriteOnly));
  log.write("x");
  log.close();
  EXPECT_EQ(unclosed_sessions(folder.path()), QStringList{first});
  delete_session(first);
  EXPECT_FALSE(QFile::exists(first) || QFile::exists(first + "-wal"));
}

TEST(Leftovers, AreOfferedOneAfterTheOther) {
  widgets::LeftoverBar bar;
  QStringList opened, discarded;
  QObject::connect(&bar, &widgets::LeftoverBar::openRequested, [&](const QString& file) { opened << file; });
  QObject::connect(&bar, &widgets::LeftoverBar::discardRequested,
                   [&](const QString& file) { discarded << file; });
  bar.offer({{"a.abrazo", "Session of 14:03 was not closed; 12 min, 3 takes"}, {"b.abrazo", "another"}});
  EXPECT_TRUE(bar.text().contains("12 min, 3 takes"));
  const auto buttons = bar.findChildren<QPushButton*>();
  buttons[2]->click();
  EXPECT_TRUE(bar.text().contains("another"));
  buttons[0]->click();
  EXPECT_EQ(opened, QStringList{"b.abrazo"});
  EXPECT_EQ(discarded, QStringList{"a.abrazo"});
  EXPECT_TRUE(bar.isHidden());
}

}  // namespace
}  // namespace abrazo::app::session_open_test
