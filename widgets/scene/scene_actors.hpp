#pragma once

#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "core/session/frame_snapshot.hpp"
#include "widgets/common/palette.hpp"
#include "widgets/common/value_range.hpp"
#include "widgets/scene/body_actor.hpp"
#include "widgets/scene/floor_actor.hpp"
#include "widgets/scene/line_set.hpp"
#include "widgets/scene/mesh_scalar.hpp"
#include "widgets/scene/scene_parts.hpp"

namespace abrazo::widgets {

/// Everything that stands in the scene. Shows what it is given; knows no window and no camera.
class SceneActors {
 public:
  SceneActors();

  /// @param solid    bodies, lines and floor with depth
  /// @param in_front what must be seen through the bodies
  /// @param topmost  the dots of the joints, over their rims
  void addTo(vtkRenderer* solid, vtkRenderer* in_front, vtkRenderer* topmost);
  /// @param pixel_ratio  device pixels per logical pixel: widths of lines are in logical ones
  void setColours(const Palette& palette, double pixel_ratio);
  void setRadii(const std::array<double, bone_count>& active, const std::array<double, bone_count>& passive);
  void setVisibility(const PartVisibility& visibility);

  void show(const FrameSnapshot& frame, const std::vector<double>& scalars, const SteadyRange& range,
            bool is_signed);
  /// The pair of a candidate under the pointer, world; nothing hides it.
  void showCandidate(const std::optional<PairPose>& pair);
  const PartCounts& counts() const { return m_counts; }

 private:
  void showMesh(const FrameResult& result, const std::vector<double>& scalars, double upper, bool is_signed);
  void rebuildEdges(const std::vector<MeshEdge>& edges);
  void showMorphSteps(const FrameResult& result);
  void showFootLocks(const FrameResult& result);
  void showContacts(const FrameResult& result);
  void showShadows(const FrameResult& result);

  Palette m_palette;
  PartVisibility m_visibility = default_visibility;
  PartCounts m_counts{};
  std::vector<MeshEdge> m_edges;
  std::vector<std::size_t> m_between;  ///< which of them join the two bodies
  bool m_hasCandidate = false;

  FloorActor m_floor;
  BodyActor m_leader, m_follower;
  LineSet m_user;
  std::array<LineSet, 2> m_selected, m_candidate, m_bones;
  LineSet m_between_lines, m_between_strong, m_between_through, m_within;
  LineSet m_morph, m_locks;
  LineSet m_contacts, m_joint_rims, m_joints;
};

}  // namespace abrazo::widgets
