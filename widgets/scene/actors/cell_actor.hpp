#pragma once

#include <memory>
#include <span>
#include <vector>

#include "widgets/common/palette.hpp"
#include "widgets/scene/actors/line_set.hpp"
#include "widgets/scene/values/mesh_cells.hpp"

namespace abrazo::widgets {

/// Tetrahedra of the interaction mesh: translucent, coloured by change of volume; inverted ones are magenta
/// with a thick rim that is always visible.
class CellActor {
 public:
  CellActor();
  ~CellActor();
  CellActor(const CellActor&) = delete;
  CellActor& operator=(const CellActor&) = delete;

  void setColours(const Palette& palette, double pixel_ratio);
  void setVisible(bool visible);
  /// @param corners  12 numbers per cell, world [m]
  /// @param doublings  |log2 ratio| at the ends of the colour map
  void show(std::vector<double> corners, std::span<const CellVolume> cells, double doublings);
  /// Sorts the faces for blending; call before each picture.
  void sortFor(const Vec3& eye, const Vec3& direction);
  void addTo(vtkRenderer* solid, vtkRenderer* in_front);

  std::span<const double> corners() const { return m_corners; }

 private:
  struct Parts;
  std::unique_ptr<Parts> m_parts;
  std::vector<double> m_corners;
  std::vector<std::array<unsigned char, 4>> m_colours;
  LineSet m_rims;
  QColor m_inverted;
  bool m_dark = true;
};

}  // namespace abrazo::widgets
