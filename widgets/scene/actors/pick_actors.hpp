#pragma once

#include "widgets/common/palette.hpp"
#include "widgets/common/selection.hpp"
#include "widgets/scene/actors/line_set.hpp"

namespace abrazo::widgets {

/// Marks what is selected and what the pointer is on, over everything else.
class PickActors {
 public:
  PickActors();
  /// @param in_front  for the rims: in one layer they would fight with their lines for the same pixels
  void addTo(vtkRenderer* in_front, vtkRenderer* topmost);
  void setColours(const Palette& palette, double pixel_ratio);
  /// Where an item is marked.
  struct Place {
    const PairPose& pair;
    std::span<const double> corners;   ///< of the cell as it is drawn, 12 numbers; empty for anything else
    const PairPose* second = nullptr;  ///< where the same mesh stands a second time
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
