#pragma once

#include <QString>

#include "widgets/scene/values/mesh_scalar.hpp"
#include "widgets/scene/values/scene_options.hpp"
#include "widgets/scene/values/scene_parts.hpp"

namespace abrazo::widgets {

/// The scene settings remembered between two starts; without selection, isolation and cutting planes, because
/// a start shows everything.
struct SceneMemory {
  PartVisibility visibility = default_visibility;
  MeshScalar scalar = MeshScalar::Residual;
  SceneOptions options;
};

/// One JSON object, by name.
QString text_of(const SceneMemory& memory);
/// Unknown (of another version) or out-of-range values get their defaults.
SceneMemory scene_memory_of(const QString& text);

}  // namespace abrazo::widgets
