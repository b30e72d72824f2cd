#include <QAction>
#include <QMainWindow>
#include <QMenu>

#include "app/workbench/shell/actions.hpp"
#include "widgets/scene/view/scene_view.hpp"

namespace abrazo::app {
namespace {

constexpr double quarter = 1.5707963267948966;
constexpr double eye_level = 0.05, isometric = 0.6154797086703873;  // elevations; atan(1 / sqrt 2)

struct Preset {
  const char* name;
  const char* key;
  double azimuth_rad, elevation_rad;
};

constexpr Preset presets[] = {
    {"From the front", "1", 0, eye_level},
    {"From behind", "Ctrl+1", 2 * quarter, eye_level},
    {"From the right", "3", quarter, eye_level},
    {"From the left", "Ctrl+3", -quarter, eye_level},
    {"From above", "7", 0, quarter},
    {"From below", "Ctrl+7", 0, -quarter},
    {"From the corner", "9", quarter / 2, isometric},
    {"From the opposite corner", "Ctrl+9", -3 * quarter / 2, isometric},
};

}  // namespace

void add_camera_actions(QMainWindow& window, widgets::SceneView& scene) {
  QMenu* menu = menu_of(window, "View")->addMenu("Camera");
  add_action(window, menu, "Show the selection, or all", {QKeySequence("F")},
             [&scene] { scene.frameSelection(); });
  add_action(window, menu, "Show all", {}, [&scene] { scene.frameAll(); });
  add_action(window, menu, "Default view", {QKeySequence("0")}, [&scene] { scene.resetView(); });
  for (const Preset& preset : presets)
    add_action(window, menu, preset.name, {QKeySequence(preset.key)},
               [&scene, preset] { scene.lookFrom(preset.azimuth_rad, preset.elevation_rad); });
  add_action(window, menu, "Previous view", {QKeySequence("Alt+Z")}, [&scene] { scene.previousView(); });
  add_action(window, menu, "Next view", {QKeySequence("Alt+Shift+Z")}, [&scene] { scene.nextView(); });
  menu->addSeparator();
  QAction* follow = add_action(window, menu, "Camera follows the pair", {}, [] {});
  follow->setCheckable(true);
  follow->setChecked(true);
  QObject::connect(follow, &QAction::toggled, &scene, &widgets::SceneView::setFollowing);
}

}  // namespace abrazo::app
