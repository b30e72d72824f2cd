#include "core/motion/joints/joint_order.hpp"

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <set>

#include "core/base/atomic_file.hpp"
#include "core/base/limits.hpp"
#include "core/base/text.hpp"
#include "core/motion/joints/joint_map.hpp"

namespace abrazo {

namespace {

std::vector<std::string> own_points() {
  return {joint_names.begin(), joint_names.end()};
}

/// Hand and its fingers, as the sets of whole hands write them.
void add_fingers(std::vector<std::string>& points, const std::string& beginning) {
  for (const char* finger : {"Index", "Middle", "Pinky", "Ring", "Thumb"})
    for (const char* bone : {"1", "2", "3"}) points.push_back(beginning + finger + bone);
}

/// SMPL-H, as OmniRetarget's data has it.
std::vector<std::string> smplh_points() {
  std::vector<std::string> points = {"Pelvis",  "L_Hip", "L_Knee", "L_Ankle", "L_Toe", "R_Hip", "R_Knee",
                                     "R_Ankle", "R_Toe", "Torso",  "Spine",   "Chest", "Neck",  "Head"};
  for (const std::string side : {"L_", "R_"}) {
    for (const char* joint : {"Thorax", "Shoulder", "Elbow", "Wrist"}) points.push_back(side + joint);
    add_fingers(points, side);
  }
  return points;
}

/// SMPL-H, as its body model orders it: the body as in SMPL-X, then the fingers.
std::vector<std::string> smplh_model_points(std::vector<std::string> points) {
  for (const char* side : {"L_", "R_"}) add_fingers(points, side);
  return points;
}

std::vector<std::string> mocap_points() {
  std::vector<std::string> points = {"Hips", "Spine", "Spine1", "Neck", "Head"};
  for (const std::string side : {"Left", "Right"}) {
    for (const char* joint : {"Shoulder", "Arm", "ForeArm", "Hand"}) points.push_back(side + joint);
    for (const char* finger : {"Thumb", "Index", "Middle", "Ring", "Pinky"})
      for (const char* bone : {"1", "2", "3"}) points.push_back(side + "Hand" + finger + bone);
  }
  for (const std::string side : {"Left", "Right"})
    for (const char* joint : {"UpLeg", "Leg", "Foot", "ToeBase"}) points.push_back(side + joint);
  points.insert(points.end(), {"LeftFootMod", "RightFootMod"});
  return points;
}

using Terms = std::vector<std::pair<int, double>>;

Terms between(int from, int to, double fraction) {
  return {{from, 1 - fraction}, {to, fraction}};
}

/// What is not among the 25, by its name without capitals and underscores; nothing for other names.
Terms estimate_point(std::string_view plain) {
  bool is_left = true;
  const auto begins = [&](std::string_view word, bool left) {
    if (!plain.starts_with(word)) return false;
    plain.remove_prefix(word.size());
    is_left = left;
    return true;
  };
  if (!begins("left", true) && !begins("right", false) && !begins("l", true) && !begins("r", false))
    return {};
  const auto sided = [&](int left_joint) { return is_left ? left_joint : mirrored_joint(left_joint); };
  const int wrist = sided(joints::left_wrist), hand = sided(joints::left_hand);
  if (plain == "footmod") return {{sided(joints::left_ankle), 1.0}};
  if (plain == "shoulder" || plain == "collar" || plain == "thorax" || plain == "clavicle")
    return between(joints::LowerNeck, sided(joints::left_shoulder), 0.3);
  if (plain.starts_with("hand")) plain.remove_prefix(4);
  if (plain.empty() || plain.back() < '1' || plain.back() > '3') return {};
  const auto bone = static_cast<std::size_t>(plain.back() - '1');
  plain.remove_suffix(1);
  if (plain == "thumb") return between(wrist, hand, std::array{0.4, 0.8, 1.1}[bone]);
  constexpr std::array<std::string_view, 5> fingers = {"index", "middle", "ring", "pinky", "little"};
  if (std::ranges::find(fingers, plain) == fingers.end()) return {};
  return between(wrist, hand, std::array{1.0, 1.5, 1.8}[bone]);
}

/// Which joint a map takes each point as; -1 for none.
std::vector<int> joints_at(const JointMap& map, const std::vector<std::string>& points) {
  const JointBinding binding = bind_joints(map, points);
  std::vector<int> found(points.size(), -1);
  for (int j = 0; j < joint_count; ++j) {
    const auto& terms = binding.terms[static_cast<std::size_t>(j)];
    if (terms.size() != 1 || terms.front().second != 1.0) continue;
    int& joint = found[static_cast<std::size_t>(terms.front().first)];
    if (joint < 0) joint = j;
  }
  return found;
}

}  // namespace

const std::vector<JointOrder>& builtin_joint_orders() {
  static const std::vector<std::string> smplx_body = {
      "Pelvis",     "L_Hip",      "R_Hip",   "Spine1",  "L_Knee",  "R_Knee",   "Spine2",   "L_Ankle",
      "R_Ankle",    "Spine3",     "L_Foot",  "R_Foot",  "Neck",    "L_Collar", "R_Collar", "Head",
      "L_Shoulder", "R_Shoulder", "L_Elbow", "R_Elbow", "L_Wrist", "R_Wrist"};
  static const std::vector<JointOrder> orders = {
      {"abrazo25", own_points()},
      {"lafan22", {"Hips",         "RightUpLeg", "RightLeg",      "RightFoot", "RightToeBase", "LeftUpLeg",
                   "LeftLeg",      "LeftFoot",   "LeftToeBase",   "Spine",     "Spine1",       "Spine2",
                   "Neck",         "Head",       "RightShoulder", "RightArm",  "RightForeArm", "RightHand",
                   "LeftShoulder", "LeftArm",    "LeftForeArm",   "LeftHand"}},
      {"smplx22", smplx_body},
      {"smplh52", smplh_points()},
      {"smplhmodel52", smplh_model_points(smplx_body)},
      {"mocap53", mocap_points()},
  };
  return orders;
}

std::string joint_order_names() {
  std::string names;
  for (const JointOrder& order : builtin_joint_orders()) names += (names.empty() ? "" : ", ") + order.name;
  return names;
}

bool is_builtin_joint_order(std::string_view name) {
  return std::ranges::any_of(builtin_joint_orders(),
                             [&](const JointOrder& order) { return order.name == name; });
}

Result<JointOrder> find_joint_order(const std::string& name_or_file) {
  for (const JointOrder& order : builtin_joint_orders())
    if (order.name == name_or_file) return order;
  const auto text = read_whole_file(name_or_file);
  if (!text)
    return Error{"is no built-in joint order (" + joint_order_names() +
                     ") and no file that can be read: " + text.error().message,
                 name_or_file};
  return parse_joint_order(*text, name_or_file);
}

Result<JointOrder> parse_joint_order(std::string_view text, std::string_view where) {
  using Json = nlohmann::json;
  JointOrder order{std::string(where), {}};
  const Error expected{
      R"(expected the joints' names in their order, one a line or as ["Hips", "Spine", ...])",
      std::string(where)};
  if (trimmed(text).starts_with('[')) {
    if (const char* beyond = json_beyond_bounds(text)) return Error{beyond, std::string(where)};
    const Json list = Json::parse(text, nullptr, false);
    if (!list.is_array()) return expected;
    for (const Json& name : list) {
      if (!name.is_string()) return expected;
      order.points.push_back(name.get<std::string>());
    }
  } else {
    for (const std::string_view line : split_lines(text))
      if (!trimmed(line).empty()) order.points.emplace_back(trimmed(line));
  }
  if (order.points.empty() || text.find('\0') != std::string_view::npos) return expected;
  std::set<std::string> seen;
  for (const std::string& point : order.points)
    if (!seen.insert(point).second)
      return Error{"names " + in_quotes(point) + " twice; every joint stands once", std::string(where)};
  return order;
}

Result<OrderedPoints> OrderedPoints::of(const JointOrder& order) {
  std::vector<int> best;
  std::ptrdiff_t most = -1;
  for (const JointMap& map : builtin_joint_maps()) {
    std::vector<int> found = joints_at(map, order.points);
    const auto known = std::ranges::count_if(found, [](int joint) { return joint >= 0; });
    if (known > most) most = known, best = std::move(found);
  }
  OrderedPoints points;
  std::string unknown;
  for (std::size_t p = 0; p < order.points.size(); ++p) {
    points.terms_.push_back(best[p] >= 0 ? Terms{{best[p], 1.0}}
                                         : estimate_point(plain_point_name(order.points[p])));
    if (points.terms_.back().empty()) unknown += (unknown.empty() ? "" : ", ") + in_quotes(order.points[p]);
  }
  if (!unknown.empty())
    return Error{"has joints that do not follow from the 25: " + unknown + "; leave them out of the order",
                 order.name};
  return points;
}

Positions OrderedPoints::positions_of(const Pose& pose) const {
  Positions points(static_cast<Eigen::Index>(terms_.size()), 3);
  for (std::size_t p = 0; p < terms_.size(); ++p) {
    const auto& [first, weight] = terms_[p].front();
    const auto row = static_cast<Eigen::Index>(p);
    points.row(row) = weight * pose.row(first);
    for (std::size_t t = 1; t < terms_[p].size(); ++t)
      points.row(row) += terms_[p][t].second * pose.row(terms_[p][t].first);
  }
  return points;
}

}  // namespace abrazo
