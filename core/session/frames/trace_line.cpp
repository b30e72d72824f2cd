#include <fmt/format.h>

#include <array>
#include <bitset>
#include <cmath>
#include <nlohmann/json.hpp>
#include <utility>

#include "core/base/limits.hpp"
#include "core/mesh/laplacian.hpp"
#include "core/session/frames/trace_frames.hpp"

namespace abrazo {
namespace {

using Json = nlohmann::json;

/// Reads fields of one line; keeps the first error and skips the rest.
class LineReader {
 public:
  LineReader(const Json& json, std::string where) : json_(json), where_(std::move(where)) {}

  const std::optional<Error>& error() const { return error_; }
  void refuse(const std::string& field, const std::string& why) {
    if (!error_) error_ = Error{fmt::format("\"{}\" {}", field, why), where_};
  }

  /// Null if there is no such field.
  const Json* find(const char* group, const char* field) const {
    const Json* in = &json_;
    if (group) {
      const auto found = json_.find(group);
      if (found == json_.end() || !found->is_object()) return nullptr;
      in = &*found;
    }
    const auto found = in->find(field);
    return found == in->end() || found->is_null() ? nullptr : &*found;
  }

  double number(const char* field) {
    const Json* value = find(nullptr, field);
    if (value && value->is_number() && std::isfinite(value->get<double>())) return value->get<double>();
    refuse(field, "has to be a number");
    return 0;
  }

  std::optional<Pose> pose(const char* group, const char* field, bool is_needed) {
    const Json* rows = find(group, field);
    if (!rows) {
      if (is_needed) refuse(field, "is missing: 25 positions were expected");
      return {};
    }
    Pose pose;
    bool is_whole = rows->is_array() && rows->size() == joint_count;
    for (int joint = 0; is_whole && joint < joint_count; ++joint) {
      const Json& row = (*rows)[static_cast<std::size_t>(joint)];
      is_whole = row.is_array() && row.size() == 3;
      for (int axis = 0; is_whole && axis < 3; ++axis) {
        const Json& value = row[static_cast<std::size_t>(axis)];
        is_whole = value.is_number() && std::isfinite(value.get<double>());
        if (is_whole) pose(joint, axis) = value.get<double>();
      }
    }
    if (is_whole) return pose;
    refuse(field, "has to be 25 positions of 3 numbers [m]");
    return {};
  }

  /// Rows of indices of the pair's vertices.
  template <std::size_t N, typename Index>
  void vertices(const char* group, const char* field, std::size_t most,
                std::vector<std::array<Index, N>>& into) {
    const Json* rows = find(group, field);
    if (!rows) return;
    if (!rows->is_array() || rows->size() > most) return refuse(field, "is no list of vertices of the pair");
    for (const Json& row : *rows) {
      std::array<Index, N> indices{};
      if (!take(row, indices)) return refuse(field, fmt::format("has to be rows of {} vertices 0..49", N));
      into.push_back(indices);
    }
  }

  template <std::size_t N, typename Index>
  static bool take(const Json& row, std::array<Index, N>& indices) {
    if (!row.is_array() || row.size() != N) return false;
    for (std::size_t i = 0; i < N; ++i) {
      if (!row[i].is_number_integer() || row[i] < 0 || row[i] >= pair_vertex_count) return false;
      indices[i] = static_cast<Index>(row[i].get<int>());
    }
    return true;
  }

 private:
  const Json& json_;
  std::string where_;
  std::optional<Error> error_;
};

void take_mesh(LineReader& reader, FrameResult& result, EdgeWeights weights) {
  const auto active = reader.pose("selected_pair", "active", false);
  const auto passive = reader.pose("selected_pair", "passive", false);
  reader.vertices("mesh", "edges", pair_vertex_count * pair_vertex_count, result.edges);
  reader.vertices("mesh", "tetrahedra", 4096, result.tetrahedra);
  std::array<std::bitset<pair_vertex_count>, pair_vertex_count> known;
  for (MeshEdge& edge : result.edges) {
    if (edge[0] == edge[1]) return reader.refuse("edges", "has an edge from a vertex to itself");
    if (edge[0] > edge[1]) std::swap(edge[0], edge[1]);
    if (known[edge[0]].test(edge[1]))
      return reader.refuse("edges", fmt::format("has the edge between {} and {} twice", edge[0], edge[1]));
    known[edge[0]].set(edge[1]);
  }
  if (reader.error() || !active || !passive) return;
  result.selected_pair << *active, *passive;
  // Values not in the trace are derived.
  Laplacian laplacian;
  laplacian.build(result.edges, result.selected_pair, weights);
  const PairPose residuals = laplacian.apply(result.result - result.selected_pair);
  for (const MeshEdge& edge : result.edges) {
    result.edge_weights.push_back(0.5 *
                                  (laplacian.weight(edge[0], edge[1]) + laplacian.weight(edge[1], edge[0])));
    result.edge_residuals_m.push_back(0.5 * (residuals.row(edge[0]).norm() + residuals.row(edge[1]).norm()));
  }
}

/// Only the number of candidates: their library is not available.
void take_selected(LineReader& reader, FrameResult& result) {
  constexpr std::size_t most = 10'000;
  const Json* candidates = reader.find(nullptr, "candidates");
  const Json* selected = reader.find(nullptr, "selected");
  if (!candidates || !selected) return;
  if (!candidates->is_array() || candidates->size() > most) return reader.refuse("candidates", "is no list");
  if (!selected->is_number_integer() || *selected < -1 || *selected >= candidates->size())
    return reader.refuse("selected", "is no index into \"candidates\", or -1");
  result.candidates.resize(candidates->size());
  result.selected = selected->get<int>();
}

void take_contacts(LineReader& reader, FrameResult& result) {
  if (const Json* locks = reader.find(nullptr, "foot_locks"); locks && locks->is_array())
    for (const Json& lock : *locks) {
      const std::string name = lock.is_string() ? lock.get<std::string>() : "";
      if (name != "active.left" && name != "active.right" && name != "passive.left" &&
          name != "passive.right")
        return reader.refuse("foot_locks", "has to be names such as \"active.left\"");
      result.foot_locks.push_back({name.starts_with("active"), name.ends_with("left")});
    }
  const Json* contacts = reader.find(nullptr, "collisions");
  if (!contacts) return;
  if (!contacts->is_array() || contacts->size() > 4096) return reader.refuse("collisions", "is no list");
  for (const Json& contact : *contacts) {
    CapsuleContact taken;
    if (!contact.is_object() || !LineReader::take(contact.value("a", Json()), taken.a) ||
        !LineReader::take(contact.value("b", Json()), taken.b) ||
        !contact.value("depth_m", Json()).is_number())
      return reader.refuse("collisions", "has to be objects with a, b and depth_m");
    taken.depth_m = contact["depth_m"].get<double>();
    if (const auto allowed = contact.find("allowed_depth_m");
        allowed != contact.end() && allowed->is_number())
      taken.allowed_depth_m = allowed->get<double>();
    result.collisions.push_back(taken);
  }
}

void take_status(LineReader& reader, FrameResult& result) {
  const Json* status = reader.find(nullptr, "status");
  const std::string text = status && status->is_string() ? status->get<std::string>() : "ok";
  result.status = text == "ok"                    ? StepStatus::Ok
                  : text.starts_with("relaxed: ") ? StepStatus::Relaxed
                                                  : StepStatus::Failed;
  const std::size_t colon = text.find(": ");
  result.message = text == "ok" ? "" : colon == std::string::npos ? text : text.substr(colon + 2);
}

}  // namespace

Result<FrameSnapshotPtr> read_trace_frame(std::string_view line, std::uint64_t index,
                                          const Settings& settings, const std::string& where) {
  if (const char* beyond = json_beyond_bounds(line)) return Error{beyond, where};
  const Json json = Json::parse(line, nullptr, false);
  if (!json.is_object())
    return Error{"is no JSON object: a line of a trace is one frame; the file may have been cut off", where};
  LineReader reader(json, where);
  auto frame = std::make_shared<FrameSnapshot>();
  frame->index = index;
  frame->settings = settings;
  frame->time_s = reader.number("time");
  frame->input_frame = static_cast<std::int64_t>(reader.number("frame"));
  FrameResult& result = frame->result;
  const auto active = reader.pose(nullptr, "active", true);
  const auto passive = reader.pose(nullptr, "passive", true);
  const auto user = reader.pose("query", "world", false);
  if (reader.error()) return *reader.error();
  result.result << *active, *passive;
  result.query_world = user.value_or(*active);
  frame->user = result.query_world;
  take_mesh(reader, result, settings.edge_weights);
  take_selected(reader, result);
  take_contacts(reader, result);
  take_status(reader, result);
  if (reader.error()) return *reader.error();
  return FrameSnapshotPtr(std::move(frame));
}

}  // namespace abrazo
