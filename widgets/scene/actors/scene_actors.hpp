#pragma once

#include <array>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "core/library/store/motion_library.hpp"
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
#include "widgets/scene/actors/skin_actor.hpp"
#include "widgets/scene/values/scene_parts.hpp"
#include "widgets/scene/values/worn_pair.hpp"

namespace abrazo::widgets {

/// All objects of the scene. Shows what it is given; independent of window and camera.
class SceneActors {
 public:
  SceneActors();

  /// @param solid    bodies, lines and floor with depth
  /// @param in_front objects visible through the bodies
  /// @param topmost  the dots of the joints, over their rims
  void addTo(vtkRenderer* solid, vtkRenderer* in_front, vtkRenderer* topmost);
  /// @param pixel_ratio device pixels per logical pixel: line widths are in logical pixels
  void setColours(const Palette& palette, double pixel_ratio);
  /// The bodies of the library, whose capsules the characters get. A character of another height gets thicker
  /// or thinner ones in proportion, as in the solver. Without a library the proportion is that to the
  /// recorded pair.
  void setBodies(const LibraryBody& active, const LibraryBody& passive);
  /// Skins instead of the capsules. @param stances  of the performers
  void setCharacters(const WornPair& characters, const std::array<Stance, 2>& stances);
  void setVisibility(const PartVisibility& visibility);

  void show(const FrameSnapshot& frame, const MeshLook& look);
  /// Call before each picture: translucent parts must be drawn back to front.
  void sortFor(const Vec3& eye, const Vec3& direction);
  const MeshActors& mesh() const { return m_mesh; }
  /// Vertices of the pair with trails.
  void setTrailJoints(const std::vector<int>& vertices) { m_trail_joints = vertices; }
  JointTrails& trails() { return m_trails; }
  void showTrails();
  /// The partner's next poses, the first is the shown one; empty = none. @see look_ahead
  /// @param first_vertex  of the partner in the pair
  void showAhead(std::span<const Pose> poses, int first_vertex);
  /// Shows the selected pair's mesh at an offset; zero = hidden.
  void setReferenceOffset(const Vec3& offset);
  void showReference(const FrameResult& result) { m_reference.show(result, m_mesh, m_reference_offset); }
  void showCut(const std::optional<CutPlane>& plane) { m_cut.show(plane); }
  /// The pair of the hovered candidate, world; always visible.
  void showCandidate(const std::optional<PairPose>& pair);
  const PartCounts& counts() const { return m_counts; }

 private:
  void placeOutOfSight();
  void showMorphSteps(const FrameResult& result);
  void showFootLocks(const FrameResult& result);
  void showShadows(const FrameResult& result);
  void setBodyVisible(std::size_t body, bool visible);
  double girthOf(std::size_t body, const Pose& shown, const Pose& recorded) const;
  void drawTrails(const JointTrails::Lines& trails, LineSet& lines, double strength);

  Palette m_palette;
  PartVisibility m_visibility = default_visibility;
  PartCounts m_counts{};
  bool m_hasCandidate = false;
  bool m_hasPose = false;  ///< of a frame

  FloorActor m_floor;
  BodyActor m_leader, m_follower;
  std::array<Body, 2> m_bodies;      ///< active, passive: those of the radii
  std::array<SkinActor, 2> m_skins;  ///< active, passive
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
