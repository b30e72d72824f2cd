#include "widgets/scene/pick_facts.hpp"

#include <algorithm>
#include <cstdio>

#include "core/motion/joint_set.hpp"
#include "widgets/scene/mesh_scalar.hpp"

namespace abrazo::widgets {
namespace {

template <typename... Values>
std::string text(const char* format, Values... values) {
  std::array<char, 160> buffer{};
  std::snprintf(buffer.data(), buffer.size(), format, values...);
  return buffer.data();
}

PickText describe_joint(const FrameSnapshot& frame, int vertex) {
  const JointFacts facts = joint_facts(frame, vertex);
  PickText told{vertex_name(vertex), {}};
  told.lines.push_back(
      text("at %.3f, %.3f, %.3f m", facts.position.x(), facts.position.y(), facts.position.z()));
  if (facts.to_user_m) told.lines.push_back(text("%.0f mm from the user's", 1000 * *facts.to_user_m));
  told.lines.push_back(
      text("nearest: %s, %.3f m", vertex_name(facts.nearest_partner).c_str(), facts.to_partner_m));
  return told;
}

PickText describe_edge(const FrameSnapshot& frame, const PickedItem& item) {
  PickText told{vertex_name(item.vertices[0]) + " — " + vertex_name(item.vertices[1]), {}};
  const auto facts = edge_facts(frame, {item.vertices[0], item.vertices[1]});
  if (!facts) {
    told.lines = {"not in the mesh of this frame"};
    return told;
  }
  told.lines.push_back(text("length %.3f m (selected %.3f, %+.0f mm)", facts->length_m, facts->reference_m,
                            1000 * (facts->length_m - facts->reference_m)));
  told.lines.push_back(text("weight %.3f · residual %.1f mm", facts->weight, 1000 * facts->residual_m));
  told.lines.push_back(text("%.2f %% of the deformation energy", facts->energy_share));
  return told;
}

PickText describe_cell(const FrameSnapshot& frame, const PickedItem& item) {
  constexpr double litres = 1000;
  PickText told{"tetrahedron", {}};
  for (const int first : {0, 2})
    told.lines.push_back(vertex_name(item.vertices[static_cast<std::size_t>(first)]) + ", " +
                         vertex_name(item.vertices[static_cast<std::size_t>(first + 1)]));
  const auto facts = cell_facts(frame, item);
  if (!facts) {
    told.lines.emplace_back("not in the mesh of this frame");
    return told;
  }
  told.lines.push_back(
      text("volume %.3f l (selected %.3f l)", litres * facts->volume_m3, litres * facts->reference_m3));
  told.lines.push_back(facts->is_flat       ? "flat in the selected pair: no ratio"
                       : facts->is_inverted ? text("turned over, ratio %.2f", facts->ratio)
                                            : text("ratio %.2f", facts->ratio));
  return told;
}

}  // namespace

JointFacts joint_facts(const FrameSnapshot& frame, int vertex) {
  const PairPose& pair = frame.result.result;
  const bool second = vertex >= joint_count;
  JointFacts facts;
  facts.position = pair.row(vertex).transpose();
  if (second == (frame.settings.user_role == UserRole::Passive))
    facts.to_user_m = (frame.user.row(vertex % joint_count) - pair.row(vertex)).norm();
  const int first = second ? 0 : joint_count;
  facts.nearest_partner = first;
  for (int v = first; v < first + joint_count; ++v) {
    const double distance = (pair.row(v) - pair.row(vertex)).norm();
    if (v != first && distance >= facts.to_partner_m) continue;
    facts.nearest_partner = v;
    facts.to_partner_m = distance;
  }
  return facts;
}

std::optional<EdgeFacts> edge_facts(const FrameSnapshot& frame, const MeshEdge& edge) {
  const FrameResult& result = frame.result;
  const auto found = std::find(result.edges.begin(), result.edges.end(), edge);
  if (found == result.edges.end()) return std::nullopt;
  const auto place = static_cast<std::size_t>(found - result.edges.begin());
  EdgeFacts facts;
  facts.length_m = (result.result.row(edge[0]) - result.result.row(edge[1])).norm();
  facts.reference_m = (result.selected_pair.row(edge[0]) - result.selected_pair.row(edge[1])).norm();
  if (place < result.edge_weights.size()) facts.weight = result.edge_weights[place];
  if (place < result.edge_residuals_m.size()) facts.residual_m = result.edge_residuals_m[place];
  facts.energy_share = edge_scalars(frame, MeshScalar::EnergyShare)[place];
  return facts;
}

std::optional<CellVolume> cell_facts(const FrameSnapshot& frame, const PickedItem& cell) {
  const FrameResult& result = frame.result;
  for (const MeshTetrahedron& tetrahedron : result.tetrahedra)
    if (PickedItem::tetrahedron(tetrahedron) == cell)
      return cell_volume(result.result, result.selected_pair, tetrahedron);
  return std::nullopt;
}

bool has_item(const FrameSnapshot& frame, const PickedItem& item) {
  const auto& edges = frame.result.edges;
  if (item.kind == PickKind::Edge)
    return std::find(edges.begin(), edges.end(), MeshEdge{item.vertices[0], item.vertices[1]}) != edges.end();
  if (item.kind == PickKind::Tetrahedron) return cell_facts(frame, item).has_value();
  return item.kind == PickKind::Joint;
}

std::string vertex_name(int vertex) {
  const std::string body = vertex < joint_count ? "leader " : "follower ";
  return body + std::string(joint_names[static_cast<std::size_t>(vertex % joint_count)]);
}

PickText describe(const FrameSnapshot& frame, const PickedItem& item) {
  switch (item.kind) {
    case PickKind::Joint:
      return describe_joint(frame, item.vertices[0]);
    case PickKind::Edge:
      return describe_edge(frame, item);
    case PickKind::Tetrahedron:
      return describe_cell(frame, item);
    case PickKind::None:
      break;
  }
  return {};
}

}  // namespace abrazo::widgets
