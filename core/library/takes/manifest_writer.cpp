#include <algorithm>
#include <climits>
#include <nlohmann/json.hpp>

#include "core/library/takes/manifest.hpp"
#include "core/library/takes/performer_letter.hpp"

namespace abrazo {

namespace {

using OrderedJson = nlohmann::ordered_json;
namespace fs = std::filesystem;

/// Relative within or just beside the folder; a path that climbs to the root is less clear than an absolute
/// one and breaks as soon as either end moves.
std::string portable(const fs::path& path, const fs::path& folder) {
  if (path.empty()) return {};
  const fs::path whole = fs::absolute(path).lexically_normal();
  const fs::path relative = whole.lexically_relative(fs::absolute(folder).lexically_normal());
  const auto climbs = std::count(relative.begin(), relative.end(), "..");
  return (relative.empty() || climbs > 2 ? whole : relative).generic_string();
}

OrderedJson performer_json(const Manifest::Performer& performer, const fs::path& folder) {
  OrderedJson object = {{"motion", portable(performer.motion, folder)}};
  if (!performer.skeleton.empty()) object["skeleton"] = portable(performer.skeleton, folder);
  if (performer.index) object["performer"] = *performer.index;
  if (performer.start > 0) object["start"] = performer.start;
  if (performer.metres_per_unit) object["metres_per_unit"] = *performer.metres_per_unit;
  if (performer.up_axis) object["up_axis"] = name_of(*performer.up_axis);
  if (!performer.joints.empty())
    object["joints"] =
        is_builtin_joint_order(performer.joints) ? performer.joints : portable(performer.joints, folder);
  if (!performer.joint_map.empty())
    object["joint_map"] = is_builtin_joint_map(performer.joint_map) ? performer.joint_map
                                                                    : portable(performer.joint_map, folder);
  if (!performer.animation.empty()) object["animation"] = performer.animation;
  if (!performer.body_model.empty()) object["body_model"] = portable(performer.body_model, folder);
  return object;
}

OrderedJson roles_json(const std::vector<RoleInterval>& roles) {
  if (roles.empty()) return "unknown";
  if (roles.size() == 1 && roles[0].start == 0 && roles[0].end == INT_MAX) return letter_of(roles[0].active);
  OrderedJson list = OrderedJson::array();
  for (const RoleInterval& role : roles)
    list.push_back({{"start", role.start}, {"end", role.end}, {"active", letter_of(role.active)}});
  return list;
}

OrderedJson take_json(const Manifest::Take& take, const fs::path& folder) {
  OrderedJson object = {{"name", take.name}};
  if (take.fps) object["fps"] = *take.fps;
  if (take.metres_per_unit) object["metres_per_unit"] = *take.metres_per_unit;
  object["a"] = performer_json(take.a, folder);
  object["b"] = performer_json(take.b, folder);
  if (take.frames) object["frames"] = *take.frames;
  if (take.roles_tier.empty()) {
    object["roles"] = roles_json(take.roles);
  } else {
    object["roles"] = {{"tier", take.roles_tier}};
    if (!take.roles_file.empty()) object["roles"]["file"] = portable(take.roles_file, folder);
  }
  if (!take.move.empty()) object["labels"] = {{"move", take.move}};
  if (take.labels.empty()) return object;
  if (take.labels_tier.empty())
    object["labels"] = portable(take.labels, folder);
  else
    object["labels"] = {{"file", portable(take.labels, folder)}, {"tier", take.labels_tier}};
  return object;
}

}  // namespace

std::string manifest_json(const Manifest& manifest, const fs::path& folder) {
  OrderedJson takes = OrderedJson::array();
  for (const Manifest::Take& take : manifest.takes) takes.push_back(take_json(take, folder));
  return OrderedJson{{"name", manifest.name}, {"takes", takes}}.dump(1) + "\n";
}

}  // namespace abrazo
