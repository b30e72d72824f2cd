#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/library/store/motion_library.hpp"
#include "core/session/frames/frame_snapshot.hpp"
#include "widgets/common/selection.hpp"
#include "widgets/scene/values/mesh_cells.hpp"

namespace abrazo::widgets {

struct JointFacts {
  Vec3 position = Vec3::Zero();     ///< world [m]
  double to_selected_m = 0;         ///< from the same joint of the selected pair
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
/// None if the frame's mesh has no such edge.
std::optional<EdgeFacts> edge_facts(const FrameSnapshot& frame, const MeshEdge& edge);

/// None if the frame's mesh has no such cell.
std::optional<CellVolume> cell_facts(const FrameSnapshot& frame, const Selection& cell);

/// Index of a pair among the candidates of the frame; none if it is not a candidate.
std::optional<std::size_t> candidate_of(const FrameSnapshot& frame, int pair);

/// Whether the frame has the item.
bool has_item(const FrameSnapshot& frame, const Selection& item);

struct PickText {
  std::string title;
  std::vector<std::string> lines;
};
/// @param library  names a candidate; may be null
PickText describe(const FrameSnapshot& frame, const Selection& item, const MotionLibrary* library = nullptr);

}  // namespace abrazo::widgets
