#include "core/motion/joints/joint_guess.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <set>

#include "core/base/text.hpp"
#include "core/motion/joints/sided_name.hpp"

namespace abrazo {

namespace {

using enum JointGuess::By;

/// The words a joint may be called by, the clearest first. The side is determined separately.
struct Words {
  int joint;
  std::array<const char*, 7> words;
};
constexpr std::array<Words, 16> vocabulary = {{
    {joints::Root, {"hips", "pelvis", "root", "hip", "waist", "sacrum", nullptr}},
    {joints::LowerBack, {"lowerback", "spine", "spine0", "abdomen", "lumbar", "ab", "l5"}},
    {joints::UpperBack, {"upperback", "spine1", "chest", "t12", "torso", "spine01", nullptr}},
    {joints::Thorax, {"thorax", "spine2", "upperchest", "chest2", "sternum", "t8", "spine3"}},
    {joints::LowerNeck, {"lowerneck", "neck", "c7", "neck1", "necklower", nullptr, nullptr}},
    {joints::UpperNeck, {"upperneck", "head", "neck2", "skull", "neckupper", nullptr, nullptr}},
    {joints::Head, {"headtop", "headend", "head", "nose", "crown", "headmid", "headcentre"}},
    {joints::left_hip, {"upleg", "thigh", "hip", "upperleg", "hipjoint", "femur", "hjc"}},
    {joints::left_knee, {"knee", "leg", "shin", "calf", "lowerleg", "kjc", "kne"}},
    {joints::left_ankle, {"ankle", "foot", "ajc", "ank", "tibia", "heel", nullptr}},
    {joints::left_toe_base, {"toebase", "toe", "ball", "toes", "forefoot", "bigtoe", "metatarsal"}},
    {joints::left_toe_tip, {"toeend", "toebaseend", "toetip", "toesend", "smalltoe", "littletoe", nullptr}},
    {joints::left_shoulder, {"uparm", "upperarm", "arm", "shoulder", "humerus", "sjc", "sho"}},
    {joints::left_elbow, {"elbow", "forearm", "lowerarm", "ejc", "elb", "radius", nullptr}},
    {joints::left_wrist, {"wrist", "hand", "wjc", "wri", "palm", nullptr, nullptr}},
    {joints::left_hand, {"handend", "middle1", "hand", "middlefinger", "finger", "knuckle", "index1"}},
}};

/// 1 for the clearest word, less for others, 0 if the name does not indicate the joint.
double similarity(const std::string& name, const Words& words) {
  double best = 0, worth = 1.0;
  for (const char* word : words.words) {
    if (!word) break;
    const std::string_view known(word);
    if (name == known) best = std::max(best, worth);
    if (known.size() > 3 && (name.starts_with(known) || name.ends_with(known)))
      best = std::max(best, 0.5 * worth);
    worth -= 0.05;
  }
  return best;
}

/// A standing person of 1 m to the head, facing +Z: left is +X.
const Pose& usual_person() {
  static const Pose pose = [] {
    Pose p;
    p << 0, .594, 0, .05, .544, 0, .06, .294, .02, .06, .056, 0, .07, .025, .075, .07, .02, .12,  //
        -.05, .544, 0, -.06, .294, .02, -.06, .056, 0, -.07, .025, .075, -.07, .02, .12,          //
        0, .66, 0, 0, .73, 0, 0, .8, 0, 0, .875, 0, 0, .925, .005, 0, 1, .01,                     //
        .119, .856, 0, .188, .7, .01, .195, .6, .1, .195, .58, .15,                               //
        -.119, .856, 0, -.188, .7, .01, -.195, .6, .1, -.195, .58, .15;
    return p;
  }();
  return pose;
}

class Guesser {
 public:
  Guesser(const NamedMotion& motion, std::size_t frame) : motion_(motion), places_(motion.frames[frame]) {}
  JointGuess guess();

 private:
  void by_names();
  void by_places();
  void take(int joint, int point, JointGuess::By by) {
    guess_.map.rules[static_cast<std::size_t>(joint)] = {
        JointRule{{{motion_.points[static_cast<std::size_t>(point)], 1.0}}}};
    guess_.by[static_cast<std::size_t>(joint)] = by;
    points_[static_cast<std::size_t>(joint)] = point;
    used_.insert(point);
  }

  const NamedMotion& motion_;
  const Positions& places_;
  JointGuess guess_;
  std::array<int, joint_count> points_{};
  std::set<int> used_;
};

void Guesser::by_names() {
  struct Match {
    double worth;
    int joint, point;
  };
  std::vector<Match> matches;
  for (int p = 0; p < static_cast<int>(motion_.points.size()); ++p) {
    const SidedName name = sided_name(motion_.points[static_cast<std::size_t>(p)]);
    for (const Words& words : vocabulary) {
      const int other = mirrored_joint(words.joint);
      const bool is_sided = other != words.joint;
      if (is_sided == (name.side == 0)) continue;
      const double worth = similarity(name.word, words);
      if (worth > 0) matches.push_back({worth, name.side < 0 ? other : words.joint, p});
    }
  }
  std::stable_sort(matches.begin(), matches.end(),
                   [](const Match& a, const Match& b) { return a.worth > b.worth; });
  for (const Match& match : matches)
    if (guess_.by[static_cast<std::size_t>(match.joint)] == Nothing && !used_.contains(match.point))
      take(match.joint, match.point, Name);
}

/// What has no name is looked for where a standing person has it, fitted to those that have one.
void Guesser::by_places() {
  std::vector<int> known;
  for (int j = 0; j < joint_count; ++j)
    if (points_[static_cast<std::size_t>(j)] >= 0 &&
        places_.row(points_[static_cast<std::size_t>(j)]).allFinite())
      known.push_back(j);
  if (known.size() < 5) return;
  Eigen::Matrix3Xd from(3, known.size()), to(3, known.size());
  for (std::size_t k = 0; k < known.size(); ++k) {
    from.col(static_cast<Eigen::Index>(k)) = usual_person().row(known[k]).transpose();
    to.col(static_cast<Eigen::Index>(k)) =
        places_.row(points_[static_cast<std::size_t>(known[k])]).transpose();
  }
  const Eigen::Matrix4d fit = Eigen::umeyama(from, to, true);
  const double metre = fit.topLeftCorner<3, 3>().col(0).norm();  // of the person, in file units
  if (!(metre > 0)) return;
  for (int j = 0; j < joint_count; ++j) {
    if (guess_.by[static_cast<std::size_t>(j)] != Nothing) continue;
    const Vec3 place = (fit * usual_person().row(j).transpose().homogeneous()).head<3>();
    int nearest = -1;
    double distance = 0.08 * metre;
    for (int p = 0; p < static_cast<int>(motion_.points.size()); ++p) {
      const double there = (places_.row(p).transpose() - place).norm();
      if (!used_.contains(p) && there < distance) nearest = p, distance = there;
    }
    if (nearest >= 0) take(j, nearest, Place);
  }
}

JointGuess Guesser::guess() {
  points_.fill(-1);
  guess_.map.name = motion_.name;
  by_names();
  by_places();
  return std::move(guess_);
}

}  // namespace

std::size_t frame_to_look_at(const NamedMotion& motion) {
  for (std::size_t f = 0; f < motion.frames.size(); ++f)
    if (motion.frames[f].allFinite()) return f;
  return 0;
}

JointGuess guess_joints(const NamedMotion& motion, std::size_t frame) {
  if (motion.frames.empty()) return {};
  return Guesser(motion, std::min(frame, motion.frames.size() - 1)).guess();
}

std::vector<int> estimate_missing_joints(JointMap& map) {
  using namespace joints;
  struct Along {
    int joint, from, to;
    double fraction;
  };
  constexpr std::array<Along, 19> ways = {{{Root, left_hip, right_hip, 0.5},
                                           {LowerNeck, left_shoulder, right_shoulder, 0.5},
                                           {LowerNeck, Root, Head, 0.71},
                                           {LowerBack, Root, LowerNeck, 0.27},
                                           {UpperBack, Root, LowerNeck, 0.53},
                                           {Thorax, Root, LowerNeck, 0.79},
                                           {Head, Root, LowerNeck, 1.41},
                                           {UpperNeck, LowerNeck, Head, 0.5},
                                           {left_toe_base, left_knee, left_ankle, 1.15},
                                           {right_toe_base, right_knee, right_ankle, 1.15},
                                           {left_toe_tip, left_ankle, left_toe_base, 1.35},
                                           {right_toe_tip, right_ankle, right_toe_base, 1.35},
                                           {left_hand, left_elbow, left_wrist, 1.28},
                                           {right_hand, right_elbow, right_wrist, 1.28},
                                           {left_wrist, left_elbow, left_hand, 0.8},
                                           {right_wrist, right_elbow, right_hand, 0.8},
                                           {left_ankle, left_knee, left_toe_base, 0.9},
                                           {right_ankle, right_knee, right_toe_base, 0.9},
                                           {Root, LowerBack, LowerNeck, -0.37}}};
  std::vector<int> estimated;
  for (const Along& way : ways) {
    auto& rules = map.rules[static_cast<std::size_t>(way.joint)];
    const auto& from = map.rules[static_cast<std::size_t>(way.from)];
    const auto& to = map.rules[static_cast<std::size_t>(way.to)];
    if (!rules.empty() || from.empty() || to.empty()) continue;
    JointRule rule;
    for (const auto& [source, share] :
         {std::pair(&from.front(), 1 - way.fraction), {&to.front(), way.fraction}})
      for (const JointRule::Term& term : source->terms) {
        const auto same =
            std::find_if(rule.terms.begin(), rule.terms.end(),
                         [&](const JointRule::Term& known) { return known.point == term.point; });
        if (same == rule.terms.end())
          rule.terms.push_back({term.point, share * term.weight});
        else
          same->weight += share * term.weight;
      }
    rules = {std::move(rule)};
    estimated.push_back(way.joint);
  }
  return estimated;
}

}  // namespace abrazo
