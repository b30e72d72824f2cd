// Retargeting takes from the window: what is offered, what is written, and what is told.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <QAction>
#include <QProgressBar>

#include "tests/support/humanoid_rig.hpp"
#include "tests/workbench/retarget_window.hpp"
#include "widgets/common/message_bar.hpp"
#include "widgets/library/take_list.hpp"

namespace abrazo::app::retarget_dialog_test {
namespace {

using ::testing::HasSubstr;

TEST_F(RetargetWindow, TheMenuOpensTheDialogWithTheTakeOfTheLibraryPanel) {
  dialog().hide();
  window().takes().setSelectedTake(0);
  QAction* open = action("Retarget take…");
  ASSERT_TRUE(open);
  EXPECT_EQ(open->objectName(), QString("library.retarget_take"));
  open->trigger();
  turn();
  EXPECT_TRUE(dialog().isVisible());
  const auto wish = dialog().wish();
  ASSERT_TRUE(wish);
  EXPECT_EQ(wish->takes, std::vector<std::string>{take(0).toStdString()});
}

TEST_F(RetargetWindow, WritesTheSameBytesAsTheCommandLine) {
  dialog().findChild<QCheckBox*>()->setChecked(true);
  for (const QString ending : {".bvh", ".glb", ".csv", ".npz"}) {
    chooseType(ending);
    retarget();
    retargetOnTheCommandLine({"--take", take(0), "--to", "20", "--active-body", "scale:0.9", "-o",
                              "line" + ending, "--trace", "line.jsonl", "--quiet"});
    EXPECT_FALSE(content("out" + ending).empty());
    EXPECT_TRUE(content("out" + ending) == content("line" + ending)) << ending.toStdString();
    EXPECT_TRUE(content("out.jsonl") == content("line.jsonl"));
  }
}

TEST_F(RetargetWindow, ItsWeightsAreThoseOfTheCommandLine) {
  emit named<widgets::ValueSlider>("Contacts").moved(0.7071, 1);
  emit named<widgets::ValueSlider>("Smoothness").moved(0.3536, 2);
  const auto wish = dialog().wish();
  ASSERT_TRUE(wish);
  EXPECT_EQ(wish->contacts, 2);
  EXPECT_EQ(wish->smoothness, 0.5);
  chooseType(".csv");
  retarget();
  const QStringList line{"--take",    take(0), "--to",     "20",     "--active-body",
                         "scale:0.9", "-o",    "line.csv", "--quiet"};
  retargetOnTheCommandLine(line);
  EXPECT_FALSE(content("out.csv") == content("line.csv")) << "they matter";
  retargetOnTheCommandLine(line + QStringList{"--contacts", "2", "--smoothness", "0.5"});
  EXPECT_TRUE(content("out.csv") == content("line.csv"));
}

TEST_F(RetargetWindow, ACharacterOfAnotherProgramPerformsBoth) {
  const QString rig = QDir(output).filePath("rig.vrm");
  ASSERT_TRUE(write_whole_file(rig.toStdString(), test::rig(test::Naming::Vrm1)));
  field("Character").setText(rig);
  EXPECT_EQ(box("As").findData(".bvh"), -1) << "a character is a GLB or VRM";
  chooseType(".vrm");
  field("Character").setText(output + "/gone.vrm");
  EXPECT_FALSE(button("Retarget").isEnabled());
  EXPECT_THAT(about(), HasSubstr("gone.vrm"));
  field("Character").setText(rig);
  retarget();
  EXPECT_EQ(files(), QStringList({"out_active.vrm", "out_passive.vrm", "rig.vrm"}));
  retargetOnTheCommandLine({"--take", take(0), "--to", "20", "--active-body", "scale:0.9", "--character", rig,
                            "-o", "line.vrm", "--quiet"});
  EXPECT_TRUE(content("out_passive.vrm") == content("line_passive.vrm"));
}

TEST_F(RetargetWindow, SeveralTakesHaveFilesOfTheirOwnAndTheirFiguresAreTold) {
  const QStringList both{take(0), take(1)};
  dialog().chooseTakes(both);
  chooseType(".csv");
  QStringList told;
  const auto listening = QObject::connect(&window().messages(), &widgets::MessageBar::told, &window(),
                                          [&](widgets::MessageKind, const QString& text) { told << text; });
  retarget();
  QObject::disconnect(listening);
  EXPECT_EQ(files(), QStringList({"out_" + both[0] + ".csv", "out_" + both[1] + ".csv"}));
  ASSERT_FALSE(told.isEmpty());
  EXPECT_THAT(told.last().toStdString(), HasSubstr(both[1].toStdString() + ": 20 frames, leader scale:0.9"));
  EXPECT_THAT(state(), HasSubstr("2 takes"));
}

TEST_F(RetargetWindow, WhatCannotBeDoneIsSaidBeforeItIsStarted) {
  const auto refused = [](const std::string& why) {
    EXPECT_FALSE(button("Retarget").isEnabled()) << why;
    EXPECT_THAT(about(), HasSubstr(why));
  };
  EXPECT_THAT(about(), HasSubstr("Writes out.bvh"));
  body("Leader's body").setEditText("scale:9");
  refused("a number from 0.3 to 3 is expected");
  body("Leader's body").setEditText("user");
  refused("a recorded pair has no user");
  body("Leader's body").setEditText("library");
  frame("To frame").setValue(10'000'000);
  refused("has frames 0 to");
  frame("To frame").setValue(20);
  dialog().setFolder(output + "/gone");
  refused("folder does not exist");
  dialog().setFolder(output);
  dialog().chooseTakes({});
  refused("No take is chosen");
}

TEST_F(RetargetWindow, AFileThatIsReplacedIsNamedBefore) {
  ASSERT_TRUE(write_whole_file(QDir(output).filePath("out.bvh").toStdString(), "old"));
  field("Name").setText("other");
  EXPECT_THAT(about(), ::testing::Not(HasSubstr("Replaces")));
  field("Name").setText("out");
  EXPECT_THAT(about(), HasSubstr("Writes out.bvh. Replaces out.bvh"));
}

TEST_F(RetargetWindow, CancelledItLeavesNothing) {
  frame("To frame").setValue(-1);
  dialog().findChild<QCheckBox*>()->setChecked(true);
  button("Retarget").click();
  ASSERT_TRUE(until([] { return named<QProgressBar>("Progress").value() > 150; })) << "fitting";
  EXPECT_THAT(state(), HasSubstr(take(0).toStdString() + ": "));
  button("Cancel").click();
  ASSERT_TRUE(until([] { return !desk().isBusy(); }));
  EXPECT_TRUE(dialog().isVisible()) << "the button closes the dialog only when nothing runs";
  EXPECT_THAT(state(), HasSubstr("nothing was written"));
  EXPECT_EQ(files(), QStringList());
}

TEST_F(RetargetWindow, AnErrorOfTheWorkIsShownAndLeavesNothing) {
  body("Follower's body").setEditText(QDir(output).filePath("gone.bvh"));
  retarget();
  EXPECT_THAT(state(), HasSubstr("gone.bvh"));
  ASSERT_EQ(window().messages().openErrors().size(), 1);
  EXPECT_EQ(files(), QStringList());
  body("Follower's body").setEditText("library");
  retarget();
  EXPECT_TRUE(window().messages().openErrors().isEmpty()) << "the error leaves with the next success";
}

TEST_F(RetargetWindow, TakesOfAManifestAreOfferedToo) {
  QProcess abrazo;
  abrazo.setWorkingDirectory(home().path());
  abrazo.start(program(), {"demo", "-o", "takes", "--minutes", "0.2"});
  ASSERT_TRUE(abrazo.waitForFinished(-1));
  const QString manifest = home().filePath("takes/manifest.json");
  emit dialog().manifestChosen(manifest);
  ASSERT_TRUE(until([] { return !desk().isBusy(); }));
  EXPECT_EQ(dialog().manifest(), manifest);
  dialog().chooseTakes({"salsa_01"});
  retarget();
  EXPECT_EQ(files(), QStringList({"out.bvh"}));
  emit dialog().manifestChosen(home().filePath("gone.json"));
  ASSERT_TRUE(until([] { return !desk().isBusy(); }));
  EXPECT_THAT(state(), HasSubstr("gone.json"));
}

}  // namespace
}  // namespace abrazo::app::retarget_dialog_test
