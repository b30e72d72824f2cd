#pragma once

#include <functional>
#include <memory>

#include "widgets/common/palette.hpp"
#include "widgets/scene/actors/comparison_ghost.hpp"
#include "widgets/scene/actors/pick_actors.hpp"
#include "widgets/scene/actors/scene_actors.hpp"
#include "widgets/scene/values/orbit_camera.hpp"

namespace abrazo::widgets {

class GlSurface;

/// The render window with layers, lights, objects and camera.
class SceneStage {
 public:
  explicit SceneStage(GlSurface& surface);
  ~SceneStage();
  SceneStage(const SceneStage&) = delete;
  SceneStage& operator=(const SceneStage&) = delete;

  void setColours(const Palette& palette, double pixel_ratio);
  /// @param smooth anti-aliasing; expensive with a software renderer
  /// @param shown  called when the picture is in the window, with the time it took [ms]
  void render(bool smooth, std::function<void(double took_ms)> shown);

  SceneActors actors;
  PickActors picks;
  ComparisonGhost ghosts;
  OrbitCamera camera;

 private:
  void applyCamera();

  struct Parts;
  std::unique_ptr<Parts> m_parts;
};

}  // namespace abrazo::widgets
