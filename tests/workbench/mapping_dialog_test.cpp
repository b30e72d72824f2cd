// The dialogs that ask which points of a motion are which joints, and where markers are on the body.
#include "app/workbench/library/mapping_dialog.hpp"

#include <gmock/gmock.h>

#include <QApplication>
#include <QCompleter>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QMessageBox>
#include <QPushButton>
#include <QTemporaryDir>
#include <QTimer>
#include <algorithm>
#include <fstream>

#include "app/workbench/library/marker_table.hpp"
#include "tests/core/motion/marker_body.hpp"
#include "tests/widgets/pictures.hpp"
#include "tests/workbench/demo_window.hpp"
#include "widgets/library/motion_picture.hpp"

namespace abrazo::app::mapping_dialog_test {
namespace {

using testing::HasSubstr;
using testing::Not;

class MappingDialogTest : public testing::Test {
 protected:
  /// Three markers, Y up; one was not seen in the first frame.
  static NamedMotion motion() {
    NamedMotion motion;
    motion.name = "three", motion.points = {"LASI", "RASI", "Head top"}, motion.parents = {-1, -1, -1};
    for (int f = 0; f < 3; ++f) {
      Positions frame(3, 3);
      frame << 0.1, 1, 0, -0.1, 1, 0, 0, 1.7, 0;
      motion.frames.push_back(frame);
    }
    return motion;
  }
};

TEST_F(MappingDialogTest, NamesStandAtThePointsAndTheGroundBelow) {
  MappingDialog dialog(motion(), nullptr);
  (void)test::picture_of(dialog.preview());
  EXPECT_EQ(dialog.preview().namesDrawn(), 3);
  EXPECT_DOUBLE_EQ(dialog.preview().space().ground, 1) << "the lowest point";
  EXPECT_LT(dialog.preview().placeOf(2).y(), dialog.preview().placeOf(0).y()) << "upright";
}

TEST_F(MappingDialogTest, NamesAreCompletedWhileTypingAlsoBehindAWeight) {
  MappingDialog dialog(motion(), nullptr);
  dialog.show();
  dialog.table().setCurrentCell(0, 1);
  dialog.table().editItem(dialog.table().item(0, 1));
  auto* line = dialog.table().findChild<QLineEdit*>();
  ASSERT_TRUE(line);
  ASSERT_TRUE(line->completer());
  const auto complete = [line](const QString& typed) {
    line->setText(typed);
    line->completer()->setCompletionPrefix(line->completer()->splitPath(typed).front());
    return line->completer()->currentCompletion();
  };
  EXPECT_EQ(complete("ras").toStdString(), "RASI");
  EXPECT_EQ(complete("0.5 LASI + 0.5 ra").toStdString(), "0.5 LASI + 0.5 RASI");
  EXPECT_EQ(complete("top").toStdString(), "Head top");
}

/// Markers of a person whose names say nothing.
NamedMotion nameless_markers() {
  NamedMotion motion = test::marked_body(60, 0.15).markers;
  motion.name = "nameless";
  for (std::size_t p = 0; p < motion.points.size(); ++p) motion.points[p] = "U" + std::to_string(p + 1);
  return motion;
}

class MarkerDialogTest : public MappingDialogTest {
 protected:
  void SetUp() override {
    dialog.show();
    ASSERT_TRUE(until([this] { return dialog.state().contains("markers guessed"); }));
  }
  int first(MarkerNaming::By by) {
    const auto& rows = dialog.markers().naming().rows();
    return static_cast<int>(std::ranges::find(rows, by, &MarkerNaming::Row::by) - rows.begin());
  }
  QTemporaryDir folder;
  MappingDialog dialog{nameless_markers(), nullptr};
};

TEST_F(MarkerDialogTest, GuessesAtOnceWhereNamesSayNothingAndCountsInASentence) {
  EXPECT_TRUE(dialog.namesMarkers());
  EXPECT_THAT(dialog.state().toStdString(),
              testing::ContainsRegex("[0-9]+ of 36 markers guessed, [0-9]+ sure"));
  const int sure = first(MarkerNaming::By::Guess), proposed = first(MarkerNaming::By::Proposal);
  EXPECT_EQ(dialog.markers().item(sure, MarkerTable::Belief)->text(), "sure");
  EXPECT_THAT(dialog.markers().item(proposed, MarkerTable::Belief)->text().toStdString(),
              testing::AnyOf("likely · accept", "doubtful · accept"));
}

TEST_F(MarkerDialogTest, EnterOrAClickAcceptsAProposal) {
  const int by_key = first(MarkerNaming::By::Proposal);
  dialog.markers().setCurrentCell(by_key, MarkerTable::Place);
  QKeyEvent enter(QEvent::KeyPress, Qt::Key_Return, Qt::NoModifier);
  QCoreApplication::sendEvent(&dialog.markers(), &enter);
  EXPECT_EQ(dialog.markers().item(by_key, MarkerTable::Belief)->text(), "said");
  const int by_click = first(MarkerNaming::By::Proposal);
  emit dialog.markers().cellClicked(by_click, MarkerTable::Belief);
  EXPECT_EQ(dialog.markers().item(by_click, MarkerTable::Belief)->text(), "said");
  EXPECT_TRUE(dialog.isVisible()) << "Enter does not close the dialog";
}

TEST_F(MarkerDialogTest, WhatWasTypedStaysWhenItGuessesAgain) {
  const int row = first(MarkerNaming::By::Guess);
  dialog.markers().item(row, MarkerTable::Place)->setText("left tail");
  EXPECT_THAT(dialog.state().toStdString(), HasSubstr("no place 'left tail'"));
  dialog.markers().item(row, MarkerTable::Place)->setText("left ear");
  dialog.guessFromMotion();
  ASSERT_TRUE(until([this] { return dialog.state().contains("markers guessed"); }));
  EXPECT_EQ(dialog.markers().item(row, MarkerTable::Place)->text(), "left ear");
}

TEST_F(MarkerDialogTest, ASavedModelIsReadAgainAndABrokenOneSaysWhy) {
  const QString file = folder.filePath("model.json");
  const auto names = dialog.markers().naming().model("").names;
  dialog.saveTo(file);
  MappingDialog other(motion(), nullptr);
  other.loadFrom(file);
  EXPECT_THAT(other.state().toStdString(), HasSubstr("none of the 3 points"));
  dialog.loadFrom(file);
  EXPECT_EQ(dialog.markers().naming().model("").names, names);
  std::ofstream(file.toStdString()) << R"({"name": "bad", "markers": {"left tail": "U1"}})";
  dialog.loadFrom(file);
  EXPECT_THAT(dialog.state().toStdString(), HasSubstr("no place 'left tail'"));
  EXPECT_EQ(dialog.markers().naming().model("").names, names) << "nothing changed";
}

/// Everything is accepted, and no marker is on an arm: no edit that is left makes a body of them.
TEST_F(MarkerDialogTest, MarkersWithoutArmsCannotBeUsedAndItSaysWhyAndWhatHelps) {
  MarkerTable& markers = dialog.markers();
  for (int point = 0; point < markers.rowCount(); ++point) {
    markers.accept(point);
    const QString place = markers.item(point, MarkerTable::Place)->text();
    for (const char* part : {"shoulder", "arm", "elbow", "wrist", "hand"})
      if (place.contains(part)) markers.item(point, MarkerTable::Place)->setText("");
  }
  EXPECT_THAT(dialog.state().toStdString(), HasSubstr("elbows, wrists and hands are"));
  EXPECT_THAT(dialog.state().toStdString(), HasSubstr("The file cannot be used without"));
  EXPECT_THAT(dialog.state().toStdString(), HasSubstr("export the recording with markers there"));
  for (const auto* button : dialog.findChildren<QPushButton*>())
    if (button->text() == "Use") {
      EXPECT_FALSE(button->isEnabled());
    }
}

TEST_F(MarkerDialogTest, ARefusedPlaceMovesNothingAndIsForgottenInAnotherRow) {
  const auto* said = dialog.findChild<QLabel*>("state");
  ASSERT_TRUE(said);
  const QRect before = said->geometry();
  dialog.markers().setCurrentCell(0, MarkerTable::Place);
  dialog.markers().item(0, MarkerTable::Place)->setText("left tail");
  EXPECT_THAT(dialog.state().toStdString(), HasSubstr("no place 'left tail'"));
  QCoreApplication::processEvents();
  EXPECT_EQ(said->geometry(), before);
  EXPECT_LT(said->text().size(), dialog.state().size()) << "all places are in the tooltip";
  dialog.markers().setCurrentCell(1, MarkerTable::Place);
  EXPECT_THAT(dialog.state().toStdString(), Not(HasSubstr("left tail")));
}

TEST_F(MarkerDialogTest, EscapeAsksBeforeItDropsWhatWasAccepted) {
  const auto escape = [this](QMessageBox::StandardButton answer) {
    bool asked = false;
    QTimer person;
    QObject::connect(&person, &QTimer::timeout, &person, [&] {
      auto* question = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
      if (!question) return;
      asked = true;
      question->button(answer)->click();
    });
    person.start(20);
    QKeyEvent key(QEvent::KeyPress, Qt::Key_Escape, Qt::NoModifier);
    QCoreApplication::sendEvent(&dialog, &key);
    return asked;
  };
  dialog.markers().accept(first(MarkerNaming::By::Proposal));
  EXPECT_TRUE(escape(QMessageBox::No));
  EXPECT_TRUE(dialog.isVisible());
  dialog.saveTo(folder.filePath("kept.json"));
  EXPECT_FALSE(escape(QMessageBox::No)) << "nothing is lost";
  EXPECT_FALSE(dialog.isVisible());
}

}  // namespace
}  // namespace abrazo::app::mapping_dialog_test
