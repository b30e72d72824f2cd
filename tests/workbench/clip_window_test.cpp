// A clip in the whole window is a document with an end; what is live begins with a stream.
#include <gtest/gtest.h>

#include <QDir>
#include <QFileInfo>
#include <QTest>
#include <functional>

#include "app/workbench/project/history_desk.hpp"
#include "app/workbench/project/project_desk.hpp"
#include "app/workbench/shell/status_figures.hpp"
#include "app/workbench/stream/stream_desk.hpp"
#include "core/session/frames/time_place.hpp"
#include "tests/workbench/demo_window.hpp"
#include "tests/workbench/streamed_performer.hpp"
#include "widgets/plots/plot_panel.hpp"
#include "widgets/timeline/timeline_view.hpp"
#include "widgets/timeline/transport_bar.hpp"

namespace abrazo::app::clip_window_test {
namespace {

using State = Playback::State;

class ClipInTheWindow : public DemoWindow {
 protected:
  static void SetUpTestSuite() { showWindow({1280, 720}, false); }
  /// Each test on the clip from its beginning, solved to its end.
  void SetUp() override {
    DemoWindow::SetUp();
    project().setAsks(true);
    project().ask = [this] { return ++m_asked, ProjectDesk::Answer::Discard; };
    history_desk().ask = [this](double) { return ++m_asked, HistoryDesk::Answer::Discard; };
    stream().disconnectStream();
    window().document().putSettings(preset("responsive").value());
    window().openDemo();
    ASSERT_TRUE(until([] { return window().session() && window().session()->isClip() && isWhole(); }));
    m_asked = 0;
  }
  static ProjectDesk& project() { return *window().findChild<ProjectDesk*>(); }
  static HistoryDesk& history_desk() { return *window().findChild<HistoryDesk*>(); }
  static StreamDesk& stream() { return *window().findChild<StreamDesk*>(); }
  static SessionEngine& engine() { return window().session()->engine(); }
  static const Clip& clip() { return window().session()->material().input; }
  static bool isWhole() {
    const auto progress = engine().clip_progress();
    const FrameSnapshotPtr newest = engine().latest().newest();
    return progress && progress->is_whole() && newest && !newest->is_learning;
  }
  static std::vector<FrameSnapshotPtr> frames() { return window().session()->history().since(0); }
  static QString filesBelow(const QString& folder) {
    return QDir(folder).entryList(QDir::AllEntries | QDir::NoDotAndDotDot).join(' ');
  }
  /// Whether a session of its own began, with nothing but a live performer.
  static bool isForStream() {
    return window().session() && window().session()->material().use == InputUse::Stream;
  }

  int m_asked = 0;  ///< questions about what would be lost
};

TEST_F(ClipInTheWindow, ItIsSolvedOnceOverItsLengthAndNothingIsAddedAfterwards) {
  const auto solved = frames();
  ASSERT_EQ(solved.size(), clip().poses.size());
  EXPECT_EQ(solved.back()->input_frame, static_cast<std::int64_t>(clip().poses.size()) - 1);
  QTest::qWait(600);
  EXPECT_EQ(frames().size(), solved.size());
  EXPECT_EQ(frames().back(), solved.back());
}

TEST_F(ClipInTheWindow, ItPlaysOnceAndStopsAtItsEnd) {
  EXPECT_EQ(ticker().playback().state, State::Playing) << "from the beginning, without being asked";
  const double end_s = static_cast<double>(clip().poses.size() - 1) / clip().fps;
  ticker().seek(end_s - 0.2);
  ticker().toggle();
  ASSERT_TRUE(until([] { return ticker().playback().state == State::Parked; }));
  EXPECT_NEAR(ticker().playback().cursor_s, end_s, 1e-9);
  ticker().toggle();
  ASSERT_TRUE(until([] { return ticker().playback().state == State::Playing; }));
  EXPECT_LT(ticker().playback().cursor_s, 5) << "played again, it begins anew";
}

TEST_F(ClipInTheWindow, SeekingShowsTheSolvedFrameWithTheNumberOfTheClip) {
  constexpr std::int64_t wanted = 1204;
  ticker().seek(wanted / clip().fps);
  ASSERT_TRUE(until([] { return ticker().shown() && ticker().shown()->input_frame == wanted; }));
  EXPECT_EQ(window().transport().timeText(), QString("00:20.067"));
  EXPECT_EQ(window().transport().stateText(), "PARKED");
}

TEST_F(ClipInTheWindow, NothingOfItIsOnDiskAndNobodyIsAskedWhenItEnds) {
  EXPECT_EQ(history_desk().folder(), "");
  EXPECT_EQ(filesBelow(remembered().historyFolder()), "");
  EXPECT_TRUE(window().isLeft());
  EXPECT_EQ(m_asked, 0);
}

TEST_F(ClipInTheWindow, AChangedSettingSolvesItAgainAndTheFrameThatIsSeenShowsIt) {
  ticker().seek(10);
  ASSERT_TRUE(until([] { return ticker().shown() && ticker().shown()->input_frame == 600; }));
  window().document().changeSetting("alpha", "0.9");
  EXPECT_TRUE(until([] { return ticker().shown()->settings.alpha == 0.9; }));
  ASSERT_TRUE(until([] { return frames().back()->settings.alpha == 0.9 && isWhole(); }));
  const auto again = frames();
  EXPECT_EQ(again.size(), clip().poses.size()) << "in place";
  EXPECT_TRUE(std::ranges::all_of(again, [](const auto& frame) { return frame->settings.alpha == 0.9; }));
  EXPECT_EQ(ticker().shown()->input_frame, 600) << "the cursor stays";
}

/// The lanes of the labels went dead, and the markers with them.
TEST_F(ClipInTheWindow, SolvedAgainItKeepsLabelsAndMarkersOnTheTimeline) {
  Markers markers = window().document().markers();
  markers.add(0.7, "clap");
  window().document().changeMarkers(markers, "mark");
  const auto tiers = window().timeline().tiers().annotations;
  window().document().changeSetting("alpha", "0.8");
  ASSERT_TRUE(until([] { return frames().back()->settings.alpha == 0.8 && isWhole(); }));
  QTest::qWait(300);  // the panels have followed
  EXPECT_EQ(window().timeline().tiers().annotations, tiers);
  EXPECT_EQ(window().timeline().markers(), markers);
  EXPECT_EQ(window().document().markers(), markers);
}

/// The selection `intent` learns the library while the first frames are solved by Eq. 7.
TEST_F(ClipInTheWindow, NoFrameIsLeftThatWasSolvedBeforeTheLibraryWasLearned) {
  for (const FrameSnapshotPtr& frame : frames()) {
    ASSERT_FALSE(frame->is_learning) << frame->index;
    ASSERT_EQ(frame->settings.selection, SelectionMethod::Intent) << frame->index;
  }
}

TEST_F(ClipInTheWindow, APinIsOfTheWholeClipAlsoWhereTheCursorIsParked) {
  ticker().seek(5);
  Decisions next = window().document().decisions();
  next.pinned = 7;
  window().document().decide(next, "pin", false);
  EXPECT_FALSE(window().document().triedPin());
  EXPECT_TRUE(until([] {
    const auto all = frames();
    return isWhole() && std::ranges::all_of(all, [](const auto& frame) {
             return frame->decisions && frame->decisions->pinned == 7;
           });
  }));
  window().undoStack().undo();
}

TEST_F(ClipInTheWindow, SavingItWritesWhatWasMadeByHandAndNoFrame) {
  window().document().changeSetting("alpha", "0.4");
  const QString file = home().filePath("clip.abrazo");
  bool is_saved = false;
  QObject::connect(&project(), &ProjectDesk::saved, &project(), [&] { is_saved = true; });
  project().saveAs(file);
  ASSERT_TRUE(until([&] { return is_saved; }));
  EXPECT_LT(QFileInfo(file).size(), 1 << 20);
  window().openFiles({file});
  ASSERT_TRUE(until([&] {
    return window().session() && window().session()->material().project && window().session()->isClip() &&
           isWhole();
  }));
  EXPECT_EQ(window().document().settings().alpha, 0.4);
  EXPECT_EQ(frames().size(), clip().poses.size()) << "solved again";
  EXPECT_EQ(m_asked, 0);
}

TEST_F(ClipInTheWindow, AStreamHasASessionOfItsOwnAndAfterItThePartnerStandsStillAndNothingIsSent) {
  const auto library = window().session()->material().library_of_files();
  const Clip danced = clip();
  stream().connectTo("vmc://127.0.0.1:39771");
  ASSERT_TRUE(until([] { return isForStream() && engine().receiver(); }));
  EXPECT_EQ(window().session()->material().library_of_files(), library);
  {
    const StreamedPerformer performer(danced, "vmc://127.0.0.1:39771");
    ASSERT_TRUE(until([] { return engine().history().span().frames > 20; }));
  }
  EXPECT_LT(engine().history().at(0)->input_frame, 0) << "nothing of the clip is in it";
  EXPECT_TRUE(ticker().playback().is_live);
  stream().send("vmc://127.0.0.1:39772", Character::Partner);
  ASSERT_TRUE(until([] { return !engine().sinks().empty(); }));
  stream().disconnectStream();
  const auto sent = [] { return engine().sinks().front().frames; };
  QTest::qWait(100);
  const auto before = sent();
  const auto solved = engine().history().span().frames;
  QTest::qWait(800);
  EXPECT_EQ(sent(), before) << "no clip takes the performer's place, and no pose is held";
  EXPECT_EQ(engine().history().span().frames, solved);
  stream().stopSending("vmc://127.0.0.1:39772");
}

TEST_F(ClipInTheWindow, AfterAStreamTheClipIsThereAgain) {
  QAction* back = action("Back to the clip");
  ASSERT_NE(back, nullptr);
  EXPECT_FALSE(back->isEnabled());
  stream().connectTo("vmc://127.0.0.1:39771");
  ASSERT_TRUE(until([] { return isForStream() && engine().receiver(); }));
  EXPECT_TRUE(window().windowTitle().contains("live with")) << window().windowTitle().toStdString();
  EXPECT_FALSE(back->isEnabled()) << "a stream plays the user";
  stream().disconnectStream();
  ASSERT_TRUE(back->isEnabled());
  back->trigger();
  ASSERT_TRUE(until([] { return window().session() && window().session()->isClip() && isWhole(); }));
  EXPECT_FALSE(back->isEnabled());
  EXPECT_FALSE(window().windowTitle().contains("live with")) << window().windowTitle().toStdString();
}

TEST_F(ClipInTheWindow, PlayedAsLiveItGoesOnWithoutEnd) {
  QAction* play = action("Play the clip as live");
  ASSERT_NE(play, nullptr);
  play->trigger();
  ASSERT_TRUE(until([] {
    return window().session() && window().session()->material().use == InputUse::ClipAsLive &&
           engine().history().span().frames > 20;
  }));
  EXPECT_TRUE(ticker().playback().is_live);
  EXPECT_EQ(ticker().playback().state, State::Following);
  EXPECT_TRUE(play->isChecked());
  play->trigger();
  EXPECT_TRUE(until([] { return window().session() && window().session()->isClip(); }));
}

TEST_F(ClipInTheWindow, ANewSessionKeepsTheLibraryAndResetsSettingsAndRole) {
  const auto library = window().session()->material().library_of_files();
  window().document().changeSetting("alpha", "0.7");
  window().document().changeSetting("user-role", "passive");
  press(Qt::Key_N, Qt::ControlModifier);
  EXPECT_EQ(m_asked, 1) << "settings were changed";
  ASSERT_TRUE(
      until([] { return window().document().settings() == preset("responsive").value() && isWhole(); }));
  EXPECT_EQ(window().session()->material().library_of_files(), library);
}

TEST_F(ClipInTheWindow, ATakeOfTheLibraryIsPlayedOnceToo) {
  window().requestSubject("salsa_02");
  ASSERT_TRUE(until([] { return window().session()->looksElsewhere() && ticker().shown(); }));
  EXPECT_FALSE(ticker().playback().is_live);
  ticker().follow();
  EXPECT_EQ(ticker().playback().state, State::Parked) << "at its end";
  window().requestSubject("");
  ASSERT_TRUE(until([] { return !window().session()->looksElsewhere(); }));
  EXPECT_FALSE(ticker().playback().is_live) << "the clip is one as before";
}

}  // namespace
}  // namespace abrazo::app::clip_window_test
