#include <QAction>
#include <QActionGroup>
#include <QMainWindow>
#include <QMenu>
#include <QTimer>

#include "app/workbench/base/user_settings.hpp"
#include "app/workbench/shell/actions.hpp"
#include "widgets/scene/values/scene_memory.hpp"
#include "widgets/scene/values/scene_tree_rows.hpp"
#include "widgets/scene/view/scene_view.hpp"

namespace abrazo::app {
namespace {

using widgets::NavigationStyle;
using widgets::SceneOptions;
using widgets::ScenePart;
using widgets::SceneView;

/// A checkable action bound to a scene option.
void add_option(QMainWindow& window, SceneView& scene, QMenu* menu, const QString& text, const char* key,
                bool SceneOptions::*option) {
  QAction* action = add_action(window, menu, text, {QKeySequence(key)}, [] {});
  action->setCheckable(true);
  QObject::connect(action, &QAction::toggled, &scene, [&scene, option](bool on) {
    SceneOptions options = scene.options();
    options.*option = on;
    scene.edit(options);
  });
  QObject::connect(&scene, &SceneView::optionsChanged, action,
                   [action, option](const SceneOptions& options) { action->setChecked(options.*option); });
}

void add_part(QMainWindow& window, SceneView& scene, QMenu* menu, const QString& text, const char* key,
              ScenePart part) {
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

void add_navigation(QMainWindow& window, SceneView& scene, QMenu* menu) {
  QMenu* styles = menu->addMenu("Mouse as in");
  auto* group = new QActionGroup(styles);
  const auto add = [&](const QString& name, NavigationStyle style) {
    QAction* action = add_action(window, styles, "Mouse as in " + name, {}, [&scene, style] {
      SceneOptions options = scene.options();
      options.navigation = style;
      scene.setOptions(options);
    });
    action->setCheckable(true);
    action->setChecked(style == scene.options().navigation);
    group->addAction(action);
    QObject::connect(
        &scene, &SceneView::optionsChanged, action,
        [action, style](const SceneOptions& options) { action->setChecked(options.navigation == style); });
  };
  add("Abrazo", NavigationStyle::Abrazo);
  add("Blender", NavigationStyle::Blender);
  add("Maya", NavigationStyle::Maya);
  add("VTK", NavigationStyle::Vtk);
}

/// Alt+1 to Alt+9: the rows of the scene tree, groups included.
void add_rows(QMainWindow& window, SceneView& scene, QMenu* menu) {
  QMenu* rows = menu->addMenu("Show or hide");
  for (std::size_t r = 0; r < widgets::rows_with_keys; ++r) {
    const widgets::TreeRow& row = widgets::part_rows()[r];
    add_action(window, rows, "Show or hide " + QString::fromStdString(row.name).toLower(),
               {QKeySequence(QString("Alt+%1").arg(r + 1))},
               [&scene, &row] { scene.setVisibility(widgets::toggled(row, scene.visibility())); });
  }
}

void add_cut(QMainWindow& window, SceneView& scene, QMenu* menu) {
  constexpr double step_m = 0.05, step_rad = 0.08726646259971647;  // 5 cm, 5 degrees
  QMenu* cut = menu->addMenu("Cutting plane");
  add_option(window, scene, cut, "Cut", "C", &SceneOptions::cuts);
  add_option(window, scene, cut, "Plane stays in the world", "Shift+C", &SceneOptions::cut_in_world);
  const auto add = [&](const char* text, const char* key, double by, double turn, double tilt) {
    add_action(window, cut, text, {QKeySequence(key)},
               [&scene, by, turn, tilt] { scene.moveCut(by, turn, tilt); });
  };
  add("Cut less", "Alt+PgUp", step_m, 0, 0);
  add("Cut more", "Alt+PgDown", -step_m, 0, 0);
  add("Turn the plane left", "Alt+Left", 0, -step_rad, 0);
  add("Turn the plane right", "Alt+Right", 0, step_rad, 0);
  add("Tilt the plane up", "Alt+Up", 0, 0, step_rad);
  add("Tilt the plane down", "Alt+Down", 0, 0, -step_rad);
}

void add_legend(QMainWindow& window, SceneView& scene, QMenu* menu) {
  QMenu* legend = menu->addMenu("Legend");
  add_action(window, legend, "Set the range of the legend…", {}, [&scene] { scene.askRange(); });
  const auto add = [&](const char* text, auto change) {
    add_action(window, legend, text, {}, [&scene, change] {
      SceneOptions options = scene.options();
      change(options);
      scene.setOptions(options);
    });
  };
  add("Colour map viridis", [](SceneOptions& options) { options.map = widgets::ColourMap::Viridis; });
  add("Colour map cividis", [](SceneOptions& options) { options.map = widgets::ColourMap::Cividis; });
  add("Logarithmic colours", [](SceneOptions& options) { options.is_logarithmic ^= true; });
}

/// Restores how the scene is drawn; changes are stored together shortly afterwards.
void remember(SceneView& scene, UserSettings& remembered) {
  constexpr int quiet_ms = 400;
  scene.setMemory(without_session(widgets::scene_memory_of(remembered.scene())));
  auto* quiet = new QTimer(&scene);
  quiet->setSingleShot(true);
  quiet->setInterval(quiet_ms);
  QObject::connect(quiet, &QTimer::timeout, &scene, [&remembered, &scene] {
    remembered.setScene(widgets::text_of(without_session(scene.memory())));
  });
  const auto changed = [quiet] { quiet->start(); };
  QObject::connect(&scene, &SceneView::visibilityChanged, quiet, changed);
  QObject::connect(&scene, &SceneView::scalarChanged, quiet, changed);
  QObject::connect(&scene, &SceneView::optionsChanged, quiet, changed);
}

}  // namespace

void add_scene_actions(QMainWindow& window, SceneView& scene, UserSettings& remembered, QUndoStack& undo) {
  QMenu* menu = menu_of(window, "View");
  menu->addSeparator();
  add_option(window, scene, menu, "Parallel projection", "5", &SceneOptions::is_parallel);
  add_part(window, scene, menu, "Tetrahedra", "T", ScenePart::Tetrahedra);
  add_option(window, scene, menu, "Reference beside", "R", &SceneOptions::shows_reference_beside);
  add_cut(window, scene, menu);
  keep_scene_edits(scene, undo);
  add_legend(window, scene, menu);
  add_action(window, menu, "Previous morph step", {QKeySequence(",")}, [&scene] { scene.stepMorph(-1); });
  add_action(window, menu, "Next morph step", {QKeySequence(".")}, [&scene] { scene.stepMorph(1); });
  add_rows(window, scene, menu);
  add_navigation(window, scene, menu);
  remember(scene, remembered);
}

}  // namespace abrazo::app
