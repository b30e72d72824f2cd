#pragma once

#include "widgets/common/palette.hpp"
#include "widgets/scene/actors/limb_actor.hpp"
#include "widgets/scene/actors/line_set.hpp"
#include "widgets/scene/values/contact_shapes.hpp"

namespace abrazo::widgets {

/// Limbs that overlap, with the line between the nearest points of their axes; hands that hold one another;
/// feet that stand on the floor.
class ContactActors {
 public:
  ContactActors();
  void addTo(vtkRenderer* in_front, vtkRenderer* topmost);
  void setColours(const Palette& palette, double pixel_ratio);
  void setRadii(const CapsuleRadii& active, const CapsuleRadii& passive);
  void setVisible(bool collisions, bool touches);
  /// @param girths  of both bodies, times the radii
  void show(const FrameResult& frame, const std::array<double, 2>& girths);
  /// Updates outlines, which are silhouettes and depend on the view direction.
  void outlineFor(const Vec3& direction);
  std::size_t touchCount() const { return m_touch_count; }

 private:
  void showTouches(const FrameResult& frame);

  struct Limb {
    Vec3 from, to;
    double radius_m;
  };
  Palette m_palette;
  bool m_visible = true;
  std::array<CapsuleRadii, 2> m_radii{};
  std::vector<Limb> m_limbs;
  std::array<LimbActor, 2> m_bodies;
  LineSet m_outlines, m_lines, m_dots{LineSet::Kind::Dots};
  LineSet m_holds, m_touches{LineSet::Kind::Dots};
  std::size_t m_touch_count = 0;
};

}  // namespace abrazo::widgets
