#include "core/motion/scenes/scene_hierarchy.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <unordered_map>

#include "core/base/limits.hpp"
#include "core/motion/scenes/fbx_records.hpp"
#include "core/motion/scenes/gltf_json.hpp"
#include "core/motion/scenes/xml_tags.hpp"

namespace abrazo {

namespace {

using Json = nlohmann::json;

/// The JSON of a .glb is its first chunk: length at byte 12, content from byte 20 on.
std::string_view gltf_json(std::string_view bytes) {
  if (!bytes.starts_with("glTF")) return bytes;
  if (bytes.size() < 20) return {};
  std::uint32_t length = 0;
  for (std::size_t i = 4; i-- > 0;) length = length << 8U | static_cast<unsigned char>(bytes[12 + i]);
  return bytes.substr(20, length);
}

/// Of two values of one key readers take either: what is checked here might not be what is read then.
class DoubledKeys {
 public:
  bool operator()(int depth, Json::parse_event_t event, Json& value) {
    if (event == Json::parse_event_t::object_start) {
      open_.resize(static_cast<std::size_t>(depth) + 1);
      open_.back().clear();
    } else if (event == Json::parse_event_t::key && !open_.empty()) {
      open_.resize(static_cast<std::size_t>(depth));
      if (!open_.back().insert(value.get<std::string>()).second) any_ = true;
    }
    return true;
  }
  bool any() const { return any_; }

 private:
  std::vector<std::set<std::string>> open_;  ///< keys of the objects that are open, by depth
  bool any_ = false;
};

/// Nodes by what the file calls them: version 2 numbers them, version 1 names them.
class GltfNodes {
 public:
  explicit GltfNodes(const Json& nodes) {
    for (const auto& item : nodes.items()) places_.emplace(item.key(), places_.size());
  }
  std::size_t size() const { return places_.size(); }

  /// Appends those that are named in `list`, which may be anything. @return false when one is not there
  bool add(const Json& list, std::vector<std::size_t>& below) const {
    for (const Json& name : list) {
      const auto found = places_.find(name.is_string() ? name.get<std::string>() : name.dump());
      if (found == places_.end()) return false;
      below.push_back(found->second);
    }
    return true;
  }

 private:
  std::map<std::string, std::size_t> places_;
};

/// A whole number of a damaged file: `otherwise` where there is none, none if it is something else.
std::optional<double> whole_number(const Json& value, double otherwise) {
  if (value.is_null()) return otherwise;
  if (!value.is_number()) return std::nullopt;
  const auto number = value.get<double>();
  return number >= 0 && number < 1e15 && number == std::floor(number) ? std::optional(number) : std::nullopt;
}

std::optional<double> bytes_of_a_value(const Json& accessor) {
  const Json &component = member(accessor, "componentType"), &type = member(accessor, "type");
  if (!component.is_number_integer() || !type.is_string()) return std::nullopt;
  const std::size_t bytes = gltf::bytes_of_component(component.get<std::int64_t>()) *
                            gltf::components_of(type.get_ref<const std::string&>());
  return bytes > 0 ? std::optional(static_cast<double>(bytes)) : std::nullopt;
}

/// Whether the values of an accessor lie in its view, and that in its buffer: readers copy them without
/// looking.
bool lies_in_its_buffer(const Json& accessor, const Json& root) {
  if (!accessor.is_object()) return false;
  const Json& name = member(accessor, "bufferView");
  if (name.is_null()) return true;  // zeros
  const Json& view = element(member(root, "bufferViews"), name);
  const Json& buffer = element(member(root, "buffers"), member(view, "buffer"));
  if (!view.is_object() || !buffer.is_object()) return false;
  const auto value = bytes_of_a_value(accessor), count = whole_number(member(accessor, "count"), 0),
             from = whole_number(member(accessor, "byteOffset"), 0),
             own_stride = whole_number(member(accessor, "byteStride"), 0),
             stride = whole_number(member(view, "byteStride"), 0),
             view_from = whole_number(member(view, "byteOffset"), 0),
             view_bytes = whole_number(member(view, "byteLength"), 0),
             buffer_bytes = whole_number(member(buffer, "byteLength"), 0);
  if (!value || !count || !from || !own_stride || !stride || !view_from || !view_bytes || !buffer_bytes)
    return false;
  const double apart = std::max({*value, *own_stride, *stride});
  const double end = *count > 0 ? *from + (*count - 1) * apart + *value : *from;
  return end <= *view_bytes && *view_from + *view_bytes <= *buffer_bytes;
}

Status check_accessors(const Json& root, const std::string& file) {
  for (const auto& item : member(root, "accessors").items())
    if (!lies_in_its_buffer(item.value(), root))
      return Error{"cannot be read as glTF: the values of accessor " + item.key() +
                       " lie outside of its buffer, or are of no known kind; export it again",
                   file};
  return Done{};
}

Result<SceneHierarchy> hierarchy_of_gltf(std::string_view bytes, const std::string& file) {
  const std::string_view json = gltf_json(bytes);
  if (const char* beyond = json_beyond_bounds(json)) return Error{beyond, file};
  DoubledKeys doubled;
  const Json root = Json::parse(json, std::ref(doubled), false);
  if (!root.is_object())
    return Error{"cannot be read as glTF: its JSON is damaged or cut short; export it again", file};
  if (doubled.any())
    return Error{
        "cannot be read as glTF: it has two values of one key, of which one cannot be meant; export it again",
        file};
  if (const Status inside = check_accessors(root, file); !inside) return inside.error();
  const Json& list = member(root, "nodes");
  const GltfNodes nodes(list);
  SceneHierarchy hierarchy;
  const auto add = [&](const Json& names, const std::string& whose) -> Status {
    if (nodes.add(names, hierarchy.emplace_back())) return Done{};
    return Error{"cannot be read as glTF: " + whose + " has a node below it that there is not; there are " +
                     std::to_string(nodes.size()) + " nodes. Export it again",
                 file};
  };
  for (const Json& node : list)
    if (const Status added = add(member(node, "children"), "node " + std::to_string(hierarchy.size()));
        !added)
      return added.error();
  // A scene may name a node several times, or one that hangs below another.
  for (const Json& scene : member(root, "scenes"))
    if (const Status added = add(member(scene, "nodes"), "a scene"); !added) return added.error();
  return hierarchy;
}

SceneHierarchy hierarchy_of_fbx(std::string_view bytes) {
  const FbxLinks links = fbx_links(bytes);
  std::unordered_map<std::uint64_t, std::size_t> places{{0, 0}};  // the scene itself is 0
  for (const std::uint64_t model : links.models) places.emplace(model, places.size());
  SceneHierarchy hierarchy(places.size());
  for (const auto& [child, parent] : links.connections)
    if (const auto from = places.find(parent), to = places.find(child);
        from != places.end() && to != places.end())
      hierarchy[from->second].push_back(to->second);
  return hierarchy;
}

/// Nodes stand inside each other, and name others that are to hang below them.
class ColladaNodes {
 public:
  void take(const XmlTag& tag) {
    if (tag.name == "instance_node" && !tag.closes && !open_.empty()) {
      const std::string_view url = tag.attribute("url");
      note(instances_, url.substr(std::min<std::size_t>(1, url.size())), open_.back());
    }
    if (tag.name != "node") return;
    if (tag.closes) {
      if (!open_.empty()) open_.pop_back();
    } else {
      add_node(tag);
      if (!tag.is_empty) open_.push_back(children_.size() - 1);
    }
  }

  /// A name that is called for is a place of its own, below which all that bear it hang: readers differ in
  /// whom they take.
  Result<SceneHierarchy> hierarchy(const std::string& file) && {
    if (has_references_ && !instances_.empty())
      return Error{
          "names nodes by character references such as &#97;, so that nobody can tell which hang below "
          "which; "
          "export it again",
          file};
    std::unordered_map<std::string_view, std::size_t> places;
    for (const auto& [name, node] : instances_) {
      const auto [place, is_new] = places.emplace(name, children_.size());
      if (is_new) children_.emplace_back();
      children_[node].push_back(place->second);
    }
    for (const auto& [name, node] : names_)
      if (const auto place = places.find(name); place != places.end())
        children_[place->second].push_back(node);
    return std::move(children_);
  }

 private:
  using Named = std::vector<std::pair<std::string_view, std::size_t>>;

  void note(Named& list, std::string_view name, std::size_t node) {
    has_references_ = has_references_ || name.find('&') != std::string_view::npos;
    list.emplace_back(name, node);
  }

  void add_node(const XmlTag& tag) {
    const std::size_t node = children_.size();
    children_.emplace_back();
    if (!open_.empty()) children_[open_.back()].push_back(node);
    const std::string_view id = tag.attribute("id"), name = tag.attribute("name");
    note(names_, id, node);
    if (name != id) note(names_, name, node);
  }

  SceneHierarchy children_;
  Named names_, instances_;
  std::vector<std::size_t> open_;
  bool has_references_ = false;
};

}  // namespace

Result<SceneHierarchy> scene_hierarchy(std::string_view bytes, MotionFormat format, const std::string& file) {
  if (format == MotionFormat::Collada) {
    ColladaNodes nodes;
    each_xml_tag(bytes, [&nodes](const XmlTag& tag) { nodes.take(tag); });
    return std::move(nodes).hierarchy(file);
  }
  if (format == MotionFormat::Fbx) return hierarchy_of_fbx(bytes);
  return hierarchy_of_gltf(bytes, file);
}

Status check_hierarchy(const SceneHierarchy& children, std::size_t deepest, std::size_t most_copies,
                       const std::string& file) {
  std::vector<std::size_t> parents(children.size(), 0), level(children.size(), 1), copies(children.size(), 0),
      ready;
  for (const auto& below : children)
    for (const std::size_t child : below) ++parents[child];
  for (std::size_t n = 0; n < children.size(); ++n)
    if (parents[n] == 0) ready.push_back(n), copies[n] = 1;
  std::size_t seen = 0, all_copies = 0;
  for (; !ready.empty(); ++seen) {
    const std::size_t node = ready.back();
    ready.pop_back();
    all_copies = std::min(most_copies + 1, all_copies + copies[node]);
    for (const std::size_t child : children[node]) {
      level[child] = std::max(level[child], level[node] + 1);
      copies[child] = std::min(most_copies + 1, copies[child] + copies[node]);
      if (--parents[child] == 0) ready.push_back(child);
    }
  }
  if (seen < children.size())
    return Error{"has nodes that hang below themselves, in a circle, which no skeleton does; it is damaged",
                 file};
  if (const auto greatest = std::max_element(level.begin(), level.end());
      greatest != level.end() && *greatest > deepest)
    return Error{"has nodes more than " + std::to_string(deepest) +
                     " deep below each other, which no skeleton has; it is damaged",
                 file};
  if (all_copies > most_copies)
    return Error{"has more than " + std::to_string(most_copies) + " nodes; export the skeletons alone", file};
  return Done{};
}

}  // namespace abrazo
