#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "core/library/store/motion_library.hpp"
#include "core/mesh/other_body.hpp"

namespace abrazo {

namespace {

/// Row by row through the library, which checks the rows of a mapped one.
void exchange_meshes(const MotionLibrary& library, LibraryColumns& columns) {
  std::vector<MeshEdge> edges;
  std::vector<MeshTetrahedron> tetrahedra;
  edges.reserve(library.columns().edges.size());
  tetrahedra.reserve(library.columns().tetrahedra.size());
  std::vector<std::uint64_t> edge_offsets = {0}, tetrahedron_offsets = {0};
  for (int pair = 0; pair < library.pair_count(); ++pair) {
    for (const MeshEdge& edge : library.edges(pair)) edges.push_back(edge_of_other_body(edge));
    std::sort(edges.begin() + static_cast<std::ptrdiff_t>(edge_offsets.back()), edges.end());
    for (const MeshTetrahedron& tetrahedron : library.tetrahedra(pair))
      tetrahedra.push_back(tetrahedron_of_other_body(tetrahedron));
    edge_offsets.push_back(edges.size());
    tetrahedron_offsets.push_back(tetrahedra.size());
  }
  columns.edges = std::move(edges);
  columns.tetrahedra = std::move(tetrahedra);
  columns.edge_offsets = std::move(edge_offsets);
  columns.tetrahedron_offsets = std::move(tetrahedron_offsets);
}

}  // namespace

MotionLibrary with_roles_exchanged(const MotionLibrary& library) {
  LibraryColumns columns = library.columns();
  columns.roles_exchanged = !columns.roles_exchanged;
  exchange_meshes(library, columns);
  std::optional<double> previous_heading;
  for (int pair = 0; pair < library.pair_count(); ++pair) {
    const bool continues = pair > 0 && library.later_pair(pair - 1, 1) == pair;
    if (!continues) previous_heading.reset();
    const PairPose& recorded = library.pose(pair);
    const Pose active = to_world(recorded.topRows<joint_count>(), library.root(pair));
    const Pose passive = to_world(recorded.bottomRows<joint_count>(), library.root(pair));
    const RootFrame root = root_frame(passive, previous_heading);
    previous_heading = root.heading_rad;
    PairPose exchanged;
    exchanged << to_normalized(passive, root), to_normalized(active, root);
    const auto row = static_cast<std::size_t>(pair);
    columns.roots[row] = root;
    columns.poses[row] = exchanged;
    columns.features[row] = pose_features(exchanged.topRows<joint_count>());
  }
  columns.mapping.reset();  // everything is in memory now
  columns.damage = library.damage();
  return MotionLibrary(std::move(columns));
}

}  // namespace abrazo
