// One's own keys, from the dialog to the next start.
#include <QTextBrowser>

#include "tests/workbench/key_window.hpp"

namespace abrazo::app::shortcut_dialog_test {
namespace {

const ShortcutTable& table() {
  return window->findChild<Shortcuts*>()->table();
}

using Editing = KeyWindow;

ShortcutDialog* editor() {
  if (!window->findChild<ShortcutDialog*>())
    for (QAction* action : window->actions())
      if (action->text() == "Shortcuts…") action->trigger();
  return window->findChild<ShortcutDialog*>();
}

void click(const QString& beginning) {
  for (auto* button : editor()->findChildren<QPushButton*>())
    if (button->isVisible() && button->text().startsWith(beginning)) return button->click();
  ADD_FAILURE() << "no button " << beginning.toStdString();
}

TEST_F(Editing, AKeyThatSomebodyHasIsToldAtOnceTakenOverAndGivenBack) {
  ShortcutDialog* dialog = editor();
  ASSERT_TRUE(dialog);
  dialog->choose("timeline.marker");
  QTest::keyClick(dialog->findChild<KeyEntry*>(), Qt::Key_T);
  EXPECT_TRUE(dialog->verdict().contains("Tetrahedra")) << dialog->verdict().toStdString();
  EXPECT_TRUE(dialog->verdict().contains("View"));
  click("Take over");
  EXPECT_EQ(table().find("timeline.marker")->keys, (std::vector<std::string>{"M", "T"}));
  dialog->close();
  turn();
  window->activateWindow();
  press(Qt::Key_T);
  EXPECT_TRUE(until([] { return markers() == 1; }));
  EXPECT_FALSE(shows(ScenePart::Tetrahedra));
  dialog = editor();
  click("Default keys for all");
  dialog->close();
  turn();
  window->activateWindow();
  press(Qt::Key_T);
  EXPECT_TRUE(until([] { return shows(ScenePart::Tetrahedra); }));
}

TEST_F(Editing, AViewsOwnKeyIsToldWithItsPlace) {
  ShortcutDialog* dialog = editor();
  dialog->choose("timeline.marker");
  QTest::keyClick(dialog->findChild<KeyEntry*>(), Qt::Key_PageUp);
  EXPECT_TRUE(dialog->verdict().contains("in the timeline")) << dialog->verdict().toStdString();
  QTest::keyClick(dialog->findChild<KeyEntry*>(), Qt::Key_F7);
  EXPECT_TRUE(dialog->verdict().contains("free"));
  EXPECT_EQ(dialog->findChild<KeyEntry*>()->key(), "F7");
  QTest::keyClick(dialog->findChild<KeyEntry*>(), Qt::Key_Question, Qt::ShiftModifier);
  EXPECT_EQ(dialog->findChild<KeyEntry*>()->key(), "?") << "Shift only writes the sign";
  dialog->close();
}

TEST_F(Editing, KeysAreThereAgainInTheNextWindowAndWhatCannotBeUsedIsTold) {
  QFile file(window->remembered().folder() + "/shortcuts.json");
  ASSERT_TRUE(file.open(QIODevice::WriteOnly));
  file.write(R"({"abrazo_shortcuts": 1, "keys": {"timeline.marker": ["F7"], "play.loop": ["Nonsense"]}})");
  file.close();
  UserSettings settings;
  MainWindow next(settings);
  add_all_actions(next);
  const auto* kept = next.findChild<Shortcuts*>();
  EXPECT_EQ(kept->action("timeline.marker")->shortcut(), QKeySequence("F7"));
  EXPECT_EQ(kept->action("play.loop")->shortcut(), QKeySequence("Ctrl+L"));
  EXPECT_TRUE(next.messages().text().contains("Nonsense")) << next.messages().text().toStdString();
  QFile::remove(file.fileName());
}

TEST_F(Editing, TheKeySheetShowsTheKeysAsTheyAre) {
  auto* shortcuts = window->findChild<Shortcuts*>();
  ShortcutTable changed = shortcuts->table();
  changed.give("timeline.marker", "F7");
  shortcuts->change(changed);
  press(Qt::Key_Question);
  ASSERT_TRUE(until([] { return dialog("Keys") != nullptr; }));
  EXPECT_TRUE(dialog("Keys")->findChild<QTextBrowser*>()->toPlainText().contains("M, F7"));
  changed.reset_all();
  shortcuts->change(changed);
}

}  // namespace
}  // namespace abrazo::app::shortcut_dialog_test
