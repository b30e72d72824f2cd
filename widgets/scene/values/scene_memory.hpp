#pragma once

#include <QString>
#include <array>
#include <optional>

#include "widgets/scene/values/mesh_scalar.hpp"
#include "widgets/scene/values/scene_options.hpp"
#include "widgets/scene/values/scene_parts.hpp"

namespace abrazo::widgets {

/// Ends of a colour range that a person set or locked.
struct KeptRange {
  double lower = 0, upper = 0;
  bool operator==(const KeptRange&) const = default;
};

/// The scene settings remembered between two starts; without selection, isolation and cutting planes, because
/// a start shows everything.
struct SceneMemory {
  PartVisibility visibility = default_visibility;
  MeshScalar scalar = MeshScalar::Residual;
  SceneOptions options;
  std::array<std::optional<KeptRange>, mesh_scalar_count> ranges = {};  ///< of the legend; none: it adapts
};

/// One JSON object, by name.
QString text_of(const SceneMemory& memory);
/// Unknown (of another version) or out-of-range values get their defaults.
SceneMemory scene_memory_of(const QString& text);

}  // namespace abrazo::widgets
