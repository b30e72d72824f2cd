// Recording takes in the whole window: keys, panel, timeline, undo, and what is in the file.
#include <QFile>
#include <QLineEdit>
#include <QPushButton>

#include "app/workbench/document/session_places.hpp"
#include "app/workbench/labels/annotation_desk.hpp"
#include "app/workbench/project/project_desk.hpp"
#include "app/workbench/stream/stream_desk.hpp"
#include "app/workbench/takes/take_desk.hpp"
#include "core/session/file/session_file.hpp"
#include "tests/workbench/demo_window.hpp"
#include "tests/workbench/streamed_performer.hpp"
#include "widgets/common/message_bar.hpp"
#include "widgets/takes/countdown.hpp"
#include "widgets/takes/take_panel.hpp"
#include "widgets/timeline/timeline_view.hpp"
#include "widgets/timeline/transport_bar.hpp"

namespace abrazo::app::take_actions_test {
namespace {

class TakeActions : public DemoWindow {
 protected:
  static void SetUpTestSuite() { showDemo({1400, 900}); }
  void SetUp() override {
    DemoWindow::SetUp();
    panel().setCountdown(0);
    panel().setTypedName("salsa");
  }
  static TakeDesk& desk() { return *window().findChild<TakeDesk*>(); }
  static widgets::TakePanel& panel() { return *window().findChild<widgets::TakePanel*>(); }
  static const RecordedTake& last() { return desk().takes().all().back(); }
  static void record_a_take(std::uint64_t frames = 20) {
    desk().toggle();
    ASSERT_TRUE(desk().isRecording());
    ASSERT_TRUE(until([&] { return last().frames >= frames; }));
    desk().toggle();
    ASSERT_FALSE(desk().isRecording());
    ASSERT_TRUE(is_finished());
  }
  /// A worker ends the recording.
  static bool is_finished() {
    return until([] { return !desk().finishing(); });
  }
  static std::vector<std::string> names_in_file() {
    std::vector<std::string> names;
    EXPECT_TRUE(is_finished());
    const auto session = SessionFile::open(desk().file().toStdString());
    if (!session) return {session.error().text()};
    for (const SessionTake& take : (*session)->contents().takes) names.push_back(take.name);
    return names;
  }
};

TEST_F(TakeActions, TheKeyRecordsATakeIntoAFileAndEndsIt) {
  press(Qt::Key_R, Qt::ControlModifier);
  ASSERT_TRUE(desk().isRecording());
  EXPECT_TRUE(until([] { return window().transport().recordingText().contains("REC  salsa 0"); }))
      << window().transport().recordingText().toStdString();
  EXPECT_TRUE(window().timeline().takes().back().is_running);
  ASSERT_TRUE(until([] { return last().frames > 20; }));
  press(Qt::Key_R, Qt::ControlModifier);
  EXPECT_FALSE(desk().isRecording());
  EXPECT_TRUE(window().transport().recordingText().isEmpty());
  EXPECT_FALSE(window().timeline().takes().back().is_running);
  EXPECT_TRUE(QFile::exists(desk().file()));
  EXPECT_EQ(names_in_file().back(), last().name);  // waits for the worker
  const auto session = SessionFile::open(desk().file().toStdString());
  ASSERT_TRUE(session) << session.error().text();
  EXPECT_TRUE((*session)->contents().runs.back().finished) << "it was closed in order";
}

/// A disk may take seconds for it; the window does not wait.
TEST_F(TakeActions, AWorkerFinishesTheFileAndTheNextTakeGoesIntoItToo) {
  record_a_take();
  desk().toggle();
  ASSERT_TRUE(until([] { return last().frames >= 5; }));
  const QString file = desk().file();
  desk().toggle();
  EXPECT_TRUE(desk().finishing());
  EXPECT_FALSE(window().session()->engine().recorder());
  const std::string first = last().name;
  desk().toggle();  // before the window has heard that it is finished
  ASSERT_TRUE(until([] { return last().frames >= 5; }));
  EXPECT_EQ(desk().file(), file);
  desk().toggle();
  const std::vector<std::string> names = names_in_file();
  ASSERT_GE(names.size(), 2U);
  EXPECT_EQ(names[names.size() - 2], first);
  EXPECT_EQ(names.back(), last().name);
  EXPECT_FALSE(desk().finishing());
}

/// All of a stream is recorded, so it begins when its file can be written, and the window answers meanwhile.
TEST_F(TakeActions, AStreamIsOpenedWhenTheFileOfTheLastTakeIsFinished) {
  auto& streams = *window().findChild<StreamDesk*>();
  const SessionEngine& engine = window().session()->engine();
  const bool kept = window().remembered().keepsEverything();
  window().remembered().setKeepsEverything(true);
  desk().toggle();
  ASSERT_TRUE(until([] { return last().frames >= 5; }));
  const QString file = desk().file();
  desk().toggle();
  ASSERT_TRUE(desk().finishing());
  streams.connectTo("vmc://127.0.0.1:0");
  EXPECT_FALSE(engine.receiver());
  EXPECT_TRUE(streams.isConnected()) << "it is on its way";
  EXPECT_TRUE(until([&] { return engine.receiver() != nullptr; }));
  ASSERT_TRUE(engine.recorder());
  EXPECT_EQ(engine.recorder()->state().path, file.toStdString());
  streams.disconnectStream();
  window().remembered().setKeepsEverything(kept);
  EXPECT_TRUE(until([&] { return !engine.recorder() && !desk().finishing(); }));
}

class TakeOfAStream : public TakeActions {
 protected:
  void SetUp() override {
    TakeActions::SetUp();
    streams().connectTo("vmc://127.0.0.1:0");
    ASSERT_TRUE(until([] { return streams().health().has_value(); }));
    m_performer =
        std::make_unique<StreamedPerformer>(window().session()->material().input,
                                            "vmc://" + QString::fromStdString(streams().health()->listening));
    ASSERT_TRUE(until([] { return live().times.arrived_s >= 0; }));
  }
  void TearDown() override {
    streams().disconnectStream();
    m_performer.reset();
    EXPECT_TRUE(until([] { return !window().session()->engine().recorder() && !desk().finishing(); }));
  }
  static StreamDesk& streams() { return *window().findChild<StreamDesk*>(); }
  static const FrameSnapshot& live() { return *window().session()->engine().latest().newest(); }

 private:
  std::unique_ptr<StreamedPerformer> m_performer;
};

/// The clip that plays the user afterwards is not the performer.
TEST_F(TakeOfAStream, DisconnectingEndsItAndSaysSo) {
  press(Qt::Key_R, Qt::ControlModifier);
  ASSERT_TRUE(desk().isRecording());
  ASSERT_TRUE(until([] { return last().frames >= 20; }));
  action("Disconnect")->trigger();
  EXPECT_FALSE(desk().isRecording());
  EXPECT_EQ(window().messages().text(),
            QString::fromStdString(last().name) + " ended, because its stream was disconnected");
  ASSERT_TRUE(until([] { return live().input_frame >= 0; })) << "the clip goes on";
  const auto frames = window().session()->history().range(last().from_s, last().to_s);
  ASSERT_GE(frames.size(), 20U);
  for (const FrameSnapshotPtr& frame : frames) EXPECT_EQ(frame->input_frame, -1) << "not of the clip";
}

TEST_F(TakeOfAStream, ItIsNotBegunWhenTheStreamEndsDuringItsCountdown) {
  const std::size_t before = desk().takes().all().size();
  panel().setCountdown(10);
  press(Qt::Key_R, Qt::ControlModifier);
  action("Disconnect")->trigger();
  EXPECT_TRUE(window().messages().text().contains("countdown")) << window().messages().text().toStdString();
  const auto* countdown = window().scene().findChild<widgets::Countdown*>();
  EXPECT_TRUE(until([&] { return !countdown->isVisible(); }));
  EXPECT_FALSE(desk().isRecording());
  EXPECT_EQ(desk().takes().all().size(), before);
}

TEST_F(TakeActions, AgainCountsUpAndBeginsAtOnce) {
  record_a_take();
  const std::size_t before = desk().takes().all().size();
  panel().setCountdown(5);
  press(Qt::Key_R, Qt::ControlModifier | Qt::ShiftModifier);
  ASSERT_TRUE(desk().isRecording());
  ASSERT_TRUE(until([] { return last().frames > 5; }));
  press(Qt::Key_R, Qt::ControlModifier | Qt::ShiftModifier);
  ASSERT_TRUE(desk().isRecording());
  ASSERT_TRUE(until([] { return last().frames > 5; }));
  desk().toggle();
  const auto names = desk().takes().names();
  ASSERT_EQ(names.size(), before + 2);
  EXPECT_NE(names[before], names[before + 1]);
  EXPECT_TRUE(QString::fromStdString(names[before + 1]).startsWith("salsa "));
}

TEST_F(TakeActions, ACountdownStandsOverTheSceneAndCanBeGivenUp) {
  const std::size_t before = desk().takes().all().size();
  panel().setCountdown(10);
  desk().toggle();
  EXPECT_FALSE(desk().isRecording());
  auto* countdown = window().scene().findChild<widgets::Countdown*>();
  ASSERT_NE(countdown, nullptr);
  EXPECT_TRUE(until([&] { return countdown->isVisible(); }));
  desk().toggle();
  EXPECT_TRUE(until([&] { return !countdown->isVisible(); }));
  EXPECT_EQ(desk().takes().all().size(), before);
}

TEST_F(TakeActions, RenamingAndDeletingAreStepsOfUndoAndReachTheFile) {
  record_a_take();
  const RecordedTake take = last();
  emit panel().renameRequested(take.id, "warm-up");
  EXPECT_EQ(last().name, "warm-up");
  EXPECT_EQ(names_in_file().back(), "warm-up");
  window().undoStack().undo();
  EXPECT_EQ(last().name, take.name);
  EXPECT_EQ(names_in_file().back(), take.name);
  emit panel().removeRequested(take.id);
  EXPECT_EQ(desk().takes().find(take.id), nullptr);
  window().undoStack().undo();
  ASSERT_NE(desk().takes().find(take.id), nullptr);
  EXPECT_EQ(*desk().takes().find(take.id), take);
}

TEST_F(TakeActions, ATakeOfTheSameNameIsRefused) {
  record_a_take();
  const std::string other = desk().takes().all().front().name;
  record_a_take();
  const std::string before = last().name;
  emit panel().renameRequested(last().id, QString::fromStdString(other));
  EXPECT_EQ(last().name, before);
}

TEST_F(TakeActions, GoingToATakeSetsInAndOutThere) {
  record_a_take();
  emit panel().goToRequested(last().id);
  turn();
  const auto range = ticker().playback().range();
  ASSERT_TRUE(range);
  EXPECT_NEAR(range->from_s, last().from_s, 1e-6);
  EXPECT_NEAR(range->to_s, last().to_s, 1e-6);
  EXPECT_EQ(ticker().playback().state, Playback::State::Parked);
  ticker().follow();
}

TEST_F(TakeActions, LookingAtATakeOfTheLibraryMeanwhileDoesNotChangeWhatIsRecorded) {
  auto& subjects = *window().findChild<AnnotationDesk*>();
  const std::string of_library = window().session()->material().library->takes().front().name;
  desk().toggle();
  ASSERT_TRUE(until([] { return last().frames >= 20; }));
  subjects.showSubject(of_library);
  turn();
  desk().toggle();
  ASSERT_EQ(names_in_file().back(), last().name) << "it was kept";
  const FrameSnapshotPtr newest = window().session()->engine().latest().newest();
  EXPECT_GE(last().frames, 20U);
  EXPECT_LE(last().to_s, newest->time_s) << "in times of the session, not of the take";
  EXPECT_GT(last().to_s, last().from_s);
  desk().goTo(last().id);
  EXPECT_EQ(window().document().subject(), "") << "a recorded take is of the session";
  EXPECT_NEAR(ticker().playback().range()->from_s, last().from_s, 1e-6);
  ticker().follow();
}

TEST_F(TakeActions, ACopyHasTheTakesAsTheyAreOnTheList) {
  record_a_take();
  emit panel().removeRequested(last().id);
  const QString copy = home().filePath("copy.abrazo");
  auto& project = *window().findChild<ProjectDesk*>();
  project.saveAs(copy);
  ASSERT_TRUE(until([&] { return !project.isSaving(); }));
  EXPECT_EQ(desk().file(), copy);
  const auto session = SessionFile::open(copy.toStdString());
  ASSERT_TRUE(session) << session.error().text();
  EXPECT_EQ((*session)->contents().takes.size(), desk().takes().all().size());
  EXPECT_GT((*session)->contents().frames, 20U);
}

TEST_F(TakeActions, AMarkerSetWhileRecordingIsInTheFileOnce) {
  const auto markers_in_file = [] {
    EXPECT_TRUE(is_finished());
    const auto session = SessionFile::open(desk().file().toStdString());
    return session ? (*session)->contents().markers : std::vector<SessionMarker>();
  };
  desk().toggle();
  ASSERT_TRUE(until([] { return last().frames >= 5; }));
  press(Qt::Key_M);
  ASSERT_EQ(window().timeline().markers().all().size(), 1U);
  const Marker set = window().timeline().markers().all().front();
  ASSERT_TRUE(until([] { return last().frames >= 20; }));
  desk().toggle();
  ASSERT_EQ(markers_in_file().size(), 1U);
  EXPECT_NEAR(markers_in_file()[0].time_s, set.time_s, 1e-9);
  record_a_take();
  EXPECT_EQ(markers_in_file().size(), 1U) << "the next run of the file has it, too, and it is the same one";
  window().undoStack().undo();
  record_a_take();
  EXPECT_TRUE(markers_in_file().empty()) << "undone before the take";
}

}  // namespace
}  // namespace abrazo::app::take_actions_test
