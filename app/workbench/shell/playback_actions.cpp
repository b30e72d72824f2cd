#include <QAction>
#include <QApplication>
#include <QKeyEvent>
#include <QMenu>

#include "app/workbench/shell/actions.hpp"
#include "app/workbench/shell/main_window.hpp"
#include "widgets/common/message_bar.hpp"
#include "widgets/scene/view/scene_view.hpp"
#include "widgets/timeline/timeline_view.hpp"
#include "widgets/timeline/transport_bar.hpp"

namespace abrazo::app {
namespace {

using widgets::TimelineView;
using widgets::TransportBar;

/// Whether a key is held down: J and L step single frames while K is. Only looks on.
class HeldKey : public QObject {
 public:
  HeldKey(int key, QObject* parent) : QObject(parent), m_key(key) { qApp->installEventFilter(this); }
  bool isDown() const { return m_down; }
  void press() { m_down = true; }

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override {
    if (event->type() == QEvent::ApplicationDeactivate) m_down = false;
    if (event->type() == QEvent::KeyRelease) {
      const auto* released = static_cast<QKeyEvent*>(event);
      if (released->key() == m_key && !released->isAutoRepeat()) m_down = false;
    }
    return QObject::eventFilter(watched, event);
  }

 private:
  int m_key;
  bool m_down = false;
};

void add_shuttle(MainWindow& window, QMenu* menu) {
  FrameTicker& ticker = window.ticker();
  auto* held = new HeldKey(Qt::Key_K, &window);
  const auto shuttle = [&ticker, held](int direction) {
    held->isDown() ? ticker.step(direction) : ticker.shuttle(direction);
  };
  add_action(window, menu, "Play backward", {QKeySequence("J")}, [shuttle] { shuttle(-1); });
  add_action(window, menu, "Stop playing", {QKeySequence("K")}, [&ticker, held] {
    held->press();
    ticker.shuttle(0);
  });
  add_action(window, menu, "Play forward", {QKeySequence("L")}, [shuttle] { shuttle(1); });
}

void add_speed(MainWindow& window, QMenu* menu) {
  FrameTicker& ticker = window.ticker();
  add_action(window, menu, "Slower", {QKeySequence("[")}, [&ticker] { ticker.changeSpeed(-1); });
  add_action(window, menu, "Faster", {QKeySequence("]")}, [&ticker] { ticker.changeSpeed(1); });
  add_action(window, menu, "Normal speed", {QKeySequence("Backspace")}, [&ticker] { ticker.setSpeed(1); });
  QAction* every = add_action(window, menu, "Play every frame", {},
                              [&ticker] { ticker.setEveryFrame(!ticker.playback().every_frame); });
  every->setCheckable(true);
  widgets::SceneView& scene = window.scene();
  ticker.setPictures([&scene] { return scene.renderedFrames(); });
  QObject::connect(&ticker, &FrameTicker::playbackChanged, every,
                   [every](const Playback& playback) { every->setChecked(playback.every_frame); });
}

void add_range(MainWindow& window, QMenu* menu) {
  FrameTicker& ticker = window.ticker();
  add_action(window, menu, "Set in", {QKeySequence("I")}, [&ticker] { ticker.setIn(); });
  add_action(window, menu, "Set out", {QKeySequence("O")}, [&ticker] { ticker.setOut(); });
  add_action(window, menu, "Clear in", {QKeySequence("Alt+I")}, [&ticker] { ticker.clearIn(); });
  add_action(window, menu, "Clear out", {QKeySequence("Alt+O")}, [&ticker] { ticker.clearOut(); });
  QAction* loop = add_action(window, menu, "Loop", {QKeySequence("Ctrl+L")},
                             [&ticker] { ticker.setLoop(!ticker.playback().loop); });
  QAction* forth = add_action(window, menu, "Loop back and forth", {}, [&ticker] {
    const bool on = ticker.playback().repeat == Playback::Repeat::PingPong;
    ticker.setRepeat(on ? Playback::Repeat::Loop : Playback::Repeat::PingPong);
  });
  for (QAction* action : {loop, forth}) action->setCheckable(true);
  QObject::connect(&ticker, &FrameTicker::playbackChanged, loop, [loop, forth](const Playback& playback) {
    loop->setChecked(playback.loop);
    forth->setChecked(playback.repeat == Playback::Repeat::PingPong);
  });
}

/// What the window does not connect itself.
void connect_views(MainWindow& window) {
  FrameTicker& ticker = window.ticker();
  TransportBar& transport = window.transport();
  TimelineView& timeline = window.timeline();
  QObject::connect(&transport, &TransportBar::everyFrameRequested, &ticker, &FrameTicker::setEveryFrame);
  QObject::connect(&transport, &TransportBar::repeatRequested, &ticker, &FrameTicker::setRepeat);
  QObject::connect(&timeline, &TimelineView::rangeRequested, &ticker, &FrameTicker::setRange);
  QObject::connect(&timeline, &TimelineView::scrubbing, &ticker, &FrameTicker::setScrubbing);
  QObject::connect(&ticker, &FrameTicker::playbackChanged, &timeline, &TimelineView::showPlayback);
  QObject::connect(&ticker, &FrameTicker::nothingToPlay, &window, [&window] {
    window.messages().showInformation(
        "Nothing to play: no frame lies between in and out. Move in or out, or switch Loop off (Ctrl+L)");
  });
  QObject::connect(&ticker, &FrameTicker::playbackChanged, &transport,
                   [&] { transport.showAchieved(ticker.achievedSpeed()); });
}

}  // namespace

void add_playback_actions(MainWindow& window) {
  QMenu* menu = menu_of(window, "Play");
  FrameTicker& ticker = window.ticker();
  const auto add = [&](const QString& text, const char* key, std::function<void()> act) {
    add_action(window, menu, text, {QKeySequence(key)}, std::move(act));
  };
  add("Play or pause", "Space", [&ticker] { ticker.toggle(); });
  add("One frame back", "Left", [&ticker] { ticker.step(-1); });
  add("One frame forward", "Right", [&ticker] { ticker.step(1); });
  add("Ten frames back", "Shift+Left", [&ticker] { ticker.step(-10); });
  add("Ten frames forward", "Shift+Right", [&ticker] { ticker.step(10); });
  add("To the beginning", "Home", [&ticker] { ticker.goToStart(); });
  add("Follow the live end", "End", [&ticker] { ticker.follow(); });
  menu->addSeparator();
  add_shuttle(window, menu);
  menu->addSeparator();
  add_speed(window, menu);
  menu->addSeparator();
  add_range(window, menu);
  connect_views(window);
}

}  // namespace abrazo::app
