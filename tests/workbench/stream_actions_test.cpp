// Live streams in the whole window: real packets over the loopback, as a person sees and steers them.
#include <QApplication>
#include <QComboBox>
#include <QDockWidget>
#include <QFile>
#include <QLabel>
#include <QMenu>
#include <QPushButton>
#include <QSignalSpy>
#include <fstream>

#include "app/workbench/labels/annotation_desk.hpp"
#include "app/workbench/project/project_desk.hpp"
#include "app/workbench/shell/panel_area.hpp"
#include "app/workbench/shell/status_figures.hpp"
#include "app/workbench/stream/latency_desk.hpp"
#include "app/workbench/stream/stream_desk.hpp"
#include "core/motion/bvh/bvh.hpp"
#include "core/session/file/session_file.hpp"
#include "tests/workbench/demo_window.hpp"
#include "tests/workbench/streamed_performer.hpp"
#include "widgets/common/message_bar.hpp"
#include "widgets/common/offer_bar.hpp"
#include "widgets/settings/settings_panel.hpp"
#include "widgets/stream/address_form.hpp"
#include "widgets/stream/connection_panel.hpp"
#include "widgets/stream/latency_button.hpp"
#include "widgets/stream/performer_card.hpp"
#include "widgets/stream/scene_notice.hpp"
#include "widgets/stream/sink_list.hpp"
#include "widgets/stream/stream_head.hpp"
#include "widgets/timeline/timeline_view.hpp"
#include "widgets/timeline/transport_bar.hpp"

namespace abrazo::app::stream_actions_test {
namespace {

using widgets::StreamMark;

class StreamActions : public DemoWindow {
 protected:
  static void SetUpTestSuite() { showDemo({1280, 800}); }
  void SetUp() override {
    ASSERT_TRUE(ticker().shown()) << "the demo did not start";
    desk().disconnectStream();
    ticker().follow();
    DemoWindow::SetUp();
  }
  static StreamDesk& desk() { return *window().findChild<StreamDesk*>(); }
  static widgets::ConnectionPanel& panel() { return *window().findChild<widgets::ConnectionPanel*>(); }
  static QString notice() {
    const auto* found = window().findChild<widgets::SceneNotice*>();
    return found->isVisible() ? found->words() : QString();
  }
  static const FrameSnapshot& live() { return *window().session()->latest().newest(); }
  static const Clip& clip() { return window().session()->material().input; }
  /// Connects to a port that is free, once the recording of the last stream is on disk. @return where to send
  /// to
  static QString listen() {
    desk().connectTo("vmc://127.0.0.1:0");
    EXPECT_TRUE(until([] { return desk().health().has_value(); }));
    return desk().health() ? "vmc://" + QString::fromStdString(desk().health()->listening) : QString();
  }
  /// What the panel says below the button.
  static QString calibration() {
    for (const auto* label : panel().findChildren<QLabel*>())
      if (label->accessibleName() == "Calibration") return label->text();
    return {};
  }
  static void calibrate() {
    press(Qt::Key_T, Qt::ControlModifier);
    ASSERT_TRUE(until([] { return !desk().calibration().is_under_way(); }));
    ASSERT_TRUE(calibration().startsWith("Calibrated")) << calibration().toStdString();
    ASSERT_TRUE(until([] { return desk().health()->performers.front().calibrated; }));
  }
  /// The library of the session has it.
  static void label_a_take() {
    auto& labels = *window().findChild<AnnotationDesk*>();
    const auto library = window().session()->material().library;
    labels.showSubject(library->takes().front().name);
    Annotations next = window().document().annotations();
    const int moves = next.first_of(TierKind::Move)->id;
    ASSERT_TRUE(next.draw(moves, 0, 0.5, "a new move", Conflict::Replace, labels.range()));
    window().document().changeAnnotations(next, "label");
    ASSERT_TRUE(until([&] { return window().session()->material().library != library; }));
    labels.showSubject("");
  }
  /// Everything that the window tells, also what something else covered since.
  class Told {
   public:
    Told() {
      QObject::connect(&window().messages(), &widgets::MessageBar::told, &m_here,
                       [this](widgets::MessageKind, const QString& text) { m_all << text; });
    }
    std::string all() const { return m_all.join('\n').toStdString(); }

   private:
    QStringList m_all;
    QObject m_here;
  };
  /// As a person does who opens the panel by its key.
  static void type_address_and_return(const QString& uri) {
    press(Qt::Key_K, Qt::ControlModifier);
    ASSERT_TRUE(panel().form().isAncestorOf(QApplication::focusWidget()));
    QTest::keyClicks(QApplication::focusWidget(), uri);
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_Return);
  }
  static bool receives() {
    return until([] {
      return desk().health() && !desk().health()->performers.empty() && live().times.arrived_s >= 0;
    });
  }
};

TEST_F(StreamActions, ConnectOpensThePanelAndGoesToTheAddress) {
  press(Qt::Key_K, Qt::ControlModifier);
  EXPECT_TRUE(window().panels().isWanted("connection"));
  EXPECT_TRUE(panel().form().isAncestorOf(QApplication::focusWidget()));
}

/// The focus stayed in the field: Space and digits were typed into the address.
TEST_F(StreamActions, AfterConnectTheKeysAreTheSessionsAgain) {
  type_address_and_return("vmc://127.0.0.1:0");
  ASSERT_TRUE(until([] { return desk().health().has_value(); }));
  ASSERT_EQ(QApplication::focusWidget(), &window().scene());
  ASSERT_EQ(ticker().playback().state, Playback::State::Following);
  QTest::keyClick(QApplication::focusWidget(), Qt::Key_Space);
  turn();
  EXPECT_EQ(ticker().playback().state, Playback::State::Parked);
  EXPECT_EQ(panel().form().uri(), "vmc://127.0.0.1:0");
}

TEST_F(StreamActions, AfterAConnectThatFailsTheFocusStaysInTheAddress) {
  const auto other =
      StreamReceiver::open(uri_of("vmc://127.0.0.1:0"), window().session()->engine().clock()).value();
  const QString taken = QString::fromStdString(other->health().listening).section(':', -1);
  type_address_and_return("vmc://127.0.0.1:" + taken);
  ASSERT_TRUE(until([&] { return window().messages().text().contains(taken); }));
  EXPECT_FALSE(desk().isConnected());
  EXPECT_TRUE(panel().form().isAncestorOf(QApplication::focusWidget())) << "where it can be mended";
}

/// A stream may connect long after it was asked for, when its name is found or a library is open.
TEST_F(StreamActions, WhoWentOnElsewhereBeforeTheStreamConnectedStaysThere) {
  press(Qt::Key_K, Qt::ControlModifier);
  window().timeline().setFocus(Qt::TabFocusReason);
  ASSERT_EQ(QApplication::focusWidget(), &window().timeline());
  listen();
  EXPECT_EQ(QApplication::focusWidget(), &window().timeline());
}

/// It went to the end of the take: a take has no live end.
TEST_F(StreamActions, ATakeThatIsAnnotatedKeepsItsCursorWhenAStreamConnects) {
  auto& labels = *window().findChild<AnnotationDesk*>();
  labels.showSubject(window().session()->material().library->takes().front().name);
  ticker().seek(1);
  turn();
  const double cursor_s = ticker().playback().cursor_s;
  ASSERT_GT(ticker().playback().last_s, cursor_s + 1);
  const auto stays = [cursor_s] {
    return ticker().playback().state == Playback::State::Parked && ticker().playback().cursor_s == cursor_s;
  };
  const StreamedPerformer performer(clip(), listen());
  EXPECT_TRUE(until([] { return desk().health() && !desk().health()->performers.empty(); }));
  EXPECT_TRUE(stays()) << ticker().playback().cursor_s;
  press(Qt::Key_T, Qt::ControlModifier);
  EXPECT_TRUE(desk().calibration().is_under_way());
  EXPECT_TRUE(stays()) << "nor does a calibration move it";
  press(Qt::Key_T, Qt::ControlModifier);
  labels.showSubject("");
  window().panels().want("annotation", false);
  EXPECT_EQ(ticker().playback().state, Playback::State::Following) << "the session is where it was";
  action("Disconnect")->trigger();
  EXPECT_TRUE(until([] { return live().input_frame >= 0; })) << "its clip is held no longer";
  EXPECT_TRUE(until([] { return ticker().shown() != nullptr; }));
}

TEST_F(StreamActions, WhileNothingHasComeTheSceneSaysSoAndTheClipIsHeld) {
  listen();
  EXPECT_TRUE(until([] { return notice().contains("Waiting for the first packet of vmc://127.0.0.1:0"); }));
  EXPECT_EQ(panel().findChild<widgets::StreamHead*>()->shown().mark, StreamMark::Waiting);
  QSignalSpy polls(&desk(), &StreamDesk::polled);
  // What was on its way comes through first; a clip that went on would give a new frame between any two
  // polls.
  EXPECT_TRUE(until([&polls] {
    const auto index = live().index;
    const int before = polls.count();
    return until([&] { return polls.count() >= before + 2; }) && live().index == index;
  })) << "nobody dances";
}

TEST_F(StreamActions, WhatComesInPlaysTheUser) {
  const StreamedPerformer performer(clip(), listen());
  ASSERT_TRUE(receives());
  EXPECT_TRUE(until([] { return notice().isEmpty(); }));
  EXPECT_TRUE(until([] { return panel().cards().size() == 1; }));
  EXPECT_EQ(panel().cards()[0]->part(), widgets::PerformerPart::User);
  EXPECT_EQ(live().input_frame, -1) << "no frame of the clip";
  auto* latency = window().findChild<widgets::LatencyButton*>();
  EXPECT_TRUE(until([latency] { return latency->words().contains("ms"); }));
}

TEST_F(StreamActions, TheWindowNamesTheStreamAfterItsSenderAndThePortIsADetail) {
  const StreamedPerformer performer(clip(), listen());
  ASSERT_TRUE(receives());
  EXPECT_TRUE(until([] { return window().status().words().front() == "VMC from this machine"; }))
      << window().status().words().front().toStdString();
  const QString detail = QString::fromStdString(panel().findChild<widgets::StreamHead*>()->shown().detail);
  EXPECT_TRUE(detail.contains(QString::fromStdString(desk().health()->listening))) << detail.toStdString();
}

TEST_F(StreamActions, AfterDisconnectingTheClipGoesOn) {
  const StreamedPerformer performer(clip(), listen());
  ASSERT_TRUE(receives());
  action("Disconnect")->trigger();
  EXPECT_FALSE(desk().health());
  EXPECT_FALSE(action("Calibrate in T-pose")->isEnabled());
  EXPECT_TRUE(until([] { return live().input_frame >= 0; }));
  EXPECT_EQ(notice(), QString());
}

TEST_F(StreamActions, OnlyAPerformerIsCalledLive) {
  {
    const StreamedPerformer performer(clip(), listen());
    ASSERT_TRUE(receives());
    EXPECT_TRUE(until([] { return window().transport().stateText() == "● LIVE"; }));
  }
  action("Disconnect")->trigger();
  EXPECT_EQ(window().transport().stateText(), "▶ CLIP");
  EXPECT_EQ(window().status().words().front(), "clip " + QString::fromStdString(clip().name));
}

TEST_F(StreamActions, APortThatIsTakenIsToldWithWhatToDo) {
  const auto other =
      StreamReceiver::open(uri_of("vmc://127.0.0.1:0"), window().session()->engine().clock()).value();
  const QString taken = QString::fromStdString(other->health().listening).section(':', -1);
  desk().connectTo("vmc://127.0.0.1:" + taken);
  EXPECT_TRUE(until([] { return !desk().isConnected(); }));
  EXPECT_TRUE(window().messages().text().contains(taken)) << window().messages().text().toStdString();
}

TEST_F(StreamActions, AConnectionThatFailsLeavesTheOneThatWorks) {
  listen();
  const auto other =
      StreamReceiver::open(uri_of("vmc://127.0.0.1:0"), window().session()->engine().clock()).value();
  const QString taken = QString::fromStdString(other->health().listening).section(':', -1);
  desk().connectTo("vmc://127.0.0.1:" + taken);
  EXPECT_TRUE(until([&] { return window().messages().text().contains(taken); }));
  EXPECT_TRUE(until([] { return desk().health().has_value(); }));
  EXPECT_TRUE(desk().isConnected());
  EXPECT_TRUE(window().messages().text().contains(taken)) << window().messages().text().toStdString();
}

TEST_F(StreamActions, WhenTheSenderStopsABadgeSaysSo) {
  {
    const StreamedPerformer performer(clip(), listen());
    ASSERT_TRUE(receives());
  }
  EXPECT_TRUE(
      until([] { return notice().contains("Nothing comes in") || notice().contains("Tracking lost"); }));
  EXPECT_TRUE(until([] { return window().transport().stateText().contains("NO INPUT"); }));
  const auto* latency = window().findChild<widgets::LatencyButton*>();
  EXPECT_TRUE(until([latency] { return latency->words().endsWith("–"); }))
      << "that of before is no figure of now";
}

/// It has another port then, and is another performer. The first was looked for, whose tracking stayed lost.
TEST_F(StreamActions, ASenderThatIsStartedAgainPlaysTheUserAgain) {
  const QString to = listen();
  QString first;
  {
    const StreamedPerformer performer(clip(), to);
    ASSERT_TRUE(receives());
    first = desk().user();
  }
  ASSERT_TRUE(until([] { return !notice().isEmpty(); }));
  const StreamedPerformer again(clip(), to);
  ASSERT_TRUE(until([&] { return desk().user() != first; })) << first.toStdString();
  for (const widgets::PerformerCard* card : panel().cards()) {
    const QString name = QString::fromStdString(card->shown().performer);
    EXPECT_EQ(card->part() == widgets::PerformerPart::User, name == desk().user()) << name.toStdString();
  }
  EXPECT_TRUE(until([] { return notice().isEmpty(); })) << notice().toStdString();
}

TEST_F(StreamActions, OfTwoSendersThatBeginTogetherAPersonIsAskedWhichOneIsTheUser) {
  const QString to = listen();
  const StreamedPerformer one(clip(), to), other(clip(), to);
  const auto* question = window().findChild<widgets::OfferBar*>("which user");
  ASSERT_TRUE(until([question] { return question->isVisible(); }));
  EXPECT_TRUE(question->text().contains(desk().user() + " is followed now"))
      << question->text().toStdString();
  QPushButton* answer = nullptr;
  for (auto* button : question->findChildren<QPushButton*>())
    if (button->isVisible() && button->text() != desk().user()) answer = button;
  ASSERT_TRUE(answer);
  const QString chosen = answer->text();
  answer->click();
  EXPECT_EQ(desk().user(), chosen);
  EXPECT_TRUE(until([] { return desk().health()->undecided.empty(); }));
  EXPECT_FALSE(question->isVisible());
}

/// Of a stream that has not ended: that one has is told there, too.
TEST_F(StreamActions, TheNoticeIsNotShownOverTheLiveEndsPast) {
  listen();
  ASSERT_TRUE(until([] { return !notice().isEmpty(); }));
  ticker().seek(0.5);
  EXPECT_TRUE(until([] { return notice().isEmpty(); }));
}

/// A performer cannot be held; what was named "Freeze the input" recorded on.
TEST_F(StreamActions, OfAStreamOnlyTheViewIsFrozenAndTheEntrySaysSo) {
  ASSERT_TRUE(action("Freeze the input"));
  const StreamedPerformer performer(clip(), listen());
  ASSERT_TRUE(receives());
  EXPECT_FALSE(action("Freeze the input"));
  EXPECT_TRUE(action("Park the view or follow; the stream goes on"));
  EXPECT_FALSE(action("Hold the input still")->isEnabled());
  action("Disconnect")->trigger();
  EXPECT_TRUE(action("Freeze the input"));
  EXPECT_TRUE(action("Hold the input still")->isEnabled());
}

TEST_F(StreamActions, FreezeParksTheViewWhileTheStreamGoesOn) {
  const StreamedPerformer performer(clip(), listen());
  ASSERT_TRUE(receives());
  press(Qt::Key_Space, Qt::ControlModifier);
  EXPECT_EQ(ticker().playback().state, Playback::State::Parked);
  const auto index = live().index;
  EXPECT_TRUE(until([index] { return live().index > index + 10; }));
  press(Qt::Key_Space, Qt::ControlModifier);
  EXPECT_EQ(ticker().playback().state, Playback::State::Following);
}

TEST_F(StreamActions, ThePartnerIsSentOnAndIsAnotherProgramsPerformer) {
  const auto engine = StreamReceiver::open(uri_of("vmc://127.0.0.1:0"), SessionClock()).value();
  const QString to = "vmc://" + QString::fromStdString(engine->health().listening);
  desk().send(to, Character::Partner);
  EXPECT_TRUE(until([&] { return !engine->health().performers.empty(); }));
  EXPECT_EQ(window().session()->engine().sinks().size(), 1U);
  EXPECT_TRUE(remembered().recentSinks().contains(to));
  desk().stopSending(to);
  EXPECT_TRUE(window().session()->engine().sinks().empty());
}

TEST_F(StreamActions, ACalibrationCountsDownMeasuresAndTells) {
  StreamedPerformer performer(clip(), listen());
  ASSERT_TRUE(receives());
  performer.standStill();
  press(Qt::Key_T, Qt::ControlModifier);
  EXPECT_TRUE(notice().startsWith("3"));
  EXPECT_TRUE(until([] { return notice().startsWith("Hold still"); }));
  EXPECT_TRUE(until([] { return !desk().calibration().is_under_way(); }));
  EXPECT_EQ(desk().calibration().stage(), CalibrationSteps::Stage::Done) << desk().calibration().words();
  EXPECT_TRUE(window().messages().text().contains("Calibrated")) << window().messages().text().toStdString();
}

TEST_F(StreamActions, ACalibrationOfSomeoneWhoDancesIsToldAsDoubtful) {
  const StreamedPerformer performer(clip(), listen());
  ASSERT_TRUE(receives());
  press(Qt::Key_T, Qt::ControlModifier);
  EXPECT_TRUE(until([] { return !desk().calibration().is_under_way(); }));
  EXPECT_TRUE(desk().calibration().is_doubtful()) << desk().calibration().words();
  EXPECT_TRUE(QString::fromStdString(desk().calibration().words()).contains("stand still"));
  const QString said = window().messages().text();
  EXPECT_TRUE(said.startsWith("Calibrated, but doubtful: ")) << said.toStdString();
  EXPECT_TRUE(said.endsWith("Ctrl+T calibrates again, Live > Forget the calibration undoes it"));
  EXPECT_LT(said.size(), 220) << "the rest is in the panel; the scene should be seen";
}

TEST_F(StreamActions, ADoubtfulCalibrationIsCalledSoUntilItIsUndone) {
  const QString free_port = listen();
  desk().connectTo(free_port);  // to undo it listens anew, at the port that was named
  const StreamedPerformer performer(clip(), free_port);
  ASSERT_TRUE(receives());
  press(Qt::Key_T, Qt::ControlModifier);
  ASSERT_TRUE(until([] { return !desk().calibration().is_under_way(); }));
  desk().poll();
  const QString about = panel().cards().front()->toolTip();
  EXPECT_TRUE(about.contains("calibrated, doubtful")) << about.toStdString();
  EXPECT_TRUE(about.contains("stand still")) << "and why: " << about.toStdString();
  action("Forget the calibration")->trigger();
  EXPECT_FALSE(window().messages().openErrors().join(' ').contains("doubtful"))
      << "what it was about is gone";
  EXPECT_TRUE(until([] {
    desk().poll();
    return !panel().cards().empty() && panel().cards().front()->toolTip().contains("not calibrated");
  }));
}

/// The library had taken the labels and so seemed to be another one: the stream went on.
TEST_F(StreamActions, AClipThatIsOpenedPlaysTheUserAlsoWhenLabelsAreDiscardedForIt) {
  auto& project = *window().findChild<ProjectDesk*>();
  const Clip dancer = clip();
  const QString motion = home().filePath("walk.bvh");
  std::ofstream(motion.toStdString()) << *write_bvh(std::vector<Clip>{dancer});
  StreamedPerformer performer(dancer, listen());
  performer.standStill();
  ASSERT_TRUE(receives());
  calibrate();
  label_a_take();
  int asked = 0;
  ProjectDesk::Answer answer = ProjectDesk::Answer::Cancel;
  project.ask = [&] { return ++asked, answer; };
  project.setAsks(true);
  const QString stream = desk().uri(), measured = calibration();
  window().openFiles({motion});
  ASSERT_TRUE(until([&] { return asked == 1; }));
  desk().connectTo("clip:" + motion);
  ASSERT_TRUE(until([&] { return asked == 2; }));
  turn();
  EXPECT_EQ(desk().uri(), stream) << "cancelled";
  EXPECT_EQ(calibration(), measured);
  EXPECT_EQ(clip().name, dancer.name);
  const auto index = live().index;
  EXPECT_TRUE(until([index] { return live().index > index && live().times.arrived_s >= 0; }));
  answer = ProjectDesk::Answer::Discard;
  const Told told;
  window().openFiles({motion});
  ASSERT_TRUE(until([&] { return window().session()->material().reading.file == motion.toStdString(); }));
  EXPECT_FALSE(desk().isConnected());
  EXPECT_NE(told.all().find("walk plays the user; " + stream.toStdString() +
                            " was disconnected, and its calibration ended"),
            std::string::npos)
      << told.all();
  EXPECT_TRUE(calibration().startsWith("Sets rest pose")) << calibration().toStdString();
  EXPECT_TRUE(until([] {
    const auto newest = window().session()->latest().newest();
    return newest && newest->input_frame >= 0;
  }));
  project.setAsks(false);
  window().openDemo();
  ASSERT_TRUE(until([] { return window().session()->material().reading.file.empty() && ticker().shown(); }));
}

/// Its text stayed, though the stream came uncalibrated from then on.
TEST_F(StreamActions, AnotherLibraryKeepsTheStreamAndSaysThatItsCalibrationEnded) {
  const Clip dancer = clip();
  const QString free_port = listen();
  desk().connectTo(free_port);  // listens there again in the next session
  StreamedPerformer performer(dancer, free_port);
  performer.standStill();
  ASSERT_TRUE(receives());
  calibrate();
  const auto* session = window().session();
  const Told told;
  window().openDemo();
  ASSERT_TRUE(until([&] { return window().session() != session && window().session()->latest().newest(); }));
  EXPECT_EQ(desk().uri(), free_port);
  EXPECT_NE(told.all().find("goes on without its calibration"), std::string::npos) << told.all();
  EXPECT_TRUE(calibration().startsWith("Sets rest pose")) << calibration().toStdString();
  EXPECT_TRUE(until([] {
    desk().poll();
    return desk().health() && !desk().health()->performers.empty() &&
           !desk().health()->performers.front().calibrated;
  }));
}

TEST_F(StreamActions, CtrlTAgainCancelsTheCalibration) {
  const StreamedPerformer performer(clip(), listen());
  ASSERT_TRUE(receives());
  press(Qt::Key_T, Qt::ControlModifier);
  press(Qt::Key_T, Qt::ControlModifier);
  EXPECT_FALSE(desk().calibration().is_under_way());
  EXPECT_TRUE(until([] { return notice().isEmpty(); }));
}

TEST_F(StreamActions, TheStepRateOfThePanelIsASettingAndAStepOfUndo) {
  const double before_hz = window().document().settings().step_rate_hz;
  emit panel().stepRateRequested("30");
  EXPECT_EQ(window().document().settings().step_rate_hz, 30);
  desk().poll();
  QComboBox* rate = nullptr;
  for (auto* box : panel().findChildren<QComboBox*>())
    if (box->accessibleName() == "Solver step rate") rate = box;
  EXPECT_EQ(rate->currentText(), "30 Hz");
  window().undoStack().undo();
  EXPECT_EQ(window().document().settings().step_rate_hz, before_hz);
}

TEST_F(StreamActions, ConnectionsAreRememberedLatestFirst) {
  listen();
  EXPECT_EQ(remembered().recentStreams().front(), "vmc://127.0.0.1:0");
}

TEST_F(StreamActions, AFrameOfThePastTellsItsOwnLatency) {
  const StreamedPerformer performer(clip(), listen());
  ASSERT_TRUE(receives());
  const auto came = live().index;
  ASSERT_TRUE(until([came] { return live().index > came + 20; }));
  const auto past = window().session()->history().at(live().time_s - 0.1);
  ticker().seek(past->time_s);
  ASSERT_TRUE(until([&] { return ticker().shown()->index == past->index; }));
  const auto sample = window().findChild<LatencyDesk*>()->log().of(window().session()->history(), *past);
  EXPECT_NEAR(sample.end_to_end, 1000 * (past->times.solved_s - past->times.arrived_s), 1e-6);
}

/// The file grew by every frame of the stream, without a save.
TEST_F(StreamActions, ASavedSessionChangesWhenItIsSavedNotWhenAStreamIsConnected) {
  const QString file = home().filePath("my take.abrazo");
  auto& project = *window().findChild<ProjectDesk*>();
  const auto is_saved = [&] { return !project.isSaving(); };
  const auto contents = [&] {
    QFile opened(file);
    return opened.open(QIODevice::ReadOnly) ? opened.readAll() : QByteArray();
  };
  const SessionEngine& engine = window().session()->engine();
  ASSERT_TRUE(until([&] { return !engine.recorder(); })) << "of the stream before";
  project.saveAs(file);
  ASSERT_TRUE(until(is_saved));
  const QByteArray saved = contents();
  ASSERT_FALSE(saved.isEmpty());
  const Clip dancer = clip();
  StreamedPerformer performer(dancer, listen());
  ASSERT_TRUE(receives());
  EXPECT_TRUE(window().messages().text().contains("saving adds it to my take.abrazo"))
      << window().messages().text().toStdString();
  const std::uint64_t first = live().index;
  ASSERT_TRUE(until([&] { return live().index > first + 50; }));
  EXPECT_FALSE(engine.recorder());
  EXPECT_EQ(contents(), saved);
  project.save();
  ASSERT_TRUE(until(is_saved));
  const auto session = SessionFile::open(file.toStdString());
  ASSERT_TRUE(session) << session.error().text();
  EXPECT_GT((*session)->contents().last_frame, first + 40) << "now the frames of the stream are in it";
  EXPECT_TRUE((*session)->recovery().empty());
  desk().disconnectStream();
}

}  // namespace
}  // namespace abrazo::app::stream_actions_test
