// Which keys a focused control keeps, and that the keymap is whole and free of clashes.
#include "app/workbench/labels/annotation_desk.hpp"
#include "app/workbench/shell/panel_area.hpp"
#include "tests/workbench/key_window.hpp"
#include "widgets/common/value_slider.hpp"

namespace abrazo::app::key_routing_test {
namespace {

const ShortcutTable& table() {
  return window->findChild<Shortcuts*>()->table();
}

using Routing = KeyWindow;

TEST_F(Routing, SpacePlaysWhereverTheFocusIsButInAnEditor) {
  QPushButton button("a button", window);
  QTreeView list(window);
  for (QWidget* place : {static_cast<QWidget*>(&button), static_cast<QWidget*>(&list),
                         static_cast<QWidget*>(&window->timeline())}) {
    ticker().pause();
    place->show();
    place->setFocus();
    press(Qt::Key_Space);
    EXPECT_TRUE(until([] { return playback().state == State::Playing; })) << place->metaObject()->className();
  }
  QLineEdit text(window);
  QSpinBox number(window);
  QComboBox choice(window);
  choice.addItems({"one", "two"});
  for (QWidget* editor :
       {static_cast<QWidget*>(&text), static_cast<QWidget*>(&number), static_cast<QWidget*>(&choice)}) {
    ticker().pause();
    editor->show();
    editor->setFocus();
    press(Qt::Key_Space);
    turn();
    EXPECT_EQ(playback().state, State::Parked) << editor->metaObject()->className();
    choice.hidePopup();
  }
}

TEST_F(Routing, NoSingleKeyReachesAnActionWhileAnEditorHasTheFocus) {
  QLineEdit text(window);
  QDoubleSpinBox number(window);
  QComboBox choice(window);
  choice.addItems({"m", "t", "other"});
  const widgets::PartVisibility parts = scene().visibility();
  for (QWidget* editor :
       {static_cast<QWidget*>(&text), static_cast<QWidget*>(&number), static_cast<QWidget*>(&choice)}) {
    editor->show();
    editor->setFocus();
    for (const int key : {Qt::Key_M, Qt::Key_T, Qt::Key_5, Qt::Key_A, Qt::Key_P, Qt::Key_J, Qt::Key_Comma,
                          Qt::Key_BracketLeft, Qt::Key_Home, Qt::Key_QuoteLeft})
      press(key);
    turn();
    EXPECT_EQ(markers(), 0U) << editor->metaObject()->className();
    EXPECT_EQ(scene().visibility(), parts);
    EXPECT_FALSE(scene().options().is_parallel);
    EXPECT_FALSE(window->document().decisions().pinned);
    EXPECT_EQ(playback().state, State::Parked);
    EXPECT_EQ(playback().speed, 1);
    EXPECT_EQ(playback().cursor_s, 1.5);
    EXPECT_FALSE(selection());
  }
  EXPECT_TRUE(text.text().contains("mt5a")) << text.text().toStdString();
}

/// Ctrl+Z took back the text of a filter in place of the setting that was just changed.
TEST_F(Routing, UndoIsOfTheLastChangeWhereverThatWas) {
  const double usual = window->document().settings().alpha;
  QSpinBox number(window);
  number.show();
  number.setFocus();
  number.selectAll();
  QTest::keyClicks(&number, "12");
  window->document().changeSetting("alpha", "0.8", 0);
  press(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(window->document().settings().alpha, usual) << "it came after the number";
  EXPECT_EQ(number.value(), 12);
  QTest::keyClicks(&number, "3");
  window->undoStack().redo();
  QTest::keyClicks(&number, "4");
  press(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(window->document().settings().alpha, 0.8) << "the number came last";
  window->undoStack().undo();
  QLineEdit field(window);
  field.show();
  field.setFocus();
  QTest::keyClicks(&field, "turn");
  window->document().changeSetting("alpha", "0.9", 0);
  press(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(window->document().settings().alpha, usual) << "it came after the text";
  EXPECT_EQ(field.text(), "turn");
  press(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
  EXPECT_EQ(window->document().settings().alpha, 0.9);
  QTest::keyClicks(&field, "s");
  press(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_NE(field.text(), "turns") << "the text came last";
  EXPECT_EQ(window->document().settings().alpha, 0.9);
  window->undoStack().undo();
}

TEST_F(Routing, ASliderThatIsDraggedTakesTheKeysFromAFieldThatWasTypedInto) {
  QLineEdit field(window);
  field.show();
  field.setFocus();
  auto* slider = window->settings().findChild<widgets::ValueSlider*>();
  QTest::mouseClick(slider, Qt::LeftButton, {}, QPoint(slider->width() / 3, 8));
  EXPECT_FALSE(field.hasFocus());
  press(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_FALSE(window->undoStack().canUndo());
}

TEST_F(Routing, DigitsAreLabelsInATimelineThatHasTheFocusAndViewsInTheScene) {
  scene().lookFrom(1, 0.3);
  QTest::qWait(400);
  ticker().pause();
  const auto labels = [] {
    const AnnotationTier* moves = window->document().annotations().first_of(TierKind::Move);
    return moves ? moves->annotations : std::vector<Annotation>();
  };
  ASSERT_TRUE(labels().empty());
  window->timeline().setFocus();
  press(Qt::Key_3);
  EXPECT_TRUE(until([] { return window->messages().text().contains("has this key"); }));
  EXPECT_TRUE(looks_from(1, 0.3));
  EXPECT_TRUE(labels().empty());  // nothing is annotated yet
  window->panels().want("annotation", true);
  turn();
  window->timeline().setFocus();
  press(Qt::Key_3);
  EXPECT_TRUE(until([&] { return labels().size() == 1; }));
  EXPECT_TRUE(looks_from(1, 0.3));
  window->undoStack().undo();
  window->panels().want("annotation", false);
  focus_scene();
  press(Qt::Key_3);
  EXPECT_TRUE(until([] { return looks_from(quarter, 0.05); }));
}

TEST_F(Routing, ReturnPressesAButtonBecauseSpacePlays) {
  QPushButton button("a button", window);
  int pressed = 0;
  QObject::connect(&button, &QPushButton::clicked, &button, [&pressed] { ++pressed; });
  button.show();
  button.setFocus();
  press(Qt::Key_Return);
  press(Qt::Key_Space);
  EXPECT_EQ(pressed, 1);
}

using Keymap = KeyWindow;

TEST_F(Keymap, NoTwoActionsShareAKeyWhereBothWork) {
  EXPECT_GT(table().all().size(), 100U);
  for (const Shortcut& each : table().all())
    for (const std::string& key : each.keys)
      for (const Shortcut* other : table().clashes(each.id, key))
        EXPECT_TRUE(each.is_fixed || other->is_fixed)
            << key << " is that of '" << each.text << "' and of '" << other->text << "'";
}

TEST_F(Keymap, EveryActionHasAnIdOfItsOwnMadeOfItsPlaceInTheMenus) {
  EXPECT_TRUE(table().find("play.play_or_pause"));
  EXPECT_TRUE(table().find("edit.undo"));
  EXPECT_TRUE(table().find("view_selection.select_nothing"));
  std::set<std::string> ids;
  for (const Shortcut& each : table().all()) {
    EXPECT_TRUE(ids.insert(each.id).second) << each.id;
    EXPECT_NE(each.id.front(), '.') << each.text << " is in no menu";
  }
}

/// "[ ] Backspace", "Alt+1 to Alt+9", ", and .": the keys of a cell of the table.
std::vector<std::string> keys_of_cell(QString cell) {
  cell.replace("Page Up", "PgUp").replace("Page Down", "PgDown").replace("Escape", "Esc").replace("−", "-");
  cell.replace("Alt+arrows", "Alt+Left Alt+Right Alt+Up Alt+Down");
  cell.replace(" to Alt+9", " Alt+2 Alt+3 Alt+4 Alt+5 Alt+6 Alt+7 Alt+8 Alt+9");
  std::vector<std::string> keys;
  for (QString word : cell.split(' ', Qt::SkipEmptyParts)) {
    if (word == "and" || word == "or") continue;
    if (word.size() > 1 && word.endsWith(',') && !word.endsWith("+,")) word.chop(1);
    keys.push_back(Shortcuts::normal(word.toStdString()));
    EXPECT_FALSE(keys.back().empty()) << "'" << word.toStdString() << "' in the guide is no key";
  }
  return keys;
}

TEST_F(Keymap, EveryKeyOfTheGuideIsThatOfAnActionOrAView) {
  QFile guide(ABRAZO_GUIDE "/workbench/keys.md");
  ASSERT_TRUE(guide.open(QIODevice::ReadOnly));
  const QString text = QString::fromUtf8(guide.readAll());
  const QString section = text.section("\n## Keys\n", 1).section("\n## ", 0, 0);
  std::map<std::string, std::set<KeyPlace>> places;
  for (const Shortcut& each : table().all())
    for (const std::string& key : each.keys) places[key].insert(each.place);
  int rows = 0;
  for (const QString& line : section.split('\n')) {
    if (!line.startsWith("| ") || line.startsWith("| key |")) continue;
    ++rows;
    QString cell = line.section(" | ", 0, 0).mid(2);
    // The list's own and those of a vocabulary, tested with them.
    if (cell.contains("in the library") || cell.startsWith("1 to 9")) continue;
    for (const auto& [words, place] :
         {std::pair(", in the timeline", KeyPlace::Timeline), std::pair(", in the scene", KeyPlace::Scene)}) {
      if (!cell.contains(words)) continue;
      for (const std::string& key : keys_of_cell(cell.remove(words)))
        EXPECT_TRUE(places[key].contains(place)) << key << words;
      cell.clear();
    }
    for (const std::string& key : keys_of_cell(cell))
      EXPECT_TRUE(places[key].contains(KeyPlace::Window)) << key << " of the guide does nothing";
  }
  EXPECT_GT(rows, 40);
}

}  // namespace
}  // namespace abrazo::app::key_routing_test
