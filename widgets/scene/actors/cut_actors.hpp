#pragma once

#include <optional>

#include "widgets/common/palette.hpp"
#include "widgets/scene/actors/line_set.hpp"
#include "widgets/scene/values/cut_plane.hpp"

namespace abrazo::widgets {

/// Clips a whole layer beyond the plane; no clipping without a plane.
void cut_away(vtkRenderer* layer, const std::optional<CutPlane>& plane);

/// The outline of a plane fixed in the world, with a tick towards the kept side.
class CutFrame {
 public:
  void addTo(vtkRenderer* renderer);
  void setColours(const Palette& palette, double pixel_ratio);
  void show(const std::optional<CutPlane>& plane);

 private:
  LineSet m_lines;
};

}  // namespace abrazo::widgets
