#include "core/motion/joints/skeleton_map.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <string>
#include <utility>

#include "core/base/text.hpp"
#include "core/motion/body/body_proportions.hpp"
#include "core/motion/joints/joint_guess.hpp"
#include "core/motion/joints/sided_name.hpp"

namespace abrazo {

namespace {

using namespace joints;
using Words = std::vector<const char*>;

constexpr double toe_base_of_toe_tip = 0.7;  ///< from the ankle to where the toes end
constexpr double hand_of_fingers = 0.5;      ///< from the wrist to where the fingers end
constexpr double head_of_crown = 0.6;        ///< from the head's joint to its top
constexpr double head_beyond_neck = 2.2;     ///< from the neck over the head's joint
constexpr double toe_base_below = 1.15,
                 toe_tip_below = 1.2;  ///< from the knee over the ankle: finds the floor

std::size_t index_of(int i) {
  return static_cast<std::size_t>(i);
}

JointRule between(const NamedMotion& motion, int from, int to, double fraction) {
  if (fraction == 1 || from == to) return {{{motion.points[index_of(to)], 1.0}}};
  return {{{motion.points[index_of(from)], 1.0 - fraction}, {motion.points[index_of(to)], fraction}}};
}

/// Names of the limbs' joints, the clearest first; the end joint of a bone is the start of the next.
struct LimbNames {
  Words hip = {"upleg",    "thigh", "thighbend", "upperleg", "upperthigh",
               "legupper", "hip",   "hipjoint",  "femur",    "leg"};
  Words knee = {"shin", "calf", "lowerleg", "leglower", "lowleg", "knee", "leg", "tibia", "crus"};
  Words ankle = {"ankle", "foot", "feet"};
  Words toe_base = {"toebase", "toe", "toes", "toe0", "ball", "toe1", "metatarsals", "foot", "bigtoe"};
  Words shoulder = {"upperarm",  "uparm",    "uarm",    "arm",           "shldr",
                    "shldrbend", "armupper", "humerus", "uppershoulder", "shoulder"};
  Words elbow = {"forearm", "forearmbend", "lowerarm", "armlower", "lowarm",
                 "loarm",   "elbow",       "radius",   "farm"};
  Words wrist = {"wrist", "hand"};
  Words hand = {"handmiddle1", "middle1",    "middle01", "middleproximal", "mid1",    "fingermiddle1",
                "finger2",     "handindex1", "index1",   "index01",        "finger1", "hand"};
};

class SkeletonReader {
 public:
  explicit SkeletonReader(const NamedMotion& motion);
  SkeletonMap read();

 private:
  int find(const Words& words, int side, const std::set<int>& taken = {}) const;
  bool is_below(int point, int above) const;
  std::vector<int> way_up(int from, int to) const;
  void limbs(int side);
  void trunk();
  void spine(const std::vector<int>& way);
  void set(int joint, JointRule rule) { result_.map.rules[index_of(joint)] = {std::move(rule)}; }
  int at(int joint) const { return points_[index_of(joint)]; }

  const NamedMotion& motion_;
  std::vector<SidedName> names_;
  std::array<int, joint_count> points_{};
  SkeletonMap result_;
};

using NameParts = std::vector<std::string>;

/// Removes a first or last part that most names share and that has no meaning: "Bip01", "J Bip",
/// "Character1"; "JNT".
/// @param at  the place of the part in a name
void drop_common_part(std::vector<NameParts>& all, NameParts::iterator (*at)(NameParts&)) {
  for (bool again = true; again;) {
    again = false;
    std::map<std::string, std::size_t> counts;
    for (NameParts& parts : all)
      if (parts.size() > 1) ++counts[*at(parts)];
    for (const auto& [part, count] : counts) {
      if (5 * count < 3 * all.size() || sided_name(NameParts{part}).side != 0) continue;
      for (NameParts& parts : all)
        if (parts.size() > 1 && *at(parts) == part) parts.erase(at(parts));
      again = true;
    }
  }
}

/// Some exporters number every node: "Hips_01", "LeftArm_015".
void drop_running_numbers(std::vector<NameParts>& all) {
  const auto is_numbered = [](const NameParts& parts) {
    return parts.size() > 1 && parts.back().find_first_not_of("0123456789") == std::string::npos;
  };
  if (5 * static_cast<std::size_t>(std::ranges::count_if(all, is_numbered)) < 4 * all.size()) return;
  for (NameParts& parts : all)
    if (is_numbered(parts)) parts.pop_back();
}

/// "lfemur" and "rfemur" are the two sides of a limb's bone.
void part_glued_sides(std::vector<SidedName>& names) {
  const LimbNames limbs;
  const auto is_limb = [&](const std::string& word) {
    for (const Words* words : {&limbs.hip, &limbs.knee, &limbs.ankle, &limbs.toe_base, &limbs.shoulder,
                               &limbs.elbow, &limbs.wrist})
      if (std::ranges::any_of(*words, [&](const char* each) { return word == each; })) return true;
    return false;
  };
  std::set<std::string> whole;
  for (const SidedName& name : names)
    if (name.side == 0) whole.insert(name.word);
  for (SidedName& name : names) {
    if (name.side != 0 || name.word.size() < 2) continue;
    const std::string limb = name.word.substr(1);
    if (is_limb(limb) && whole.contains("l" + limb) && whole.contains("r" + limb))
      name = {limb, name.word.front() == 'l' ? 1 : -1};
  }
}

std::vector<SidedName> names_without_ornament(const std::vector<std::string>& points) {
  std::vector<NameParts> all;
  for (const std::string& point : points) all.push_back(name_parts(point));
  drop_running_numbers(all);
  drop_common_part(all, [](NameParts& parts) { return parts.begin(); });
  drop_common_part(all, [](NameParts& parts) { return parts.end() - 1; });
  std::vector<SidedName> names;
  for (NameParts& parts : all) {
    // "C" and "M" of the middle, as others have "L" and "R".
    if (parts.size() > 1 && parts.front() == "c") parts.erase(parts.begin());
    if (parts.size() > 1 && (parts.back() == "m" || parts.back() == "c")) parts.pop_back();
    names.push_back(sided_name(parts));
  }
  part_glued_sides(names);
  return names;
}

SkeletonReader::SkeletonReader(const NamedMotion& motion)
    : motion_(motion), names_(names_without_ornament(motion.points)) {
  points_.fill(-1);
}

int SkeletonReader::find(const Words& words, int side, const std::set<int>& taken) const {
  for (const char* word : words)
    for (std::size_t p = 0; p < names_.size(); ++p)
      if (names_[p].side == side && names_[p].word == word && !taken.contains(static_cast<int>(p)))
        return static_cast<int>(p);
  return -1;
}

bool SkeletonReader::is_below(int point, int above) const {
  for (; point >= 0; point = motion_.parents[index_of(point)])
    if (point == above) return true;
  return false;
}

/// Path from a point to an ancestor, both included; empty if it is not an ancestor.
std::vector<int> SkeletonReader::way_up(int from, int to) const {
  std::vector<int> way;
  for (int point = from; point >= 0; point = motion_.parents[index_of(point)]) {
    way.push_back(point);
    if (point == to) return way;
  }
  return {};
}

/// Each joint must be a descendant of the previous: "LeftShoulder" is the collar if there is a "LeftArm".
void SkeletonReader::limbs(int side) {
  const LimbNames names;
  const auto chain = [&](const std::vector<std::pair<int, const Words*>>& wanted) {
    std::set<int> taken;
    int above = -1;
    for (const auto& [joint, words] : wanted) {
      for (int point = find(*words, side, taken); point >= 0; point = find(*words, side, taken)) {
        taken.insert(point);
        if (above >= 0 && (point == above || !is_below(point, above))) continue;
        points_[index_of(side > 0 ? joint : mirrored_joint(joint))] = above = point;
        break;
      }
    }
  };
  chain({{left_hip, &names.hip},
         {left_knee, &names.knee},
         {left_ankle, &names.ankle},
         {left_toe_base, &names.toe_base}});
  chain({{left_shoulder, &names.shoulder},
         {left_elbow, &names.elbow},
         {left_wrist, &names.wrist},
         {left_hand, &names.hand}});
}

/// Hips, neck and head, and the chain between them.
void SkeletonReader::trunk() {
  int root = find({"hips", "pelvis", "hip"}, 0);
  const int left = at(left_hip), right = at(right_hip);
  if (root < 0)  // whatever both legs hang on
    for (int p = left; p >= 0 && root < 0; p = motion_.parents[index_of(p)])
      if (p != left && is_below(right, p)) root = p;
  const int head = find({"head", "skull", "spine006"}, 0);  // the last of Rigify
  int neck = find({"neck", "neck1", "neck01", "necklower", "lowerneck", "neck0", "spine004"}, 0);
  if (neck < 0 && head >= 0) neck = motion_.parents[index_of(head)];
  points_[Root] = root, points_[UpperNeck] = head, points_[LowerNeck] = neck;
  if (root < 0 || neck < 0) return;
  std::vector<int> way = way_up(neck, root);
  if (way.empty()) {  // spine and hips hang side by side: from where both do
    for (int p = motion_.parents[index_of(root)]; p >= 0 && way.empty(); p = motion_.parents[index_of(p)]) {
      way = way_up(neck, p);
      if (!way.empty()) way.back() = root;
    }
  }
  std::reverse(way.begin(), way.end());
  if (way.size() >= 2) spine(way);
}

/// The joints of the spine at usual heights between root and neck: where the file has one near, there.
void SkeletonReader::spine(const std::vector<int>& way) {
  const Positions& frame = motion_.frames[frame_to_look_at(motion_)];
  std::vector<double> along = {0};
  for (std::size_t k = 1; k < way.size(); ++k)
    along.push_back(along.back() + (frame.row(way[k]) - frame.row(way[k - 1])).norm());
  if (!(along.back() > 0)) return;
  constexpr double near = 0.13;
  std::size_t used = 0;
  for (const auto& [joint, usual] : {std::pair(LowerBack, 0.27), {UpperBack, 0.53}, {Thorax, 0.79}}) {
    const double wanted = usual * along.back();
    std::size_t best = 0;
    for (std::size_t k = used + 1; k + 1 < way.size(); ++k)
      if (best == 0 || std::abs(along[k] - wanted) < std::abs(along[best] - wanted)) best = k;
    if (best > 0 && std::abs(along[best] - wanted) < near * along.back()) {
      set(joint, between(motion_, way[best], way[best], 1));
      used = best;
      continue;
    }
    std::size_t next = 1;
    while (along[next] < wanted) ++next;
    const double length = along[next] - along[next - 1];
    set(joint, between(motion_, way[next - 1], way[next], (wanted - along[next - 1]) / length));
    result_.inferred.push_back(joint);
  }
}

SkeletonMap SkeletonReader::read() {
  result_.map.name = "skeleton";
  const bool is_tree =
      std::any_of(motion_.parents.begin(), motion_.parents.end(), [](int p) { return p >= 0; });
  if (is_tree && !motion_.frames.empty()) {
    limbs(1), limbs(-1);
    trunk();
    for (int j = 0; j < joint_count; ++j)
      if (at(j) >= 0) set(j, between(motion_, at(j), at(j), 1));
    const std::vector<int> ends = infer_ends(result_.map, motion_);
    result_.inferred.insert(result_.inferred.end(), ends.begin(), ends.end());
  }
  for (int j = 0; j < joint_count; ++j)
    if (result_.map.rules[index_of(j)].empty()) result_.missing.push_back(j);
  return std::move(result_);
}

/// The single point of a joint's rule; -1 if there are several or none.
int point_of(const JointMap& map, int joint, const NamedMotion& motion) {
  const auto& rules = map.rules[index_of(joint)];
  if (rules.empty() || rules.front().terms.size() != 1) return -1;
  const auto found = std::find(motion.points.begin(), motion.points.end(), rules.front().terms.front().point);
  return found == motion.points.end() ? -1 : static_cast<int>(found - motion.points.begin());
}

bool is_an_end(const std::string& point) {
  static constexpr std::array ends = {"end", "nub", "site", "top", "tip"};
  const std::string word = sided_name(point).word;
  return std::any_of(ends.begin(), ends.end(),
                     [&](const char* end) { return word.find(end) != std::string::npos; });
}

/// What ends the limb behind a point: its only child, or the one that is called an end.
int end_behind(const NamedMotion& motion, int point) {
  std::vector<int> children;
  for (std::size_t p = 0; p < motion.parents.size(); ++p)
    if (motion.parents[p] == point) children.push_back(static_cast<int>(p));
  for (const int child : children)
    if (is_an_end(motion.points[index_of(child)])) return child;
  return children.size() == 1 ? children.front() : -1;
}

/// The farthest chain below a point, itself first.
std::vector<int> chain_below(const NamedMotion& motion, int point) {
  const Positions& frame = motion.frames[frame_to_look_at(motion)];
  std::vector<int> chain = {point};
  double farthest = -1;
  for (std::size_t p = 0; p < motion.parents.size(); ++p) {
    std::vector<int> way;
    for (int above = static_cast<int>(p); above >= 0; above = motion.parents[index_of(above)]) {
      way.push_back(above);
      if (above == point) break;
    }
    const double distance = (frame.row(static_cast<Eigen::Index>(p)) - frame.row(point)).norm();
    if (way.size() < 2 || way.back() != point || distance <= farthest) continue;
    farthest = distance;
    chain.assign(way.rbegin(), way.rend());
  }
  return chain;
}

/// Whether the end has a plausible distance: exporters write ends of length 0.
bool reaches(const NamedMotion& motion, int point, int end, double limb) {
  const Positions& frame = motion.frames[frame_to_look_at(motion)];
  const double length = (frame.row(end) - frame.row(point)).norm();
  return length > 0.1 * limb && length < 1.2 * limb;
}

double length_of(const NamedMotion& motion, int from, int to) {
  const Positions& frame = motion.frames[frame_to_look_at(motion)];
  return (frame.row(from) - frame.row(to)).norm();
}

}  // namespace

std::vector<int> infer_ends(JointMap& map, const NamedMotion& motion) {
  std::vector<int> inferred;
  if (motion.frames.empty()) return inferred;
  const auto infer = [&](int joint, JointRule rule) {
    auto& rules = map.rules[index_of(joint)];
    if (!rules.empty()) return;
    rules = {std::move(rule)};
    inferred.push_back(joint);
  };
  // "LeftForeFoot", "toe1-1.l": a foot of two parts, whatever they are called.
  const auto foot_of_parts = [&](int knee, int ankle, int toe_base, int toe_tip) {
    const std::vector<int> chain = chain_below(motion, ankle);
    if (chain.size() < 3 || !map.rules[index_of(toe_base)].empty()) return;
    const int middle = chain[1], tip = chain.back();
    const double first = length_of(motion, ankle, middle), second = length_of(motion, middle, tip);
    const double shin = length_of(motion, knee, ankle);
    if (!(first + second > 0.3 * shin && first + second < 1.2 * shin)) return;
    const double share = first / (first + second);
    if (share > 0.4 && share < 0.9) {
      map.rules[index_of(toe_base)] = {between(motion, middle, middle, 1)};
      map.rules[index_of(toe_tip)] = {between(motion, tip, tip, 1)};
      return;
    }
    const double wanted = toe_base_of_toe_tip * (first + second);
    infer(toe_base, wanted < first ? between(motion, ankle, middle, wanted / first)
                                   : between(motion, middle, tip, (wanted - first) / second));
    infer(toe_tip, between(motion, tip, tip, 1));
  };
  const auto usable_end = [&](int before, int point) {
    const int end = end_behind(motion, point);
    return end >= 0 && reaches(motion, point, end, length_of(motion, before, point)) ? end : -1;
  };
  for (const bool is_left : {true, false}) {
    const auto side = [is_left](int joint) { return is_left ? joint : mirrored_joint(joint); };
    const int knee = point_of(map, side(left_knee), motion), ankle = point_of(map, side(left_ankle), motion);
    if (knee >= 0 && ankle >= 0) {
      foot_of_parts(knee, ankle, side(left_toe_base), side(left_toe_tip));
      const int toe_base = point_of(map, side(left_toe_base), motion);
      const int end = usable_end(knee, ankle);
      if (toe_base >= 0) {
        const int tip = end_behind(motion, toe_base);
        infer(side(left_toe_tip),
              tip >= 0 && reaches(motion, toe_base, tip, length_of(motion, ankle, toe_base))
                  ? between(motion, tip, tip, 1)
                  : between(motion, ankle, toe_base, toe_tip_beyond_foot));
      } else if (end >= 0) {
        infer(side(left_toe_base), between(motion, ankle, end, toe_base_of_toe_tip));
        infer(side(left_toe_tip), between(motion, end, end, 1));
      } else {
        infer(side(left_toe_base), between(motion, knee, ankle, toe_base_below));
        infer(side(left_toe_tip), between(motion, knee, ankle, toe_tip_below));
      }
    }
    const int elbow = point_of(map, side(left_elbow), motion);
    if (elbow < 0) continue;
    int wrist = point_of(map, side(left_wrist), motion);
    if (wrist < 0) {
      const int shoulder = point_of(map, side(left_shoulder), motion);
      wrist = shoulder >= 0 ? usable_end(shoulder, elbow) : -1;
      if (wrist >= 0) infer(side(left_wrist), between(motion, wrist, wrist, 1));
    }
    if (wrist < 0) continue;
    const int end = usable_end(elbow, wrist);
    infer(side(left_hand), end >= 0 ? between(motion, wrist, end, hand_of_fingers)
                                    : between(motion, elbow, wrist, hand_beyond_forearm));
  }
  const int neck = point_of(map, LowerNeck, motion), head = point_of(map, UpperNeck, motion);
  if (neck < 0 || head < 0) return inferred;
  const int crown = usable_end(neck, head) >= 0 || neck == head ? end_behind(motion, head) : -1;
  infer(Head, crown >= 0 && is_an_end(motion.points[index_of(crown)])
                  ? between(motion, head, crown, head_of_crown)
                  : between(motion, neck, head, head_beyond_neck));
  return inferred;
}

SkeletonMap skeleton_map(const NamedMotion& motion) {
  return SkeletonReader(motion).read();
}

}  // namespace abrazo
