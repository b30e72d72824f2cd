#pragma once

#include <array>
#include <optional>

#include "core/base/positions.hpp"
#include "widgets/common/palette.hpp"
#include "widgets/scene/actors/line_set.hpp"

namespace abrazo::widgets {

/// The bodies of other runs over those of the frame: run A dashed, run B solid, in the character's colour,
/// with thin lines between joints that differ.
class ComparisonGhost {
 public:
  ComparisonGhost();
  void addTo(vtkRenderer* in_front);
  void setColours(const Palette& palette, double pixel_ratio);
  void setVisible(bool visible);
  /// @param direction  of the view, unit
  void separateFor(const Vec3& direction);
  /// @param recorded of the frame; absent runs are as recorded, and an almost equal body is not drawn twice
  void show(const PairPose& recorded, const std::optional<PairPose>& a, const std::optional<PairPose>& b);

  bool isThere() const;

 private:
  struct Run {
    std::array<LineSet, 2> rims, bodies;  ///< leader, follower
    std::array<bool, 2> is_there{};
  };
  void applyVisibility();

  Run m_a, m_b;
  LineSet m_differences;
  bool m_isVisible = true;
};

}  // namespace abrazo::widgets
