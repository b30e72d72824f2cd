#pragma once

#include <QString>

#include "widgets/scene/values/mesh_scalar.hpp"
#include "widgets/scene/values/scene_options.hpp"
#include "widgets/scene/values/scene_parts.hpp"

namespace abrazo::widgets {

/// How a person has set up the scene: what is remembered between two starts. Not what was selected, isolated
/// or cut: a start shows everything.
struct SceneMemory {
  PartVisibility visibility = default_visibility;
  MeshScalar scalar = MeshScalar::Residual;
  SceneOptions options;
};

/// One JSON object, by name.
QString text_of(const SceneMemory& memory);
/// What is not known (of another version) or out of range is as usual.
SceneMemory scene_memory_of(const QString& text);

}  // namespace abrazo::widgets
