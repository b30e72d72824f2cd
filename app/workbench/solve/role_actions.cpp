#include <QActionGroup>
#include <QMenu>

#include "app/workbench/shell/actions.hpp"
#include "app/workbench/shell/main_window.hpp"
#include "widgets/common/message_bar.hpp"
#include "widgets/settings/settings_panel.hpp"
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

/// Who decides about the user's role, and what of it is shown.
class RoleKeeper : public QObject {
 public:
  explicit RoleKeeper(MainWindow& window)
      : QObject(&window), m_window(window), m_group(new QActionGroup(this)) {
    connect(&window.ticker(), &FrameTicker::frameReady, this, [this](const FrameSnapshotPtr& frame) {
      if (m_window.session()->looksElsewhere()) return;  // a take has no user
      if (m_window.session()->roleControl() != m_by) adopt(m_window.session()->roleControl());
      show(frame->settings.user_role, frame->decisions ? frame->decisions->role_control : RoleControl::Hand);
    });
    connect(&window, &MainWindow::sessionStarted, this, [this] { control(m_by); });
  }

  QAction* add(QAction* action, RoleControl by) {
    action->setCheckable(true);
    action->setChecked(by == m_by);
    action->setData(static_cast<int>(by));
    return m_group->addAction(action);
  }

  void control(RoleControl by) {
    LiveSession* session = m_window.session();
    const Status done = session ? session->controlRole(by) : Status(Done{});
    if (!done) m_window.messages().showError(QString::fromStdString(done.error().text()));
    if (!done && by == m_by) control(RoleControl::Hand);  // another library, which does not say who leads
    adopt(done ? by : m_by);
  }

  /// To the other role than the newest frame's; from then on the hand decides.
  void exchange() {
    if (!m_window.session()) return m_window.messages().showInformation("Nothing is open yet");
    const FrameSnapshotPtr newest = m_window.session()->engine().latest().newest();
    const UserRole now = newest ? newest->settings.user_role : m_window.settings().settings().user_role;
    if (m_by != RoleControl::Hand) control(RoleControl::Hand);
    const bool becomes_active = now == UserRole::Passive;
    Settings next = m_window.settings().settings();
    next.user_role = becomes_active ? UserRole::Active : UserRole::Passive;
    if (next == m_window.settings().settings())
      m_window.session()->push(SetSettings{next});  // the panel had it already; something else decided
    else
      m_window.settings().change("user-role", becomes_active ? "active" : "passive");
    showLane();
  }

  void showLane() {
    widgets::TimelineLanes lanes = m_window.timeline().lanes();
    lanes.set_shown(widgets::TimelineLane::UserRole, true);
    m_window.timeline().setLanes(lanes);
  }

 private:
  /// What is so already, by a project that was opened, say.
  void adopt(RoleControl by) {
    m_by = by;
    for (QAction* action : m_group->actions())
      action->setChecked(action->data().toInt() == static_cast<int>(m_by));
  }

  void show(UserRole role, RoleControl by) {
    m_window.transport().showRole(role == UserRole::Active, words_of(by));
  }

  MainWindow& m_window;
  QActionGroup* m_group;
  RoleControl m_by = RoleControl::Hand;
};

}  // namespace

void add_role_actions(MainWindow& window) {
  auto* keeper = new RoleKeeper(window);
  QMenu* menu = window.menu("Live");
  auto* at_the_role = new QMenu(&window);
  at_the_role->addAction(add_action(window, menu, "Switch the user's role", {QKeySequence("U")},
                                    [keeper] { keeper->exchange(); }));
  at_the_role->addSeparator();
  const std::pair<const char*, RoleControl> ways[] = {
      {"Role by hand", RoleControl::Hand},
      {"Role from the library's annotation", RoleControl::Library},
      {"Role by who leads", RoleControl::Leader}};
  for (const auto& [name, by] : ways)
    at_the_role->addAction(keeper->add(add_action(window, menu, name, {},
                                                  [keeper, by = by] {
                                                    keeper->control(by);
                                                    if (by != RoleControl::Hand) keeper->showLane();
                                                  }),
                                       by));
  window.transport().setRoleMenu(at_the_role);
  menu->addSeparator();
}

}  // namespace abrazo::app
