// Exporting bodies that a humanoid character of another program performs.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <QProcess>

#include "app/workbench/takes/take_desk.hpp"
#include "tests/workbench/export_window.hpp"
#include "widgets/scene/view/scene_view.hpp"

namespace abrazo::app::export_character_test {
namespace {

using ::testing::HasSubstr;

class ExportCharacter : public export_fixture::ExportWindow {};

TEST_F(ExportCharacter, TheCharacterThatThePartnerWearsIsProposedWhereTheTypeCanHoldIt) {
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

TEST_F(ExportCharacter, ACharacterPerformsTheBodiesInAFileEachAndTheFilesAreListed) {
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

TEST_F(ExportCharacter, ACharacterIsOfMotionOnly) {
  character().setText(rig());
  EXPECT_FALSE(character().isHidden());
  choose("What", 2);
  EXPECT_TRUE(character().parentWidget()->isHidden());
  EXPECT_TRUE(dialog().request().wish.character.empty());
  EXPECT_TRUE(button("Export…").isEnabled()) << about();
}

TEST_F(ExportCharacter, ACharacterThatCannotBeReadIsSaidBeforeTheExportAndOneThatIsNoHumanoidByIt) {
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

TEST_F(ExportCharacter, TheCharacterItselfIsNotReplaced) {
  ASSERT_TRUE(write_whole_file(file("me_active.glb").toStdString(), test::rig(test::Naming::Vrm1)));
  character().setText(file("me_active.glb"));
  choose("As", ".glb");
  write("me.glb");
  EXPECT_THAT(window().messages().text().toStdString(), HasSubstr("also read"));
  EXPECT_EQ(content("me_active.glb"), test::rig(test::Naming::Vrm1));
}

TEST_F(ExportCharacter, FilesOfTheBodiesAreReplacedOnlyWhenThePersonSaysSo) {
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

TEST_F(ExportCharacter, ACharacterIsWrittenInTheSameBytesAsByTheCommandLine) {
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

}  // namespace
}  // namespace abrazo::app::export_character_test
