#include "core/choreography/fight.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <numbers>
#include <set>
#include <stdexcept>
#include <string>

#include "core/motion/body/body.hpp"
#include "core/motion/body/body_segments.hpp"
#include "core/motion/body/joint_set.hpp"

namespace abrazo::fight_test {
namespace {

using namespace joints;

constexpr double degree = std::numbers::pi / 180;

Vec3 joint(const Pose& pose, int index) {
  return pose.row(index).transpose();
}
double apart(const Pose& a, int ja, const Pose& b, int jb) {
  return (joint(a, ja) - joint(b, jb)).norm();
}
Vec3 level(const Vec3& v) {
  return {v.x(), 0, v.z()};
}

/// Three minutes of each of three seeds, generated once.
const std::vector<PairedTake>& takes() {
  static const std::vector<PairedTake> all = [] {
    std::vector<PairedTake> sum;
    for (const std::uint64_t seed : {1, 2, 77})
      for (PairedTake& take : generate_fight({.seed = seed, .minutes = 3})) sum.push_back(std::move(take));
    return sum;
  }();
  return all;
}

/// A labelled blow with the poses of its interval.
struct Move {
  std::string technique, defence, where;
  bool by_a = true, blocked = true;
  double fps = 60;
  std::vector<Pose> attacker, defender;

  bool kick() const { return technique == "front kick" || technique == "round kick"; }
  /// Shoulder or hip, elbow or knee, fist or ankle.
  std::array<int, 3> limb() const {
    if (kick()) return {right_hip, right_knee, right_ankle};
    if (technique == "cross") return {right_shoulder, right_elbow, right_hand};
    return {left_shoulder, left_elbow, left_hand};
  }
  /// Distance of fist or ankle from shoulder or hip, of the limb's length.
  double stretch(std::size_t frame) const {
    const auto [base, middle, end] = limb();
    const Pose& pose = attacker[frame];
    return apart(pose, base, pose, end) / (apart(pose, base, pose, middle) + apart(pose, middle, pose, end));
  }
  /// The frame of the greatest stretch; of a standing leg before and after a kick it says nothing.
  std::size_t arrival() const {
    std::size_t at = attacker.size() / 2;
    double most = 0;
    for (std::size_t f = 0; f < attacker.size(); ++f)
      if ((!kick() || attacker[f](right_ankle, 1) > 0.45) && stretch(f) > most) most = stretch(f), at = f;
    return at;
  }
  double peak_speed() const {
    double most = 0;
    const int end = kick() ? static_cast<int>(right_toe_base) : limb()[2];
    for (std::size_t f = 1; f < attacker.size(); ++f)
      most = std::max(most, fps * apart(attacker[f - 1], end, attacker[f], end));
    return most;
  }
};

std::vector<Move> moves_of(const std::vector<PairedTake>& all) {
  std::vector<Move> moves;
  for (const PairedTake& take : all)
    for (const LabelInterval& label : take.labels) {
      if (label.label == "guard") continue;
      const std::size_t first = label.detail.find("; "), second = label.detail.find("; ", first + 1);
      Move move;
      move.technique = label.detail.substr(0, first);
      move.defence = label.detail.substr(first + 2, second - first - 2);
      move.where = take.name + " at " + std::to_string(label.start) + ": " + label.detail;
      move.by_a = label.detail.substr(second + 2) == "a attacks";
      move.blocked = label.label.ends_with("_block");
      move.fps = take.fps;
      const auto cut = [&](const Clip& clip) {
        return std::vector<Pose>(clip.poses.begin() + label.start, clip.poses.begin() + label.end);
      };
      move.attacker = cut(move.by_a ? take.a : take.b), move.defender = cut(move.by_a ? take.b : take.a);
      moves.push_back(std::move(move));
    }
  return moves;
}

const std::vector<Move>& moves() {
  static const std::vector<Move> all = moves_of(takes());
  return all;
}

void for_each_clip(const std::function<void(const PairedTake&, const Clip&)>& visit) {
  for (const PairedTake& take : takes()) {
    visit(take, take.a);
    visit(take, take.b);
  }
}

double from_segment(const Vec3& point, const Vec3& from, const Vec3& to) {
  const Vec3 along = to - from;
  return (point - from - std::clamp((point - from).dot(along) / along.squaredNorm(), 0.0, 1.0) * along)
      .norm();
}
/// Least distance of points of one segment from another.
double between_segments(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  double least = 1e9;
  for (int i = 0; i <= 40; ++i) least = std::min(least, from_segment(a + (b - a) * (i / 40.0), c, d));
  return least;
}

/// Distance of what strikes (forearm and fist; shank and foot) from the limb that blocks when it arrives.
double contact(const Move& move) {
  double least = 1e9;
  // It stays there for some three frames.
  for (std::size_t f = move.arrival() - 1; f <= move.arrival() + 1; ++f) {
    const Pose &a = move.attacker[f], &d = move.defender[f];
    const bool left = move.technique != "jab" && move.technique != "hook";
    std::array<int, 2> block =
        left ? std::array<int, 2>{left_elbow, left_hand} : std::array<int, 2>{right_elbow, right_hand};
    if (move.defence == "shin check") block = {left_knee, left_ankle};
    const Vec3 from = joint(d, block[0]), to = joint(d, block[1]);
    const auto [base, middle, end] = move.limb();
    least = std::min(least, between_segments(joint(a, middle), joint(a, end), from, to));
    if (move.kick())
      least = std::min(least, between_segments(joint(a, right_ankle), joint(a, right_toe_tip), from, to));
  }
  return least;
}

double angle(const Pose& pose, int upper, int middle, int lower) {
  const Vec3 u = joint(pose, upper) - joint(pose, middle), l = joint(pose, lower) - joint(pose, middle);
  return std::acos(u.normalized().dot(l.normalized())) / degree;
}

double median(std::vector<double> values) {
  std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2),
                   values.end());
  return values[values.size() / 2];
}

/// Direction of the line from the right to the left joint, seen from above [rad].
double yaw_of(const Pose& pose, int left, int right) {
  const Vec3 line = joint(pose, left) - joint(pose, right);
  return std::atan2(-line.z(), line.x());
}

TEST(Fight, TheSameSeedGivesTheSameFightAndAnotherSeedAnother) {
  const auto once = generate_fight({.seed = 9, .minutes = 0.5}),
             again = generate_fight({.seed = 9, .minutes = 0.5}),
             other = generate_fight({.seed = 10, .minutes = 0.5});
  ASSERT_EQ(once.size(), again.size());
  for (std::size_t t = 0; t < once.size(); ++t) {
    EXPECT_EQ(once[t].a.poses, again[t].a.poses);
    EXPECT_EQ(once[t].b.poses, again[t].b.poses);
  }
  EXPECT_GT((once[0].a.poses[30] - other[0].a.poses[30]).norm(), 0.01);
}

TEST(Fight, TheFrameRateOnlySamplesTheSameMotion) {
  const auto at_60 = generate_fight({.seed = 3, .minutes = 0.5, .fps = 60}),
             at_120 = generate_fight({.seed = 3, .minutes = 0.5, .fps = 120});
  for (std::size_t f = 0; f < at_60[0].a.poses.size(); ++f)
    ASSERT_LT((at_60[0].a.poses[f] - at_120[0].a.poses[2 * f]).cwiseAbs().maxCoeff(), 1e-9);
}

TEST(Fight, LastsAsLongAsAsked) {
  for (const double minutes : {0.5, 1.0, 2.5}) {
    double seconds = 0;
    for (const PairedTake& take : generate_fight({.seed = 4, .minutes = minutes})) {
      seconds += take.a.duration_s();
      EXPECT_EQ(take.a.poses.size(), take.b.poses.size());
    }
    EXPECT_NEAR(seconds, minutes * 60, 2);
  }
}

TEST(Fight, LabelsTileEveryTakeAndGuardLastsAtLeastFourTenthsOfASecond) {
  std::set<std::string> labels;
  for (const PairedTake& take : takes()) {
    int covered = 0;
    for (const LabelInterval& label : take.labels) {
      EXPECT_EQ(label.start, covered) << take.name;
      EXPECT_GE(label.end - label.start, (label.label == "guard" ? 0.4 : 0.2) * take.fps) << take.name;
      EXPECT_EQ(label.detail.empty(), label.label == "guard");
      EXPECT_EQ(label.confidence, "high");
      covered = label.end;
      labels.insert(label.label);
    }
    EXPECT_EQ(covered, static_cast<int>(take.a.poses.size()));
    EXPECT_EQ(take.labels.front().label, "guard");
    EXPECT_EQ(take.labels.back().label, "guard");
  }
  EXPECT_EQ(labels,
            (std::set<std::string>{"guard", "punch_block", "punch_dodge", "kick_block", "kick_dodge"}));
}

TEST(Fight, WhoAttacksIsActiveAndNeutralFootworkBelongsToTheNextAttack) {
  int to_a = 0, to_b = 0;
  for (const PairedTake& take : takes()) {
    int covered = 0;
    for (std::size_t i = 0; i < take.roles.size(); ++i) {
      EXPECT_EQ(take.roles[i].start, covered);
      covered = take.roles[i].end;
      if (i > 0) {
        EXPECT_NE(take.roles[i].active, take.roles[i - 1].active);
        ++(take.roles[i].active == ActivePerformer::A ? to_a : to_b);
      }
    }
    EXPECT_EQ(covered, static_cast<int>(take.a.poses.size()));
    for (std::size_t i = 0; i < take.labels.size(); ++i) {
      const std::size_t attack = take.labels[i].label != "guard" ? i
                                 : i + 1 < take.labels.size()    ? i + 1
                                                                 : i - 1;
      const auto active =
          take.labels[attack].detail.ends_with("a attacks") ? ActivePerformer::A : ActivePerformer::B;
      for (int f = take.labels[i].start; f < take.labels[i].end; ++f)
        ASSERT_EQ(active_at(take, f), active) << take.name << " frame " << f;
    }
  }
  EXPECT_GT(to_a, 10);
  EXPECT_GT(to_b, 10);
}

TEST(Fight, EveryTechniqueIsMetInItsOwnWays) {
  std::map<std::string, std::map<std::string, int>> met;
  for (const Move& move : moves()) ++met[move.technique][move.defence];
  EXPECT_GT(met["jab"]["parry"], met["jab"]["slip"]);
  EXPECT_GT(met["cross"]["slip"], 0);
  EXPECT_GT(met["cross"]["high guard"], 0);
  EXPECT_GT(met["hook"]["duck"], met["hook"]["high guard"]);
  EXPECT_GT(met["front kick"]["parry down"], 0);
  EXPECT_GT(met["front kick"]["step back"], 0);
  EXPECT_GT(met["round kick"]["shin check"] + met["round kick"]["arm check"], met["round kick"]["lean back"]);
  EXPECT_GT(met["round kick"]["lean back"], 0);
}

TEST(Fight, BoneLengthsAreConstantAndEverythingIsFinite) {
  for_each_clip([](const PairedTake&, const Clip& clip) {
    const Body first = body_of(clip.poses.front());
    for (const Pose& pose : clip.poses) {
      ASSERT_TRUE(pose.allFinite());
      ASSERT_LT(largest_length_difference(body_of(pose), first), 1e-9);
    }
  });
}

TEST(Fight, ABlockedBlowStopsAtTheLimbThatBlocksIt) {
  // Axes of two limbs that touch are some 5 cm apart.
  for (const Move& move : moves()) {
    if (!move.blocked) continue;
    const double distance = contact(move);
    EXPECT_LT(distance, 0.085) << move.where;
    EXPECT_GT(distance, 0.01) << move.where;
  }
}

TEST(Fight, ABlockedPunchDoesNotReachTheHead) {
  for (const Move& move : moves()) {
    if (!move.blocked || move.kick()) continue;
    for (std::size_t f = 0; f < move.attacker.size(); ++f)
      ASSERT_GT(apart(move.attacker[f], move.limb()[2], move.defender[f], Head), 0.10) << move.where;
  }
}

TEST(Fight, AHeadThatDodgesAPunchIsOutOfItsLine) {
  for (const Move& move : moves()) {
    if (move.blocked || move.kick()) continue;
    for (std::size_t f = 0; f < move.attacker.size(); ++f) {
      const auto [base, elbow, fist] = move.limb();
      ASSERT_GT(from_segment(joint(move.defender[f], Head), joint(move.attacker[f], elbow),
                             joint(move.attacker[f], fist)),
                0.125)
          << move.where;
    }
  }
}

TEST(Fight, ATrunkThatDodgesAKickIsOutOfItsReach) {
  for (const Move& move : moves()) {
    if (move.blocked || !move.kick()) continue;
    for (std::size_t f = 0; f < move.attacker.size(); ++f)
      for (const int spine :
           {static_cast<int>(Root), static_cast<int>(LowerBack), static_cast<int>(UpperBack),
            static_cast<int>(Thorax), static_cast<int>(LowerNeck), static_cast<int>(Head)}) {
        const Vec3 at = joint(move.defender[f], spine);
        const Pose& by = move.attacker[f];
        ASSERT_GT(from_segment(at, joint(by, right_knee), joint(by, right_ankle)), 0.125) << move.where;
        ASSERT_GT(from_segment(at, joint(by, right_ankle), joint(by, right_toe_tip)), 0.125) << move.where;
      }
  }
}

TEST(Fight, ADodgedBlowGoesToFullStretchAndABlockedPunchDoesNot) {
  std::map<std::string, std::vector<double>> blocked, dodged;
  for (const Move& move : moves()) {
    (move.blocked ? blocked : dodged)[move.technique].push_back(move.stretch(move.arrival()));
    if (move.blocked) continue;
    EXPECT_GT(move.stretch(move.arrival()), move.technique == "hook" ? 0.82 : 0.92) << move.where;
    EXPECT_LT(move.stretch(move.arrival()), 0.985) << move.where;
  }
  for (const char* technique : {"jab", "cross", "front kick"})
    EXPECT_GT(median(dodged[technique]), median(blocked[technique]) + 0.03) << technique;
}

TEST(Fight, StrikesAreAsFastAsInTraining) {
  std::map<std::string, std::vector<double>> speeds;
  for (const Move& move : moves()) {
    speeds[move.technique].push_back(move.peak_speed());
    EXPECT_GT(move.peak_speed(), move.kick() ? 5.5 : 3.5) << move.where;
    EXPECT_LT(move.peak_speed(), move.technique == "round kick" ? 12 : 10) << move.where;
  }
  const auto expect_median = [&](const char* technique, double low, double high) {
    EXPECT_GT(median(speeds[technique]), low) << technique;
    EXPECT_LT(median(speeds[technique]), high) << technique;
  };
  // Lower halves of what is published for trained fighters [m/s].
  expect_median("jab", 5, 7);
  expect_median("cross", 5, 7);
  expect_median("hook", 6, 8);
  expect_median("front kick", 6, 8);
  expect_median("round kick", 8, 10);
}

TEST(Fight, TheHipsTurnBeforeTheShouldersInACross) {
  int crosses = 0;
  for (const Move& move : moves()) {
    if (move.technique != "cross" || !move.blocked) continue;
    const auto fastest = [&](int left, int right) {
      std::size_t at = 0;
      double most = 0;
      for (std::size_t f = 1; f < move.attacker.size(); ++f) {
        const double turned =
            std::remainder(yaw_of(move.attacker[f], left, right) - yaw_of(move.attacker[f - 1], left, right),
                           2 * std::numbers::pi);
        if (turned > most) most = turned, at = f;
      }
      EXPECT_GT(most * move.fps, 2) << move.where;
      return at;
    };
    EXPECT_LT(fastest(left_hip, right_hip), fastest(left_shoulder, right_shoulder)) << move.where;
    ++crosses;
  }
  EXPECT_GT(crosses, 10);
}

TEST(Fight, TheOtherHandStaysUpWhileOnePunches) {
  for (const Move& move : moves()) {
    if (move.kick()) continue;
    const int resting = move.technique == "cross" ? left_hand : right_hand;
    const Pose& pose = move.attacker[move.arrival()];
    EXPECT_GT(pose(resting, 1), pose(LowerNeck, 1) - 0.05) << move.where;
    EXPECT_LT(apart(pose, resting, pose, Head), 0.45) << move.where;
  }
}

TEST(Fight, PlantedFeetStandStillAndOneAlwaysStands) {
  for_each_clip([](const PairedTake& take, const Clip& clip) {
    const double rest = body_of(clip.poses).toe_rest_height;
    for (std::size_t f = 1; f < clip.poses.size(); ++f) {
      const Pose &before = clip.poses[f - 1], &now = clip.poses[f];
      int standing = 0;
      for (const int toe_base : {left_toe_base, right_toe_base}) {
        ASSERT_GT(now(toe_base, 1), rest - 0.002);
        if (std::max(before(toe_base, 1), now(toe_base, 1)) > rest + 1e-4) continue;
        ++standing;
        ASSERT_LT(apart(before, toe_base, now, toe_base), 0.001) << take.name << " frame " << f;
      }
      const double lower = std::min(now(left_toe_base, 1), now(right_toe_base, 1));
      ASSERT_LT(lower, rest + 0.002) << "both feet in the air: " << take.name << " frame " << f;
    }
  });
}

TEST(Fight, AKickerStandsOverTheSupportingFoot) {
  const auto segments = body_segments(SegmentTable::Mean);
  int kicking = 0;
  for (const Move& move : moves()) {
    if (!move.kick()) continue;
    for (const Pose& pose : move.attacker) {
      if (pose(right_toe_base, 1) < 0.35) continue;
      const Vec3 centre = level(centre_of_mass(segments, pose));
      ASSERT_LT(from_segment(centre, level(joint(pose, left_ankle)), level(joint(pose, left_toe_base))), 0.09)
          << move.where;
      ++kicking;
    }
  }
  EXPECT_GT(kicking, 500);
}

TEST(Fight, KneesAndElbowsBendAsTheyShould) {
  for_each_clip([](const PairedTake& take, const Clip& clip) {
    for (const Pose& pose : clip.poses) {
      for (const auto& [hip, knee, ankle] : {std::array<int, 3>{left_hip, left_knee, left_ankle},
                                             std::array<int, 3>{right_hip, right_knee, right_ankle}}) {
        ASSERT_GT(angle(pose, hip, knee, ankle), 45) << take.name;
        ASSERT_LT(angle(pose, hip, knee, ankle), 172) << take.name;
        const Vec3 toes = joint(pose, ankle + 1) - joint(pose, ankle);
        const Vec3 aside = joint(pose, knee) - 0.5 * (joint(pose, hip) + joint(pose, ankle));
        // A standing knee points where the foot does.
        if (pose(ankle + 1, 1) < 0.05) {
          ASSERT_GT(aside.dot(level(toes)), 0) << take.name;
        }
      }
      for (const auto& [shoulder, elbow, wrist] :
           {std::array<int, 3>{left_shoulder, left_elbow, left_wrist},
            std::array<int, 3>{right_shoulder, right_elbow, right_wrist}}) {
        ASSERT_GT(angle(pose, shoulder, elbow, wrist), 25) << take.name;
        ASSERT_LT(angle(pose, shoulder, elbow, wrist), 172) << take.name;
      }
    }
  });
}

TEST(Fight, AcceleratesNoMoreThanStrikesDo) {
  // Captured salsa reaches 66 (root), 77 (head), 270 (hands), 190 (toes) m/s^2 in one frame of a thousand;
  // fists of boxers and feet of kickers exceed 500 m/s^2 before they hit.
  std::array<double, joint_count> limit{};
  limit.fill(70);
  for (const int j : {left_elbow, right_elbow, left_wrist, right_wrist, left_hand, right_hand})
    limit[static_cast<std::size_t>(j)] = 450;
  for (const int j : {left_knee, right_knee}) limit[static_cast<std::size_t>(j)] = 220;
  for (const int j : {left_ankle, right_ankle, left_toe_base, right_toe_base, left_toe_tip, right_toe_tip})
    limit[static_cast<std::size_t>(j)] = 400;
  limit[Head] = limit[left_shoulder] = limit[right_shoulder] = 100;
  for_each_clip([&](const PairedTake& take, const Clip& clip) {
    for (std::size_t f = 2; f < clip.poses.size(); ++f) {
      const Pose change = (clip.poses[f] - 2 * clip.poses[f - 1] + clip.poses[f - 2]) * clip.fps * clip.fps;
      for (int j = 0; j < joint_count; ++j)
        ASSERT_LT(change.row(j).norm(), limit[static_cast<std::size_t>(j)])
            << take.name << " frame " << f << " " << joint_names[static_cast<std::size_t>(j)];
    }
  });
}

TEST(Fight, TheyKeepTheirDistanceAndStayInTheRing) {
  for (const PairedTake& take : takes())
    for (std::size_t f = 0; f < take.a.poses.size(); ++f) {
      const double distance = apart(take.a.poses[f], Root, take.b.poses[f], Root);
      ASSERT_GT(distance, 0.5) << take.name << " frame " << f;
      ASSERT_LT(distance, 1.8) << take.name << " frame " << f;
      ASSERT_LT(level(joint(take.a.poses[f], Root)).norm(), 3);
    }
}

TEST(Fight, BeginnersMissTheBlowTheyBlockMoreOften) {
  ChoreographyOptions options{.seed = 5, .minutes = 5};
  options.a.performance = options.b.performance = performance_of_skill(0);
  const std::vector<Move> beginners = moves_of(generate_fight(options));
  const auto missed = [](const std::vector<Move>& all) {
    int blocks = 0, misses = 0;
    for (const Move& move : all) {
      if (!move.blocked) continue;
      const double distance = contact(move);
      ++blocks, misses += distance < 0.03 || distance > 0.08 ? 1 : 0;
    }
    return static_cast<double>(misses) / blocks;
  };
  EXPECT_LT(missed(moves()), 0.05);
  EXPECT_GT(missed(beginners), 0.15);
}

TEST(Fight, ASmallAmplitudeMakesSmallerDodges) {
  const auto dodge = [](double amplitude) {
    ChoreographyOptions options{.seed = 5, .minutes = 4};
    options.a.performance.amplitude = options.b.performance.amplitude = amplitude;
    std::vector<double> ways;
    for (const Move& move : moves_of(generate_fight(options))) {
      if (move.defence != "duck" && move.defence != "slip") continue;
      double farthest = 0;
      for (const Pose& pose : move.defender)
        farthest = std::max(farthest, (joint(pose, Head) - joint(move.defender.front(), Head)).norm());
      ways.push_back(farthest);
    }
    return median(ways);
  };
  EXPECT_LT(dodge(0.6), 0.92 * dodge(1));
}

TEST(Fight, PaceMakesBlowsFasterAndMore) {
  std::vector<double> slow, fast;
  for (const Move& move : moves_of(generate_fight({.seed = 5, .minutes = 3, .pace = 0.6})))
    if (move.kick()) slow.push_back(move.peak_speed());
  for (const Move& move : moves_of(generate_fight({.seed = 5, .minutes = 3, .pace = 1.2})))
    if (move.kick()) fast.push_back(move.peak_speed());
  EXPECT_GT(median(fast), 1.4 * median(slow));
}

TEST(Fight, StaysAFightForOtherBuildsRatesAndSkills) {
  std::vector<ChoreographyOptions> all(4, ChoreographyOptions{.seed = 8, .minutes = 0.7});
  all[0].fps = 30;
  all[1].a.height_m = 1.45, all[1].b.height_m = 2.1;
  all[2].a.arm_scale = 0.8, all[2].a.leg_scale = 1.15, all[2].b.arm_scale = 1.25, all[2].b.leg_scale = 0.85;
  all[3].a.performance = {.amplitude = 0.5, .timing_error_s = 0.25, .wander_m = 0.1};
  all[3].b.performance = {.amplitude = 1.3, .timing_error_s = 0.1, .wander_m = 0.05};
  for (const ChoreographyOptions& options : all)
    for (const PairedTake& take : generate_fight(options))
      for (const Clip* clip : {&take.a, &take.b}) {
        const Body first = body_of(clip->poses.front());
        for (const Pose& pose : clip->poses) {
          ASSERT_TRUE(pose.allFinite());
          ASSERT_LT(largest_length_difference(body_of(pose), first), 1e-9);
        }
      }
}

TEST(Fight, RefusesOptionsThatMakeNoFight) {
  EXPECT_THROW(generate_fight({.minutes = 0}), std::invalid_argument);
  EXPECT_THROW(generate_fight({.fps = -60}), std::invalid_argument);
  EXPECT_THROW(generate_fight({.pace = 0.2}), std::invalid_argument);
  EXPECT_THROW(generate_fight({.pace = 3}), std::invalid_argument);
  EXPECT_THROW(generate_fight({.take_seconds = std::nan("")}), std::invalid_argument);
  EXPECT_THROW(generate_fight({.b = {.height_m = 0.3}}), std::invalid_argument);
  try {
    generate_fight({.pace = 3});
  } catch (const std::invalid_argument& refusal) {
    EXPECT_NE(std::string(refusal.what()).find("between 0.5 and 1.5, not 3"), std::string::npos);
  }
}

}  // namespace
}  // namespace abrazo::fight_test
