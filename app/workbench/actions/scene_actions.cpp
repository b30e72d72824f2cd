#include <QAction>
#include <QActionGroup>
#include <QMenu>

#include "app/workbench/actions/actions.hpp"
#include "app/workbench/main_window.hpp"
#include "widgets/scene/scene_view.hpp"

namespace abrazo::app {
namespace {

using widgets::NavigationStyle;
using widgets::SceneOptions;
using widgets::ScenePart;
using widgets::SceneView;

/// A tick that stands for something of the options and follows them.
void add_option(MainWindow& window, QMenu* menu, const QString& text, const char* key,
                bool SceneOptions::*option) {
  SceneView& scene = window.scene();
  QAction* action = add_action(window, menu, text, {QKeySequence(key)}, [] {});
  action->setCheckable(true);
  QObject::connect(action, &QAction::toggled, &scene, [&scene, option](bool on) {
    SceneOptions options = scene.options();
    options.*option = on;
    scene.setOptions(options);
  });
  QObject::connect(&scene, &SceneView::optionsChanged, action,
                   [action, option](const SceneOptions& options) { action->setChecked(options.*option); });
}

void add_part(MainWindow& window, QMenu* menu, const QString& text, const char* key, ScenePart part) {
  SceneView& scene = window.scene();
  const auto place = static_cast<std::size_t>(part);
  QAction* action = add_action(window, menu, text, {QKeySequence(key)}, [] {});
  action->setCheckable(true);
  action->setChecked(scene.visibility()[place]);
  QObject::connect(action, &QAction::toggled, &scene, [&scene, place](bool on) {
    widgets::PartVisibility visible = scene.visibility();
    visible[place] = on;
    scene.setVisibility(visible);
  });
  QObject::connect(
      &scene, &SceneView::visibilityChanged, action,
      [action, place](const widgets::PartVisibility& visible) { action->setChecked(visible[place]); });
}

void add_navigation(MainWindow& window, QMenu* menu) {
  QMenu* styles = menu->addMenu("Mouse as in");
  auto* group = new QActionGroup(styles);
  const auto add = [&](const QString& name, NavigationStyle style) {
    QAction* action = styles->addAction(name);
    action->setCheckable(true);
    action->setChecked(style == window.scene().options().navigation);
    group->addAction(action);
    QObject::connect(action, &QAction::triggered, &window, [&window, style] {
      SceneOptions options = window.scene().options();
      options.navigation = style;
      window.scene().setOptions(options);
    });
  };
  add("Abrazo", NavigationStyle::Abrazo);
  add("Blender", NavigationStyle::Blender);
  add("Maya", NavigationStyle::Maya);
  add("VTK", NavigationStyle::Vtk);
}

}  // namespace

void add_scene_actions(MainWindow& window) {
  QMenu* menu = window.menu("View");
  SceneView& scene = window.scene();
  menu->addSeparator();
  add_option(window, menu, "Parallel projection", "5", &SceneOptions::is_parallel);
  add_option(window, menu, "Cut away the front", "C", &SceneOptions::cuts);
  add_part(window, menu, "Tetrahedra", "T", ScenePart::Tetrahedra);
  add_option(window, menu, "Only at the selected joint", "X", &SceneOptions::picked_joint_only);
  QAction* nothing =
      add_action(window, menu, "Select nothing", {QKeySequence("Esc")}, [&scene] { scene.select({}); });
  // Only where the scene has the keyboard: fields and lists have an Escape of their own.
  nothing->setShortcutContext(Qt::WidgetWithChildrenShortcut);
  window.removeAction(nothing);
  scene.addAction(nothing);
  add_navigation(window, menu);
}

}  // namespace abrazo::app
