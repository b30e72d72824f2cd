#include "core/library/takes/manifest.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <climits>
#include <initializer_list>
#include <nlohmann/json.hpp>
#include <set>

#include "core/base/atomic_file.hpp"
#include "core/base/limits.hpp"
#include "core/library/takes/refusal.hpp"

namespace abrazo {

namespace {

using nlohmann::json;
namespace fs = std::filesystem;

std::string_view json_type(const json& value) {
  return value.type_name();
}

/// A JSON value with its position, for messages.
struct ManifestNode {
  const json& value;
  std::string place;  ///< "manifest.json: takes[3].b"
  std::vector<std::string>& warnings;

  [[noreturn]] void refuse(std::string message) const { throw Refusal{{std::move(message), place}}; }

  ManifestNode at(const char* key) const {
    return {value.at(key), fmt::format("{}{}{}", place, place.ends_with(": ") ? "" : ".", key), warnings};
  }
  ManifestNode at(std::size_t index) const {
    return {value.at(index), fmt::format("{}[{}]", place, index), warnings};
  }
  bool has(const char* key) const { return value.contains(key) && !value.at(key).is_null(); }

  void expect_object(std::initializer_list<std::string_view> known) const {
    if (!value.is_object()) refuse(fmt::format("expected an object {{...}}, found {}", json_type(value)));
    for (const auto& [key, unused] : value.items())
      if (std::find(known.begin(), known.end(), key) == known.end())
        warnings.push_back(fmt::format("{}: \"{}\" is not read; known here are {}", place_text(), key,
                                       fmt::join(known, ", ")));
  }
  ManifestNode required(const char* key, const char* what) const {
    if (!has(key)) refuse(fmt::format("\"{}\" is missing; add {}", key, what));
    return at(key);
  }
  std::string string() const {
    if (!value.is_string()) refuse(fmt::format("expected a text in quotes, found {}", json_type(value)));
    if (value.get_ref<const std::string&>().empty()) refuse("is empty");
    return value.get<std::string>();
  }
  double positive() const {
    if (!value.is_number() || !(value.get<double>() > 0))
      refuse(fmt::format("expected a number above 0, found {}", value.dump()));
    return value.get<double>();
  }
  int frame() const {
    if (!value.is_number_integer()) refuse(fmt::format("expected a frame number, found {}", value.dump()));
    const auto number = value.get<long long>();
    if (number < 0 || number > INT_MAX)
      refuse(fmt::format("expected a frame number from 0 on, found {}", number));
    return static_cast<int>(number);
  }
  const json::array_t& array() const {
    if (!value.is_array()) refuse(fmt::format("expected a list [...], found {}", json_type(value)));
    return value.get_ref<const json::array_t&>();
  }
  std::string place_text() const { return place.ends_with(": ") ? place.substr(0, place.size() - 2) : place; }
};

ActivePerformer parse_performer(const ManifestNode& node) {
  const std::string text = node.string();
  if (text == "a") return ActivePerformer::A;
  if (text == "b") return ActivePerformer::B;
  if (text == "unknown") return ActivePerformer::Unknown;
  node.refuse(fmt::format("expected \"a\", \"b\" or \"unknown\", found \"{}\"", text));
}

RoleInterval parse_role(const ManifestNode& node) {
  node.expect_object({"start", "end", "active"});
  RoleInterval role;
  role.start = node.required("start", "the first frame").frame();
  role.end = node.required("end", "the frame after the last one").frame();
  role.active = parse_performer(node.required("active", "\"a\", \"b\" or \"unknown\""));
  if (role.end <= role.start)
    node.refuse(fmt::format("ends at frame {}, which is not after its start {}; end is exclusive", role.end,
                            role.start));
  return role;
}

std::vector<RoleInterval> parse_roles(const ManifestNode& node) {
  if (node.value.is_string()) {
    const ActivePerformer active = parse_performer(node);
    if (active == ActivePerformer::Unknown) return {};
    return {{0, INT_MAX, active}};
  }
  if (!node.value.is_array())
    node.refuse("expected \"a\", \"b\", \"unknown\" or a list of {\"start\", \"end\", \"active\"}");
  std::vector<RoleInterval> roles;
  for (std::size_t i = 0; i < node.array().size(); ++i) {
    const ManifestNode item = node.at(i);
    roles.push_back(parse_role(item));
    if (i > 0 && roles[i].start < roles[i - 1].end)
      item.refuse(fmt::format(
          "starts at frame {}, before the one above it ends ({}); give them in order and without overlap",
          roles[i].start, roles[i - 1].end));
  }
  return roles;
}

/// A letter or list as parse_roles has it, or {"tier": ..., "file": ...}.
void parse_take_roles(const ManifestNode& node, const fs::path& folder, Manifest::Take& take) {
  if (!node.value.is_object()) {
    take.roles = parse_roles(node);
    return;
  }
  node.expect_object({"tier", "file"});
  take.roles_tier = node.required("tier", "the tier of the label file that says who is active").string();
  if (node.has("file")) take.roles_file = folder / node.at("file").string();
  if (take.roles_file.empty() && take.labels.empty())
    node.refuse("names a tier but no file; add \"file\", or \"labels\" to the take");
}

/// A file, {"file": ..., "tier": ...}, or {"move": ...} of the whole take.
void parse_take_labels(const ManifestNode& node, const fs::path& folder, Manifest::Take& take) {
  if (!node.value.is_object()) {
    take.labels = folder / node.string();
    return;
  }
  node.expect_object({"file", "tier", "move"});
  if (node.has("move") && node.has("file"))
    node.refuse("has a file and a move; one of both says what the labels are");
  if (node.has("move")) {
    take.move = node.at("move").string();
    return;
  }
  take.labels = folder / node.required("file", "the label file").string();
  if (node.has("tier")) take.labels_tier = node.at("tier").string();
}

UpAxis parse_up_axis(const ManifestNode& node) {
  const std::string text = node.string();
  if (const auto up = find_up_axis(text)) return *up;
  node.refuse(fmt::format("expected an axis, {}, found \"{}\"", up_axis_names(), text));
}

Manifest::Performer parse_manifest_performer(const ManifestNode& node, const fs::path& folder) {
  node.expect_object({"motion", "skeleton", "performer", "start", "metres_per_unit", "up_axis", "joints",
                      "joint_map", "animation", "body_model"});
  Manifest::Performer performer;
  performer.motion = folder / node.required("motion", "the performer's motion file").string();
  if (node.has("skeleton")) performer.skeleton = folder / node.at("skeleton").string();
  if (node.has("performer")) performer.index = node.at("performer").frame();
  if (node.has("start")) performer.start = node.at("start").frame();
  if (node.has("metres_per_unit")) performer.metres_per_unit = node.at("metres_per_unit").positive();
  if (node.has("up_axis")) performer.up_axis = parse_up_axis(node.at("up_axis"));
  if (node.has("animation")) performer.animation = node.at("animation").string();
  if (node.has("body_model")) performer.body_model = folder / node.at("body_model").string();
  if (node.has("joints")) performer.joints = node.at("joints").string();
  if (!performer.joints.empty() && !is_builtin_joint_order(performer.joints))
    performer.joints = (folder / performer.joints).string();
  if (node.has("joint_map")) performer.joint_map = node.at("joint_map").string();
  if (!performer.joint_map.empty() && !is_builtin_joint_map(performer.joint_map))
    performer.joint_map = (folder / performer.joint_map).string();
  return performer;
}

Manifest::Take parse_take(const ManifestNode& node, const fs::path& folder) {
  node.expect_object({"name", "fps", "metres_per_unit", "a", "b", "frames", "roles", "labels"});
  Manifest::Take take;
  take.name = node.required("name", "a name that no other take has").string();
  if (node.has("fps")) take.fps = node.at("fps").positive();
  if (node.has("metres_per_unit")) take.metres_per_unit = node.at("metres_per_unit").positive();
  take.a = parse_manifest_performer(node.required("a", "the first performer, {\"motion\": ...}"), folder);
  take.b = parse_manifest_performer(node.required("b", "the second performer, {\"motion\": ...}"), folder);
  if (node.has("frames")) take.frames = node.at("frames").frame();
  if (node.has("labels")) parse_take_labels(node.at("labels"), folder, take);
  if (node.has("roles")) parse_take_roles(node.at("roles"), folder, take);
  return take;
}

Manifest parse_root(const ManifestNode& root, const fs::path& file) {
  root.expect_object({"name", "takes"});
  Manifest manifest;
  manifest.name = root.has("name") ? root.at("name").string() : file.stem().string();
  const ManifestNode takes = root.required("takes", "a list of takes");
  if (takes.array().empty()) takes.refuse("is empty; name at least one take");
  std::set<std::string> names;
  for (std::size_t i = 0; i < takes.array().size(); ++i) {
    manifest.takes.push_back(parse_take(takes.at(i), file.parent_path()));
    const std::string& name = manifest.takes.back().name;
    if (!names.insert(name).second)
      takes.at(i).refuse(fmt::format("the name \"{}\" is already taken by another take; rename one", name));
  }
  return manifest;
}

int line_of(std::string_view text, std::size_t byte) {
  return 1 +
         static_cast<int>(std::count(
             text.begin(), text.begin() + static_cast<std::ptrdiff_t>(std::min(byte, text.size())), '\n'));
}

}  // namespace

Result<Manifest> parse_manifest(std::string_view text, const fs::path& file) {
  if (const char* beyond = json_beyond_bounds(text)) return Error{beyond, file.string()};
  try {
    const json root = json::parse(text);
    std::vector<std::string> warnings;
    Manifest manifest = parse_root({root, file.string() + ": ", warnings}, file);
    manifest.warnings = std::move(warnings);
    return manifest;
  } catch (const json::parse_error& failure) {
    return Error{"is not JSON from here on; look for a missing comma, quote or bracket",
                 fmt::format("{}:{}", file.string(), line_of(text, failure.byte))};
  } catch (const json::out_of_range& failure) {
    return Error{std::string("holds a number that is too large: ") + failure.what(), file.string()};
  } catch (const Refusal& refusal) {
    Error error = refusal.error;
    if (error.where.ends_with(": ")) error.where.resize(error.where.size() - 2);
    return error;
  }
}

Result<Manifest> read_manifest(const fs::path& file) {
  auto text = read_whole_file(file);
  if (!text) return text.error();
  return parse_manifest(*text, file);
}

}  // namespace abrazo
