#include "core/motion/joints/performers.hpp"

#include <algorithm>
#include <map>
#include <set>

#include "core/base/text.hpp"
#include "core/motion/joints/joint_map.hpp"
#include "core/motion/joints/marker_model.hpp"
#include "core/motion/joints/marker_words.hpp"

namespace abrazo {

namespace {

constexpr std::size_t fewest_points = 8;  ///< of a performer; fewer are a prop

/// "L", "right": of a name that is one of both sides, and of no performer.
bool is_side(std::string_view word) {
  const std::string plain = lower_case(word);
  return plain == "l" || plain == "r" || plain == "left" || plain == "right";
}

/// Where the point's own name begins.
std::size_t name_begin(const std::string& point, const std::string& marks,
                       const std::vector<std::string>& beginnings) {
  std::size_t begin = 0;
  for (const std::string& beginning : beginnings)
    if (point.size() > beginning.size() && point.starts_with(beginning))
      begin = std::max(begin, beginning.size());
  if (begin > 0) return begin;
  const auto mark = point.find_last_of(marks);
  if (mark == std::string::npos || mark == 0 || mark + 1 == point.size()) return 0;
  return is_side(std::string_view(point).substr(0, mark)) ? 0 : mark + 1;
}

std::string performer_name(std::string beginning) {
  while (beginning.size() > 1 && std::string(":._|- ").find(beginning.back()) != std::string::npos)
    beginning.pop_back();
  return beginning;
}

NamedMotion part_of(const NamedMotion& whole, const std::string& beginning, const std::vector<int>& points) {
  NamedMotion part;
  part.name = performer_name(beginning);
  part.fps = whole.fps, part.metres_per_unit = whole.metres_per_unit, part.up_axis = whole.up_axis;
  part.warnings = whole.warnings;
  std::vector<int> place(whole.points.size(), -1);
  for (const int point : points) {
    const auto p = static_cast<std::size_t>(point);
    place[p] = static_cast<int>(part.points.size());
    part.points.push_back(whole.points[p].substr(beginning.size()));
    int parent = whole.parents[p];
    while (parent >= 0 && place[static_cast<std::size_t>(parent)] < 0)
      parent = whole.parents[static_cast<std::size_t>(parent)];
    part.parents.push_back(parent < 0 ? -1 : place[static_cast<std::size_t>(parent)]);
  }
  part.frames.reserve(whole.frames.size());
  for (const Positions& frame : whole.frames)
    part.frames.emplace_back(frame(points, Eigen::seqN(0, Eigen::fix<3>)));
  return part;
}

/// Points with the same beginning, in the order in which the beginnings appear.
struct PointGroup {
  std::string beginning;
  std::vector<int> points;
};
using PointGroups = std::vector<PointGroup>;

template <class BeginOf>
PointGroups groups_by(const NamedMotion& motion, const BeginOf& begin_of) {
  PointGroups groups;
  std::map<std::string, std::size_t> places;
  for (std::size_t p = 0; p < motion.points.size(); ++p) {
    const std::string beginning = motion.points[p].substr(0, begin_of(motion.points[p]));
    const auto [place, is_new] = places.emplace(beginning, groups.size());
    if (is_new) groups.push_back({beginning, {}});
    groups[place->second].points.push_back(static_cast<int>(p));
  }
  return groups;
}

/// Whether the names, without their beginning, are those of a whole body that Abrazo knows.
bool is_known_body(const NamedMotion& motion, const PointGroup& group) {
  std::vector<std::string> names;
  for (const int point : group.points)
    names.push_back(motion.points[static_cast<std::size_t>(point)].substr(group.beginning.size()));
  return names.size() >= fewest_points &&
         (nearest_marker_model(names).missing.empty() || marker_model_by_words(names) ||
          std::ranges::any_of(builtin_joint_maps(),
                              [&](const JointMap& map) { return bind_joints(map, names).missing.empty(); }));
}

/// Some programs put another mark between performer and point: "Anna_LASI", "Ben-LASI". Taken only where it
/// gives known bodies, since most names have such marks themselves.
PointGroups groups_by_unusual_marks(const NamedMotion& motion) {
  const bool is_tree = std::ranges::any_of(motion.parents, [](int parent) { return parent >= 0; });
  const auto known = [&](const PointGroup& group) { return is_known_body(motion, group); };
  for (const char mark : {'_', '-', '.', ' '}) {
    if (is_tree) break;
    PointGroups groups = groups_by(motion, [mark](const std::string& point) -> std::size_t {
      const auto at = point.find(mark);
      return at == std::string::npos || at == 0 || at + 1 == point.size() || is_side(point.substr(0, at))
                 ? 0
                 : at + 1;
    });
    if (std::ranges::any_of(
            groups, [&](const PointGroup& group) { return !group.beginning.empty() && known(group); }))
      return groups;
  }
  return {};
}

/// Of points without a beginning: somebody whose capture also has a box with one, or nobody.
bool is_somebody_without_prefix(const NamedMotion& motion, const PointGroups& groups) {
  const auto known = [&](const PointGroup& group) { return is_known_body(motion, group); };
  const auto group = std::ranges::find(groups, std::string(), &PointGroup::beginning);
  if (group == groups.end() || group->points.size() < fewest_points) return false;
  return known(*group) || std::ranges::none_of(groups, known);
}

}  // namespace

std::string some_of(const std::vector<std::string>& names, std::size_t most) {
  std::string text;
  for (std::size_t i = 0; i < names.size() && i < most; ++i) text += (i > 0 ? ", " : "") + names[i];
  if (names.size() > most) text += " and " + std::to_string(names.size() - most) + " more";
  return text;
}

void make_names_unique(std::vector<std::string>& names, const std::string& what,
                       std::vector<ImportWarning>& warnings) {
  std::set<std::string> known;
  std::vector<std::string> doubled;
  for (std::string& name : names) {
    const std::string wanted = name;
    for (int n = 2; !known.insert(name).second; ++n) name = wanted + "_" + std::to_string(n);
    if (name != wanted) doubled.push_back(wanted);
  }
  if (!doubled.empty())
    warnings.push_back({"duplicate-name", 0,
                        "more than one " + what + " is called " + some_of(doubled) +
                            "; the later ones got a number behind their name"});
}

std::vector<NamedMotion> split_performers(NamedMotion motion, const std::string& marks,
                                          const std::vector<std::string>& beginnings) {
  PointGroups groups =
      groups_by(motion, [&](const std::string& point) { return name_begin(point, marks, beginnings); });
  if (std::ranges::none_of(groups, [&](const PointGroup& each) { return is_known_body(motion, each); }))
    if (PointGroups others = groups_by_unusual_marks(motion); !others.empty()) groups = std::move(others);
  const bool has_prefixes = std::ranges::any_of(groups, [](const PointGroup& group) {
    return !group.beginning.empty() && group.points.size() >= fewest_points;
  });
  if (!has_prefixes) {
    std::vector<NamedMotion> whole;
    whole.push_back(std::move(motion));
    return whole;
  }
  const bool somebody_without = is_somebody_without_prefix(motion, groups);
  std::vector<NamedMotion> performers;
  std::vector<std::string> left_out;
  for (const PointGroup& group : groups) {
    const bool is_one = group.beginning.empty() ? somebody_without : group.points.size() >= fewest_points;
    if (is_one) {
      performers.push_back(part_of(motion, group.beginning, group.points));
      if (group.beginning.empty()) performers.back().name = motion.name;
      continue;
    }
    for (const int point : group.points) left_out.push_back(motion.points[static_cast<std::size_t>(point)]);
  }
  // An armature's own node, which everything hangs on, is not missed.
  std::erase_if(left_out, [&](const std::string& point) {
    const auto place = std::find(motion.points.begin(), motion.points.end(), point) - motion.points.begin();
    return std::count(motion.parents.begin(), motion.parents.end(), static_cast<int>(place)) > 0;
  });
  if (!left_out.empty())
    performers.front().warnings.push_back(
        {"left-out", 0,
         std::to_string(left_out.size()) +
             " points belong to no performer and were left out: " + some_of(left_out)});
  std::vector<std::string> names;
  for (NamedMotion& performer : performers) {
    make_names_unique(performer.points, "point", performer.warnings);
    names.push_back(performer.name);
  }
  make_names_unique(names, "performer", performers.front().warnings);
  for (std::size_t i = 0; i < names.size(); ++i) performers[i].name = names[i];
  return performers;
}

void strip_common_beginning(std::vector<std::string>& names) {
  if (names.size() < fewest_points) return;
  std::string_view common = names.front();
  for (const std::string& name : names)
    while (!name.starts_with(common)) common.remove_suffix(1);
  const auto mark = common.find_last_of("_:|.-");
  if (mark == std::string_view::npos) return;
  const std::size_t length = mark + 1;
  if (std::any_of(names.begin(), names.end(), [&](const std::string& name) { return name.size() == length; }))
    return;
  for (std::string& name : names) name.erase(0, length);
}

}  // namespace abrazo
