#include <algorithm>
#include <optional>

#include "core/library/motion_library.hpp"
#include "core/mesh/other_body.hpp"

namespace abrazo {

namespace {

void exchange_meshes(LibraryColumns& columns) {
  for (MeshEdge& edge : columns.edges) {
    edge = {vertex_of_other_body(edge[0]), vertex_of_other_body(edge[1])};
    if (edge[0] > edge[1]) std::swap(edge[0], edge[1]);
  }
  for (std::size_t pair = 0; pair + 1 < columns.edge_offsets.size(); ++pair)
    std::sort(columns.edges.begin() + static_cast<std::ptrdiff_t>(columns.edge_offsets[pair]),
              columns.edges.begin() + static_cast<std::ptrdiff_t>(columns.edge_offsets[pair + 1]));
  for (MeshTetrahedron& tetrahedron : columns.tetrahedra)
    for (std::uint8_t& vertex : tetrahedron) vertex = vertex_of_other_body(vertex);
}

}  // namespace

MotionLibrary with_roles_exchanged(const MotionLibrary& library) {
  LibraryColumns columns = library.columns();
  columns.roles_exchanged = !columns.roles_exchanged;
  exchange_meshes(columns);
  std::optional<double> previous_heading;
  for (std::size_t pair = 0; pair < columns.poses.size(); ++pair) {
    const bool continues =
        pair > 0 && library.later_pair(static_cast<int>(pair) - 1, 1) == static_cast<int>(pair);
    if (!continues) previous_heading.reset();
    const Pose active = to_world(columns.poses[pair].topRows<joint_count>(), columns.roots[pair]);
    const Pose passive = to_world(columns.poses[pair].bottomRows<joint_count>(), columns.roots[pair]);
    const RootFrame root = root_frame(passive, previous_heading);
    previous_heading = root.heading_rad;
    columns.roots[pair] = root;
    columns.poses[pair].topRows<joint_count>() = to_normalized(passive, root);
    columns.poses[pair].bottomRows<joint_count>() = to_normalized(active, root);
    columns.features[pair] = pose_features(columns.poses[pair].topRows<joint_count>());
  }
  return MotionLibrary(std::move(columns));
}

}  // namespace abrazo
