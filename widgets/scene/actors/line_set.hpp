#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "core/base/positions.hpp"

class QColor;
class vtkActor;
class vtkRenderer;

namespace abrazo::widgets {

/// Straight lines (or dots) between points of one list. Topology and points are set separately.
class LineSet {
 public:
  enum class Kind { Lines, Dots };
  explicit LineSet(Kind kind = Kind::Lines);
  ~LineSet();
  LineSet(const LineSet&) = delete;
  LineSet& operator=(const LineSet&) = delete;

  /// @param xyz  three per point, world [m]
  void setPoints(std::span<const double> xyz);
  /// Indices into the points.
  void setLines(std::span<const std::array<int, 2>> lines);
  void setDots(int count);
  /// One RGBA per line or dot; an empty list restores the single colour.
  void setCellColours(std::span<const std::array<unsigned char, 4>> colours);

  void setColour(const QColor& colour, double opacity = 1);
  void setWidth(double pixels);
  /// Moves all points [m], without an upload.
  void setOffset(const Vec3& offset);
  void setVisible(bool visible);
  void addTo(vtkRenderer* renderer);
  vtkActor* actor() const;

 private:
  struct Parts;
  std::unique_ptr<Parts> m_parts;
};

}  // namespace abrazo::widgets
