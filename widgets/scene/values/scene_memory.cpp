#include "widgets/scene/values/scene_memory.hpp"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <algorithm>
#include <cmath>

namespace abrazo::widgets {
namespace {

/// In the order of ScenePart; never change, they are in files.
constexpr std::array<const char*, scene_part_count> part_names = {
    "user",       "leader",      "follower", "selected_pair", "mesh_between", "mesh_within",
    "tetrahedra", "morph_steps", "bones",    "joints",        "foot_locks",   "collisions",
    "contacts",   "trails",      "floor",    "comparison",    "look_ahead"};
static_assert(part_names.back() != nullptr, "a part without a name is not remembered");
constexpr std::array<const char*, mesh_scalar_count> scalar_names = {"residual", "weight", "length_change",
                                                                     "energy"};
constexpr std::array<const char*, 4> mouse_names = {"abrazo", "blender", "maya", "vtk"};
constexpr std::array<const char*, 2> character_names = {"active_character", "passive_character"};
constexpr std::array<const char*, 2> map_names = {"viridis", "cividis"};

template <typename Enum, std::size_t Count>
void read(const QJsonObject& from, const char* name, const std::array<const char*, Count>& names,
          Enum& value) {
  const QString text = from.value(name).toString();
  const auto found = std::find_if(names.begin(), names.end(), [&text](const char* n) { return text == n; });
  if (found != names.end()) value = static_cast<Enum>(found - names.begin());
}

template <typename Enum, std::size_t Count>
QString name_of(Enum value, const std::array<const char*, Count>& names) {
  return names[static_cast<std::size_t>(value)];
}

void read(const QJsonObject& from, const char* name, double least, double most, double& value) {
  const double found = from.value(name).toDouble(value);
  if (found >= least && found <= most) value = found;
}

QJsonObject ranges_of(const SceneMemory& memory) {
  QJsonObject ranges;
  for (std::size_t s = 0; s < mesh_scalar_count; ++s)
    if (const auto& kept = memory.ranges[s]) ranges[scalar_names[s]] = QJsonArray{kept->lower, kept->upper};
  return ranges;
}

std::optional<KeptRange> range_of(const QJsonValue& value) {
  const QJsonArray ends = value.toArray();
  if (ends.size() != 2 || !ends[0].isDouble() || !ends[1].isDouble()) return std::nullopt;
  const KeptRange range{ends[0].toDouble(), ends[1].toDouble()};
  if (!(range.upper > 0 && range.lower < range.upper)) return std::nullopt;
  return range;
}

}  // namespace

SceneMemory without_session(SceneMemory memory) {
  memory.visibility = default_visibility;
  memory.ranges = {};
  memory.options.character_files = {};
  memory.options.isolates = false;
  memory.options.take_cut_of({});
  return memory;
}

QString text_of(const SceneMemory& memory) {
  QJsonObject shown;
  for (std::size_t p = 0; p < scene_part_count; ++p) shown[part_names[p]] = memory.visibility[p];
  const SceneOptions& options = memory.options;
  QJsonObject all{{"shown", shown},
                  {"colour_by", name_of(memory.scalar, scalar_names)},
                  {"shortest_edge_m", options.shortest_m},
                  {"least_value", options.least_value},
                  {"apart", options.apart},
                  {"trail_s", options.trail_s},
                  {"map", name_of(options.map, map_names)},
                  {"logarithmic", options.is_logarithmic},
                  {"parallel", options.is_parallel},
                  {"mouse", name_of(options.navigation, mouse_names)},
                  {"reference_beside", options.shows_reference_beside}};
  for (std::size_t body = 0; body < 2; ++body)
    if (!options.character_files[body].empty())
      all[character_names[body]] = QString::fromStdString(options.character_files[body]);
  if (std::isfinite(options.longest_m)) all["longest_edge_m"] = options.longest_m;
  if (std::isfinite(options.most_value)) all["most_value"] = options.most_value;
  if (const QJsonObject ranges = ranges_of(memory); !ranges.isEmpty()) all["ranges"] = ranges;
  return QJsonDocument(all).toJson(QJsonDocument::Compact);
}

SceneMemory scene_memory_of(const QString& text) {
  constexpr double longest_m = 3, most_apart = 2;
  const QJsonObject all = QJsonDocument::fromJson(text.toUtf8()).object();
  SceneMemory memory;
  const QJsonObject shown = all.value("shown").toObject();
  for (std::size_t p = 0; p < scene_part_count; ++p)
    memory.visibility[p] = shown.value(part_names[p]).toBool(memory.visibility[p]);
  read(all, "colour_by", scalar_names, memory.scalar);
  SceneOptions& options = memory.options;
  read(all, "shortest_edge_m", 0, longest_m, options.shortest_m);
  read(all, "longest_edge_m", 0, longest_m, options.longest_m);
  read(all, "least_value", 0, greatest_value, options.least_value);
  read(all, "most_value", 0, greatest_value, options.most_value);
  read(all, "apart", 0, most_apart, options.apart);
  read(all, "trail_s", shortest_trail_s, longest_trail_s, options.trail_s);
  read(all, "map", map_names, options.map);
  read(all, "mouse", mouse_names, options.navigation);
  for (std::size_t body = 0; body < 2; ++body)
    options.character_files[body] = all.value(character_names[body]).toString().toStdString();
  const QJsonObject ranges = all.value("ranges").toObject();
  for (std::size_t s = 0; s < mesh_scalar_count; ++s)
    memory.ranges[s] = range_of(ranges.value(scalar_names[s]));
  options.is_logarithmic = all.value("logarithmic").toBool();
  options.is_parallel = all.value("parallel").toBool();
  options.shows_reference_beside = all.value("reference_beside").toBool();
  return memory;
}

}  // namespace abrazo::widgets
