#include <QActionGroup>
#include <QMenu>

#include "app/workbench/shell/actions.hpp"
#include "app/workbench/shell/main_window.hpp"
#include "widgets/common/message_bar.hpp"
#include "widgets/timeline/timeline_view.hpp"
#include "widgets/timeline/transport_bar.hpp"

namespace abrazo::app {
namespace {

QString words_of(RoleControl by) {
  switch (by) {
    case RoleControl::Hand:
      return {};
    case RoleControl::Library:
      return "by the library";
    case RoleControl::Leader:
      return "by who leads";
  }
  return {};
}

/// Role of the newest frame, and the role control.
void show_role(MainWindow& window, const FrameSnapshot& frame) {
  if (window.session()->looksElsewhere()) return;  // a take has no user
  const RoleControl by = frame.decisions ? frame.decisions->role_control : RoleControl::Hand;
  window.transport().showRole(frame.settings.user_role == UserRole::Active, words_of(by));
}

/// To the other role than the newest frame's; from then on the hand decides.
void exchange(MainWindow& window) {
  if (!window.session()) return window.messages().showInformation("Nothing is open yet");
  Document& document = window.document();
  const FrameSnapshotPtr newest = window.session()->engine().latest().newest();
  const UserRole now =
      newest && !document.triesOther() ? newest->settings.user_role : document.settings().user_role;
  if (document.decisions().role_control != RoleControl::Hand) document.controlRole(RoleControl::Hand);
  const UserRole wanted = now == UserRole::Passive ? UserRole::Active : UserRole::Passive;
  if (wanted == document.settings().user_role)
    document.putSettings(document.settings());  // as it was asked for already; something else decided
  else
    document.changeSetting("user-role", wanted == UserRole::Active ? "active" : "passive");
}

QAction* add_control(MainWindow& window, QMenu* menu, QActionGroup& group, const char* name, RoleControl by) {
  QAction* action = add_action(window, menu, name, {}, [&window, by] { window.document().controlRole(by); });
  action->setCheckable(true);
  group.addAction(action);
  const auto show = [&window, action, by] {
    action->setChecked(window.document().decisions().role_control == by);
  };
  // What is refused changes nothing, and the entry that was clicked is not the one that holds.
  QObject::connect(&window.document(), &Document::refused, action, show);
  QObject::connect(&window.document(), &Document::changed, action, [show](ProjectPart part) {
    if (part == ProjectPart::RoleControl) show();
  });
  show();
  return action;
}

}  // namespace

void add_role_actions(MainWindow& window) {
  QMenu* menu = menu_of(window, "Live");
  auto* at_the_role = new QMenu(&window);
  at_the_role->addAction(add_action(window, menu, "Switch the user's role", {QKeySequence("U")},
                                    [&window] { exchange(window); }));
  at_the_role->addSeparator();
  auto* group = new QActionGroup(&window);
  const std::pair<const char*, RoleControl> ways[] = {
      {"Role by hand", RoleControl::Hand},
      {"Role from the library's annotation", RoleControl::Library},
      {"Role by who leads", RoleControl::Leader}};
  for (const auto& [name, by] : ways) at_the_role->addAction(add_control(window, menu, *group, name, by));
  window.transport().setRoleMenu(at_the_role);
  menu->addSeparator();
  QObject::connect(&window.ticker(), &FrameTicker::frameReady, &window,
                   [&window](const FrameSnapshotPtr& frame) { show_role(window, *frame); });
  // The next library may lack annotations of who leads.
  QObject::connect(&window.document(), &Document::began, &window, [&window] {
    if (!window.document().controlRole(window.document().decisions().role_control))
      window.document().controlRole(RoleControl::Hand);
  });
}

}  // namespace abrazo::app
