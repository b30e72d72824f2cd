// What the transport bar says and asks for, and the field for a typed value.
#include "widgets/timeline/transport_bar.hpp"

#include <gtest/gtest.h>

#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSignalSpy>
#include <QTest>
#include <algorithm>

#include "tests/widgets/pictures.hpp"
#include "widgets/common/tabular.hpp"
#include "widgets/timeline/quick_entry.hpp"

namespace abrazo::widgets::transport_bar_test {
namespace {

using test::picture_of;

const Palette& dark() {
  return palette_of(Theme::Dark);
}

TEST(TransportBar, TellsTheStateInWords) {
  TransportBar bar;
  Playback playback;
  playback.extend(0, 35);
  bar.showPlayback(playback, 10);
  bar.showUserInput(UserInput::Stream);
  EXPECT_EQ(bar.stateText(), "● LIVE");
  bar.showUserInput(UserInput::None);
  EXPECT_EQ(bar.stateText(), "○ NO INPUT") << "a stalled stream is not live";
  bar.showUserInput(UserInput::Clip);
  EXPECT_EQ(bar.stateText(), "▶ CLIP") << "nor is a clip";
  playback.seek(11.5);
  bar.showPlayback(playback, 10);
  EXPECT_EQ(bar.stateText(), QString("PARKED −23.5 s"));
  playback.play();
  bar.showPlayback(playback, 10);
  EXPECT_TRUE(bar.stateText().startsWith("PLAYING"));
}

TEST(TransportBar, SaysToAParkedCursorThatTheLiveEndGoesOn) {
  TransportBar bar;
  const auto* live = bar.findChild<QPushButton*>();
  ASSERT_TRUE(live);
  Playback playback;
  playback.extend(0, 35);
  bar.showUserInput(UserInput::Clip);
  bar.showPlayback(playback, 10);
  EXPECT_EQ(live->text(), "CLIP  End");
  playback.seek(11.5);
  bar.showPlayback(playback, 10);
  EXPECT_EQ(live->text(), "CLIP goes on  End");
  EXPECT_FALSE(live->styleSheet().contains(dark().live.name())) << "nobody performs";
  EXPECT_TRUE(live->toolTip().contains("Hold the input still (Ctrl+Space)")) << "and how to hold it";
  bar.showHeld(true);
  EXPECT_EQ(live->text(), "HELD  End");
  bar.showHeld(false);
  bar.showUserInput(UserInput::Stream);
  EXPECT_EQ(live->text(), "LIVE goes on  End");
  EXPECT_TRUE(live->styleSheet().contains(dark().live.name()));
  EXPECT_FALSE(live->toolTip().contains("Ctrl+Space")) << "a stream cannot be held";
  bar.showUserInput(UserInput::None);
  EXPECT_EQ(live->text(), "NEWEST  End") << "nothing comes in that could be answered";
  EXPECT_FALSE(live->styleSheet().contains(dark().live.name()));
}

/// "… · 60 Hz" was cut behind "60".
TEST(TransportBar, ALongNameOfTheInputIsShortenedBeforeItsRateAndToldInTheTooltip) {
  TransportBar bar;
  const QString input =
      "Ana Maria de la Torre y Fernandez de Cordoba, NatNet (Motive) at capture-room.studio.example · 120 Hz";
  bar.setInput(input, "on every network (0.0.0.0:1511)");
  bar.resize(2400, bar.height());
  (void)picture_of(bar);
  EXPECT_EQ(bar.inputText(), input);
  bar.resize(900, bar.height());
  (void)picture_of(bar);
  EXPECT_TRUE(bar.inputText().startsWith("Ana")) << bar.inputText().toStdString();
  EXPECT_TRUE(bar.inputText().contains("…")) << bar.inputText().toStdString();
  EXPECT_TRUE(bar.inputText().endsWith(" Hz")) << bar.inputText().toStdString();
  bool is_told = false;
  for (const QLabel* label : bar.findChildren<QLabel*>())
    is_told = is_told || (label->toolTip().contains("Torre") && label->toolTip().contains("1511"));
  EXPECT_TRUE(is_told);
  bar.resize(500, bar.height());
  (void)picture_of(bar);
  EXPECT_EQ(bar.inputText(), QString());
}

/// "PARKED -3", "goes on", "ser leads", "nned · ap": both ends of what was written were cut.
TEST(TransportBar, LeavesOutWordsInANarrowWindowAndCutsNone) {
  QWidget window;
  window.resize(1700, 60);
  TransportBar bar(&window);
  Playback playback;
  playback.extend(0, 35);
  playback.seek(11.5);
  bar.setInput("VMC from this machine · 60 Hz");
  bar.showRole(true, "by the library");
  const auto cut = [&] {
    (void)picture_of(window);
    QString found;
    for (const QWidget* part : bar.findChildren<QWidget*>(QString(), Qt::FindDirectChildrenOnly))
      if (part->isVisible() &&
          (part->width() < part->minimumSizeHint().width() || part->geometry().right() > bar.width()))
        found += part->accessibleName() + " ";
    return found.toStdString();
  };
  for (const bool is_full : {false, true}) {
    bar.showPins(is_full, false);
    bar.showRecording(is_full ? "salsa 003 · 00:35" : "");
    for (const int width : {1600, 1100, 640, 1600}) {
      bar.resize(width, bar.height());
      for (const bool plays : {false, true}) {
        plays ? playback.play() : playback.pause();
        bar.showPlayback(playback, 690);
        EXPECT_EQ(cut(), "") << width << (is_full ? " with a pin and a recording" : "");
      }
    }
    EXPECT_TRUE(bar.stateText().contains("−23.5 s")) << "whole again where there is room";
    EXPECT_EQ(bar.roleText(), QString("user leads · by the library ▾"));
  }
  bar.resize(640, bar.height());
  (void)picture_of(window);
  EXPECT_EQ(bar.recordingText(), QString("● REC"));
  bool is_told = false;
  for (const QLabel* label : bar.findChildren<QLabel*>())
    is_told = is_told || label->toolTip().contains("salsa 003");
  EXPECT_TRUE(is_told) << "the tooltip has the rest";
}

TEST(TransportBar, LeavesOutThatTheSenderIsThisMachineBeforeItsNameIsShortened) {
  TransportBar bar;
  bar.setInput("Abrazo, NatNet (Motive) at this machine · 120 Hz");
  bar.resize(2400, bar.height());
  (void)picture_of(bar);
  EXPECT_EQ(bar.inputText(), QString("Abrazo, NatNet (Motive) at this machine · 120 Hz"));
  for (int width = 2400; width > 640 && bar.inputText().contains("at this machine"); width -= 10) {
    bar.resize(width, bar.height());
    (void)picture_of(bar);
  }
  EXPECT_EQ(bar.inputText(), QString("Abrazo, NatNet (Motive) · 120 Hz"));
}

TEST(TransportBar, WhatHasAnEndIsNeverLive) {
  TransportBar bar;
  bar.resize(1600, bar.height());
  bar.show();
  const auto is_live_offered = [&bar] {
    for (const QPushButton* button : bar.findChildren<QPushButton*>())
      if (button->isVisible()) return true;
    return false;
  };
  Playback playback;
  playback.extend(0, 28);
  bar.showPlayback(playback, 12);
  EXPECT_TRUE(is_live_offered());
  playback.is_live = false;
  playback.seek(20.07);
  bar.setFrames(1678);
  bar.showPlayback(playback, 1204);
  EXPECT_FALSE(is_live_offered());
  EXPECT_EQ(bar.stateText(), "PARKED") << "behind nothing";
  const auto labels = bar.findChildren<TabularLabel*>();
  EXPECT_TRUE(std::any_of(labels.begin(), labels.end(),
                          [](const TabularLabel* label) { return label->text() == "frame 1204 of 1678"; }));
}

TEST(TransportBar, WritesTimeAsAskedFor) {
  TransportBar bar;
  bar.setRate(60);
  Playback playback;
  playback.extend(0, 35);
  playback.seek(11.5);
  bar.showPlayback(playback, 690);
  EXPECT_EQ(bar.timeText(), QString("00:11.500"));
  bar.setFormat(TimeFormat::Timecode);
  EXPECT_EQ(bar.timeText(), QString("00:00:11:30"));
  bar.setFormat(TimeFormat::Frames);
  EXPECT_EQ(bar.timeText(), QString("690"));
}

TEST(TransportBar, ShowsTheAchievedSpeedOnlyWhereItDiffers) {
  TransportBar bar;
  Playback playback;
  playback.extend(0, 35);
  playback.seek(5);
  playback.play();
  playback.every_frame = true;
  bar.showPlayback(playback, 10);
  EXPECT_EQ(bar.speedText(), QString("1.00× every frame"));
  bar.showAchieved(0.48);
  EXPECT_EQ(bar.speedText(), QString("1.00× (is 0.48) every frame"));
  bar.showAchieved(0.99);
  EXPECT_EQ(bar.speedText(), QString("1.00× every frame"));
}

TEST(TransportBar, DoubleClickOnTheTimeAsksWhereToGo) {
  TransportBar bar;
  bar.resize(1000, 40);
  bar.show();
  QSignalSpy asked(&bar, &TransportBar::placeEntryRequested);
  for (QWidget* child : bar.findChildren<QWidget*>())
    if (child->accessibleName() == "Time") QTest::mouseDClick(child, Qt::LeftButton);
  EXPECT_EQ(asked.size(), 1);
}

TEST(QuickEntry, TakesAValueOrSaysWhatIsWrongAndStays) {
  QWidget window;
  window.resize(600, 300);
  window.show();
  QString taken;
  auto* entry = QuickEntry::open(window, {100, 250}, "Number", "1", [&taken](const QString& text) -> QString {
    if (text == "x") return "x is not a number";
    taken = text;
    return {};
  });
  auto* field = entry->findChild<QLineEdit*>();
  EXPECT_EQ(field->accessibleName(), QString("Number"));
  field->setText("x");
  QTest::keyClick(field, Qt::Key_Return);
  EXPECT_EQ(entry->complaint(), QString("x is not a number"));
  EXPECT_TRUE(entry->isVisible());
  field->setText("7");
  QTest::keyClick(field, Qt::Key_Return);
  EXPECT_EQ(taken, QString("7"));
  EXPECT_FALSE(entry->isVisible());
}

TEST(QuickEntry, EscapeTakesNothing) {
  QWidget window;
  window.resize(600, 300);
  window.show();
  bool taken = false;
  auto* entry = QuickEntry::open(window, {100, 250}, "Number", "1", [&taken](const QString&) {
    taken = true;
    return QString();
  });
  QTest::keyClick(entry->findChild<QLineEdit*>(), Qt::Key_Escape);
  EXPECT_FALSE(taken);
  EXPECT_FALSE(entry->isVisible());
}

}  // namespace
}  // namespace abrazo::widgets::transport_bar_test
