// Two streamed performers become a take of the open library: real packets over the loopback, the menu, the
// dialog, and the library that the session goes on with.
#include <QComboBox>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QLineEdit>
#include <QPushButton>
#include <QSignalSpy>

#include "app/workbench/document/library_feed.hpp"
#include "app/workbench/labels/annotation_desk.hpp"
#include "app/workbench/stream/stream_desk.hpp"
#include "app/workbench/takes/pair_desk.hpp"
#include "app/workbench/takes/pair_dialog.hpp"
#include "app/workbench/takes/take_desk.hpp"
#include "core/choreography/salsa.hpp"
#include "core/library/store/motion_library_file.hpp"
#include "tests/workbench/demo_window.hpp"
#include "tests/workbench/streamed_performer.hpp"
#include "widgets/candidates/candidate_table.hpp"
#include "widgets/common/message_bar.hpp"
#include "widgets/library/take_list.hpp"
#include "widgets/takes/take_panel.hpp"
#include "widgets/timeline/timeline_view.hpp"

namespace abrazo::app::pair_actions_test {
namespace {

constexpr int patience_ms = 60'000;

class PairActions : public DemoWindow {
 protected:
  static void SetUpTestSuite() {
    showDemo({1280, 800});
    ChoreographyOptions dance;
    dance.seed = 77;
    dance.minutes = 0.25;
    dance.take_seconds = 15;
    s_dance = std::make_unique<PairedTake>(generate_salsa(dance).front());
    for (Clip* clip : {&s_dance->a, &s_dance->b}) clip->poses.resize(120);  // danced over and over
  }
  static void TearDownTestSuite() {
    s_dance.reset();
    DemoWindow::TearDownTestSuite();
  }
  void SetUp() override {
    ASSERT_TRUE(ticker().shown()) << "the demo did not start";
    DemoWindow::SetUp();
    window().findChild<widgets::TakePanel*>()->setCountdown(0);
    streams().disconnectStream();
    ticker().follow();
  }
  void TearDown() override {
    if (takes().isRecording()) takes().toggle();
    if (dialog()) dialog()->reject();
    turn();
  }

  static StreamDesk& streams() { return *window().findChild<StreamDesk*>(); }
  static TakeDesk& takes() { return *window().findChild<TakeDesk*>(); }
  static PairDesk& pairs() { return *window().findChild<PairDesk*>(); }
  static PairDialog* dialog() {
    for (auto* each : window().findChildren<PairDialog*>())
      if (each->isVisible()) return each;
    return nullptr;
  }
  template <typename Field>
  static Field& field(const QString& name) {
    for (auto* each : dialog()->findChildren<Field*>())
      if (each->accessibleName() == name) return *each;
    throw std::runtime_error("the dialog has no field " + name.toStdString());
  }
  static void press_add() {
    for (auto* button : dialog()->findChildren<QPushButton*>())
      if (button->text() == "Add to library") return button->click();
  }
  static void record_or_end() { action("Record a pair for the library")->trigger(); }
  static double recorded_s() {
    const auto& take = takes().takes().all().back();
    return take.to_s - take.from_s;
  }

  static std::shared_ptr<const MotionLibrary> library() { return window().session()->material().library; }
  static const FrameSnapshot& live() { return *window().session()->latest().newest(); }
  /// Connects to a port that is free. @return where to send to
  static QString listen() {
    streams().connectTo("vmc://127.0.0.1:0");
    EXPECT_TRUE(streams().health());
    return streams().health() ? "vmc://" + QString::fromStdString(streams().health()->listening) : QString();
  }
  static bool comes(std::size_t performers) {
    return until(
        [performers] { return streams().health() && streams().health()->performers.size() == performers; },
        patience_ms);
  }
  /// Both dancers, of whom the leader plays the user.
  struct Couple {
    explicit Couple(const QString& to) : leader(std::make_unique<StreamedPerformer>(s_dance->a, to)) {
      EXPECT_TRUE(comes(1));
      streams().setUser(QString::fromStdString(streams().health()->performers[0].performer));
      follower = std::make_unique<StreamedPerformer>(s_dance->b, to);
      EXPECT_TRUE(comes(2));
      for (const PerformerHealth& each : streams().health()->performers)
        if (each.performer != streams().user().toStdString())
          streams().setSecond(QString::fromStdString(each.performer));
      EXPECT_TRUE(until([] { return live().times.arrived_s >= 0; }, patience_ms));
    }
    std::unique_ptr<StreamedPerformer> leader, follower;
  };
  static void record_a_pair(double seconds) {
    record_or_end();
    ASSERT_TRUE(until([] { return takes().isRecording(); }, patience_ms));
    ASSERT_TRUE(until([seconds] { return recorded_s() > seconds; }, patience_ms));
    record_or_end();
    ASSERT_TRUE(until([] { return dialog() != nullptr; }, patience_ms));
  }

  static inline std::unique_ptr<PairedTake> s_dance;
};

TEST_F(PairActions, OnePerformerIsNoPair) {
  const StreamedPerformer alone(s_dance->a, listen());
  ASSERT_TRUE(comes(1));
  record_or_end();
  EXPECT_FALSE(takes().isRecording());
  EXPECT_TRUE(window().messages().text().contains("two performers"));
}

TEST_F(PairActions, TwoStreamedPerformersBecomeATakeOfTheLibraryAndTheSessionGoesOn) {
  const Couple couple(listen());
  const auto before = library();
  record_a_pair(2.5);
  field<QLineEdit>("Name").setText("live couple");
  field<QComboBox>("Role").setCurrentIndex(0);
  field<QComboBox>("Move").setCurrentText("walk");
  field<QDoubleSpinBox>("Cut off at the beginning").setValue(0.1);
  field<QDoubleSpinBox>("Cut off at the end").setValue(0.1);
  const auto index = live().index;
  QSignalSpy extended(&pairs(), &PairDesk::extended);
  press_add();
  ASSERT_TRUE(until([&] { return extended.count() == 1; }, patience_ms))
      << window().messages().text().toStdString() << (dialog() ? dialog()->trouble().toStdString() : "");
  EXPECT_EQ(dialog(), nullptr);

  const auto after = library();
  ASSERT_EQ(after->takes().size(), before->takes().size() + 1);
  const LibraryTake& take = after->takes().back();
  EXPECT_EQ(take.name, "live couple");
  EXPECT_EQ(after->pair_count(), before->pair_count() + take.frames);
  EXPECT_GT(take.frames / take.fps, 1.5);
  ASSERT_EQ(take.roles.size(), 1U);
  EXPECT_EQ(take.roles[0].active, ActivePerformer::A);
  ASSERT_EQ(take.labels.size(), 1U);
  EXPECT_EQ(take.labels[0].label, "walk");
  EXPECT_EQ(window().session()->material().library, after);
  EXPECT_TRUE(until([&] { return ticker().shown()->library == after; })) << "frames are shown as it has them";

  EXPECT_TRUE(streams().isConnected());
  EXPECT_EQ(ticker().playback().state, Playback::State::Following);
  EXPECT_TRUE(until([&] { return live().index > index + 60; }, patience_ms));
  EXPECT_GE(live().times.arrived_s, 0) << "the stream still plays the user";
  EXPECT_TRUE(until(
      [&] {
        const auto& result = live().result;
        if (result.selected < 0) return false;
        const int pair = result.candidates[static_cast<std::size_t>(result.selected)].pair;
        return pair >= before->pair_count();
      },
      patience_ms))
      << "who dances the same again is answered from the new take";
  EXPECT_TRUE(until([] { return !window().takes().coverageText().contains("being measured"); }, patience_ms));

  const QString file = home().filePath("longer.h5");
  pairs().save(file);
  const auto read = read_library(file.toStdString());
  ASSERT_TRUE(read) << read.error().text();
  EXPECT_EQ(read->pair_count(), after->pair_count());
  EXPECT_EQ(read->takes().back().name, "live couple");
}

TEST_F(PairActions, ANameThatTheLibraryHasIsAskedForAgainAndNothingIsLost) {
  const Couple couple(listen());
  const auto before = library();
  record_a_pair(1.5);
  field<QLineEdit>("Name").setText(QString::fromStdString(before->takes().front().name));
  press_add();
  ASSERT_NE(dialog(), nullptr);
  EXPECT_TRUE(dialog()->trouble().contains("another name")) << dialog()->trouble().toStdString();
  dialog()->reject();
  EXPECT_EQ(library(), before);
}

TEST_F(PairActions, ATakeAndALabelThatComeAtTheSameTimeAreBothInTheLibrary) {
  auto& desk = *window().findChild<AnnotationDesk*>();
  desk.showSubject(library()->takes().front().name);
  Annotations next = window().document().annotations();
  const int moves = next.first_of(TierKind::Move)->id;
  ASSERT_TRUE(next.draw(moves, 0, 1, "said meanwhile", Conflict::Replace, desk.range()));
  PairedTake take = *s_dance;
  take.name = "added meanwhile";
  take.labels.clear();
  take.roles = {{0, static_cast<int>(take.a.poses.size()), ActivePerformer::A}};
  QSignalSpy extended(&pairs(), &PairDesk::extended);
  window().document().changeAnnotations(next, "label");
  pairs().extend(take);
  ASSERT_TRUE(until([&] { return extended.count() == 1 && desk.feed().isIdle(); }, patience_ms))
      << window().messages().text().toStdString();
  EXPECT_GE(library()->find_take("added meanwhile"), 0);
  ASSERT_FALSE(library()->takes().front().labels.empty());
  EXPECT_EQ(library()->takes().front().labels.front().label, "said meanwhile");
  desk.showSubject("");
}

TEST_F(PairActions, TheLanesOfTheTimelineStayWhenATakeIsAdded) {
  const auto tracks = [] { return window().timeline().tracks(); };
  ASSERT_TRUE(until([&] { return !tracks().sources().empty(); }, patience_ms));
  PairedTake take = *s_dance;
  take.name = "added to the lanes";
  take.roles = {{0, static_cast<int>(take.a.poses.size()), ActivePerformer::A}};
  const auto before = tracks();
  widgets::TimelineTracks after;
  QSignalSpy extended(&pairs(), &PairDesk::extended);
  QObject here;
  QObject::connect(&pairs(), &PairDesk::extended, &here, [&] { after = tracks(); });
  pairs().extend(take);
  ASSERT_TRUE(until([&] { return extended.count() == 1; }, patience_ms))
      << window().messages().text().toStdString();
  ASSERT_GE(after.sources().size(), before.sources().size()) << "in the turn of the change already";
  for (std::size_t i = 0; i < before.sources().size(); ++i) {
    EXPECT_EQ(after.sources()[i].from_s, before.sources()[i].from_s) << i;
    EXPECT_EQ(after.sources()[i].key, before.sources()[i].key) << i;
  }
  EXPECT_GE(after.moves().size(), before.moves().size());
}

TEST_F(PairActions, TheCountdownIsNotOfThePair) {
  const Couple couple(listen());
  window().findChild<widgets::TakePanel*>()->setCountdown(3);
  record_a_pair(1.0);
  EXPECT_LT(field<QDoubleSpinBox>("Cut off at the end").maximum(), recorded_s() + 1);
}

TEST_F(PairActions, ACountdownThatIsGivenUpLeavesNoPairBehind) {
  const Couple couple(listen());
  window().findChild<widgets::TakePanel*>()->setCountdown(10);
  record_or_end();
  EXPECT_FALSE(takes().isRecording());
  record_or_end();
  window().findChild<widgets::TakePanel*>()->setCountdown(0);
  takes().toggle();
  ASSERT_TRUE(takes().isRecording());
  ASSERT_TRUE(until([] { return recorded_s() > 0.3; }, patience_ms));
  takes().toggle();
  turn();
  EXPECT_EQ(dialog(), nullptr) << "a take of one is no pair";
}

}  // namespace
}  // namespace abrazo::app::pair_actions_test
