#include "core/session/file/decisions_json.hpp"

#include <array>
#include <nlohmann/json.hpp>
#include <utility>

#include "core/base/json_text.hpp"
#include "core/base/limits.hpp"

namespace abrazo {

namespace {

using Json = nlohmann::json;

constexpr std::array<std::pair<RoleControl, std::string_view>, 3> role_controls = {
    {{RoleControl::Hand, "hand"}, {RoleControl::Library, "library"}, {RoleControl::Leader, "leader"}}};

void write_optional(JsonText& json, std::string_view key, const std::optional<std::string>& text) {
  json.key(key);
  if (text)
    json.value(*text);
  else
    json.null();
}

std::optional<std::string> optional_text(const Json& object, const char* key) {
  const auto found = object.find(key);
  if (found == object.end() || !found->is_string()) return std::nullopt;
  return found->get<std::string>();
}

template <typename T>
void read_set(const Json& object, const char* key, std::set<T>& into) {
  const auto found = object.find(key);
  if (found == object.end() || !found->is_array()) return;
  for (const Json& one : *found) {
    if constexpr (std::is_same_v<T, int>) {
      if (one.is_number_integer()) into.insert(one.get<int>());
    } else {
      if (one.is_string()) into.insert(one.get<T>());
    }
  }
}

}  // namespace

std::string decisions_json(const Decisions& decisions) {
  const auto& [pinned, vetoes, meant, role_control] = decisions;
  JsonText json;
  json.begin_object().key("pinned");
  if (pinned)
    json.value(*pinned);
  else
    json.null();
  json.key("vetoes").begin_object().key("pairs").begin_array();
  for (const int pair : vetoes.pairs) json.value(pair);
  json.end_array().key("takes").begin_array();
  for (const std::string& take : vetoes.takes) json.value(take);
  json.end_array().key("labels").begin_array();
  for (const std::string& label : vetoes.labels) json.value(label);
  json.end_array().end_object().key("meant");
  if (meant) {
    const auto& [label, take, until_s, until_done] = *meant;
    json.begin_object();
    write_optional(json, "label", label);
    write_optional(json, "take", take);
    json.key("until_s").value(until_s).key("until_done").value(until_done).end_object();
  } else {
    json.null();
  }
  json.key("role_control");
  for (const auto& [control, name] : role_controls)
    if (control == role_control) json.value(name);
  return json.end_object().take();
}

Result<Decisions> parse_decisions(std::string_view json, std::string_view where) {
  if (const char* beyond = json_beyond_bounds(json)) return Error{beyond, std::string(where)};
  const Json parsed = Json::parse(json, nullptr, false);
  if (!parsed.is_object()) return Error{"an object of decisions is expected", std::string(where)};
  Decisions decisions;
  if (const auto pinned = parsed.find("pinned"); pinned != parsed.end() && pinned->is_number_integer())
    decisions.pinned = pinned->get<int>();
  if (const auto vetoes = parsed.find("vetoes"); vetoes != parsed.end() && vetoes->is_object()) {
    read_set(*vetoes, "pairs", decisions.vetoes.pairs);
    read_set(*vetoes, "takes", decisions.vetoes.takes);
    read_set(*vetoes, "labels", decisions.vetoes.labels);
  }
  if (const auto meant = parsed.find("meant"); meant != parsed.end() && meant->is_object()) {
    decisions.meant.emplace();
    decisions.meant->label = optional_text(*meant, "label");
    decisions.meant->take = optional_text(*meant, "take");
    if (const auto until = meant->find("until_s"); until != meant->end() && until->is_number())
      decisions.meant->until_s = until->get<double>();
    if (const auto done = meant->find("until_done"); done != meant->end() && done->is_boolean())
      decisions.meant->until_done = done->get<bool>();
  }
  const std::string control = optional_text(parsed, "role_control").value_or("hand");
  bool is_known = false;
  for (const auto& [value, name] : role_controls)
    if (control == name) {
      decisions.role_control = value;
      is_known = true;
    }
  if (!is_known) return Error{"'" + control + "' decides about no role", std::string(where)};
  return decisions;
}

}  // namespace abrazo
