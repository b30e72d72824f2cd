#pragma once

#include <array>
#include <memory>
#include <span>

#include "core/base/positions.hpp"

class QColor;
class vtkRenderer;

namespace abrazo::widgets {

/// Half-metre lines on y = 0 that fade with distance from the characters, and soft shadows under them.
class FloorActor {
 public:
  FloorActor();
  ~FloorActor();
  FloorActor(const FloorActor&) = delete;
  FloorActor& operator=(const FloorActor&) = delete;

  void setColour(const QColor& lines, bool dark_background);
  /// Lines are fixed in the world; only the set of drawn lines changes.
  void setCentre(const Vec3& centre);
  struct Shadow {
    Vec3 above;  ///< what casts it, world [m]
    double radius_m;
    double strength;  ///< 0..1
  };
  void setShadows(std::span<const Shadow> shadows);
  void setVisible(bool visible);
  void addTo(vtkRenderer* renderer);

 private:
  struct Parts;
  std::unique_ptr<Parts> m_parts;
};

}  // namespace abrazo::widgets
