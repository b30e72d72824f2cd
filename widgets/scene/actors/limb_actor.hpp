#pragma once

#include <memory>
#include <span>

#include "core/mesh/capsules.hpp"

class QColor;
class vtkRenderer;

namespace abrazo::widgets {

/// Limbs of one body as translucent capsules with the solver's radii.
class LimbActor {
 public:
  LimbActor();
  ~LimbActor();
  LimbActor(const LimbActor&) = delete;
  LimbActor& operator=(const LimbActor&) = delete;

  void setRadii(const CapsuleRadii& radii);
  void setColour(const QColor& colour, double opacity);
  /// @param bones  ascending; none shows nothing
  /// @param girth  times the radii
  void show(std::span<const int> bones, const Pose& pose, double girth);
  void setVisible(bool visible);
  void addTo(vtkRenderer* renderer);

 private:
  struct Parts;
  std::unique_ptr<Parts> m_parts;
};

}  // namespace abrazo::widgets
