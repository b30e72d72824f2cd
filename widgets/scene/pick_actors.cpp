#include "widgets/scene/pick_actors.hpp"

#include <QColor>
#include <vector>

namespace abrazo::widgets {

PickActors::PickActors() {
  showSelected({}, PairPose::Zero(), {});
  showHovered({}, PairPose::Zero(), {});
}

void PickActors::addTo(vtkRenderer* topmost) {
  for (Mark* mark : {&m_selected, &m_hovered})
    for (LineSet* lines : {&mark->rim, &mark->lines, &mark->dots}) lines->addTo(topmost);
}

void PickActors::setColours(const Palette& palette, double pixel_ratio) {
  // The opposite of the background with a rim of its own colour: seen on bodies, on edges and on nothing.
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

void PickActors::Mark::show(const PickedItem& item, const PairPose& pair, std::span<const double> corners) {
  rim.setVisible(item.kind != PickKind::None);
  lines.setVisible(item.kind != PickKind::None);
  dots.setVisible(item.kind == PickKind::Joint);
  if (item.kind == PickKind::None) return;
  std::vector<double> points(corners.begin(), corners.end());
  if (corners.empty())
    for (int v = 0; v < item.vertex_count(); ++v)
      for (int axis = 0; axis < 3; ++axis)
        points.push_back(pair(item.vertices[static_cast<std::size_t>(v)], axis));
  const int count = static_cast<int>(points.size() / 3);
  std::vector<std::array<int, 2>> pairs;
  for (int a = 0; a < count; ++a)
    for (int b = a + 1; b < count; ++b) pairs.push_back({a, b});
  for (LineSet* set : {&rim, &lines, &dots}) set->setPoints(points);
  rim.setLines(pairs);
  lines.setLines(pairs);
  dots.setDots(item.kind == PickKind::Joint ? 1 : 0);
}

void PickActors::showSelected(const PickedItem& item, const PairPose& pair, std::span<const double> corners) {
  m_selected.show(item, pair, corners);
}

void PickActors::showHovered(const PickedItem& item, const PairPose& pair, std::span<const double> corners) {
  m_hovered.show(item, pair, corners);
}

}  // namespace abrazo::widgets
