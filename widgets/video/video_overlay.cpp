#include "widgets/video/video_overlay.hpp"

#include <algorithm>

#include "core/motion/body/joint_set.hpp"

namespace abrazo::widgets {
namespace {

using Part = OverlayLine::Part;

constexpr double farthest_step_m = 0.4;  // from one frame to the next: no hand is faster

bool is_bone(const MeshEdge& edge) {
  const auto parent = [](int vertex) {
    const int joint = vertex % joint_count;
    const int of_body = joint_parents[static_cast<std::size_t>(joint)];
    return of_body < 0 ? -1 : of_body + vertex - joint;
  };
  return parent(edge[1]) == edge[0] || parent(edge[0]) == edge[1];
}

class Projected {
 public:
  Projected(const CameraModel& camera, const PairPose& pose) : m_camera(camera), m_pose(pose) {}

  void add(Part part, int from, int to) {
    for (auto& piece : m_camera.project_segment(m_pose.row(from).transpose(), m_pose.row(to).transpose()))
      if (piece.size() > 1) m_overlay.lines.push_back({part, std::move(piece)});
  }
  void addBody(Part part, int first) {
    for (int b = 0; b < bone_count; ++b) add(part, first + bone(b).first, first + bone(b).second);
    for (int joint = 0; joint < joint_count; ++joint)
      m_overlay.joints[static_cast<std::size_t>(first + joint)] =
          m_camera.project(m_pose.row(first + joint).transpose());
  }
  VideoOverlay take() { return std::move(m_overlay); }

 private:
  const CameraModel& m_camera;
  const PairPose& m_pose;
  VideoOverlay m_overlay;
};

}  // namespace

VideoOverlay project_overlay(const CameraModel& camera, const PairPose& pose, std::span<const MeshEdge> edges,
                             const OverlayParts& parts) {
  Projected projected(camera, pose);
  if (parts.within_bodies)
    for (const MeshEdge& edge : edges)
      if (!is_inter_body(edge) && !is_bone(edge)) projected.add(Part::WithinBody, edge[0], edge[1]);
  if (parts.mesh)
    for (const MeshEdge& edge : edges)
      if (is_inter_body(edge)) projected.add(Part::BetweenBodies, edge[0], edge[1]);
  if (parts.passive) projected.addBody(Part::Passive, joint_count);
  if (parts.active) projected.addBody(Part::Active, 0);
  return projected.take();
}

PairPose between(const PairPose& a, const PairPose& b, double share) {
  const bool jumps = (b - a).rowwise().norm().maxCoeff() > farthest_step_m;
  return jumps ? (share < 1 ? a : b) : PairPose(a + std::clamp(share, 0.0, 1.0) * (b - a));
}

}  // namespace abrazo::widgets
