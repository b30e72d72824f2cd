// Exporting from the window: what is offered, what is written, and what is told.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QCoreApplication>
#include <QDialog>
#include <QDir>
#include <QDoubleSpinBox>
#include <QFile>
#include <QFileDialog>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QMessageBox>
#include <QProcess>
#include <QPushButton>
#include <QSignalSpy>
#include <QStyle>
#include <QStyleOptionComboBox>
#include <QThread>
#include <QTimer>
#include <QToolButton>

#include "app/workbench/export/export_desk.hpp"
#include "app/workbench/export/export_dialog.hpp"
#include "app/workbench/labels/annotation_desk.hpp"
#include "app/workbench/takes/take_desk.hpp"
#include "core/base/atomic_file.hpp"
#include "core/library/takes/tier_file.hpp"
#include "tests/support/humanoid_rig.hpp"
#include "tests/workbench/demo_window.hpp"
#include "widgets/annotation/annotation_panel.hpp"
#include "widgets/common/message_bar.hpp"
#include "widgets/common/offer_bar.hpp"
#include "widgets/timeline/transport_bar.hpp"

namespace abrazo::app::export_window_test {
namespace {

using ::testing::HasSubstr;
using ::testing::IsSupersetOf;
using ::testing::StartsWith;

class ExportWindow : public DemoWindow {
 protected:
  static void SetUpTestSuite() {
    QCoreApplication::setAttribute(Qt::AA_DontUseNativeDialogs);
    showDemo({1100, 700}, 60);
  }

  static ExportDesk& desk() { return *window().findChild<ExportDesk*>(); }
  static ExportDialog& dialog() { return *window().findChild<ExportDialog*>(); }
  static QComboBox& box(const char* name) { return *dialog().findChild<QComboBox*>(name); }
  static QCheckBox& body(const QString& name) {
    for (auto* check : dialog().findChildren<QCheckBox*>())
      if (check->text() == name) return *check;
    throw std::invalid_argument(name.toStdString());
  }
  static QPushButton& button(const QString& text) {
    for (auto* one : dialog().findChildren<QPushButton*>())
      if (one->text() == text) return *one;
    throw std::invalid_argument(text.toStdString());
  }
  static void choose(const char* name, const QVariant& data) {
    const int index = box(name).findData(data);
    ASSERT_GE(index, 0) << name << " does not have " << data.toString().toStdString();
    box(name).setCurrentIndex(index);
  }
  static QString estimate() { return dialog().findChild<QLabel*>("estimate")->text(); }
  void SetUp() override {
    DemoWindow::SetUp();
    dialog().offer(desk().offer());
    choose("What", 0);
    choose("Of", QString());
    choose("Part", "all");
    for (const char* name : {"Leader", "Follower"}) body(name).setChecked(true);
    body("User as received").setChecked(false);
    character().clear();
  }
  static qsizetype rootsIn(const QString& name) {
    return QString::fromStdString(content(name)).count("ROOT ");
  }
  static QLineEdit& character() {
    for (auto* each : dialog().findChildren<QLineEdit*>())
      if (each->accessibleName() == "Character") return *each;
    throw std::invalid_argument("no field for a character");
  }
  /// What the dialog says below the choices: why they do not go together, or what the file will hold.
  static std::string about() { return dialog().findChild<QLabel*>("secondary")->text().toStdString(); }
  static std::string content(const QString& name) {
    const auto read = read_whole_file(file(name).toStdString());
    return read ? *read : std::string();
  }
  /// Presses Export, names the file and answers whether files may be replaced. @return the question
  static QString exportTo(const QString& name, QMessageBox::StandardButton answer) {
    QString asked;
    QTimer person;
    QObject::connect(&person, &QTimer::timeout, &person, [&] {
      QWidget* modal = QApplication::activeModalWidget();
      if (auto* files = qobject_cast<QFileDialog*>(modal)) {
        files->findChild<QLineEdit*>()->setText(file(name));
        QMetaObject::invokeMethod(files, "accept");
      } else if (auto* question = qobject_cast<QMessageBox*>(modal)) {
        asked = question->text();
        question->button(answer)->click();
      }
    });
    person.start(20);
    button("Export…").click();
    EXPECT_TRUE(until([] { return !desk().isBusy(); }));
    return asked;
  }
  /// A humanoid with the bone names of VRM 1.0.
  static QString rig() {
    EXPECT_TRUE(write_whole_file(file("rig.vrm").toStdString(), test::rig(test::Naming::Vrm1)));
    return file("rig.vrm");
  }
  static QString file(const QString& name) { return home().filePath(name); }
  /// Writes what the dialog says, to the end.
  static void write(const QString& name) {
    desk().write(dialog().request(), file(name));
    ASSERT_TRUE(until([] { return !desk().isBusy(); }));
  }
  static QString told() { return desk().bar().text(); }
};

TEST_F(ExportWindow, TheMenuOpensTheDialogOfWhatThereIs) {
  QAction* open = action("Export…");
  ASSERT_TRUE(open);
  open->trigger();
  turn();
  EXPECT_TRUE(dialog().isVisible());
  EXPECT_GT(box("Of").count(), 1) << "the session and the takes of its library";
  EXPECT_TRUE(estimate().contains("frames, about")) << estimate().toStdString();
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
    if (each->text().startsWith("LIVE")) live = each;
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

TEST_F(ExportWindow, TheCharacterThatThePartnerWearsIsProposedWhereTheTypeCanHoldIt) {
  const QString worn = file("partner.vrm");
  ASSERT_TRUE(write_whole_file(worn.toStdString(), test::skinned_rig(test::Naming::Vrm1)));
  widgets::SceneOptions options = window().scene().options();
  options.character_files = {"", worn.toStdString()};
  window().scene().setOptions(options);
  dialog().offer(desk().offer());
  choose("As", ".bvh");
  dialog().restore({});
  EXPECT_EQ(character().text(), QString()) << "a BVH has no character";
  choose("As", ".glb");
  EXPECT_EQ(character().text(), worn);
  EXPECT_THAT(about(), HasSubstr("performed by the character: NAME_passive.glb"));
  character().clear();
  choose("As", ".npz");
  choose("As", ".glb");
  EXPECT_EQ(character().text(), QString()) << "the person took it off";
  dialog().restore({});
  EXPECT_EQ(character().text(), worn);
  const QStringList choices = dialog().choices();
  options.character_files = {};
  window().scene().setOptions(options);
  dialog().offer(desk().offer());
  dialog().restore(choices);
  EXPECT_EQ(character().text(), QString()) << "it was a proposal, not a choice";
}

TEST_F(ExportWindow, ACharacterPerformsTheBodiesInAFileEachAndTheFilesAreListed) {
  ticker().setRange(0.2, 0.9);
  dialog().offer(desk().offer());
  choose("Part", "range");
  choose("As", ".bvh");
  character().setText(rig());
  EXPECT_EQ(box("As").findData(".bvh"), -1) << "a character is a GLB or VRM";
  EXPECT_TRUE(box("Unit").isHidden()) << "it has its own";
  for (const QString ending : {".glb", ".vrm"}) {
    choose("As", ending);
    ASSERT_TRUE(button("Export…").isEnabled()) << about();
    write("worn" + ending);
    EXPECT_THAT(told().toStdString(),
                HasSubstr(("worn_active" + ending + ", worn_passive" + ending).toStdString()));
    for (const QString body : {"worn_active", "worn_passive"})
      EXPECT_EQ(content(body + ending).substr(0, 4), "glTF") << window().messages().text().toStdString();
    EXPECT_FALSE(QFile::exists(file("worn" + ending)));
  }
  character().clear();
  EXPECT_GE(box("As").findData(".bvh"), 0);
  EXPECT_TRUE(dialog().request().wish.character.empty());
}

TEST_F(ExportWindow, ACharacterIsOfMotionOnly) {
  character().setText(rig());
  EXPECT_FALSE(character().isHidden());
  choose("What", 2);
  EXPECT_TRUE(character().parentWidget()->isHidden());
  EXPECT_TRUE(dialog().request().wish.character.empty());
  EXPECT_TRUE(button("Export…").isEnabled()) << about();
}

TEST_F(ExportWindow, ACharacterThatCannotBeReadIsSaidBeforeTheExportAndOneThatIsNoHumanoidByIt) {
  character().setText(file("gone.vrm"));
  EXPECT_FALSE(button("Export…").isEnabled());
  EXPECT_THAT(about(), HasSubstr("gone.vrm"));
  character().setText(rig());
  EXPECT_TRUE(button("Export…").isEnabled()) << about();
  ASSERT_TRUE(write_whole_file(file("box.glb").toStdString(), "a box"));
  character().setText(file("box.glb"));
  choose("As", ".glb");
  write("refused.glb");
  EXPECT_THAT(window().messages().text().toStdString(), HasSubstr("is no GLB"));
  EXPECT_EQ(QDir(home().path()).entryList({"refused*"}), QStringList());
}

TEST_F(ExportWindow, TheCharacterItselfIsNotReplaced) {
  ASSERT_TRUE(write_whole_file(file("me_active.glb").toStdString(), test::rig(test::Naming::Vrm1)));
  character().setText(file("me_active.glb"));
  choose("As", ".glb");
  write("me.glb");
  EXPECT_THAT(window().messages().text().toStdString(), HasSubstr("also read"));
  EXPECT_EQ(content("me_active.glb"), test::rig(test::Naming::Vrm1));
}

TEST_F(ExportWindow, FilesOfTheBodiesAreReplacedOnlyWhenThePersonSaysSo) {
  character().setText(rig());
  choose("As", ".glb");
  EXPECT_EQ(exportTo("twice.glb", QMessageBox::No), QString()) << "there is nothing to replace";
  EXPECT_EQ(content("twice_active.glb").substr(0, 4), "glTF");
  ASSERT_TRUE(write_whole_file(file("twice_active.glb").toStdString(), "mine"));
  ASSERT_TRUE(QFile::remove(file("twice_passive.glb")));
  EXPECT_EQ(exportTo("twice.glb", QMessageBox::No), QString("Replace twice_active.glb?"));
  EXPECT_EQ(content("twice_active.glb"), "mine");
  EXPECT_FALSE(QFile::exists(file("twice_passive.glb")));
  EXPECT_EQ(exportTo("twice.glb", QMessageBox::Yes), QString("Replace twice_active.glb?"));
  EXPECT_EQ(content("twice_active.glb").substr(0, 4), "glTF");
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

TEST_F(ExportWindow, ACharacterIsWrittenInTheSameBytesAsByTheCommandLine) {
  auto& takes = *window().findChild<TakeDesk*>();
  takes.toggle();
  ASSERT_TRUE(until([&] { return !takes.takes().empty() && takes.takes().all().back().frames > 60; }));
  takes.toggle();
  ASSERT_TRUE(until([&] { return !takes.finishing(); }));
  const RecordedTake take = takes.takes().all().back();
  const double from_s = take.from_s + 0.3, to_s = take.to_s - 0.3;
  ticker().setRange(from_s, to_s);
  dialog().offer(desk().offer());
  choose("Part", "range");
  character().setText(rig());
  choose("As", ".vrm");
  write("window.vrm");
  QProcess abrazo;
  abrazo.setWorkingDirectory(home().path());
  abrazo.start(QCoreApplication::applicationDirPath() + "/abrazo",  // built beside the tests
               {"export", takes.file(), "--from", QString::number(from_s, 'g', 17), "--to",
                QString::number(to_s, 'g', 17), "--what", "active,passive", "--character", "rig.vrm", "-o",
                "line.vrm", "--quiet"});
  ASSERT_TRUE(abrazo.waitForFinished(-1));
  ASSERT_EQ(abrazo.exitCode(), 0) << abrazo.readAllStandardError().toStdString();
  for (const QString body : {"_active.vrm", "_passive.vrm"}) {
    EXPECT_FALSE(content("window" + body).empty()) << window().messages().text().toStdString();
    EXPECT_TRUE(content("window" + body) == content("line" + body)) << body.toStdString();
  }
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
                                     {2, ".vtt"},
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
  EXPECT_NE(window().findChild<widgets::OfferBar*>()->text().contains("series.pvd"), is_cancelled);
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
  EXPECT_TRUE(window().findChild<widgets::OfferBar*>()->text().contains("late.bvh"));
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
  choose("As", ".vtt");
  const QStringList choices = dialog().choices();
  choose("What", 0);
  dialog().restore(choices);
  EXPECT_EQ(box("What").currentData().toInt(), 2);
  EXPECT_EQ(box("As").currentData().toString(), ".vtt");
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
