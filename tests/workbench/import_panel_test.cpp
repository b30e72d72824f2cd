// The panel that asks how a motion file is read, driven as a person does.
#include <gmock/gmock.h>

#include <QComboBox>
#include <QDir>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTableWidget>
#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>

#include "app/workbench/library/import_desk.hpp"
#include "app/workbench/library/import_rules_dialog.hpp"
#include "app/workbench/project/history_desk.hpp"
#include "app/workbench/project/project_desk.hpp"
#include "core/library/build/motion_library_builder.hpp"
#include "core/motion/bvh/bvh.hpp"
#include "core/motion/scenes/glb_writer.hpp"
#include "tests/support/libraries.hpp"
#include "tests/widgets/pictures.hpp"
#include "tests/workbench/demo_window.hpp"
#include "widgets/common/message_bar.hpp"
#include "widgets/library/motion_picture.hpp"
#include "widgets/library/take_list.hpp"

namespace abrazo::app::import_panel_test {
namespace {

using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

class ImportPanelTest : public DemoWindow {
 protected:
  static void SetUpTestSuite() { showDemo({1280, 720}); }
  void SetUp() override {
    DemoWindow::SetUp();
    QDir(remembered().importRuleFolder()).removeRecursively();
    remembered().setRemembersImports(false);
  }
  void TearDown() override { delete desk().panel(); }

  static ImportDesk& desk() { return *window().findChild<ImportDesk*>(); }
  static ImportPanel* panel() { return desk().panel(); }
  /// A swinging person of 1.7 m in some unit, in a folder of its own for each test. The floor of the file
  /// leaves a question: it is half a metre below the feet.
  static QString walk(const QString& name, double units_per_metre = 1) {
    return written(name, units_per_metre, false, 0.5);
  }
  /// The same on the floor: that the unit is not stated is no question, as only one makes an adult.
  static QString plain(const QString& name) { return written(name, 100, false, 0); }
  static QString written(const QString& name, double units_per_metre, bool z_up, double above_floor_m) {
    PairedTake take = test::swinging_take("t", 40, 1);
    for (Pose& pose : take.a.poses) pose.col(1).array() += above_floor_m;
    for (Pose& pose : take.a.poses)
      if (z_up) {
        const Eigen::Matrix<double, joint_count, 1> y = pose.col(1);
        pose.col(1) = -pose.col(2);
        pose.col(2) = y;
      }
    const auto* test = testing::UnitTest::GetInstance()->current_test_info();
    QDir(home().path()).mkpath(test->name());
    const QString file = home().filePath(QString("%1/%2").arg(test->name(), name));
    std::ofstream(file.toStdString()) << *write_bvh(std::vector<Clip>{take.a}, units_per_metre);
    return file;
  }
  /// A person without joints at the toes, between the shoulders and in the hands, as many programs write it.
  static QString without_toes_and_thorax(const QString& name) {
    struct Bone {
      int depth;
      std::string name;  // empty: an end site
      int x, y, z;
    };
    static const std::vector<Bone> bones = {{0, "Hips", 0, 90, 0},
                                            {1, "LeftUpLeg", 10, -3, 0},
                                            {2, "LeftLeg", 0, -42, 0},
                                            {3, "LeftFoot", 0, -41, -5},
                                            {4, "", 0, -2, 15},
                                            {1, "RightUpLeg", -10, -3, 0},
                                            {2, "RightLeg", 0, -42, 0},
                                            {3, "RightFoot", 0, -41, -5},
                                            {4, "", 0, -2, 15},
                                            {1, "Spine", 0, 7, -3},
                                            {2, "Spine1", 0, 20, 3},
                                            {3, "Neck", 0, 22, -4},
                                            {4, "Head", 0, 13, 5},
                                            {5, "", 0, 18, 0},
                                            {3, "LeftShoulder", 6, 16, 3},
                                            {4, "LeftArm", 12, 2, -4},
                                            {5, "LeftForeArm", 28, 0, 0},
                                            {6, "LeftHand", 25, 0, 0},
                                            {7, "", 15, 0, 0},
                                            {3, "RightShoulder", -6, 16, 3},
                                            {4, "RightArm", -12, 2, -4},
                                            {5, "RightForeArm", -28, 0, 0},
                                            {6, "RightHand", -25, 0, 0},
                                            {7, "", -15, 0, 0}};
    const QString file = home().filePath(name);
    std::ofstream bvh(file.toStdString());
    bvh << "HIERARCHY\n";
    int open = 0;
    std::string frame = "0 90 0";
    for (const Bone& bone : bones) {
      for (; open > bone.depth; --open) bvh << "}\n";
      bvh << (bone.name.empty() ? "End Site" : (bone.depth == 0 ? "ROOT " : "JOINT ") + bone.name)
          << "\n{\nOFFSET " << bone.x << ' ' << bone.y << ' ' << bone.z << '\n';
      if (!bone.name.empty()) {
        bvh << "CHANNELS " << (bone.depth == 0 ? "6 Xposition Yposition Zposition" : "3")
            << " Zrotation Xrotation Yrotation\n";
        frame += " 0 0 0";
      }
      ++open;
    }
    for (; open > 0; --open) bvh << "}\n";
    bvh << "MOTION\nFrames: 4\nFrame Time: 0.04\n";
    for (int f = 0; f < 4; ++f) bvh << frame << '\n';
    return file;
  }
  /// Two people in one file, who stand two metres apart.
  static QString pair(const QString& name) {
    PairedTake take = test::swinging_take("t", 40, 1);
    take.a.name = "Anna", take.b.name = "Ben";
    const QString file = home().filePath(name);
    std::ofstream(file.toStdString()) << *write_bvh(std::vector<Clip>{take.a, take.b}, 100);
    return file;
  }
  /// A person with two animations: "motion" of 40 frames, and "short", the first 20 of them.
  static QString with_two_animations(const QString& name) {
    const PairedTake take = test::swinging_take("t", 40, 1);
    const std::string glb = *write_glb(std::vector<Clip>{take.a});
    const auto number = [](const std::string& bytes, std::size_t at) {
      std::size_t value = 0;
      for (std::size_t byte = 4; byte-- > 0;)
        value = value << 8U | static_cast<unsigned char>(bytes[at + byte]);
      return value;
    };
    const auto written = [](std::size_t value) {
      std::string bytes;
      for (int byte = 0; byte < 4; ++byte, value >>= 8U) bytes += static_cast<char>(value & 0xffU);
      return bytes;
    };
    const std::size_t header = 20, length = number(glb, 12);
    auto scene = nlohmann::json::parse(glb.substr(header, length));
    auto half = scene["animations"][0];
    half["name"] = "short";
    for (auto& sampler : half["samplers"])
      for (const char* of : {"input", "output"}) {
        auto accessor = scene["accessors"][sampler[of].get<std::size_t>()];
        accessor["count"] = std::max<std::size_t>(1, accessor["count"].get<std::size_t>() / 2);
        sampler[of] = scene["accessors"].size();
        scene["accessors"].push_back(accessor);
      }
    scene["animations"].push_back(half);
    std::string text = scene.dump();
    text.resize((text.size() + 3) / 4 * 4, ' ');
    const std::string rest = glb.substr(header + length);
    const QString file = home().filePath(name);
    std::ofstream(file.toStdString(), std::ios::binary)
        << glb.substr(0, 8) << written(header + text.size() + rest.size()) << written(text.size())
        << glb.substr(16, 4) << text << rest;
    return file;
  }
  static bool shows() {
    return until([] { return panel() && !panel()->isWaiting(); });
  }
  template <typename Widget>
  static Widget* named(const QString& name) {
    for (auto* one : panel()->findChildren<Widget*>())
      if (one->accessibleName() == name) return one;
    return nullptr;
  }
  static void choose(const QString& field, const QString& entry) {
    auto* box = named<QComboBox>(field);
    const int exact = box->findText(entry);
    const int at = exact >= 0 ? exact : box->findText(entry, Qt::MatchContains);
    ASSERT_GE(at, 0) << entry.toStdString();
    box->setCurrentIndex(at);
    emit box->activated(at);
    ASSERT_TRUE(shows());
  }
  static void type(const QString& field, const QString& text) {
    auto* line = named<QComboBox>(field)->lineEdit();
    line->setFocus();
    line->selectAll();
    QTest::keyClicks(line, text);
    emit line->editingFinished();
  }
  static QRect placeInPanel(const QWidget* widget) {
    return {widget->mapTo(panel(), QPoint(0, 0)), widget->size()};
  }
  static void click(const QString& text) {
    for (auto* button : panel()->findChildren<QPushButton*>())
      if (button->text() == text) return button->click();
    ADD_FAILURE() << "no button " << text.toStdString();
  }
  static QPushButton* import() {
    for (auto* button : panel()->findChildren<QPushButton*>())
      if (button->text() == "Import") return button;
    return nullptr;
  }
  static const Material& open() { return window().session()->material(); }
  static double height() { return panel()->view().imported.report.height_m; }
};

TEST_F(ImportPanelTest, AFileThatIsReadWithDoubtsIsAskedAboutAndChangesNothingUntilThen) {
  const QString before = QString::fromStdString(open().input.name);
  window().openFiles({walk("asked_1.bvh")});
  ASSERT_TRUE(shows());
  EXPECT_THAT(panel()->warnings().toStdString(), HasSubstr("does not state its unit"));
  EXPECT_EQ(QString::fromStdString(open().input.name), before);
  click("Cancel");
  ASSERT_TRUE(until([] { return !panel(); }));
  EXPECT_EQ(QString::fromStdString(open().input.name), before);
  EXPECT_TRUE(QDir(remembered().importRuleFolder()).isEmpty()) << "nothing is remembered either";
}

TEST_F(ImportPanelTest, TheReasonIsTheFirstThingAndLeavesWhenItIsAnswered) {
  window().openFiles({walk("asked_1.bvh", 100)});
  ASSERT_TRUE(shows());
  EXPECT_THAT(panel()->reason().toStdString(), StartsWith("Please check: "));
  EXPECT_THAT(panel()->reason().toStdString(), HasSubstr("the toe bases rest at"));
  EXPECT_THAT(panel()->reason().toStdString(), Not(HasSubstr("does not state its unit")))
      << "that was guessed with certainty: a warning, no question";
  turn();
  const QRect reason = placeInPanel(named<QLabel>("Reason"));
  for (QWidget* each : panel()->findChildren<QWidget*>())
    if (each->isVisible() && each->accessibleName() != "Reason") {
      EXPECT_LE(reason.bottom(), placeInPanel(each).top()) << each->accessibleName().toStdString();
    }
  choose("Floor", "as in the file");
  EXPECT_EQ(panel()->reason(), "");
}

TEST_F(ImportPanelTest, PerformersAndAnimationsThatNobodyChoseAreTheReason) {
  window().openFiles({pair("two.bvh")});
  ASSERT_TRUE(shows());
  EXPECT_THAT(panel()->reason().toStdString(), HasSubstr("the file has 2 performers"));
  choose("Performer", "Ben");
  EXPECT_THAT(panel()->reason().toStdString(), Not(HasSubstr("performers")));
  click("Cancel");
  ASSERT_TRUE(until([] { return !panel(); }));
  window().openFiles({with_two_animations("two.glb")});
  ASSERT_TRUE(shows());
  EXPECT_THAT(panel()->reason().toStdString(), HasSubstr("the file has 2 animations"));
}

/// It was ticked before anybody had decided.
TEST_F(ImportPanelTest, TheTickIsOffUntilThePersonSetItAndThenAsThePersonLeftIt) {
  for (const auto& [name, was, becomes] :
       {std::tuple("walk", false, true), {"jump", true, false}, {"sit", false, false}}) {
    QDir(remembered().importRuleFolder()).removeRecursively();
    window().openFiles({walk(name + QString(".bvh"))});
    ASSERT_TRUE(shows());
    EXPECT_EQ(panel()->remembers(), was) << name;
    panel()->setRemembers(becomes);
    click("Import");
    ASSERT_TRUE(until([name = name] { return !panel() && open().input.name == name; }));
  }
}

TEST_F(ImportPanelTest, AFileThatHasARuleShowsItsTickSoThatTheRuleIsNotLostUnasked) {
  const QString file = walk("walk_1.bvh");
  window().openFiles({file});
  ASSERT_TRUE(shows());
  panel()->setRemembers(true);
  click("Import");
  ASSERT_TRUE(until([] { return open().input.name == "walk_1" && !panel(); }));
  remembered().setRemembersImports(false);
  desk().offer({file});
  ASSERT_TRUE(shows());
  EXPECT_TRUE(panel()->remembers());
}

/// It was asked before the panel was there, and again when the panel was accepted.
TEST_F(ImportPanelTest, WorkThatWouldBeLostIsAskedAboutOnceAndAfterThePanel) {
  auto& project = *window().findChild<ProjectDesk*>();
  int asked = 0;
  ProjectDesk::Answer answer = ProjectDesk::Answer::Cancel;
  project.ask = [&] { return ++asked, answer; };
  window().findChild<HistoryDesk*>()->ask = [](double) { return HistoryDesk::Answer::Discard; };
  project.setAsks(true);
  window().document().changeSetting("alpha", "0.23");
  const std::string before = open().input.name;
  window().openFiles({walk("late_1.bvh")});
  ASSERT_TRUE(shows());
  EXPECT_EQ(asked, 0) << "nothing is lost yet";
  panel()->setRemembers(false);
  click("Import");
  ASSERT_TRUE(until([&] { return asked == 1; }));
  turn();
  EXPECT_EQ(open().input.name, before) << "cancelled";
  answer = ProjectDesk::Answer::Discard;
  window().openFiles({walk("late_1.bvh")});
  ASSERT_TRUE(shows());
  panel()->setRemembers(false);
  click("Import");
  EXPECT_TRUE(until([] { return open().input.name == "late_1"; }));
  EXPECT_EQ(asked, 2) << "once for each";
  project.setAsks(false);
}

TEST_F(ImportPanelTest, WhatIsSaidIsSeenAtOnceImportedAndDoneForFilesAlike) {
  window().openFiles({walk("walk_1.bvh", 100)});
  ASSERT_TRUE(shows());
  EXPECT_NEAR(height(), 1.6, 0.2);
  choose("Unit", "millimetres");
  EXPECT_NEAR(height(), 0.16, 0.02);
  EXPECT_THAT(panel()->warnings().toStdString(), HasSubstr("m tall"));
  choose("Unit", "centimetres");
  type("Frame rate", "48");
  ASSERT_TRUE(until([] { return panel()->view().imported.clip.fps == 48; }));
  ASSERT_TRUE(shows());
  panel()->setRemembers(true);
  click("Import");
  ASSERT_TRUE(until([] { return open().input.name == "walk_1"; }));
  EXPECT_EQ(open().input.fps, 48);
  EXPECT_EQ(open().reading.metres_per_unit, 0.01);
  window().openFiles({walk("walk_2.bvh", 100)});
  ASSERT_TRUE(until([] { return open().input.name == "walk_2"; })) << "without a question";
  EXPECT_FALSE(panel());
  EXPECT_EQ(open().input.fps, 48);
}

TEST_F(ImportPanelTest, WhatIsRememberedCanBeSeenAndRemoved) {
  window().openFiles({walk("walk_1.bvh")});
  ASSERT_TRUE(shows());
  choose("Unit", "metres");
  panel()->setRemembers(true);
  click("Import");
  ASSERT_TRUE(until([] { return open().input.name == "walk_1" && !panel(); }));
  ImportRulesDialog rules(remembered().importRuleFolder(), nullptr);
  ASSERT_EQ(rules.table().rowCount(), 1);
  EXPECT_EQ(rules.table().item(0, 0)->text(), "walk_#.bvh");
  EXPECT_EQ(rules.table().item(0, 2)->text(), "metres per unit 1");
  rules.table().selectRow(0);
  rules.removeChosen();
  EXPECT_EQ(rules.table().rowCount(), 0);
  window().openFiles({walk("walk_2.bvh")});
  EXPECT_TRUE(shows()) << "asked again";
}

TEST_F(ImportPanelTest, WithoutTheTickNothingIsRemembered) {
  window().openFiles({walk("walk_1.bvh")});
  ASSERT_TRUE(shows());
  panel()->setRemembers(false);
  click("Import");
  ASSERT_TRUE(until([] { return open().input.name == "walk_1" && !panel(); }));
  EXPECT_TRUE(QDir(remembered().importRuleFolder()).isEmpty());
}

TEST_F(ImportPanelTest, AGuessThatIsCertainOpensNoPanel) {
  window().openFiles({plain("certain_1.bvh")});
  ASSERT_TRUE(until([] { return open().input.name == "certain_1"; }));
  EXPECT_FALSE(panel());
  EXPECT_THAT(window().messages().text().toStdString(), HasSubstr("does not state its unit"))
      << "but is told";
}

TEST_F(ImportPanelTest, AFileWithoutDoubtsIsReachedByTheMenu) {
  const QString file = plain("plain_1.bvh");
  MotionReading said;
  said.metres_per_unit = 0.01;
  window().openFiles({file}, said);
  ASSERT_TRUE(until([] { return open().input.name == "plain_1"; }));
  EXPECT_FALSE(panel()) << "somebody said how it is read";
  action_of(window(), "file.import_options_of_the_open_motion")->trigger();
  ASSERT_TRUE(shows());
  EXPECT_EQ(panel()->reading().metres_per_unit, 0.01) << "as it was read";
  EXPECT_EQ(panel()->warnings(), "");
  choose("Floor", "below the toes");
  EXPECT_NEAR(panel()->view().imported.clip.poses.front().col(1).minCoeff(), 0.04, 0.05);
}

TEST_F(ImportPanelTest, OfSeveralPerformersTheOneThatIsChosenPlaysTheUser) {
  window().openFiles({pair("two.bvh")});
  ASSERT_TRUE(shows()) << "the file asks";
  auto* performers = named<QComboBox>("Performer");
  ASSERT_TRUE(performers->isVisible());
  ASSERT_EQ(performers->count(), 2);
  EXPECT_EQ(performers->currentText(), "Anna");
  const Pose anna = panel()->view().imported.clip.poses.front();
  choose("Performer", "Ben");
  const Pose ben = panel()->view().imported.clip.poses.front();
  EXPECT_GT((anna.row(0) - ben.row(0)).norm(), 0.5) << "the picture shows the other one";
  panel()->setRemembers(false);
  click("Import");
  ASSERT_TRUE(until([] { return open().reading.performer == "Ben" && !panel(); }));
  EXPECT_LT((open().input.poses.front() - ben).norm(), 1e-9);
}

TEST_F(ImportPanelTest, OfSeveralAnimationsTheOneThatIsChosenIsRead) {
  window().openFiles({with_two_animations("two.glb")});
  ASSERT_TRUE(shows()) << "the file asks";
  auto* animations = named<QComboBox>("Animation");
  ASSERT_TRUE(animations->isVisible());
  ASSERT_EQ(animations->count(), 2);
  EXPECT_EQ(animations->currentText(), "motion") << "the longest";
  EXPECT_EQ(panel()->view().imported.clip.poses.size(), 40U);
  choose("Animation", "short");
  EXPECT_EQ(panel()->view().imported.clip.poses.size(), 20U);
  EXPECT_EQ(animations->count(), 2) << "it can be taken back";
  panel()->setRemembers(false);
  click("Import");
  ASSERT_TRUE(until([] { return open().reading.animation == "short" && !panel(); }));
  EXPECT_EQ(open().input.poses.size(), 20U);
}

TEST_F(ImportPanelTest, ATakeOfTheLibraryIsReadAnewAndTheLibraryBuiltAgain) {
  const PairedTake take = test::swinging_take("t", 40, 1);
  Manifest manifest;
  manifest.name = "pairs";
  for (const char* name : {"one", "two"}) {
    Manifest::Take& each = manifest.takes.emplace_back();
    each.name = name;
    for (const auto& [performer, clip, ending] :
         {std::tuple(&each.a, &take.a, "_a.bvh"), {&each.b, &take.b, "_b.bvh"}}) {
      performer->motion = home().filePath(QString(name) + ending).toStdString();
      std::ofstream(performer->motion) << *write_bvh(std::vector<Clip>{*clip}, 100);
    }
  }
  std::vector<std::string> warnings;
  auto library = std::make_shared<const MotionLibrary>(*build_library(manifest, {}, {}, warnings));
  window().openMaterial(
      [&](const Progress&) -> Result<Material> { return built_material(library, manifest, "", {}); });
  ASSERT_TRUE(until([&] { return open().library == library; }));
  const int row = library->find_take("one");
  emit window().takes().readingRequested(row, true);
  ASSERT_TRUE(shows());
  EXPECT_THAT(panel()->reading().file, HasSubstr("one_b.bvh"));
  click("Import");
  ASSERT_TRUE(until([] { return !panel(); }));
  EXPECT_EQ(open().library, library) << "nothing was changed";
  emit window().takes().readingRequested(row, true);
  ASSERT_TRUE(shows());
  type("Unit", "0.011");
  ASSERT_TRUE(until([] { return panel()->reading().metres_per_unit == 0.011; }));
  ASSERT_TRUE(shows());
  panel()->setRemembers(false);
  click("Import");
  ASSERT_TRUE(until([&] { return open().library != library; }));
  ASSERT_TRUE(open().manifest);
  EXPECT_EQ(open().manifest->takes.front().b.metres_per_unit, 0.011);
  EXPECT_EQ(open().manifest->takes.front().a.metres_per_unit, std::nullopt)
      << "the other file is read as before";
}

TEST_F(ImportPanelTest, ALibraryThatWasNotBuiltOfFilesSaysSo) {
  window().openDemo();
  ASSERT_TRUE(until([] { return open().is_generated; }));
  emit window().takes().readingRequested(0, false);
  EXPECT_FALSE(panel());
  EXPECT_THAT(window().messages().text().toStdString(), HasSubstr("was generated"));
}

TEST_F(ImportPanelTest, NumbersThatAreNoneAreRefusedAndTheFileStaysAsItWasRead) {
  desk().offer({walk("walk_1.bvh")});
  ASSERT_TRUE(shows());
  for (const char* text : {"fast", "-3", "0", "1e999"}) {
    type("Frame rate", text);
    EXPECT_FALSE(panel()->isWaiting()) << text;
    EXPECT_FALSE(panel()->reading().fps) << text;
  }
}

TEST_F(ImportPanelTest, AFileThatCannotBeReadSaysWhyInThePanelAndCannotBeImported) {
  const QString broken = home().filePath("broken.bvh");
  std::ofstream(broken.toStdString()) << "HIERARCHY\nROOT Hips\n{\n";
  desk().offer({broken});
  ASSERT_TRUE(shows());
  EXPECT_THAT(panel()->warnings().toStdString(), HasSubstr("broken.bvh"));
  EXPECT_FALSE(import()->isEnabled());
}

TEST_F(ImportPanelTest, AJointMapThatDoesNotFitIsSaidAndTakenBack) {
  desk().offer({walk("walk_1.bvh")});
  ASSERT_TRUE(shows());
  choose("Joint map", "xsens");
  EXPECT_THAT(panel()->warnings().toStdString(), HasSubstr("'xsens' does not fit"));
  EXPECT_FALSE(import()->isEnabled());
  choose("Joint map", "as found");
  EXPECT_TRUE(import()->isEnabled());
}

TEST_F(ImportPanelTest, FeetThatAreOffTheFloorAreToldWithTheValueToEnter) {
  desk().offer({written("walk_1.bvh", 1, false, 0)});
  ASSERT_TRUE(shows());
  const double toes_m = panel()->view().imported.report.floor_y_m;
  type("Floor", QString::number(toes_m - 0.11));  // the toes 11 cm above it
  ASSERT_TRUE(shows());
  EXPECT_FALSE(panel()->view().floor_to_enter()) << "a person said it";
  delete desk().panel();
  desk().offer({written("walk_2.bvh", 1, false, 0.11 - toes_m)});
  ASSERT_TRUE(shows());
  ASSERT_TRUE(panel()->view().floor_to_enter());
  EXPECT_NEAR(*panel()->view().floor_to_enter(), 0.07, 0.0011);
  const QString enter = QString("enter %1 m").arg(*panel()->view().floor_to_enter(), 0, 'f', 3);
  const auto says = [&enter] {
    return std::ranges::any_of(panel()->findChildren<QLabel*>(),
                               [&](const QLabel* label) { return label->text().contains(enter); });
  };
  EXPECT_TRUE(says());
  type("Floor", QString::number(*panel()->view().floor_to_enter()));
  ASSERT_TRUE(shows());
  EXPECT_NEAR(body_of(panel()->view().imported.clip.poses).toe_rest_height, 0.04, 0.0011);
  EXPECT_FALSE(says());
}

/// Names such as LeftUpLeg are those of several programs.
TEST_F(ImportPanelTest, AMapIsSaidToBeOfNamesAndNotOfTheProgramThatWroteTheFile) {
  desk().offer({written("walk_1.bvh", 1, false, 0)});
  ASSERT_TRUE(shows());
  const std::string map = panel()->view().imported.report.joint_map;
  EXPECT_TRUE(std::ranges::any_of(panel()->findChildren<QLabel*>(), [&](const QLabel* label) {
    return label->text().toStdString() == "25 of 25 joints found by names as in “" + map + "”";
  })) << map;
}

/// The head counted only some of the joints that the warnings below it named.
TEST_F(ImportPanelTest, TheJointsFoundAndThoseInTheWarningsMakeAll) {
  desk().offer({without_toes_and_thorax("walk_1.bvh")});
  ASSERT_TRUE(shows());
  const auto said = [](const std::string& words) {
    return std::ranges::any_of(panel()->findChildren<QLabel*>(), [&](const QLabel* label) {
      return label->text().toStdString().find(words) != std::string::npos;
    });
  };
  EXPECT_TRUE(said("18 of 25 joints found by names as in “motive”, 7 inferred"));
  EXPECT_TRUE(
      said("7 of the 25 joints are not in the file and were inferred: "
           "lfoot, ltoes, rfoot, rtoes, thorax, lhand, rhand"));
  const auto* table = panel()->findChild<QTableWidget*>();
  int inferred = 0;
  for (int joint = 0; joint < table->rowCount(); ++joint)
    inferred += table->item(joint, 1)->text().startsWith("inferred: ") ? 1 : 0;
  EXPECT_EQ(inferred, 7);
}

TEST_F(ImportPanelTest, ThePictureStandsOnTheGroundAndLiesWhenTheAxisIsWrong) {
  desk().offer({written("walk_1.bvh", 1, true, 0)});
  ASSERT_TRUE(shows());
  const QColor blue = window().colours().active;
  const auto box_of_body = [&] {
    const QImage picture = test::picture_of(panel()->picture());
    QRect box;
    for (int y = 0; y < picture.height(); y += 2)
      for (int x = 0; x < picture.width(); x += 2)
        if (QColor pixel(picture.pixel(x, y));
            std::abs(pixel.hslHue() - blue.hslHue()) < 8 && pixel.hslSaturation() > blue.hslSaturation() / 2)
          box |= QRect(x, y, 2, 2);
    return box;
  };
  const QRect standing = box_of_body();
  EXPECT_GT(standing.height(), 1.5 * standing.width()) << "upright";
  EXPECT_GT(standing.height(), panel()->picture().height() / 2) << "and fills the picture";
  EXPECT_GT(panel()->picture().namesDrawn(), 8);
  choose("Up axis", "Y");
  const QRect lying = box_of_body();
  EXPECT_LT(lying.height(), 0.65 * standing.height());
}

}  // namespace
}  // namespace abrazo::app::import_panel_test
