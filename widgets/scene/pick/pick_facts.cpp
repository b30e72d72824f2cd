#include "widgets/scene/pick/pick_facts.hpp"

#include <algorithm>
#include <cstdio>
#include <string>
#include <utility>

#include "core/motion/body/joint_set.hpp"
#include "core/session/frames/frame_in_library.hpp"
#include "widgets/scene/values/contact_shapes.hpp"
#include "widgets/scene/values/mesh_scalar.hpp"

namespace abrazo::widgets {
namespace {

template <typename... Values>
std::string text_of_fact(const char* format, Values... values) {
  std::array<char, 160> buffer{};
  std::snprintf(buffer.data(), buffer.size(), format, values...);
  return buffer.data();
}

/// What the limbs that end at a joint overlap.
void add_contacts(PickText& told, const FrameSnapshot& frame, int vertex) {
  for (const CapsuleContact& contact : frame.result.collisions) {
    const bool ours = contact.a[1] == vertex || contact.b[1] == vertex;
    if (!ours) continue;
    const int other = contact.a[1] == vertex ? contact.b[1] : contact.a[1];
    told.lines.push_back("limb overlaps " + vertex_name(other) + "'s by " +
                         depth_text(contact.depth_m, contact.allowed_depth_m));
  }
}

PickText describe_joint(const FrameSnapshot& frame, int vertex) {
  const JointFacts facts = joint_facts(frame, vertex);
  PickText told{vertex_name(vertex), {}};
  told.lines.push_back(
      text_of_fact("at %.3f, %.3f, %.3f m", facts.position.x(), facts.position.y(), facts.position.z()));
  if (facts.to_user_m) told.lines.push_back(text_of_fact("%.0f mm from the user's", 1000 * *facts.to_user_m));
  if (frame.result.selected >= 0)  // the pair of a library that is not open is not known
    told.lines.push_back(text_of_fact("%.0f mm from the selected pair's", 1000 * facts.to_selected_m));
  told.lines.push_back(
      text_of_fact("nearest: %s, %.3f m", vertex_name(facts.nearest_partner).c_str(), facts.to_partner_m));
  add_contacts(told, frame, vertex);
  return told;
}

PickText describe_joints(const FrameSnapshot& frame, const Selection& item) {
  constexpr std::size_t most_lines = 6;
  PickText told{text_of_fact("%zu joints", item.vertices.size()), {}};
  const std::size_t listed = item.vertices.size() > most_lines ? most_lines - 1 : item.vertices.size();
  for (std::size_t j = 0; j < listed; ++j) told.lines.push_back(vertex_name(item.vertices[j]));
  if (listed < item.vertices.size())
    told.lines.push_back(text_of_fact("and %zu more", item.vertices.size() - listed));
  if (item.vertices.size() == 2) {
    const PairPose& pair = frame.result.result;
    told.lines.push_back(
        text_of_fact("%.3f m apart", (pair.row(item.vertices[0]) - pair.row(item.vertices[1])).norm()));
  }
  return told;
}

std::string cost_line(const CostBreakdown& cost, double alpha) {
  return text_of_fact("cost %.3f m² = pose %.3f + %.2f (%.3f + %.3f)", cost.total, cost.pose, alpha,
                      cost.temporal_active, cost.temporal_passive);
}

/// Two lines: one would make the card too wide.
void add_intent_cost(PickText& told, const IntentCost& cost) {
  told.lines.push_back(
      text_of_fact("cost %.3f m = partner %.3f + leader %.3f", cost.total, cost.partner, cost.leader));
  std::string rest;
  for (const auto& [name, value] : {std::pair{"move", cost.move},
                                    {"intended", cost.meant},
                                    {"change", cost.change},
                                    {"temporal", cost.temporal}})
    if (value != 0) rest += text_of_fact("%s+ %s %.3f", rest.empty() ? "" : " ", name, value);
  if (!rest.empty()) told.lines.push_back(std::move(rest));
}

PickText describe_candidate(const FrameSnapshot& frame, int pair, const MotionLibrary* library) {
  PickText told{text_of_fact("pair %d", pair), {}};
  if (library && pair >= 0 && pair < library->pair_count()) {
    told.title = text_of_fact("%s · %u", library->take_of(pair).name.c_str(), library->source(pair).frame);
    if (std::string move(library->label(pair)); !move.empty()) {
      std::ranges::replace(move, '_', ' ');
      told.lines.push_back(std::move(move));
    }
  }
  const auto place = candidate_of(frame, pair);
  if (!place) {
    told.lines.push_back(frame.absent ? absence_text(frame) : "not among the candidates of this frame");
    return told;
  }
  const Candidate& candidate = frame.result.candidates[*place];
  const auto cheaper = std::ranges::count_if(frame.result.candidates, [&candidate](const Candidate& other) {
    return deciding_cost(other) < deciding_cost(candidate);
  });
  const bool is_used =
      frame.result.selected >= 0 && *place == static_cast<std::size_t>(frame.result.selected);
  const bool is_continuation =
      candidate.intent && (candidate.continuation || candidate.pair == frame.result.intent.continued);
  told.lines.push_back(text_of_fact("rank %d of %zu%s%s", static_cast<int>(cheaper) + 1,
                                    frame.result.candidates.size(), is_used ? ", selected" : "",
                                    is_continuation ? ", continues" : ""));
  if (candidate.intent)
    add_intent_cost(told, *candidate.intent);
  else
    told.lines.push_back(cost_line(candidate.cost, frame.settings.alpha));
  return told;
}

PickText describe_edge(const FrameSnapshot& frame, const Selection& item) {
  PickText told{vertex_name(item.vertices[0]) + " — " + vertex_name(item.vertices[1]), {}};
  const auto facts = edge_facts(frame, {item.vertices[0], item.vertices[1]});
  if (!facts) {
    told.lines = {"not in the mesh of this frame"};
    return told;
  }
  told.lines.push_back(text_of_fact("length %.0f mm (in pair %.0f, %+.0f)", 1000 * facts->length_m,
                                    1000 * facts->reference_m,
                                    1000 * (facts->length_m - facts->reference_m)));
  told.lines.push_back(
      text_of_fact("weight %.3f · residual %.1f mm", facts->weight, 1000 * facts->residual_m));
  told.lines.push_back(text_of_fact("%.2f %% of the deformation energy", facts->energy_share));
  return told;
}

PickText describe_cell(const FrameSnapshot& frame, const Selection& item) {
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
      text_of_fact("volume %.3f l (in pair %.3f)", litres * facts->volume_m3, litres * facts->reference_m3));
  told.lines.push_back(facts->is_flat       ? "flat in the selected pair: no ratio"
                       : facts->is_inverted ? text_of_fact("inverted, ratio %.2f", facts->ratio)
                                            : text_of_fact("ratio %.2f", facts->ratio));
  return told;
}

}  // namespace

JointFacts joint_facts(const FrameSnapshot& frame, int vertex) {
  const PairPose& pair = frame.result.result;
  const bool second = vertex >= joint_count;
  JointFacts facts;
  facts.position = pair.row(vertex).transpose();
  facts.to_selected_m = (frame.result.selected_pair.row(vertex) - pair.row(vertex)).norm();
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

std::optional<CellVolume> cell_facts(const FrameSnapshot& frame, const Selection& cell) {
  const FrameResult& result = frame.result;
  for (const MeshTetrahedron& tetrahedron : result.tetrahedra)
    if (Selection::tetrahedron(tetrahedron) == cell)
      return cell_volume(result.result, result.selected_pair, tetrahedron);
  return std::nullopt;
}

std::optional<std::size_t> candidate_of(const FrameSnapshot& frame, int pair) {
  const auto& all = frame.result.candidates;
  const auto found = std::ranges::find(all, pair, &Candidate::pair);
  if (found == all.end()) return std::nullopt;
  return static_cast<std::size_t>(found - all.begin());
}

bool has_item(const FrameSnapshot& frame, const Selection& item) {
  const auto& edges = frame.result.edges;
  if (item.kind == SelectionKind::Edge)
    return std::find(edges.begin(), edges.end(), MeshEdge{item.vertices[0], item.vertices[1]}) != edges.end();
  if (item.kind == SelectionKind::Tetrahedron) return cell_facts(frame, item).has_value();
  if (item.kind == SelectionKind::Candidate) return candidate_of(frame, item.pair).has_value();
  return item.kind == SelectionKind::Joints;
}

PickText describe(const FrameSnapshot& frame, const Selection& item, const MotionLibrary* library) {
  switch (item.kind) {
    case SelectionKind::Joints:
      return item.vertices.size() == 1 ? describe_joint(frame, item.vertices[0])
                                       : describe_joints(frame, item);
    case SelectionKind::Edge:
      return describe_edge(frame, item);
    case SelectionKind::Tetrahedron:
      return describe_cell(frame, item);
    case SelectionKind::Candidate:
      return describe_candidate(frame, item.pair, library);
    case SelectionKind::None:
      break;
  }
  return {};
}

}  // namespace abrazo::widgets
