#pragma once

#include <array>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "core/mesh/capsules.hpp"
#include "core/session/frames/frame_snapshot.hpp"
#include "widgets/common/palette.hpp"
#include "widgets/scene/actors/body_actor.hpp"
#include "widgets/scene/actors/contact_actors.hpp"
#include "widgets/scene/actors/cut_actors.hpp"
#include "widgets/scene/actors/floor_actor.hpp"
#include "widgets/scene/actors/joint_trails.hpp"
#include "widgets/scene/actors/line_set.hpp"
#include "widgets/scene/actors/mesh_actors.hpp"
#include "widgets/scene/actors/reference_actors.hpp"
#include "widgets/scene/values/scene_parts.hpp"

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
  void setRadii(const CapsuleRadii& active, const CapsuleRadii& passive);
  void setVisibility(const PartVisibility& visibility);

  void show(const FrameSnapshot& frame, const MeshLook& look);
  /// Before each picture: what is translucent must be drawn from the back to the front.
  void sortFor(const Vec3& eye, const Vec3& direction);
  const MeshActors& mesh() const { return m_mesh; }
  /// Whose trails are drawn, vertices of the pair.
  void setTrailJoints(const std::vector<int>& vertices) { m_trail_joints = vertices; }
  JointTrails& trails() { return m_trails; }
  void showTrails();
  /// The partner's next moments, the first as it is shown; empty for none. @see look_ahead
  /// @param first_vertex  of the partner in the pair
  void showAhead(std::span<const Pose> poses, int first_vertex);
  /// The selected pair's own mesh a second time, moved by an offset; zero for not at all.
  void setReferenceOffset(const Vec3& offset);
  void showReference(const FrameResult& result) { m_reference.show(result, m_mesh, m_reference_offset); }
  void showCut(const std::optional<CutPlane>& plane) { m_cut.show(plane); }
  /// The pair of a candidate under the pointer, world; nothing hides it.
  void showCandidate(const std::optional<PairPose>& pair);
  const PartCounts& counts() const { return m_counts; }

 private:
  void showMorphSteps(const FrameResult& result);
  void showFootLocks(const FrameResult& result);
  void showShadows(const FrameResult& result);
  void drawTrails(const JointTrails::Lines& trails, LineSet& lines, double strength);

  Palette m_palette;
  PartVisibility m_visibility = default_visibility;
  PartCounts m_counts{};
  bool m_hasCandidate = false;

  FloorActor m_floor;
  BodyActor m_leader, m_follower;
  LineSet m_user;
  std::array<LineSet, 2> m_selected, m_candidate, m_bones;
  MeshActors m_mesh;
  LineSet m_morph, m_locks, m_trail_lines, m_ahead_lines;
  JointTrails m_trails;
  std::vector<int> m_trail_joints;
  LineSet m_joint_rims, m_joints;
  ContactActors m_contacts;
  ReferenceActors m_reference;
  Vec3 m_reference_offset = Vec3::Zero();
  CutFrame m_cut;
};

}  // namespace abrazo::widgets
