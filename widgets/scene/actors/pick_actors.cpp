#include "widgets/scene/actors/pick_actors.hpp"

#include <QColor>
#include <vector>

namespace abrazo::widgets {

PickActors::PickActors() {
  const PairPose nowhere = PairPose::Zero();
  showSelected({}, {nowhere, {}});
  showHovered({}, {nowhere, {}});
}

void PickActors::addTo(vtkRenderer* in_front, vtkRenderer* topmost) {
  for (Mark* mark : {&m_selected, &m_hovered}) {
    mark->rim.addTo(in_front);
    mark->lines.addTo(topmost);
    mark->dots.addTo(topmost);
  }
}

void PickActors::setColours(const Palette& palette, double pixel_ratio) {
  // Contrast to the background, with a rim in the background colour: visible on bodies, edges and background.
  const QColor ink = palette.dark ? QColor("#ffffff") : QColor("#000000");
  const QColor rim = palette.dark ? QColor("#000000") : QColor("#ffffff");
  const auto dress = [&](Mark& mark, double width, double opacity) {
    mark.rim.setColour(rim, opacity);
    mark.lines.setColour(ink, opacity);
    mark.dots.setColour(ink, opacity);
    mark.rim.setWidth((width + 3) * pixel_ratio);
    mark.lines.setWidth(width * pixel_ratio);
    mark.dots.setWidth((width + 9) * pixel_ratio);
  };
  dress(m_selected, 4, 1);
  dress(m_hovered, 2.5, 0.8);
}

void PickActors::Mark::show(const Selection& item, const Place& place) {
  const bool is_joints = item.kind == SelectionKind::Joints;
  for (LineSet* set : {&rim, &lines}) set->setVisible(item.is_of_mesh());
  dots.setVisible(is_joints);
  if (!item.is_of_mesh()) return;
  std::vector<double> points(place.corners.begin(), place.corners.end());
  const auto add = [&](const PairPose& pair) {
    for (const std::uint8_t v : item.vertices)
      for (int axis = 0; axis < 3; ++axis) points.push_back(pair(v, axis));
  };
  if (place.corners.empty()) add(place.pair);
  const int once = static_cast<int>(item.vertices.size());
  if (place.second) add(*place.second);
  const int count = static_cast<int>(points.size() / 3);
  std::vector<std::array<int, 2>> pairs;
  for (int first = 0; !is_joints && first < count; first += once)
    for (int a = 0; a < once; ++a)
      for (int b = a + 1; b < once; ++b) pairs.push_back({first + a, first + b});
  for (LineSet* set : {&rim, &lines, &dots}) set->setPoints(points);
  rim.setLines(pairs);
  lines.setLines(pairs);
  dots.setDots(is_joints ? count : 0);
}

}  // namespace abrazo::widgets
