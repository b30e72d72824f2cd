// Exporting from the window: what is offered, what is written, and what is told.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <QDialog>
#include <QDir>
#include <QDoubleSpinBox>
#include <QMenu>
#include <QProcess>
#include <QSignalSpy>
#include <QStyle>
#include <QStyleOptionComboBox>
#include <QThread>
#include <QToolButton>

#include "app/workbench/labels/annotation_desk.hpp"
#include "app/workbench/takes/take_desk.hpp"
#include "core/library/takes/tier_file.hpp"
#include "tests/workbench/export_window.hpp"
#include "widgets/annotation/annotation_panel.hpp"
#include "widgets/timeline/transport_bar.hpp"

namespace abrazo::app::export_window_test {
namespace {

using export_fixture::ExportWindow;
using ::testing::HasSubstr;
using ::testing::IsSupersetOf;
using ::testing::StartsWith;

TEST_F(ExportWindow, TheMenuOpensTheDialogOfWhatThereIs) {
  QAction* open = action("Export…");
  ASSERT_TRUE(open);
  open->trigger();
  turn();
  EXPECT_TRUE(dialog().isVisible());
  EXPECT_GT(box("Of").count(), 1) << "the session and the takes of its library";
  EXPECT_TRUE(estimate().contains(" frames at ")) << estimate().toStdString();
  dialog().hide();
}

TEST_F(ExportWindow, NoTypeIsCut) {
  dialog().show();
  const QString rigged = rig();
  for (const QString& performed : {QString(), rigged})
    for (int what = 0; what < box("What").count(); ++what) {
      character().setText(performed);
      box("What").setCurrentIndex(what);
      turn();
      QStyleOptionComboBox look;
      look.initFrom(&box("As"));
      const QRect room = box("As").style()->subControlRect(QStyle::CC_ComboBox, &look,
                                                           QStyle::SC_ComboBoxEditField, &box("As"));
      for (int type = 0; type < box("As").count(); ++type) {
        const QString words = box("As").itemText(type);
        EXPECT_LE(box("As").fontMetrics().horizontalAdvance(words), room.width()) << words.toStdString();
      }
    }
  character().clear();
  dialog().hide();
}

TEST_F(ExportWindow, LabelsHaveFramesOnlyInATable) {
  dialog().show();
  auto* rate = dialog().findChild<QDoubleSpinBox*>("Rate");
  choose("What", 2);
  choose("As", ".eaf");
  EXPECT_FALSE(rate->isVisible());
  EXPECT_TRUE(estimate().startsWith("About ")) << estimate().toStdString();
  rate->setValue(30);
  EXPECT_EQ(dialog().request().wish.rate_hz, 0);
  choose("As", ".csv");
  EXPECT_FALSE(rate->isVisible()) << "all tiers are in seconds";
  EXPECT_EQ(dialog().request().wish.rate_hz, 0);
  choose("Tiers", false);
  EXPECT_TRUE(rate->isVisible());
  EXPECT_EQ(dialog().request().wish.rate_hz, 30);
  rate->setValue(0);
  choose("Tiers", true);
  dialog().hide();
}

TEST_F(ExportWindow, ATableOfLabelsHasEveryTierUnlessTheMovesAloneAreChosen) {
  choose("What", 2);
  choose("As", ".csv");
  EXPECT_THAT(about(), HasSubstr("Every tier, a row for each label"));
  write("tiers.csv");
  const auto table = read_tiers(file("tiers.csv").toStdString(), {});
  ASSERT_TRUE(table) << table.error().text();
  std::vector<std::string> names;
  for (const Tier& tier : table->tiers) names.push_back(tier.name);
  EXPECT_THAT(names, IsSupersetOf({"user role", "take followed"}));
  choose("Tiers", false);
  EXPECT_THAT(about(), HasSubstr("Other tiers are left out"));
  write("moves.csv");
  EXPECT_THAT(content("moves.csv"), StartsWith("take,start_frame,end_frame,label"));
  choose("Tiers", true);
  choose("As", ".eaf");
  EXPECT_TRUE(box("Tiers").isHidden()) << "it holds all";
}

TEST_F(ExportWindow, LabelsOfWhatIsAnnotatedAreExportedFromItsMenu) {
  auto& subjects = *window().findChild<AnnotationDesk*>();
  const std::string take = window().session()->material().library->takes().front().name;
  subjects.showSubject(take);
  turn();
  action("Export labels…")->trigger();
  turn();
  EXPECT_TRUE(dialog().isVisible());
  EXPECT_EQ(box("Of").currentData().toString().toStdString(), take);
  EXPECT_EQ(box("What").currentText(), QString("Labels"));
  EXPECT_EQ(box("As").currentData().toString(), QString(".eaf"));
  EXPECT_GE(box("As").findData(".csv"), 0);
  dialog().hide();
  subjects.showSubject("");
  turn();
}

TEST_F(ExportWindow, ThePanelOfAnnotationsHasItToo) {
  auto& panel = window().findChild<AnnotationDesk*>()->panel();
  QToolButton* files = nullptr;
  for (auto* each : panel.findChildren<QToolButton*>())
    if (each->accessibleName() == "Label files") files = each;
  ASSERT_TRUE(files);
  files->menu()->actions().front()->trigger();
  turn();
  EXPECT_TRUE(dialog().isVisible());
  EXPECT_EQ(box("What").currentText(), QString("Labels"));
  EXPECT_EQ(box("Of").currentData().toString(), QString()) << "of the session, which is annotated";
  dialog().hide();
}

TEST_F(ExportWindow, WhatWasWrittenIsAmongTheMessagesAndItsOldErrorLeaves) {
  QStringList told_as_well;
  const auto listening = QObject::connect(&window().messages(), &widgets::MessageBar::told, &window(),
                                          [&](widgets::MessageKind kind, const QString& text) {
                                            if (kind == widgets::MessageKind::Information)
                                              told_as_well << text;
                                          });
  window().messages().showError("of something else");
  choose("As", ".bvh");
  desk().write(dialog().request(), "/no/such/folder/motion.bvh");
  ASSERT_TRUE(until([] { return !desk().isBusy(); }));
  EXPECT_EQ(window().messages().openErrors().size(), 2);
  write("again.bvh");
  EXPECT_EQ(window().messages().openErrors(), QStringList("of something else"));
  EXPECT_EQ(window().messages().text(), QString("of something else")) << "that nobody has answered";
  ASSERT_FALSE(told_as_well.isEmpty());
  EXPECT_TRUE(told_as_well.last().startsWith("Exported again.bvh")) << told_as_well.last().toStdString();
  QObject::disconnect(listening);
}

TEST_F(ExportWindow, NothingSpeaksOfTheUserOrOfTheLiveEndWhileATakeIsAnnotated) {
  auto& subjects = *window().findChild<AnnotationDesk*>();
  QPushButton* live = nullptr;
  for (auto* each : window().transport().findChildren<QPushButton*>())
    if (each->text().startsWith("CLIP")) live = each;
  ASSERT_TRUE(live);
  EXPECT_TRUE(live->isVisible());
  EXPECT_EQ(window().transport().roleText(), QString("user leads ▾"));
  subjects.showSubject(window().session()->material().library->takes().front().name);
  turn();
  EXPECT_FALSE(live->isVisible());
  EXPECT_EQ(window().transport().roleText(), QString());
  EXPECT_EQ(window().transport().stateText(), QString("PARKED"));
  subjects.showSubject("");
  ASSERT_TRUE(until([] { return !window().transport().roleText().isEmpty(); }));
  EXPECT_TRUE(live->isVisible());
}

TEST_F(ExportWindow, MotionIsWrittenAndTheFolderIsOffered) {
  ticker().setRange(0.2, 0.9);
  dialog().offer(desk().offer());
  choose("Part", "range");
  for (const QString ending : {".glb", ".bvh", ".csv"}) {
    choose("As", ending);
    write("motion" + ending);
    EXPECT_GT(QFileInfo(file("motion" + ending)).size(), 1000) << window().messages().text().toStdString();
    EXPECT_TRUE(told().contains("motion" + ending)) << told().toStdString();
    EXPECT_TRUE(told().contains("frames at")) << told().toStdString();
    EXPECT_FALSE(desk().bar().isHidden());
  }
}

TEST_F(ExportWindow, ThePartnerAloneIsProposedAndTheDialogSaysWhoCannotReadAFileOfBoth) {
  choose("As", ".bvh");
  dialog().restore({});
  EXPECT_TRUE(body("Follower").isChecked()) << "the user leads";
  EXPECT_FALSE(body("Leader").isChecked());
  EXPECT_EQ(about(), "The follower alone.");
  write("partner.bvh");
  EXPECT_EQ(rootsIn("partner.bvh"), 1) << window().messages().text().toStdString();
  body("Leader").setChecked(true);
  EXPECT_THAT(about(), HasSubstr("The leader and follower in one file"));
  EXPECT_THAT(about(), HasSubstr("Blender and MotionBuilder expect a single root"));
  write("both.bvh");
  EXPECT_EQ(rootsIn("both.bvh"), 2) << "that was chosen";
  choose("As", ".glb");
  EXPECT_EQ(about(), "The leader and follower in one file.");
}

TEST_F(ExportWindow, ThePartnerOfAUserWhoFollowsIsTheLeader) {
  press(Qt::Key_U);
  EXPECT_TRUE(until([] { return desk().offer().partner == SessionBody::Active; }));
  dialog().offer(desk().offer());
  dialog().restore({});
  EXPECT_TRUE(body("Leader").isChecked());
  EXPECT_FALSE(body("Follower").isChecked());
  press(Qt::Key_U);
  EXPECT_TRUE(until([] { return desk().offer().partner == SessionBody::Passive; }));
}

TEST_F(ExportWindow, BodiesThatAPersonChoseAreProposedAgainAndThePartnerIsWhoeverItIsThen) {
  body("User as received").setChecked(true);
  const QStringList chosen = dialog().choices();
  dialog().restore({});
  const QStringList proposed = dialog().choices();
  dialog().restore(chosen);
  for (const char* name : {"Leader", "Follower", "User as received"}) EXPECT_TRUE(body(name).isChecked());
  ExportOffer offer = desk().offer();
  offer.partner = SessionBody::Active;
  dialog().offer(offer);
  dialog().restore(proposed);
  EXPECT_TRUE(body("Leader").isChecked());
  EXPECT_FALSE(body("Follower").isChecked());
}

TEST_F(ExportWindow, WhatTheWindowIsSetToIsProposed) {
  ticker().setRange(0.2, 0.9);
  dialog().offer(desk().offer());
  dialog().restore({});
  EXPECT_EQ(box("Part").currentData().toString(), "range");
  EXPECT_EQ(dialog().request().wish.part.from_s, ticker().playback().range()->from_s);
  ticker().setRange(0, 0);
  dialog().offer(desk().offer());
  dialog().restore({});
  EXPECT_EQ(box("Part").currentData().toString(), "all");
}

TEST_F(ExportWindow, ATypedEndingIsAChoiceOfTheType) {
  choose("What", 2);  // labels
  choose("As", ".eaf");
  EXPECT_EQ(exportTo("typed.csv", QMessageBox::No), QString());
  EXPECT_THAT(content("typed.csv"), HasSubstr("start")) << "a table";
  EXPECT_EQ(box("As").currentData().toString(), ".csv");
  EXPECT_EQ(exportTo("typed.unknown", QMessageBox::No), QString());
  EXPECT_EQ(QDir(home().path()).entryList({"typed*"}), QStringList({"typed.csv", "typed.unknown.csv"}));
}

TEST_F(ExportWindow, ANameWithoutAnEndingReplacesNoFileUnasked) {
  choose("What", 2);  // labels
  choose("As", ".eaf");
  ASSERT_TRUE(write_whole_file(file("mine.eaf").toStdString(), "mine"));
  EXPECT_EQ(exportTo("mine", QMessageBox::No), QString("Replace mine.eaf?"));
  EXPECT_EQ(content("mine.eaf"), "mine");
  EXPECT_EQ(exportTo("mine", QMessageBox::Yes), QString("Replace mine.eaf?"));
  EXPECT_THAT(content("mine.eaf"), HasSubstr("ANNOTATION_DOCUMENT"));
}

TEST_F(ExportWindow, ATakeOfTheSessionIsWrittenInTheSameBytesAsByTheCommandLine) {
  auto& takes = *window().findChild<TakeDesk*>();
  takes.toggle();
  ASSERT_TRUE(until([&] { return !takes.takes().empty() && takes.takes().all().back().frames > 30; }));
  takes.toggle();
  ASSERT_TRUE(until([&] { return !takes.finishing(); }));
  const QString take = QString::fromStdString(takes.takes().all().back().name);
  dialog().offer(desk().offer());
  choose("Part", "take " + take);
  choose("As", ".csv");
  write("window.csv");
  QProcess abrazo;
  abrazo.setWorkingDirectory(home().path());
  abrazo.start(
      QCoreApplication::applicationDirPath() + "/abrazo",
      {"export", takes.file(), "--take", take, "--what", "active,passive", "-o", "line.csv", "--quiet"});
  ASSERT_TRUE(abrazo.waitForFinished(-1));
  ASSERT_EQ(abrazo.exitCode(), 0) << abrazo.readAllStandardError().toStdString();
  EXPECT_FALSE(content("window.csv").empty()) << window().messages().text().toStdString();
  EXPECT_TRUE(content("window.csv") == content("line.csv"));
}

TEST_F(ExportWindow, EveryOtherContentIsWritten) {
  ticker().setRange(0.2, 0.6);
  dialog().offer(desk().offer());
  for (const auto& [what, ending] : {std::pair{1, ".pvd"},
                                     {2, ".eaf"},
                                     {2, ".TextGrid"},
                                     {3, ".jsonl"},
                                     {4, ".csv"},
                                     {4, ".png"},
                                     {4, ".svg"}}) {
    choose("What", what);
    if (what < 4) choose("Part", "range");
    choose("As", ending);
    write(QString("content%1%2").arg(what).arg(ending));
    EXPECT_TRUE(QFileInfo::exists(file(QString("content%1%2").arg(what).arg(ending))))
        << ending << ": " << window().messages().text().toStdString();
  }
}

/// The session goes on while the dialog is open; what it says is what is written.
TEST_F(ExportWindow, AllOfALiveSessionIsWhatTheDialogSaid) {
  const FrameHistory& history = window().session()->engine().history();
  const Playback::Range said = desk().offer().session->range;
  dialog().offer(desk().offer());
  choose("What", 3);
  choose("As", ".jsonl");
  const QString stated = box("Part").currentText(), frames = estimate();
  ASSERT_TRUE(until([&] { return history.span().last_s > said.to_s + 1; }));
  EXPECT_EQ(box("Part").currentText(), stated);
  write("so_far.jsonl");
  const auto part = dialog().request().wish.part;
  const std::string lines = content("so_far.jsonl");
  const auto written = std::ranges::count(lines, '\n') - 1;  // the first line is the header
  EXPECT_EQ(written, static_cast<std::ptrdiff_t>(history.range(*part.from_s, *part.to_s).size()));
  EXPECT_LT(*part.to_s, history.span().last_s - 0.5);
  EXPECT_NEAR(static_cast<double>(written), QLocale().toDouble(frames.section(' ', 0, 0)), 2);
}

/// A held input leaves a gap in the recording, which a file with one rate cannot have.
TEST_F(ExportWindow, TheDialogSaysHowManyFramesAreWrittenAndHowManyOfThemAcrossAGap) {
  SessionEngine& engine = window().session()->engine();
  const FrameHistory& history = engine.history();
  action("Hold the input still")->trigger();
  const double released_s = engine.clock().now_s() + 1;
  ASSERT_TRUE(until([&] { return engine.clock().now_s() > released_s; }));
  action("Hold the input still")->trigger();
  ASSERT_TRUE(until([&] { return history.span().last_s > released_s + 0.5; }));
  const double after_s = history.stepped(released_s - 0.2, 1)->time_s;
  ticker().setRange(after_s - 1.5, after_s + 0.4);
  dialog().offer(desk().offer());
  choose("Part", "range");
  choose("As", ".csv");
  for (const double rate_hz : {0.0, 25.0}) {
    dialog().findChild<QDoubleSpinBox*>("Rate")->setValue(rate_hz);
    const QString stated = estimate().section(", about", 0, 0), bridged = estimate().section('\n', 1);
    write("gap.csv");
    const std::string lines = content("gap.csv");
    EXPECT_EQ(stated.section(' ', 0, 0).toLongLong(), std::ranges::count(lines, '\n') - 1);
    EXPECT_THAT(told().toStdString(), HasSubstr(stated.toStdString())) << "number and rate";
    EXPECT_THAT(bridged.toStdString(), HasSubstr(" interpolated across "));
    EXPECT_THAT(told().toStdString(), HasSubstr(bridged.section(" of the", 0, 0).toStdString()));
  }
  dialog().findChild<QDoubleSpinBox*>("Rate")->setValue(0);
  ticker().setRange(0, 0);
}

TEST_F(ExportWindow, ATakeOfTheLibraryIsWritten) {
  choose("Of", box("Of").itemData(1));
  choose("As", ".bvh");
  write("take.bvh");
  EXPECT_GT(QFileInfo(file("take.bvh")).size(), 10'000) << window().messages().text().toStdString();
  choose("What", 3);
  EXPECT_FALSE(button("Export…").isEnabled()) << "a take was not solved: it has no trace";
}

TEST_F(ExportWindow, TheSessionStaysTheSessionWhileATakeIsLookedAt) {
  auto& subjects = *window().findChild<AnnotationDesk*>();
  subjects.showSubject(window().session()->material().library->takes().front().name);
  turn();
  ticker().setRange(0.2, 0.6);
  const ExportOffer offer = desk().offer();
  const auto span = window().session()->engine().history().span();
  subjects.showSubject("");
  ASSERT_TRUE(offer.session);
  EXPECT_EQ(offer.session->range.from_s, span.first_s);
  EXPECT_NEAR(offer.session->range.to_s, span.last_s, 1);
  EXPECT_FALSE(offer.range) << "in and out are the take's";
  EXPECT_FALSE(offer.cursor_s);
  EXPECT_TRUE(desk().offer().cursor_s);
}

TEST_F(ExportWindow, WhatDoesNotFitCannotBeStarted) {
  EXPECT_TRUE(button("Export…").isEnabled());
  for (const char* name : {"Leader", "Follower", "User as received"}) body(name).setChecked(false);
  EXPECT_FALSE(button("Export…").isEnabled());
  body("Leader").setChecked(true);
  EXPECT_TRUE(button("Export…").isEnabled());
  choose("Part", "frame");
  EXPECT_FALSE(button("Export…").isEnabled());
  choose("What", 1);
  EXPECT_TRUE(button("Export…").isEnabled());
  EXPECT_TRUE(estimate().startsWith("1 frame,")) << estimate().toStdString();
  body("Follower").setChecked(true);
}

TEST_F(ExportWindow, AHalvedRateHalvesTheEstimate) {
  choose("As", ".csv");
  dialog().findChild<QDoubleSpinBox*>("Rate")->setValue(60);
  const QString whole = estimate();
  dialog().findChild<QDoubleSpinBox*>("Rate")->setValue(30);
  EXPECT_NE(estimate(), whole);
  dialog().findChild<QDoubleSpinBox*>("Rate")->setValue(0);
}

TEST_F(ExportWindow, UnitAndAxesAreForTypesThatLeaveThemOpen) {
  choose("As", ".bvh");
  EXPECT_FALSE(box("Unit").isHidden());
  box("Unit").setCurrentIndex(1);
  EXPECT_EQ(dialog().request().wish.space.units_per_metre, 100);
  choose("As", ".glb");
  EXPECT_TRUE(box("Unit").isHidden());
  EXPECT_TRUE(dialog().request().wish.space.is_usual());
  choose("As", ".bvh");
  box("Unit").setCurrentIndex(0);
}

// The worker may be done before it sees that it is to stop: what is said is what is there, either way.
TEST_F(ExportWindow, CancellingLeavesNothingOrSaysWhatIsThere) {
  choose("What", 1);
  choose("As", ".pvd");
  desk().write(dialog().request(), file("series.pvd"));
  emit window().messages().cancelRequested();
  ASSERT_TRUE(until([] { return !desk().isBusy(); }));
  const bool is_cancelled = window().messages().text().contains("cancelled");
  EXPECT_EQ(QDir(home().path()).entryList({"series*"}).isEmpty(), is_cancelled);
  EXPECT_NE(window().findChild<widgets::OfferBar*>("exported")->text().contains("series.pvd"), is_cancelled);
}

TEST_F(ExportWindow, WhatWasWrittenBeforeCancellingWasSeenIsTold) {
  choose("What", 0);
  choose("As", ".bvh");
  desk().write(dialog().request(), file("late.bvh"));
  // No event is handled meanwhile, so that nobody has heard that it is done.
  while (!QFile::exists(file("late.bvh"))) QThread::msleep(5);
  emit window().messages().cancelRequested();
  ASSERT_TRUE(until([] { return !desk().isBusy(); }));
  EXPECT_TRUE(QFile::exists(file("late.bvh")));
  EXPECT_TRUE(window().findChild<widgets::OfferBar*>("exported")->text().contains("late.bvh"));
  EXPECT_FALSE(window().messages().text().contains("cancelled")) << window().messages().text().toStdString();
}

TEST_F(ExportWindow, WhatIsInTheWayIsTold) {
  desk().write(dialog().request(), "/nowhere/at/all" + QString(".glb"));
  EXPECT_TRUE(until([] { return !desk().isBusy(); }));
  EXPECT_TRUE(window().messages().text().contains("folder does not exist"))
      << window().messages().text().toStdString();
}

TEST_F(ExportWindow, TheChoicesOfLastTimeComeBack) {
  choose("What", 2);
  choose("As", ".TextGrid");
  const QStringList choices = dialog().choices();
  choose("What", 0);
  dialog().restore(choices);
  EXPECT_EQ(box("What").currentData().toInt(), 2);
  EXPECT_EQ(box("As").currentData().toString(), ".TextGrid");
  choose("What", 0);
  character().setText(rig());
  choose("As", ".vrm");
  const QStringList performed = dialog().choices();
  character().clear();
  dialog().restore(performed);
  EXPECT_EQ(dialog().request().wish.character, rig().toStdString());
  EXPECT_EQ(box("As").currentData().toString(), ".vrm");
}

}  // namespace
}  // namespace abrazo::app::export_window_test
