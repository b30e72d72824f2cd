#pragma once

#include <memory>

#include "core/motion/scenes/worn_character.hpp"

class QColor;
class vtkRenderer;

namespace abrazo::widgets {

class BodyLight;

/// A character of another program as the skin of a body: shaded in the colours of its materials, with a
/// silhouette in the colour of the character that wears it. Without a character it shows nothing.
class SkinActor {
 public:
  SkinActor();
  ~SkinActor();
  SkinActor(const SkinActor&) = delete;
  SkinActor& operator=(const SkinActor&) = delete;

  /// @param character  null = none
  /// @param stance  of the performer whose poses follow
  void wear(std::shared_ptr<const WornCharacter> character, const Stance& stance);
  bool wears() const;
  /// A hidden skin is not moved.
  void setPose(const Pose& pose, double time_s);
  void setColour(const QColor& colour);
  /// Shades the skin; called for every picture, because the light moves with the camera.
  void lightFor(const BodyLight& light);
  void setVisible(bool visible);
  void addTo(vtkRenderer* renderer);

 private:
  struct Parts;
  std::unique_ptr<Parts> m_parts;
};

}  // namespace abrazo::widgets
