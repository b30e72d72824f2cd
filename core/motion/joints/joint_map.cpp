#include "core/motion/joints/joint_map.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>

#include "core/base/limits.hpp"
#include "core/base/line_reader.hpp"

namespace abrazo {

namespace {

using OrderedJson = nlohmann::ordered_json;

class PointIndex {
 public:
  explicit PointIndex(const std::vector<std::string>& points) {
    for (std::size_t i = 0; i < points.size(); ++i) {
      exact_.emplace(points[i], static_cast<int>(i));
      plain_.emplace(plain_point_name(points[i]), static_cast<int>(i));
    }
  }
  /// -1 if there is no such point.
  int find(const std::string& name) const {
    if (const auto found = exact_.find(name); found != exact_.end()) return found->second;
    const auto found = plain_.find(plain_point_name(name));
    return found == plain_.end() ? -1 : found->second;
  }

 private:
  std::map<std::string, int> exact_, plain_;
};

Result<JointRule> parse_rule(const OrderedJson& json, const std::string& where) {
  JointRule rule;
  if (json.is_string()) {
    rule.terms.push_back({json.get<std::string>(), 1.0});
    return rule;
  }
  if (!json.is_object() || json.empty())
    return Error{
        R"(expected a point name, or weights such as {"Neck": 0.5, "Head": 0.5}, or a list of those)", where};
  double sum = 0;
  for (const auto& [point, weight] : json.items()) {
    if (!weight.is_number()) return Error{"the weight of '" + point + "' is not a number", where};
    rule.terms.push_back({point, weight.get<double>()});
    sum += rule.terms.back().weight;
  }
  if (std::abs(sum - 1.0) > 1e-6)
    return Error{"the weights add up to " + std::to_string(sum) + "; they must add up to 1", where};
  return rule;
}

Result<std::vector<JointRule>> parse_alternatives(const OrderedJson& json, const std::string& where) {
  std::vector<JointRule> rules;
  const OrderedJson list = json.is_array() ? json : OrderedJson::array({json});
  if (list.empty()) return Error{"the list of alternatives is empty", where};
  for (const OrderedJson& entry : list) {
    Result<JointRule> rule = parse_rule(entry, where);
    if (!rule) return rule.error();
    rules.push_back(std::move(*rule));
  }
  return rules;
}

}  // namespace

std::string plain_point_name(std::string_view name) {
  if (const auto colon = name.rfind(':'); colon != std::string_view::npos) name.remove_prefix(colon + 1);
  std::string plain;
  for (const char c : name)
    if (c != ' ' && c != '\t' && c != '_')
      plain += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  constexpr std::string_view exporter = "mixamorig";
  if (plain.starts_with(exporter) && plain.size() > exporter.size()) plain.erase(0, exporter.size());
  return plain;
}

std::string joint_map_json(const JointMap& map) {
  OrderedJson joints = OrderedJson::object();
  for (std::size_t j = 0; j < joint_count; ++j) {
    OrderedJson alternatives = OrderedJson::array();
    for (const JointRule& rule : map.rules[j]) {
      if (rule.terms.size() == 1 && rule.terms[0].weight == 1.0) {
        alternatives.push_back(rule.terms[0].point);
        continue;
      }
      OrderedJson weights = OrderedJson::object();
      for (const JointRule::Term& term : rule.terms) weights[term.point] = term.weight;
      alternatives.push_back(std::move(weights));
    }
    joints[std::string(joint_names[j])] = alternatives.size() == 1 ? alternatives[0] : alternatives;
  }
  return OrderedJson{{"name", map.name}, {"joints", joints}}.dump(2, ' ', false,
                                                                  OrderedJson::error_handler_t::replace) +
         "\n";
}

Result<JointMap> parse_joint_map(std::string_view text, std::string_view where) {
  const std::string file(where);
  if (const char* beyond = json_beyond_bounds(text)) return Error{beyond, file};
  OrderedJson json;
  try {
    json = OrderedJson::parse(text);
  } catch (const OrderedJson::parse_error& failure) {
    const auto end = text.begin() + static_cast<std::ptrdiff_t>(std::min(failure.byte, text.size()));
    return error_at(where, 1 + static_cast<int>(std::count(text.begin(), end, '\n')),
                    std::string("is not JSON: ") + failure.what());
  } catch (const OrderedJson::exception& failure) {  // a number too large for a double
    return Error{std::string("cannot be read: ") + failure.what(), file};
  }
  if (!json.is_object() || !json.contains("joints") || !json["joints"].is_object())
    return Error{R"(expected {"name": "...", "joints": {"root": "Hips", ...}})", file};
  JointMap map;
  map.name = json.contains("name") && json["name"].is_string() ? json["name"].get<std::string>() : file;
  for (const auto& [name, entry] : json["joints"].items()) {
    const auto joint = joint_index(name);
    if (!joint) return Error{"there is no joint '" + name + "' among the 25", file + ": joints"};
    Result<std::vector<JointRule>> rules = parse_alternatives(entry, file + ": joints." + name);
    if (!rules) return rules.error();
    map.rules[static_cast<std::size_t>(*joint)] = std::move(*rules);
  }
  std::string missing;
  for (std::size_t j = 0; j < joint_count; ++j)
    if (map.rules[j].empty()) missing += (missing.empty() ? "" : ", ") + std::string(joint_names[j]);
  if (!missing.empty()) return Error{"gives no point for " + missing, file + ": joints"};
  return map;
}

Pose JointBinding::joints_of(const Positions& points) const {
  Pose pose;
  for (int j = 0; j < joint_count; ++j) {
    pose.row(j).setZero();
    for (const auto& [point, weight] : terms[static_cast<std::size_t>(j)])
      pose.row(j) += weight * points.row(point);
  }
  return pose;
}

JointBinding bind_joints(const JointMap& map, const std::vector<std::string>& points) {
  const PointIndex index(points);
  JointBinding binding;
  for (int j = 0; j < joint_count; ++j) {
    const auto& rules = map.rules[static_cast<std::size_t>(j)];
    auto& terms = binding.terms[static_cast<std::size_t>(j)];
    std::size_t taken = 0;
    for (; taken < rules.size(); ++taken) {
      terms.clear();
      for (const JointRule::Term& term : rules[taken].terms)
        terms.emplace_back(index.find(term.point), term.weight);
      if (std::none_of(terms.begin(), terms.end(), [](const auto& term) { return term.first < 0; })) break;
    }
    if (taken == rules.size()) {
      terms.clear();
      binding.missing.push_back(j);
    } else if (taken > 0 && terms.size() > 1) {
      binding.estimated.push_back(j);
    }
  }
  return binding;
}

std::string describe_joint(const JointMap& map, int joint) {
  std::string points;
  for (const JointRule& rule : map.rules[static_cast<std::size_t>(joint)]) {
    if (!points.empty()) points += " or ";
    for (std::size_t t = 0; t < rule.terms.size(); ++t)
      points += (t > 0 ? " with " : "") + rule.terms[t].point;
  }
  const std::string name(joint_names[static_cast<std::size_t>(joint)]);
  return points.empty() ? name : name + " (" + points + ")";
}

}  // namespace abrazo
