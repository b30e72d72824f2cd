#include "widgets/scene/values/mesh_filter.hpp"

#include <algorithm>
#include <cmath>

namespace abrazo::widgets {
namespace {

bool has_length(const MeshFilter& filter, const PairPose& pair, int a, int b) {
  const double length = (pair.row(a) - pair.row(b)).norm();
  return length >= filter.shortest_m && length <= filter.longest_m;
}

/// For joints: items at one of them; for an edge or a cell: items with all of its vertices, and optionally
/// its parts.
template <typename Item>
bool belongs(const Selection& selection, const Item& item, bool with_parts) {
  const auto shared = std::count_if(item.begin(), item.end(), [&](auto v) { return selection.has(v); });
  if (selection.kind == SelectionKind::Joints) return shared > 0;
  if (shared == static_cast<std::ptrdiff_t>(selection.vertices.size())) return true;
  return with_parts && shared == static_cast<std::ptrdiff_t>(item.size());
}

template <typename Item>
bool is_wanted(const MeshFilter& filter, const Item& item) {
  if (filter.isolated.is_of_mesh() && !belongs(filter.isolated, item, true)) return false;
  return std::none_of(filter.hidden.begin(), filter.hidden.end(),
                      [&item](const Selection& hidden) { return belongs(hidden, item, false); });
}

}  // namespace

bool MeshFilter::passes(const PairPose& pair, const MeshEdge& edge) const {
  return is_wanted(*this, edge) && has_length(*this, pair, edge[0], edge[1]);
}

bool MeshFilter::passes_value(double value) const {
  if (least_value <= 0 && most_value == no_limit) return true;
  return std::abs(value) >= least_value && std::abs(value) <= most_value;
}

bool MeshFilter::passes(const PairPose& pair, const MeshTetrahedron& cell) const {
  if (!is_wanted(*this, cell)) return false;
  for (std::size_t a = 0; a < 4; ++a)
    for (std::size_t b = a + 1; b < 4; ++b)
      if (!has_length(*this, pair, cell[a], cell[b])) return false;
  return true;
}

}  // namespace abrazo::widgets
