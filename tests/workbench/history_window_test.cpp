// The history of a session in the whole window: held, on disk, left behind; and a pin on a parked frame.
#include <gtest/gtest.h>

#include <QApplication>
#include <QDir>
#include <QDockWidget>
#include <QFile>
#include <QMessageBox>
#include <QPushButton>
#include <QTest>
#include <QTimer>
#include <QToolButton>
#include <fstream>
#include <functional>

#include "app/workbench/compare/comparison_desk.hpp"
#include "app/workbench/document/session_places.hpp"
#include "app/workbench/labels/annotation_desk.hpp"
#include "app/workbench/project/history_desk.hpp"
#include "app/workbench/project/project_desk.hpp"
#include "app/workbench/shell/panel_area.hpp"
#include "app/workbench/shell/status_figures.hpp"
#include "app/workbench/stream/stream_desk.hpp"
#include "app/workbench/takes/take_desk.hpp"
#include "core/motion/bvh/bvh.hpp"
#include "tests/workbench/demo_window.hpp"
#include "tests/workbench/streamed_performer.hpp"
#include "widgets/candidates/candidate_table.hpp"
#include "widgets/common/message_bar.hpp"
#include "widgets/takes/leftover_bar.hpp"
#include "widgets/timeline/timeline_view.hpp"
#include "widgets/timeline/transport_bar.hpp"

namespace abrazo::app::history_window_test {
namespace {

using State = Playback::State;

class HistoryInTheWindow : public DemoWindow {
 protected:
  static void SetUpTestSuite() {
    showDemo({1280, 720}, 120);
    QTest::qWait(300);
  }
  void SetUp() override {
    ASSERT_TRUE(until([] { return ticker().shown() != nullptr; })) << "the demo did not start";
    DemoWindow::SetUp();
    window().document().put(Decisions{});
    window().document().tryPin({});
    if (is_held()) press(Qt::Key_Space, Qt::ControlModifier);
    ticker().follow();
    ASSERT_TRUE(until([] { return !is_held() && ticker().playback().state == State::Following; }));
  }
  static SessionEngine& engine() { return window().session()->engine(); }
  static bool is_held() { return engine().is_held(); }
  /// What is recorded once the step that was being solved has ended.
  static auto settled() {
    auto span = engine().history().span();
    EXPECT_TRUE(until([&span] {
      const auto before = span;
      QTest::qWait(200);
      span = engine().history().span();
      return span.frames == before.frames && span.bytes == before.bytes;
    }));
    return span;
  }
  static HistoryDesk& desk() { return *window().findChild<HistoryDesk*>(); }
  /// A tenth of a second counts, and the question is answered, as long as this lives.
  struct AskedAbout {
    AskedAbout(HistoryDesk& of, HistoryDesk::Answer answer) : desk(of), own(of.ask) {
      desk.settles_s = 0.1;
      desk.ask = [this, answer](double) { return ++times, answer; };
    }
    ~AskedAbout() {
      desk.settles_s = history_settles_s;
      desk.ask = own;
    }
    AskedAbout(const AskedAbout&) = delete;
    AskedAbout& operator=(const AskedAbout&) = delete;

    HistoryDesk& desk;
    std::function<HistoryDesk::Answer(double)> own;
    int times = 0;
  };
  static ComparisonDesk& comparison() { return *window().findChild<ComparisonDesk*>(); }
  static int winner_of(const FrameSnapshot& frame) {
    return frame.result.candidates[static_cast<std::size_t>(frame.result.selected)].pair;
  }
  static QToolButton* button(const QString& name) {
    for (auto* each : window().transport().findChildren<QToolButton*>())
      if (each->accessibleName() == name) return each;
    return nullptr;
  }
};

TEST_F(HistoryInTheWindow, AHeldClipRecordsNothingAndSaysSo) {
  press(Qt::Key_Space, Qt::ControlModifier);
  ASSERT_TRUE(until([] { return is_held(); }));
  const auto before = settled();
  QTest::qWait(1500);
  const auto after = engine().history().span();
  EXPECT_EQ(after.frames, before.frames);
  EXPECT_EQ(after.bytes, before.bytes);
  EXPECT_EQ(after.last_s, before.last_s) << "the live end stays";
  EXPECT_EQ(window().transport().stateText(), "‖ HELD");
  EXPECT_TRUE(until([] { return window().status().words().contains("in held"); }));
  press(Qt::Key_Space, Qt::ControlModifier);
  EXPECT_TRUE(until([&] { return engine().history().span().frames > after.frames + 5; }));
  EXPECT_TRUE(until([] { return window().transport().stateText() == "▶ CLIP"; }));
}

TEST_F(HistoryInTheWindow, WhileATakeIsAnnotatedTheSessionRecordsNothing) {
  auto& labels = *window().findChild<AnnotationDesk*>();
  labels.showSubject(window().session()->material().library->takes().front().name);
  ASSERT_TRUE(until([] { return is_held(); }));
  const auto before = settled();
  QTest::qWait(1000);
  EXPECT_EQ(engine().history().span().bytes, before.bytes);
  EXPECT_TRUE(until([] { return window().status().words().contains("in held"); }));
  labels.showSubject("");
  EXPECT_TRUE(until([&] { return engine().history().span().frames > before.frames + 5; }));
}

TEST_F(HistoryInTheWindow, TheSameFramesAreOnDisk) {
  ASSERT_FALSE(desk().folder().isEmpty());
  EXPECT_TRUE(desk().folder().startsWith(remembered().historyFolder()));
  const FrameSnapshotPtr remembered_frame = engine().history().stepped(1e9, -10);
  const auto store = engine().history_keeper()->store();
  ASSERT_TRUE(until([&] { return store->span().last_index >= remembered_frame->index; }));
  const FrameSnapshotPtr kept = store->frame(remembered_frame->index);
  ASSERT_TRUE(kept);
  EXPECT_EQ(kept->result.result, remembered_frame->result.result);
}

/// Whatever its length: it can be had again at any time.
TEST_F(HistoryInTheWindow, OfADemoThatNobodyTouchedTheHistoryGoesWithoutAQuestion) {
  AskedAbout asked(desk(), HistoryDesk::Answer::Cancel);
  EXPECT_EQ(desk().unsaved(false), 0);
  bool allowed = true;
  desk().leaveSession(allowed);
  EXPECT_TRUE(allowed);
  EXPECT_EQ(asked.times, 0);
  EXPECT_GT(desk().unsaved(true), 0) << "with a marker it is no longer that";
}

TEST_F(HistoryInTheWindow, OfAMotionThatWasOpenedTheHistoryIsAskedAbout) {
  const QString motion = home().filePath("walk.bvh");
  const Clip walk = clip_of_take(*window().session()->material().library, 0);
  std::ofstream(motion.toStdString()) << *write_bvh(std::vector<Clip>{walk});
  window().openFiles({motion});
  ASSERT_TRUE(until([] {
    return window().session()->material().reading.file.size() > 0 && !desk().folder().isEmpty() &&
           engine().history().span().last_s > 0.5;
  })) << window().messages().text().toStdString();
  bool allowed = true;
  {
    AskedAbout asked(desk(), HistoryDesk::Answer::Cancel);
    ASSERT_TRUE(until([] { return desk().unsaved(false) > 0; })) << "once it is on disk";
    desk().leaveSession(allowed);
    EXPECT_FALSE(allowed) << "cancelled";
    EXPECT_EQ(asked.times, 1);
  }
  window().openDemo();
  ASSERT_TRUE(until([] { return window().session()->material().reading.file.empty(); }));
}

/// Ten seconds of a performer went without a question, like those of a clip.
TEST_F(HistoryInTheWindow, WhatALivePerformerDidIsAskedAboutFromTheFirstSecond) {
  auto& stream = *window().findChild<StreamDesk*>();
  auto& takes = *window().findChild<TakeDesk*>();
  const bool keeps_everything = remembered().keepsEverything();
  takes.keepEverything(false);  // else it is recorded, and nothing would be lost
  ASSERT_TRUE(until([] { return !desk().folder().isEmpty(); }));
  AskedAbout asked(desk(), HistoryDesk::Answer::Cancel);
  desk().settles_s = 1e9;  // whatever the clip has
  stream.connectTo("vmc://127.0.0.1:0");
  ASSERT_TRUE(until([&] { return stream.health().has_value(); }));
  EXPECT_EQ(desk().unsaved(false), 0) << "nobody has come yet";
  const Clip dance = window().session()->material().input;
  {
    const StreamedPerformer performer(dance, "vmc://" + QString::fromStdString(stream.health()->listening));
    EXPECT_TRUE(until([] { return desk().unsaved(false) > 0; }));
  }
  stream.disconnectStream();
  bool allowed = true;
  desk().leaveSession(allowed);
  EXPECT_FALSE(allowed) << "cancelled";
  EXPECT_EQ(asked.times, 1);
  desk().noteSaved(engine().clock().now_s());
  EXPECT_EQ(desk().unsaved(false), 0) << "it is in a file";
  takes.keepEverything(keeps_everything);
  const QString folder = desk().folder();
  window().openDemo();
  ASSERT_TRUE(until([&] { return !desk().folder().isEmpty() && desk().folder() != folder; }));
}

TEST_F(HistoryInTheWindow, AMomentGoesWithoutAQuestionMoreIsAskedAboutAndKept) {
  ASSERT_TRUE(until([] { return !desk().folder().isEmpty() && engine().history().span().last_s > 0.6; }));
  ticker().setRange(0.1, 0.5);  // as with I and O: a person has looked for something
  bool allowed = true;
  {
    AskedAbout asked(desk(), HistoryDesk::Answer::Cancel);
    desk().settles_s = 1e9;
    desk().leaveSession(allowed);
    EXPECT_TRUE(allowed);
    EXPECT_EQ(asked.times, 0);
    desk().settles_s = 0.1;
    desk().leaveSession(allowed);
    EXPECT_FALSE(allowed) << "cancelled";
    EXPECT_EQ(asked.times, 1);
  }
  AskedAbout asked(desk(), HistoryDesk::Answer::Keep);
  allowed = true;
  desk().leaveSession(allowed);
  EXPECT_TRUE(allowed);
  const QString folder = desk().folder();
  window().openDemo();
  ASSERT_TRUE(until([&] { return !desk().folder().isEmpty() && desk().folder() != folder; }));
  EXPECT_EQ(HistoryDesk::leftBehind(remembered().historyFolder()).size(), 1) << "offered at the next start";
  HistoryDesk::discard(folder + "/1.abrazo");
}

/// "Save?" was followed by "Keep the history?".
TEST_F(HistoryInTheWindow, ClosingWithChangesAndALongHistoryIsOneQuestion) {
  auto& project = *window().findChild<ProjectDesk*>();
  project.setAsks(true);
  Markers markers = window().document().markers();
  markers.add(0.1, "turn");
  window().document().changeMarkers(markers, "add marker");
  ASSERT_TRUE(until([] { return !desk().folder().isEmpty() && engine().history().span().last_s > 0.5; }));
  desk().settles_s = 0.1;
  int asked = 0;
  const auto own_ask = desk().ask;
  desk().ask = [&asked](double) { return ++asked, HistoryDesk::Answer::Cancel; };
  const auto answer = [&asked](const QString& button) {
    QTimer::singleShot(100, [&asked, button] {
      auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
      ASSERT_TRUE(box);
      ++asked;
      EXPECT_TRUE(box->informativeText().contains("of live history, too: it was not recorded"));
      EXPECT_EQ(box->buttons().size(), 3);
      for (QAbstractButton* each : box->buttons())
        if (each->text().remove('&') == button) return each->click();
      ADD_FAILURE() << "no button " << button.toStdString();
      box->reject();
    });
  };
  const QString folder = desk().folder();
  answer("Cancel");
  window().openDemo();
  EXPECT_EQ(desk().folder(), folder) << "the session stays";
  answer("Discard");
  window().openDemo();
  EXPECT_EQ(asked, 2) << "once each";
  ASSERT_TRUE(until([&] { return !desk().folder().isEmpty() && desk().folder() != folder; }));
  EXPECT_TRUE(until([&] { return HistoryDesk::leftBehind(remembered().historyFolder()).isEmpty(); }));
  project.setAsks(false);
  desk().settles_s = history_settles_s;
  desk().ask = own_ask;
}

TEST_F(HistoryInTheWindow, ASavedSessionOpensWithTheFramesOfItsHistory) {
  auto& project = *window().findChild<ProjectDesk*>();
  const QString file = home().filePath("saved.abrazo");
  ASSERT_TRUE(until([] { return engine().history().span().last_s > 3; }));
  const FrameSnapshotPtr early = engine().history().at(1);
  const auto before = engine().history().span();
  project.saveAs(file);
  ASSERT_TRUE(until([&] { return !project.isSaving(); }));
  EXPECT_TRUE(window().messages().openErrors().isEmpty()) << window().messages().text().toStdString();
  int asked = 0;
  bool allowed = true;
  const auto own_ask = desk().ask;
  desk().ask = [&asked](double) { return ++asked, HistoryDesk::Answer::Discard; };
  desk().settles_s = 2;
  desk().leaveSession(allowed);
  EXPECT_EQ(asked, 0) << "what is saved goes without a question";
  window().openFiles({file});
  ASSERT_TRUE(until([&] { return window().session() && window().session()->material().recorded; }));
  const FrameStore& recorded = *window().session()->material().recorded->frames;
  EXPECT_EQ(recorded.span().first_s, before.first_s);
  EXPECT_GE(recorded.span().last_s, before.last_s);
  EXPECT_EQ(recorded.span().frames, recorded.span().last_index - recorded.span().first_index + 1)
      << "none is missing";
  const FrameSnapshotPtr again = engine().history().at(1);
  ASSERT_TRUE(again);
  EXPECT_EQ(again->index, early->index);
  EXPECT_EQ(again->result.result, early->result.result);
  desk().leaveSession(allowed);
  EXPECT_EQ(asked, 0) << "nor what was read from it";
  ASSERT_TRUE(until([&] { return engine().latest().newest() != nullptr; })) << "the clip continues";
  EXPECT_GT(engine().latest().newest()->index, recorded.span().last_index) << "its frames are numbered on";
  EXPECT_EQ(ticker().playback().state, State::Following);
  ticker().seek(1);
  turn();
  ASSERT_TRUE(ticker().shown());
  EXPECT_EQ(ticker().shown()->index, early->index) << "the past can be scrubbed";
  desk().ask = own_ask;
  desk().settles_s = history_settles_s;
  window().openDemo();
  ASSERT_TRUE(until([] { return window().session() && !window().session()->material().recorded; }));
}

TEST_F(HistoryInTheWindow, WhatACrashLeavesIsOfferedAndBecomesASession) {
  EXPECT_TRUE(HistoryDesk::leftBehind(remembered().historyFolder()).isEmpty()) << "it belongs to this window";
  const QString crashed = remembered().historyFolder() + "/crashed";
  ASSERT_TRUE(QDir().mkpath(crashed));
  ASSERT_TRUE(until([] { return !desk().folder().isEmpty(); })) << "a worker makes the files";
  const QString own = QDir(desk().folder()).filePath("1.abrazo");
  ASSERT_TRUE(QFile::copy(own, crashed + "/1.abrazo")) << own.toStdString();
  ASSERT_EQ(HistoryDesk::leftBehind(remembered().historyFolder()), QStringList{crashed + "/1.abrazo"});
  const QString adopted = HistoryDesk::adopt(crashed + "/1.abrazo");
  EXPECT_EQ(QFileInfo(adopted).absolutePath(), QFileInfo(sessions_folder()).absoluteFilePath());
  EXPECT_FALSE(QDir(crashed).exists());
  EXPECT_TRUE(HistoryDesk::leftBehind(remembered().historyFolder()).isEmpty());
}

/// A message above it went, and Discard was where its button to close had been; it deleted at once.
TEST_F(HistoryInTheWindow, WhatACrashLeftIsDeletedOnlyAfterAQuestionAndItsButtonsStayWhereTheyAre) {
  const QString crashed = remembered().historyFolder() + "/crashed";
  ASSERT_TRUE(QDir().mkpath(crashed));
  ASSERT_TRUE(until([] { return !desk().folder().isEmpty(); })) << "a worker makes the files";
  ASSERT_TRUE(QFile::copy(QDir(desk().folder()).filePath("1.abrazo"), crashed + "/1.abrazo"));
  auto& bar = *window().findChild<widgets::LeftoverBar*>();
  offer_leftovers(window(), bar);
  ASSERT_TRUE(until([&] { return bar.isVisible(); }));
  QPushButton* discard = nullptr;
  for (auto* each : bar.findChildren<QPushButton*>())
    if (each->text() == "Discard") discard = each;
  ASSERT_TRUE(discard);
  const auto place = [&] { return discard->mapToGlobal(QPoint()); };
  window().messages().showError("first");
  turn();
  const QPoint before = place();
  window().messages().succeed({}, "first", true);
  ASSERT_TRUE(until([] { return !window().messages().isVisible(); }));
  turn();
  EXPECT_EQ(place(), before);
  const auto answer = [](const QString& words) {
    QTimer::singleShot(100, [words] {
      auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
      ASSERT_TRUE(box);
      EXPECT_TRUE(box->informativeText().contains("cannot be brought back"));
      for (QAbstractButton* each : box->buttons())
        if (each->text().remove('&') == words) return each->click();
      ADD_FAILURE() << "no button " << words.toStdString();
      box->reject();
    });
  };
  answer("Cancel");
  discard->click();
  EXPECT_TRUE(QDir(crashed).exists());
  EXPECT_TRUE(bar.isVisible()) << "it is still offered";
  answer("Delete");
  discard->click();
  EXPECT_FALSE(QDir(crashed).exists());
  EXPECT_FALSE(bar.isVisible());
}

TEST_F(HistoryInTheWindow, APinOnAParkedFrameIsTriedThereAndTheLivePartnerIsNotTold) {
  ticker().step(-30);
  turn();
  ASSERT_EQ(ticker().playback().state, State::Parked);
  window().panels().panel("candidates")->raise();
  const FrameSnapshotPtr parked = ticker().shown();
  const int other = parked->result.candidates.back().pair;
  ASSERT_NE(other, winner_of(*parked));
  window().selection().select(widgets::Selection::candidate(other));
  turn();
  press(Qt::Key_P);
  EXPECT_EQ(window().document().triedPin(), other);
  EXPECT_FALSE(window().document().decisions().pinned) << "the live partner is not pinned";
  EXPECT_FALSE(button("Lift the pin of the live partner")->isVisible());
  EXPECT_TRUE(button("Use for the live partner, too")->isVisible());
  ASSERT_TRUE(until([] { return comparison().shown() && comparison().shown()->done; }));
  const FrameSnapshotPtr tried = comparison().shown()->b->at(parked->time_s);
  ASSERT_TRUE(tried);
  EXPECT_EQ(winner_of(*tried), other);
  EXPECT_NE(tried->result.result, parked->result.result);
  EXPECT_FALSE(engine().latest().newest()->decisions && engine().latest().newest()->decisions->pinned);
}

TEST_F(HistoryInTheWindow, TheTriedPinIsAppliedToLiveByAClickAndLiftedByAnother) {
  ticker().step(-30);
  turn();
  const int other = ticker().shown()->result.candidates.back().pair;
  window().selection().select(widgets::Selection::candidate(other));
  turn();
  press(Qt::Key_P);
  ASSERT_TRUE(window().document().triedPin());
  QTest::mouseClick(button("Use for the live partner, too"), Qt::LeftButton);
  EXPECT_EQ(window().document().decisions().pinned, other);
  EXPECT_FALSE(window().document().triedPin());
  EXPECT_TRUE(button("Lift the pin of the live partner")->isVisible()) << "also while parked";
  EXPECT_TRUE(until([&] { return winner_of(*engine().latest().newest()) == other; }));
  QTest::mouseClick(button("Lift the pin of the live partner"), Qt::LeftButton);
  EXPECT_FALSE(window().document().decisions().pinned);
  EXPECT_FALSE(button("Lift the pin of the live partner")->isVisible());
}

/// One rule for both: alpha changed the live partner while a pin was tried.
TEST_F(HistoryInTheWindow, ASettingOnAParkedFrameIsTriedThereLikeAPin) {
  Document& document = window().document();
  const Settings live = document.settings();
  const auto alpha_of_newest = [] { return engine().latest().newest()->settings.alpha; };
  const auto goes_on = [] {
    const auto from = engine().latest().newest()->index;
    return until([from] { return engine().latest().newest()->index > from + 20; });
  };
  ticker().step(-30);
  turn();
  document.changeSetting("alpha", "0.93");
  EXPECT_TRUE(document.triesOther());
  EXPECT_TRUE(button("Use for the live partner, too")->isVisible());
  ASSERT_TRUE(until([] { return comparison().shown() && comparison().shown()->done; }));
  EXPECT_EQ(comparison().shown()->task.b->alpha, 0.93);
  ASSERT_TRUE(goes_on());
  EXPECT_EQ(alpha_of_newest(), live.alpha) << "the live partner keeps what it has";
  press(Qt::Key_End);
  ASSERT_TRUE(until([&] { return document.settings() == live; })) << "taken back";
  EXPECT_FALSE(button("Use for the live partner, too")->isVisible());
  EXPECT_TRUE(window().messages().text().contains("taken back"));
  document.undoStack().undo();
  EXPECT_EQ(document.settings().alpha, 0.93) << "and not lost";
  EXPECT_TRUE(until([&] { return alpha_of_newest() == 0.93; }));
  document.adopt(live, "as before");

  ticker().step(-30);
  turn();
  document.changeSetting("alpha", "0.94");
  QTest::mouseClick(button("Use for the live partner, too"), Qt::LeftButton);
  EXPECT_TRUE(until([&] { return alpha_of_newest() == 0.94; }));
  EXPECT_FALSE(document.triesOther());
  press(Qt::Key_End);
  turn();
  EXPECT_EQ(document.settings().alpha, 0.94);
  document.adopt(live, "as before");
}

TEST_F(HistoryInTheWindow, ATriedPinEndsWithTheSameKeyAndAtTheLiveEnd) {
  window().messages().showInformation("before");
  ticker().step(-30);
  turn();
  press(Qt::Key_P);
  ASSERT_TRUE(window().document().triedPin());
  press(Qt::Key_P);
  EXPECT_FALSE(window().document().triedPin());
  press(Qt::Key_P);
  ASSERT_TRUE(window().document().triedPin());
  press(Qt::Key_End);
  EXPECT_TRUE(until([] { return !window().document().triedPin(); }));
  EXPECT_FALSE(window().document().decisions().pinned);
  EXPECT_FALSE(window().messages().text().contains("taken back")) << "no setting was tried";
}

}  // namespace
}  // namespace abrazo::app::history_window_test
