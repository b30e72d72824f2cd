#pragma once

#include <QString>
#include <array>
#include <optional>

#include "widgets/common/value_range.hpp"
#include "widgets/scene/values/mesh_scalar.hpp"
#include "widgets/scene/values/scene_options.hpp"
#include "widgets/scene/values/scene_parts.hpp"

namespace abrazo::widgets {

/// Ends of a colour range that a person set or locked.
struct KeptRange {
  double lower = 0, upper = 0;
  bool operator==(const KeptRange&) const = default;
};

/// A colour range of the scene with all that it adapts by.
struct LegendRange {
  std::optional<MeshScalar> scalar;  ///< none: of the tetrahedra's volume ratios
  SteadyRange range;
};

/// The setup of the scene as text keeps it; without selection, isolation and cutting planes, because whoever
/// opens a session wants to see all of it.
struct SceneMemory {
  PartVisibility visibility = default_visibility;
  MeshScalar scalar = MeshScalar::Residual;
  SceneOptions options;
  std::array<std::optional<KeptRange>, mesh_scalar_count> ranges = {};  ///< of the legend; none: it adapts
};

/// What stays when another session begins: how the scene is drawn. Shown parts, characters, isolation,
/// cutting plane and ranges of the legend belong to a session and are as usual.
SceneMemory without_session(SceneMemory memory);
/// One JSON object, by name.
QString text_of(const SceneMemory& memory);
/// Unknown (of another version) or out-of-range values get their defaults.
SceneMemory scene_memory_of(const QString& text);

}  // namespace abrazo::widgets
