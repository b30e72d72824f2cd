#pragma once

#include "widgets/common/palette.hpp"
#include "widgets/common/selection.hpp"
#include "widgets/scene/actors/line_set.hpp"

namespace abrazo::widgets {

/// Marks of the selected and the hovered item, over everything else.
class PickActors {
 public:
  PickActors();
  /// @param in_front for the rims: in one layer they would have z-fighting with their lines
  void addTo(vtkRenderer* in_front, vtkRenderer* topmost);
  void setColours(const Palette& palette, double pixel_ratio);
  /// Geometry of a marked item.
  struct Place {
    const PairPose& pair;
    std::span<const double> corners;   ///< of the drawn cell, 12 numbers; empty for other items
    const PairPose* second = nullptr;  ///< positions of the second copy of the mesh
  };
  void showSelected(const Selection& item, const Place& place) { m_selected.show(item, place); }
  void showHovered(const Selection& item, const Place& place) { m_hovered.show(item, place); }

 private:
  struct Mark {
    LineSet rim, lines, dots{LineSet::Kind::Dots};
    void show(const Selection& item, const Place& place);
  };
  Mark m_selected, m_hovered;
};

}  // namespace abrazo::widgets
