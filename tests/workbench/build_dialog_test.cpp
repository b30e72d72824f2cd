// Building a library in the dialog from files that the test writes.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <QComboBox>
#include <QDir>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSignalSpy>
#include <QTableView>
#include <QTemporaryDir>
#include <QTest>
#include <QToolButton>
#include <fstream>

#include "app/workbench/library/build_form.hpp"
#include "app/workbench/library/library_build.hpp"
#include "core/library/store/motion_library_file.hpp"
#include "core/motion/bvh/bvh.hpp"
#include "tests/support/libraries.hpp"
#include "tests/widgets/pictures.hpp"
#include "widgets/library/pair_preview.hpp"

namespace abrazo::app::build_dialog_test {
namespace {

using testing::Contains;
using testing::HasSubstr;

class BuildDialogTest : public testing::Test {
 protected:
  void SetUp() override {
    ASSERT_TRUE(folder.isValid());
    build = std::make_unique<LibraryBuild>(nullptr, widgets::palette_of(widgets::Theme::Dark));
  }
  QString path(const std::string& name) const { return folder.filePath(QString::fromStdString(name)); }
  /// Both performers of a swinging couple as two files in some unit; with Z up when asked.
  QStringList couple(const std::string& a, const std::string& b, int frames, double units_per_metre = 1,
                     bool z_up = false) {
    PairedTake take = test::swinging_take("t", frames, 1);
    for (Clip* clip : {&take.a, &take.b})
      for (Pose& pose : clip->poses)
        if (z_up) {
          const Eigen::Matrix<double, joint_count, 1> y = pose.col(1);
          pose.col(1) = -pose.col(2);
          pose.col(2) = y;
        }
    std::ofstream(path(a).toStdString()) << *write_bvh(std::vector<Clip>{take.a}, units_per_metre);
    std::ofstream(path(b).toStdString()) << *write_bvh(std::vector<Clip>{take.b}, units_per_metre);
    return {path(a), path(b)};
  }
  void offer(const QStringList& files) {
    build->offer(files);
    settle();
  }
  void settle() {
    ASSERT_TRUE(QTest::qWaitFor([this] { return !build->isBusy(); }, 20'000));
  }
  QString cell(int row, BuildPlanModel::Column column) {
    return model().index(row, column).data().toString();
  }
  BuildPlanModel& model() { return build->dialog().model(); }
  std::vector<std::string> remarks() {
    std::vector<std::string> texts;
    for (const QString& text : build->dialog().remarks()) texts.push_back(text.toStdString());
    return texts;
  }
  template <typename Widget>
  Widget* named(const QString& name) {
    for (auto* one : build->dialog().findChildren<Widget*>())
      if (one->accessibleName() == name) return one;
    return nullptr;
  }
  /// As a person who chooses an entry.
  void choose(const QString& field, int entry) {
    auto* box = named<QComboBox>(field);
    box->setCurrentIndex(entry);
    emit box->activated(entry);
    settle();
  }
  QPushButton* button(const QString& text) {
    for (auto* one : build->dialog().findChildren<QPushButton*>())
      if (one->text() == text) return one;
    return nullptr;
  }
  QTemporaryDir folder;
  std::unique_ptr<LibraryBuild> build;
};

TEST_F(BuildDialogTest, ReturnAddsFilesBeforeThereAreAny) {
  const auto on_return = [this] {
    QString text;
    for (auto* button : build->dialog().findChildren<QPushButton*>())
      if (button->isDefault()) text += button->text();
    return text.toStdString();
  };
  offer({});
  EXPECT_EQ(on_return(), "Add files…");
  offer(couple("anna.bvh", "ben.bvh", 40));
  EXPECT_EQ(on_return(), "Build");
}

TEST_F(BuildDialogTest, ShowsWhatItFoundAndGuessed) {
  offer(couple("x_leader.bvh", "x_follower.bvh", 40, 100));
  ASSERT_EQ(model().rowCount(), 2);
  EXPECT_EQ(cell(0, BuildPlanModel::Take), "x");
  EXPECT_EQ(cell(0, BuildPlanModel::Performer), "x_leader.bvh");
  EXPECT_EQ(cell(0, BuildPlanModel::Role), "leads");
  EXPECT_EQ(cell(1, BuildPlanModel::Role), "follows");
  EXPECT_EQ(cell(0, BuildPlanModel::Frames), "40");
  EXPECT_EQ(cell(0, BuildPlanModel::Rate), "60 fps");
  EXPECT_EQ(cell(0, BuildPlanModel::Unit), "cm ?") << "a guess is marked";
  EXPECT_EQ(cell(0, BuildPlanModel::Up), "Y ?");
  EXPECT_EQ(cell(0, BuildPlanModel::Pairing), "sure");
  EXPECT_TRUE(model().index(0, BuildPlanModel::Pairing).data(Qt::ToolTipRole).toString().contains("leader"));
  EXPECT_TRUE(button("Build")->isEnabled());
}

TEST_F(BuildDialogTest, AWrongUnitShowsAndIsReadAnewWhenItIsSet) {
  offer(couple("x_leader.bvh", "x_follower.bvh", 40, 100));
  build->dialog().table().selectAll();
  choose("Unit", 1);  // metres
  EXPECT_THAT(remarks(), Contains(HasSubstr("m tall; set its unit")));
  EXPECT_EQ(cell(0, BuildPlanModel::Unit), "m");
  choose("Unit", 2);  // centimetres
  EXPECT_EQ(cell(1, BuildPlanModel::Unit), "cm") << "said, so no guess any more; for every chosen row";
  EXPECT_THAT(remarks(), testing::Not(Contains(HasSubstr("tall"))));
  EXPECT_EQ(cell(0, BuildPlanModel::Take), "x") << "what was decided stays";
}

TEST_F(BuildDialogTest, AWrongAxisShowsInThePreview) {
  offer(couple("x_leader.bvh", "x_follower.bvh", 40, 1, true));
  EXPECT_EQ(cell(0, BuildPlanModel::Up), "Z ?");
  build->dialog().table().selectAll();
  const QImage standing = test::picture_of(build->dialog().preview());
  choose("Up axis", 1);  // Y: they lie
  EXPECT_EQ(cell(0, BuildPlanModel::Up), "Y");
  EXPECT_GT(test::difference(standing, test::picture_of(build->dialog().preview())), 0.01);
}

TEST_F(BuildDialogTest, DrawsBothPerformersFromTwoSides) {
  offer(couple("x_A.bvh", "x_B.bvh", 40));
  const QImage picture = test::picture_of(build->dialog().preview());
  for (const QImage& half :
       {picture.copy(0, 0, picture.width() / 2, picture.height() - 50),
        picture.copy(picture.width() / 2, 0, picture.width() / 2, picture.height() - 50)}) {
    EXPECT_GT(test::pixels_of_hue(half, widgets::palette_of(widgets::Theme::Dark).active), 60);
    EXPECT_GT(test::pixels_of_hue(half, widgets::palette_of(widgets::Theme::Dark).passive), 60);
  }
}

TEST_F(BuildDialogTest, AnEmptyPlanAsksForMotionFiles) {
  EXPECT_THAT(remarks(), Contains(HasSubstr("To do: no motion yet: add the files")));
  EXPECT_FALSE(button("Build")->isEnabled());
}

TEST_F(BuildDialogTest, TakesArePairedByHand) {
  offer(couple("anna.bvh", "morning_ben.bvh", 40) + couple("cleo.bvh", "dan_x.bvh", 60));
  build->dialog().table().selectAll();
  choose("Take", 0);
  EXPECT_EQ(cell(0, BuildPlanModel::Take), "not used");
  EXPECT_FALSE(button("Build")->isEnabled());
  EXPECT_THAT(remarks(), Contains(HasSubstr("To do: no take yet")));
  for (const int row : {0, 1})
    model().setData(model().index(row, BuildPlanModel::Take), "mine", Qt::EditRole);
  EXPECT_EQ(cell(1, BuildPlanModel::Pairing), "by hand");
  EXPECT_TRUE(button("Build")->isEnabled());
}

TEST_F(BuildDialogTest, BuildsSavesAndHandsOverTheLibrary) {
  offer(couple("x_leader.bvh", "x_follower.bvh", 40, 100));
  build->dialog().setOutputs({path("l.h5"), path("l.json")});
  std::shared_ptr<const MotionLibrary> library;
  QObject::connect(build.get(), &LibraryBuild::built, build.get(),
                   [&](const Material& now) { library = now.library; });
  button("Build")->click();
  settle();
  ASSERT_TRUE(library);
  EXPECT_EQ(library->pair_count(), 40);
  EXPECT_EQ(read_library(path("l.h5").toStdString())->pair_count(), 40);
  EXPECT_TRUE(read_manifest(path("l.json").toStdString()).ok());
  EXPECT_FALSE(build->dialog().isVisible());
}

TEST_F(BuildDialogTest, CancelledHalfWayLeavesNothingBehindAndCanBeStartedAgain) {
  offer(couple("x_leader.bvh", "x_follower.bvh", 3000));
  build->dialog().setOutputs({path("l.h5"), path("l.json")});
  int built = 0;
  QObject::connect(build.get(), &LibraryBuild::built, build.get(), [&built] { ++built; });
  button("Build")->click();
  EXPECT_TRUE(build->isBusy());
  EXPECT_FALSE(button("Build")->isEnabled());
  button("Cancel")->click();
  EXPECT_FALSE(build->isBusy());
  EXPECT_TRUE(build->dialog().isVisible()) << "what was decided is not lost";
  EXPECT_TRUE(button("Build")->isEnabled());
  build.reset();  // waits for the worker
  EXPECT_EQ(built, 0);
  EXPECT_EQ(QDir(folder.path()).entryList(QDir::Files).size(), 2) << "the two motions";
}

TEST_F(BuildDialogTest, AnErrorNamesTheFileAndKeepsTheDialog) {
  const QStringList files = couple("x_leader.bvh", "x_follower.bvh", 40);
  offer(files);
  QFile::remove(files[1]);
  int built = 0;
  QObject::connect(build.get(), &LibraryBuild::built, build.get(), [&built] { ++built; });
  button("Build")->click();
  settle();
  EXPECT_EQ(built, 0);
  EXPECT_TRUE(build->dialog().isVisible());
  bool named = false;
  for (const auto* label : build->dialog().findChildren<QLabel*>())
    named = named || label->text().contains("x_follower.bvh: ");
  EXPECT_TRUE(named);
}

TEST_F(BuildDialogTest, OfTwoMotionsOneMayPlayTheUser) {
  const QStringList files = couple("x_A.bvh", "x_B.bvh", 40);
  offer(files);
  const QSignalSpy chosen(build.get(), &LibraryBuild::userChosen);
  for (auto* one : build->dialog().findChildren<QToolButton*>())
    if (one->text() == "x_B.bvh plays the user") one->click();
  ASSERT_EQ(chosen.count(), 1);
  EXPECT_EQ(chosen[0][0].toStringList(), QStringList{files[1]});
  EXPECT_FALSE(build->dialog().isVisible());
}

TEST_F(BuildDialogTest, AFileThatIsNoMotionIsShownWithItsReason) {
  const QStringList files = couple("x_A.bvh", "x_B.bvh", 40);
  std::ofstream(path("broken.bvh").toStdString()) << "HIERARCHY\nROOT";
  offer(files + QStringList{path("broken.bvh")});
  EXPECT_EQ(cell(2, BuildPlanModel::Frames), "cannot be read");
  EXPECT_THAT(remarks(), Contains(HasSubstr("broken.bvh:")));
  EXPECT_TRUE(button("Build")->isEnabled()) << "the others can be used";
}

TEST_F(BuildDialogTest, TakesGetTheNamesOfTheirLabels) {
  std::ofstream(path("moves.csv").toStdString()) << "take,start_frame,end_frame,label\nsalsa_7,0,20,turn\n";
  offer(couple("60_07.bvh", "61_07.bvh", 40) + QStringList{path("moves.csv")});
  EXPECT_EQ(cell(0, BuildPlanModel::Take), "salsa_7");
  std::shared_ptr<const MotionLibrary> library;
  QObject::connect(build.get(), &LibraryBuild::built, build.get(),
                   [&](const Material& now) { library = now.library; });
  button("Build")->click();
  settle();
  ASSERT_TRUE(library);
  EXPECT_EQ(library->label(0), "turn");
}

}  // namespace
}  // namespace abrazo::app::build_dialog_test
