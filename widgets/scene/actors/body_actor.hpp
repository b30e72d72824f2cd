#pragma once

#include <array>
#include <memory>

#include "core/mesh/capsules.hpp"

class QColor;
class vtkRenderer;

namespace abrazo::widgets {

class BodyLight;

/// A character: shaded capsules with a darker silhouette, solid or dashed, so that characters differ not only
/// in hue.
class BodyActor {
 public:
  enum class Outline { Solid, Dashed };
  explicit BodyActor(Outline outline);
  ~BodyActor();
  BodyActor(const BodyActor&) = delete;
  BodyActor& operator=(const BodyActor&) = delete;

  /// @param radii  per bone [m]
  void setRadii(const CapsuleRadii& radii);
  /// @param girth  times the radii: of a body that is taller or shorter than the one they belong to
  void setPose(const Pose& pose, double girth);
  void setColour(const QColor& colour);
  /// Shades the body; called for every picture, because the light moves with the camera.
  void lightFor(const BodyLight& light);
  void setVisible(bool visible);
  void addTo(vtkRenderer* renderer);

 private:
  struct Parts;
  std::unique_ptr<Parts> m_parts;
};

}  // namespace abrazo::widgets
