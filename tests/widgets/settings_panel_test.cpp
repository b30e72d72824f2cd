#include "widgets/settings/settings_panel.hpp"

#include <gtest/gtest.h>

#include <QSignalSpy>
#include <QUndoStack>

namespace abrazo::widgets {
namespace {

struct Panel {
  QUndoStack undo;
  SettingsPanel panel{undo};
  std::vector<Settings> sent;
  QString mistake;
  Panel() {
    QObject::connect(&panel, &SettingsPanel::commandRequested, [this](const Command& command) {
      sent.push_back(std::get<SetSettings>(command).settings);
    });
    QObject::connect(&panel, &SettingsPanel::mistaken, [this](const QString& text) { mistake = text; });
  }
};

TEST(SettingsPanel, SendsTheWholeValueAtOnce) {
  Panel p;
  p.panel.change("alpha", "0.7");
  ASSERT_EQ(p.sent.size(), 1u);
  Settings wanted = preset("paper").value();
  wanted.alpha = 0.7;
  EXPECT_EQ(p.sent[0], wanted);
}

TEST(SettingsPanel, OneDragIsOneStepOfUndo) {
  Panel p;
  const Settings before = p.panel.settings();
  for (const char* value : {"0.6", "0.7", "0.8"}) p.panel.change("alpha", value, 1);
  EXPECT_EQ(p.undo.count(), 1);
  EXPECT_EQ(p.sent.size(), 3u) << "every move goes to the solver";
  p.undo.undo();
  EXPECT_EQ(p.panel.settings(), before);
  p.undo.redo();
  EXPECT_DOUBLE_EQ(p.panel.settings().alpha, 0.8);
}

TEST(SettingsPanel, TwoDragsAreTwoSteps) {
  Panel p;
  p.panel.change("alpha", "0.6", 1);
  p.panel.change("alpha", "0.7", 2);
  EXPECT_EQ(p.undo.count(), 2);
}

TEST(SettingsPanel, AnEntryThatCannotBeUsedChangesNothingAndSaysWhy) {
  Panel p;
  const Settings before = p.panel.settings();
  p.panel.change("alpha", "much");
  EXPECT_EQ(p.panel.settings(), before);
  EXPECT_TRUE(p.sent.empty());
  EXPECT_TRUE(p.mistake.contains("alpha")) << p.mistake.toStdString();
}

TEST(SettingsPanel, APresetCanBeUndone) {
  Panel p;
  p.panel.choosePreset("responsive");
  EXPECT_EQ(p.panel.settings(), preset("responsive").value());
  p.undo.undo();
  EXPECT_EQ(p.panel.settings(), preset("paper").value());
}

}  // namespace
}  // namespace abrazo::widgets
