#include <QMenu>

#include "app/workbench/actions/actions.hpp"
#include "app/workbench/main_window.hpp"

namespace abrazo::app {

void add_playback_actions(MainWindow& window) {
  QMenu* menu = window.menu("Play");
  FrameTicker& ticker = window.ticker();
  const auto add = [&](const QString& text, const char* key, std::function<void()> act) {
    add_action(window, menu, text, {QKeySequence(key)}, std::move(act));
  };
  add("Play or pause", "Space", [&ticker] { ticker.toggle(); });
  add("One frame back", "Left", [&ticker] { ticker.step(-1); });
  add("One frame on", "Right", [&ticker] { ticker.step(1); });
  add("Ten frames back", "Shift+Left", [&ticker] { ticker.step(-10); });
  add("Ten frames on", "Shift+Right", [&ticker] { ticker.step(10); });
  add("To the beginning", "Home", [&ticker] { ticker.goToStart(); });
  add("Follow the live end", "End", [&ticker] { ticker.follow(); });
  menu->addSeparator();
  add("Shuttle back", "J", [&ticker] { ticker.shuttle(-1); });
  add("Shuttle stop", "K", [&ticker] { ticker.shuttle(0); });
  add("Shuttle on", "L", [&ticker] { ticker.shuttle(1); });
  add("Slower", "[", [&ticker] { ticker.setSpeed(ticker.playback().speed / 2); });
  add("Faster", "]", [&ticker] { ticker.setSpeed(ticker.playback().speed * 2); });
  add("Normal speed", "Backspace", [&ticker] { ticker.setSpeed(1); });
  menu->addSeparator();
  add("Set in", "I", [&ticker] { ticker.setIn(); });
  add("Set out", "O", [&ticker] { ticker.setOut(); });
  add("Clear in and out", "Alt+I", [&ticker] { ticker.clearRange(); });
  add("Loop", "Ctrl+L", [&ticker] { ticker.setLoop(!ticker.playback().loop); });
}

}  // namespace abrazo::app
