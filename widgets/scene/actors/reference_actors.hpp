#pragma once

#include "widgets/common/palette.hpp"
#include "widgets/scene/actors/mesh_actors.hpp"

namespace abrazo::widgets {

/// The selected pair's mesh beside the edited one, with the same edge colours.
class ReferenceActors {
 public:
  ReferenceActors();
  void addTo(vtkRenderer* solid, vtkRenderer* in_front);
  void setColours(const Palette& palette, double pixel_ratio);
  void setVisible(bool visible, bool between, bool within);
  /// @param mesh the shown edited mesh
  void show(const FrameResult& frame, const MeshActors& mesh, const Vec3& offset);

 private:
  std::array<LineSet, 2> m_bodies;
  LineSet m_between, m_within, m_joints{LineSet::Kind::Dots};
};

}  // namespace abrazo::widgets
