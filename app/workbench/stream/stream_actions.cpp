#include <QAction>
#include <QDockWidget>
#include <QMenu>

#include "app/workbench/shell/actions.hpp"
#include "app/workbench/shell/main_window.hpp"
#include "app/workbench/shell/panel_area.hpp"
#include "app/workbench/stream/latency_desk.hpp"
#include "app/workbench/stream/stream_desk.hpp"
#include "core/opening/material.hpp"
#include "widgets/stream/address_form.hpp"
#include "widgets/stream/connection_panel.hpp"
#include "widgets/stream/sink_list.hpp"

namespace abrazo::app {
namespace {

using widgets::ConnectionPanel;

void show_panel(MainWindow& window) {
  window.panels().want("connection", true);
  if (QDockWidget* dock = window.panels().panel("connection")) dock->raise();
}

/// The entries of a menu that lists URIs, rebuilt whenever it opens.
void list_uris(QMenu& menu, const QStringList& uris, const QString& none,
               const std::function<void(const QString&)>& chosen) {
  menu.clear();
  for (const QString& uri : uris)
    menu.addAction(QString(uri).replace('&', "&&"), &menu, [uri, chosen] { chosen(uri); });
  if (uris.isEmpty()) menu.addAction(none)->setEnabled(false);
}

void add_recent(MainWindow& window, QMenu* menu, StreamDesk& desk) {
  auto* recent = menu->addMenu("Recent connections");
  QObject::connect(recent, &QMenu::aboutToShow, recent, [&window, &desk, recent] {
    list_uris(*recent, desk.recent(), "Nothing has been connected yet", [&window, &desk](const QString& uri) {
      show_panel(window);
      desk.connectTo(uri);
    });
  });
}

void add_sinks(MainWindow& window, QMenu* menu, StreamDesk& desk, ConnectionPanel& panel) {
  add_action(window, menu, "Send partner to…", {}, [&window, &panel] {
    show_panel(window);
    panel.sinks().takeFocus();
  });
  auto* recent = menu->addMenu("Send partner to recent");
  QObject::connect(recent, &QMenu::aboutToShow, recent, [&window, &desk, recent] {
    list_uris(*recent, window.remembered().recentSinks(), "Nothing has been sent yet",
              [&desk](const QString& uri) { desk.send(uri, Character::Partner); });
  });
}

/// The clip in a loop in real time, as if it were performed: for rehearsing, and for receivers.
void add_play_as_live(MainWindow& window, QMenu* menu) {
  QAction* play = add_action(window, menu, "Play the clip as live", {}, [] {});
  play->setCheckable(true);
  QObject::connect(&window.document(), &Document::began, play,
                   [&window, play] { play->setChecked(window.playsAsLive()); });
  QObject::connect(play, &QAction::triggered, &window, [&window, play](bool on) {
    window.setPlaysAsLive(on);
    if (!window.session()) return;
    const bool leaves = window.openMaterial([next = fresh_session(window.session()->material())](
                                                const Progress&) { return Result<Material>(next); });
    if (leaves) return;
    window.setPlaysAsLive(!on);
    play->setChecked(!on);
  });
}

/// After a stream: the clip that was open before it.
QAction* add_back_to_clip(MainWindow& window, QMenu* menu) {
  QAction* back = add_action(window, menu, "Back to the clip", {}, [&window] {
    window.openMaterial([next = fresh_session(window.session()->material())](const Progress&) {
      return Result<Material>(next);
    });
  });
  back->setEnabled(false);
  return back;
}

/// A stream continues, and the view is parked; a clip, which has no other end, is paused.
void freeze(MainWindow& window, const StreamDesk& desk) {
  if (desk.isConnected()) {
    const bool follows = window.ticker().playback().state == Playback::State::Following;
    return follows ? window.ticker().pause() : window.ticker().follow();
  }
  if (QAction* hold = action_of(window, "solve.hold_the_input_still")) hold->trigger();
}

}  // namespace

void send_partner_to(MainWindow& window, StreamDesk& desk, const QString& uri) {
  if (window.session()) return desk.send(uri, Character::Partner);
  const auto once = std::make_shared<QMetaObject::Connection>();
  *once = QObject::connect(&window.document(), &Document::began, &desk, [&desk, uri, once] {
    QObject::disconnect(*once);
    desk.send(uri, Character::Partner);
  });
}

StreamDesk& add_stream_actions(MainWindow& window) {
  auto* panel = new ConnectionPanel;
  window.colour(panel);
  window.addPanel("connection", "Connection", panel, Qt::RightDockWidgetArea, false);
  auto* desk = new StreamDesk(window, *panel);
  new LatencyDesk(window, *desk);

  QMenu* menu = menu_of(window, "Live");
  add_action(window, menu, "Connect to a stream…", {QKeySequence("Ctrl+K")}, [&window, panel] {
    show_panel(window);
    panel->form().takeFocus();
  });
  add_recent(window, menu, *desk);
  QAction* end = add_action(window, menu, "Disconnect", {}, [desk] { desk->disconnectStream(); });
  QAction* back = add_back_to_clip(window, menu);
  add_play_as_live(window, menu);
  menu->addSeparator();
  QAction* calibrate = add_action(window, menu, "Calibrate in T-pose", {QKeySequence("Ctrl+T")},
                                  [desk] { desk->calibrate(); });
  QAction* forget =
      add_action(window, menu, "Forget the calibration", {}, [desk] { desk->forgetCalibration(); });
  menu->addSeparator();
  add_sinks(window, menu, *desk, *panel);
  menu->addSeparator();
  QAction* still = add_action(window, menu, "Freeze the input", {QKeySequence("Ctrl+Space")},
                              [&window, desk] { freeze(window, *desk); });
  QAction* hold = action_of(window, "solve.hold_the_input_still");
  const auto enable = [=, &window] {
    const bool connected = desk->isConnected();
    for (QAction* action : {end, calibrate, forget}) action->setEnabled(connected);
    still->setText(connected ? "Park the view or follow; the stream goes on" : "Freeze the input");
    back->setEnabled(!connected && window.session() && window.session()->material().use == InputUse::Stream);
    // A performer cannot be held, and a clip is not going on.
    const bool is_as_live = window.session() && window.session()->material().use == InputUse::ClipAsLive;
    if (hold) hold->setEnabled(!connected && is_as_live);
    still->setEnabled(connected || is_as_live);
  };
  enable();
  QObject::connect(desk, &StreamDesk::connectionChanged, end, enable);
  QObject::connect(&window.document(), &Document::began, end, enable);
  return *desk;
}

}  // namespace abrazo::app
