#include "widgets/scene/actors/reference_actors.hpp"

#include "core/motion/body/joint_set.hpp"

namespace abrazo::widgets {
namespace {

using Line = std::array<int, 2>;

}  // namespace

ReferenceActors::ReferenceActors() {
  for (std::size_t body = 0; body < 2; ++body) {
    const int first = static_cast<int>(body) * joint_count;
    std::vector<Line> bones;
    for (int b = 0; b < bone_count; ++b) bones.push_back({first + bone(b).first, first + bone(b).second});
    m_bodies[body].setLines(bones);
  }
  m_joints.setDots(pair_vertex_count);
  setVisible(false, false, false);
}

void ReferenceActors::addTo(vtkRenderer* solid, vtkRenderer* in_front) {
  for (LineSet* lines : {&m_within, &m_between}) lines->addTo(solid);
  // Bones are edges, too: in one layer the two would fight for the same pixels.
  for (LineSet* lines : {&m_bodies[0], &m_bodies[1], &m_joints}) lines->addTo(in_front);
}

void ReferenceActors::setColours(const Palette& palette, double pixel_ratio) {
  const auto style = [pixel_ratio](LineSet& lines, const QColor& colour, double width, double opacity) {
    lines.setColour(colour, opacity);
    lines.setWidth(width * pixel_ratio);
  };
  style(m_bodies[0], palette.ghost_active, 5, 0.9);
  style(m_bodies[1], palette.ghost_passive, 5, 0.9);
  style(m_between, palette.text, 1.8, 1);
  style(m_within, palette.dark ? QColor("#aab4c4") : QColor("#3c4552"), 1, palette.dark ? 0.26 : 0.30);
  style(m_joints, palette.text, 5, 1);
}

void ReferenceActors::setVisible(bool visible, bool between, bool within) {
  for (LineSet* lines : {&m_bodies[0], &m_bodies[1], &m_joints}) lines->setVisible(visible);
  m_between.setVisible(visible && between);
  m_within.setVisible(visible && within);
}

void ReferenceActors::show(const FrameResult& frame, const MeshActors& mesh, const Vec3& offset) {
  std::vector<double> points;
  points.reserve(3 * pair_vertex_count);
  for (int v = 0; v < pair_vertex_count; ++v)
    for (int axis = 0; axis < 3; ++axis) points.push_back(frame.selected_pair(v, axis) + offset[axis]);
  for (LineSet* lines : {&m_bodies[0], &m_bodies[1], &m_between, &m_within, &m_joints})
    lines->setPoints(points);
  std::vector<Line> between, within;
  for (const std::size_t e : mesh.betweenEdges()) between.push_back({frame.edges[e][0], frame.edges[e][1]});
  for (const MeshEdge& edge : mesh.shownEdges())
    if (!is_inter_body(edge)) within.push_back({edge[0], edge[1]});
  m_between.setLines(between);
  m_between.setCellColours(mesh.betweenColours());
  m_within.setLines(within);
}

}  // namespace abrazo::widgets
