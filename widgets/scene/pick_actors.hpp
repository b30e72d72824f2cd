#pragma once

#include "widgets/common/palette.hpp"
#include "widgets/scene/line_set.hpp"
#include "widgets/scene/scene_pick.hpp"

namespace abrazo::widgets {

/// Marks what is selected and what the pointer is on, over everything else.
class PickActors {
 public:
  PickActors();
  void addTo(vtkRenderer* topmost);
  void setColours(const Palette& palette, double pixel_ratio);
  /// @param corners  of the cell as it is drawn, 12 numbers; empty for a joint or an edge
  void showSelected(const PickedItem& item, const PairPose& pair, std::span<const double> corners);
  void showHovered(const PickedItem& item, const PairPose& pair, std::span<const double> corners);

 private:
  struct Mark {
    LineSet rim, lines, dots{LineSet::Kind::Dots};
    void show(const PickedItem& item, const PairPose& pair, std::span<const double> corners);
  };
  Mark m_selected, m_hovered;
};

}  // namespace abrazo::widgets
