#include "widgets/scene/mesh_filter.hpp"

#include <algorithm>

namespace abrazo::widgets {
namespace {

bool has_length(const MeshFilter& filter, const PairPose& pair, int a, int b) {
  const double length = (pair.row(a) - pair.row(b)).norm();
  return length >= filter.shortest_m && length <= filter.longest_m;
}

}  // namespace

bool MeshFilter::passes(const PairPose& pair, const MeshEdge& edge) const {
  if (joint >= 0 && edge[0] != joint && edge[1] != joint) return false;
  return has_length(*this, pair, edge[0], edge[1]);
}

bool MeshFilter::passes(const PairPose& pair, const MeshTetrahedron& cell) const {
  if (joint >= 0 && std::find(cell.begin(), cell.end(), joint) == cell.end()) return false;
  for (std::size_t a = 0; a < 4; ++a)
    for (std::size_t b = a + 1; b < 4; ++b)
      if (!has_length(*this, pair, cell[a], cell[b])) return false;
  return true;
}

}  // namespace abrazo::widgets
