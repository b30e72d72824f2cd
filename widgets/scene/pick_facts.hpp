#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/session/frame_snapshot.hpp"
#include "widgets/scene/mesh_cells.hpp"
#include "widgets/scene/scene_pick.hpp"

namespace abrazo::widgets {

struct JointFacts {
  Vec3 position = Vec3::Zero();     ///< world [m]
  std::optional<double> to_user_m;  ///< from the same joint of the input; only for the user's character
  int nearest_partner = 0;          ///< vertex of the other body
  double to_partner_m = 0;
};
JointFacts joint_facts(const FrameSnapshot& frame, int vertex);

struct EdgeFacts {
  double length_m = 0, reference_m = 0;  ///< in the result, in the selected pair
  double weight = 0, residual_m = 0;
  double energy_share = 0;  ///< [%]
};
/// Nothing when the frame's mesh has no such edge.
std::optional<EdgeFacts> edge_facts(const FrameSnapshot& frame, const MeshEdge& edge);

/// Nothing when the frame's mesh has no such cell.
std::optional<CellVolume> cell_facts(const FrameSnapshot& frame, const PickedItem& cell);

/// Whether the frame has the item.
bool has_item(const FrameSnapshot& frame, const PickedItem& item);

/// "leader lhand"
std::string vertex_name(int vertex);

struct PickText {
  std::string title;
  std::vector<std::string> lines;
};
PickText describe(const FrameSnapshot& frame, const PickedItem& item);

}  // namespace abrazo::widgets
