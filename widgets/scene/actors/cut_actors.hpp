#pragma once

#include <optional>

#include "widgets/common/palette.hpp"
#include "widgets/scene/actors/line_set.hpp"
#include "widgets/scene/values/cut_plane.hpp"

namespace abrazo::widgets {

/// Leaves out what is beyond the plane in a whole layer; nothing is left out without one.
void cut_away(vtkRenderer* layer, const std::optional<CutPlane>& plane);

/// The frame of a plane that stands in the world, with a tick into what is kept.
class CutFrame {
 public:
  void addTo(vtkRenderer* renderer);
  void setColours(const Palette& palette, double pixel_ratio);
  void show(const std::optional<CutPlane>& plane);

 private:
  LineSet m_lines;
};

}  // namespace abrazo::widgets
