#include "core/choreography/salsa.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <set>
#include <stdexcept>
#include <vector>

#include "core/motion/body/body.hpp"
#include "core/motion/body/joint_set.hpp"

namespace abrazo::salsa_test {
namespace {

using namespace joints;

constexpr std::array<std::uint64_t, 3> seeds = {1, 2, 77};

Vec3 joint(const Pose& pose, int index) {
  return pose.row(index).transpose();
}
double apart(const Pose& a, int ja, const Pose& b, int jb) {
  return (joint(a, ja) - joint(b, jb)).norm();
}

/// A minute and a half of each seed, generated once.
const std::vector<PairedTake>& takes() {
  static const std::vector<PairedTake> all = [] {
    std::vector<PairedTake> sum;
    for (const std::uint64_t seed : seeds)
      for (PairedTake& take : generate_salsa({.seed = seed, .minutes = 1.5})) sum.push_back(std::move(take));
    return sum;
  }();
  return all;
}

void for_each_performer(const std::function<void(const PairedTake&, const Clip&)>& visit) {
  for (const PairedTake& take : takes()) {
    visit(take, take.a);
    visit(take, take.b);
  }
}

/// Visits the frames of the middle half of every move with this label.
void for_each_mid_frame(std::string_view label, const std::function<void(const Pose&, const Pose&)>& visit) {
  for (const PairedTake& take : takes())
    for (const LabelInterval& move : take.labels) {
      const int quarter = (move.end - move.start) / 4;
      if (move.label != label) continue;
      for (int f = move.start + quarter; f < move.end - quarter; ++f)
        visit(take.a.poses[static_cast<std::size_t>(f)], take.b.poses[static_cast<std::size_t>(f)]);
    }
}

/// Largest and mean of a distance over the middle of all moves with a label.
struct Spread {
  double most = 0, mean = 0;
};
Spread spread(std::string_view label, const std::function<double(const Pose&, const Pose&)>& distance) {
  Spread found;
  int count = 0;
  for_each_mid_frame(label, [&](const Pose& a, const Pose& b) {
    found.most = std::max(found.most, distance(a, b));
    found.mean += distance(a, b);
    ++count;
  });
  found.mean /= std::max(1, count);
  return found;
}

double knee_angle(const Pose& pose, int hip, int knee, int ankle) {
  const Vec3 thigh = joint(pose, hip) - joint(pose, knee), shank = joint(pose, ankle) - joint(pose, knee);
  return std::acos(thigh.normalized().dot(shank.normalized()));
}

/// Smallest distance of a segment's points from the polyline root - thorax - head of a body.
double from_spine(const Vec3& from, const Vec3& to, const Pose& body) {
  double least = 1e9;
  for (const auto& [low, high] : {std::pair<int, int>(Root, Thorax), std::pair<int, int>(Thorax, Head)}) {
    const Vec3 base = joint(body, low), bone = joint(body, high) - base;
    for (int i = 0; i <= 8; ++i) {
      const Vec3 point = from + (to - from) * (i / 8.0);
      const double along = std::clamp((point - base).dot(bone) / bone.squaredNorm(), 0.0, 1.0);
      least = std::min(least, (point - base - along * bone).norm());
    }
  }
  return least;
}

TEST(Salsa, TheSameSeedGivesTheSameDance) {
  const auto once = generate_salsa({.seed = 9, .minutes = 0.3}),
             again = generate_salsa({.seed = 9, .minutes = 0.3});
  ASSERT_EQ(once.size(), again.size());
  for (std::size_t t = 0; t < once.size(); ++t) {
    EXPECT_EQ(once[t].a.poses, again[t].a.poses);
    EXPECT_EQ(once[t].b.poses, again[t].b.poses);
  }
}

TEST(Salsa, AnotherSeedGivesAnotherDance) {
  const auto one = generate_salsa({.seed = 1, .minutes = 0.3}),
             two = generate_salsa({.seed = 2, .minutes = 0.3});
  EXPECT_GT((one[0].a.poses[30] - two[0].a.poses[30]).norm(), 0.01);
}

TEST(Salsa, LastsAsLongAsAskedToTheNearestEightCount) {
  for (const double minutes : {0.2, 1.0, 2.5}) {
    double seconds = 0;
    for (const PairedTake& take : generate_salsa({.seed = 4, .minutes = minutes})) {
      seconds += take.a.duration_s();
      EXPECT_EQ(take.a.poses.size(), take.b.poses.size());
      EXPECT_LT(take.a.duration_s(), 30);
    }
    EXPECT_NEAR(seconds, minutes * 60, 1.5);
  }
}

TEST(Salsa, LabelsTileEveryTakeAndTheLeaderIsActiveThroughout) {
  std::set<std::string> moves;
  for (const PairedTake& take : takes()) {
    const int frames = static_cast<int>(take.a.poses.size());
    int covered = 0;
    for (const LabelInterval& label : take.labels) {
      EXPECT_EQ(label.start, covered) << take.name;
      EXPECT_GT(label.end, label.start);
      covered = label.end;
      moves.insert(label.label);
    }
    EXPECT_EQ(covered, frames);
    ASSERT_EQ(take.roles.size(), 1U);
    EXPECT_EQ(take.roles[0].start, 0);
    EXPECT_EQ(take.roles[0].end, frames);
    EXPECT_EQ(take.roles[0].active, ActivePerformer::A);
  }
  EXPECT_EQ(moves, (std::set<std::string>{"open_hold", "closed_hold", "turn", "cross_body_lead", "walk",
                                          "in_and_out"}));
}

TEST(Salsa, BoneLengthsAreConstantAndEverythingIsFinite) {
  for_each_performer([](const PairedTake&, const Clip& clip) {
    const Body first = body_of(clip.poses.front());
    for (const Pose& pose : clip.poses) {
      ASSERT_TRUE(pose.allFinite());
      ASSERT_LT(largest_length_difference(body_of(pose), first), 1e-9);
    }
  });
}

// Ends of the hands that hold one another: 14 cm apart in the capture's median.
constexpr double held = 0.14;

TEST(Salsa, OpenHoldJoinsHisLeftHandWithHerRightAndOftenTheOthersToo) {
  const Spread lead =
      spread("open_hold", [](auto& a, auto& b) { return apart(a, left_hand, b, right_hand); });
  EXPECT_LT(lead.most, held);
  EXPECT_LT(lead.mean, 0.09);
  int frames = 0, both = 0;
  for_each_mid_frame("open_hold", [&](const Pose& a, const Pose& b) {
    ++frames;
    both += apart(a, right_hand, b, left_hand) < held ? 1 : 0;
  });
  EXPECT_GT(both, frames / 2);
  EXPECT_LT(both, frames);
}

TEST(Salsa, ClosedHoldPutsHisHandOnHerBackAndHersOnHisShoulder) {
  const Spread side =
      spread("closed_hold", [](auto& a, auto& b) { return apart(a, left_hand, b, right_hand); });
  const Spread shoulder =
      spread("closed_hold", [](auto& a, auto& b) { return apart(a, right_shoulder, b, left_hand); });
  const Spread back = spread("closed_hold", [](auto& a, auto& b) {
    return std::min(apart(a, right_hand, b, Thorax), apart(a, right_hand, b, UpperBack));
  });
  EXPECT_LT(side.most, held);
  EXPECT_LT(side.mean, 0.09);
  EXPECT_LT(shoulder.most, 0.15);
  EXPECT_LT(back.most, 0.20);
}

TEST(Salsa, TheHoldIsRaisedAboveTheOneWhoTurns) {
  int turns = 0;
  for (const PairedTake& take : takes())
    for (const LabelInterval& move : take.labels) {
      if (move.label != "turn") continue;
      const bool she_turns = move.detail.find("follower") != std::string::npos;
      double highest = 0, widest = 0;
      for (int f = move.start; f < move.end; ++f) {
        const Pose &a = take.a.poses[static_cast<std::size_t>(f)],
                   &b = take.b.poses[static_cast<std::size_t>(f)];
        highest = std::max(highest, b(right_hand, 1) - (she_turns ? b : a)(Head, 1));
        widest = std::max(widest, apart(a, left_hand, b, right_hand));
      }
      ++turns;
      EXPECT_GT(highest, 0.05) << take.name << " at " << move.start << " " << move.detail;
      EXPECT_LT(widest, 0.25);  // for a moment, when her back is turned
    }
  EXPECT_GT(turns, 10);
}

TEST(Salsa, InACrossBodyLeadTheyHoldOneHandThroughout) {
  const Spread lead =
      spread("cross_body_lead", [](auto& a, auto& b) { return apart(a, left_hand, b, right_hand); });
  EXPECT_LT(lead.most, held);
  EXPECT_LT(lead.mean, 0.09);
}

TEST(Salsa, WalkingTheyHoldTheHandsBetweenThemOrBothRightHands) {
  int frames = 0, holding = 0;
  for_each_mid_frame("walk", [&](const Pose& a, const Pose& b) {
    const double nearest = std::min({apart(a, left_hand, b, right_hand), apart(a, right_hand, b, left_hand),
                                     apart(a, right_hand, b, right_hand)});
    ++frames;
    holding += nearest < held ? 1 : 0;
  });
  // In tandem the hands change while she turns away.
  EXPECT_GT(holding, 0.85 * frames);
}

TEST(Salsa, LedInHisRightHandIsAtHerWaist) {
  const Spread waist = spread("in_and_out", [](auto& a, auto& b) {
    return std::min(apart(a, right_hand, b, LowerBack), apart(a, right_hand, b, UpperBack));
  });
  EXPECT_LT(waist.mean, 0.2);
}

TEST(Salsa, PlantedFeetStandStill) {
  for_each_performer([](const PairedTake& take, const Clip& clip) {
    const double rest = body_of(clip.poses).toe_rest_height;
    int planted = 0;
    for (std::size_t f = 1; f < clip.poses.size(); ++f) {
      const Pose &before = clip.poses[f - 1], &now = clip.poses[f];
      int standing = 0;
      for (const int toe_base : {left_toe_base, right_toe_base}) {
        EXPECT_GT(now(toe_base, 1), rest - 0.002);
        if (std::max(before(toe_base, 1), now(toe_base, 1)) > rest + 1e-4) continue;
        ++standing;
        EXPECT_LT(apart(before, toe_base, now, toe_base), 0.001) << take.name << " frame " << f;
      }
      planted += standing;
      EXPECT_GE(standing, 1) << "both feet in the air: " << take.name << " frame " << f;
    }
    EXPECT_GT(planted, static_cast<int>(clip.poses.size()));
  });
}

TEST(Salsa, KneesBendForwardAndNeverTooFar) {
  for_each_performer([](const PairedTake&, const Clip& clip) {
    for (const Pose& pose : clip.poses) {
      const Vec3 left = joint(pose, left_hip) - joint(pose, right_hip);
      const Vec3 forward = left.cross(Vec3::UnitY());
      for (const auto& [hip, knee, ankle] :
           {std::array{left_hip, left_knee, left_ankle}, std::array{right_hip, right_knee, right_ankle}}) {
        const double angle = knee_angle(pose, hip, knee, ankle);
        // Captured dancers: 91 degrees (leader) and 53 (follower) at the 0.1th percentile.
        ASSERT_GT(angle, 75 * std::numbers::pi / 180);
        ASSERT_LT(angle, 175 * std::numbers::pi / 180);
        const Vec3 aside = joint(pose, knee) - 0.5 * (joint(pose, hip) + joint(pose, ankle));
        ASSERT_GT(aside.dot(forward), 0);
      }
    }
  });
}

TEST(Salsa, TheDancersKeepClearOfOneAnother) {
  int forearms = 0, deep = 0;
  for (const PairedTake& take : takes())
    for (std::size_t f = 0; f < take.a.poses.size(); ++f) {
      const Pose &a = take.a.poses[f], &b = take.b.poses[f];
      ASSERT_GT(apart(a, Root, b, Root), 0.35);
      ASSERT_GT(apart(a, Head, b, Head), 0.25);
      for (const auto& [elbow, wrist] :
           {std::pair(left_elbow, left_wrist), std::pair(right_elbow, right_wrist)})
        for (const double distance : {from_spine(joint(a, elbow), joint(a, wrist), b),
                                      from_spine(joint(b, elbow), joint(b, wrist), a)}) {
          ++forearms;
          deep += distance < 0.054 ? 1 : 0;
        }
    }
  // The captured leader's forearm is nearer than 5.4 cm to the partner's spine in one frame of a thousand.
  EXPECT_LT(deep, 0.001 * forearms);
}

TEST(Salsa, AcceleratesNoMoreThanCapturedDancersDo) {
  // 99.9th percentile of |second difference| x 60^2 [m/s^2] of each joint over all eleven captured salsa
  // takes at 60 fps: CMU subject 60 (leads), subject 61 (follows).
  constexpr std::array<double, joint_count> leader = {66,  144, 114, 135, 189, 220, 165, 96, 108,
                                                      172, 194, 90,  110, 50,  63,  76,  77, 180,
                                                      198, 196, 202, 274, 280, 269, 268};
  constexpr std::array<double, joint_count> follower = {29, 40, 49, 54, 67, 111, 38, 80,  55, 67, 103, 26, 29,
                                                        27, 35, 36, 34, 66, 73,  81, 134, 58, 71, 76,  299};
  // Knees and elbows lie where the ends of their limbs put them, a wrist where the hand that is held points:
  // they are somewhat quicker than captured ones.
  const auto margin = [](int j) {
    const bool middle = j == left_knee || j == right_knee || j == left_elbow || j == right_elbow;
    return j == left_wrist || j == right_wrist ? 2.2 : middle ? 1.9 : 1.5;
  };
  for_each_performer([&](const PairedTake& take, const Clip& clip) {
    const auto& limit = &clip == &take.a ? leader : follower;
    for (std::size_t f = 2; f < clip.poses.size(); ++f) {
      const Pose change = (clip.poses[f] - 2 * clip.poses[f - 1] + clip.poses[f - 2]) * clip.fps * clip.fps;
      for (int j = 0; j < joint_count; ++j)
        ASSERT_LT(change.row(j).norm(), margin(j) * limit[static_cast<std::size_t>(j)])
            << take.name << " frame " << f << " " << joint_names[static_cast<std::size_t>(j)];
    }
  });
}

TEST(Salsa, ElbowsNeitherOverstretchNorFold) {
  for_each_performer([](const PairedTake& take, const Clip& clip) {
    for (const Pose& pose : clip.poses)
      for (const auto& [shoulder, elbow, wrist] : {std::array{left_shoulder, left_elbow, left_wrist},
                                                   std::array{right_shoulder, right_elbow, right_wrist}}) {
        const double angle = knee_angle(pose, shoulder, elbow, wrist) * 180 / std::numbers::pi;
        ASSERT_GT(angle, 25) << take.name;
        ASSERT_LT(angle, 165) << take.name;
      }
  });
}

TEST(Salsa, FeetSlideNoMoreThanCapturedOnes) {
  // Mean horizontal speed of a toe-base less than 3 cm above its rest [m/s]. Captured: 0.145 (leads) and 0.17
  // (follows); there, feet that stand move too, here only those that are being lifted or set down.
  for_each_performer([](const PairedTake& take, const Clip& clip) {
    const double rest = body_of(clip.poses).toe_rest_height;
    double sum = 0;
    int low = 0;
    for (std::size_t f = 1; f < clip.poses.size(); ++f)
      for (const int toe_base : {left_toe_base, right_toe_base}) {
        if (clip.poses[f - 1](toe_base, 1) > rest + 0.03) continue;
        const Vec3 step = joint(clip.poses[f], toe_base) - joint(clip.poses[f - 1], toe_base);
        sum += std::hypot(step.x(), step.z()) * clip.fps, ++low;
      }
    EXPECT_LT(sum / low, &clip == &take.a ? 0.16 : 0.18) << take.name;
  });
}

TEST(Salsa, HipsAndShouldersCounterRotate) {
  for_each_performer([](const PairedTake& take, const Clip& clip) {
    double least = 0, most = 0;
    for (const Pose& pose : clip.poses) {
      const Vec3 hips = joint(pose, left_hip) - joint(pose, right_hip),
                 shoulders = joint(pose, left_shoulder) - joint(pose, right_shoulder);
      const double twist = std::remainder(
          std::atan2(-shoulders.z(), shoulders.x()) - std::atan2(-hips.z(), hips.x()), 2 * std::numbers::pi);
      least = std::min(least, twist), most = std::max(most, twist);
    }
    // Captured: 5th and 95th percentile some 20 degrees to either side.
    EXPECT_LT(least, -15 * std::numbers::pi / 180) << take.name;
    EXPECT_GT(most, 15 * std::numbers::pi / 180) << take.name;
  });
}

TEST(Salsa, NoTwoFramesAreAlike) {
  std::set<std::vector<double>> seen;
  std::size_t frames = 0;
  for (const PairedTake& take : takes())
    for (std::size_t f = 0; f < take.a.poses.size(); ++f, ++frames) {
      const Pose a = take.a.poses[f].rowwise() - take.a.poses[f].row(0);
      seen.insert(std::vector<double>(a.data(), a.data() + a.size()));
    }
  EXPECT_EQ(seen.size(), frames);
}

TEST(Salsa, TheTempoIsDrawnWhenItIsNotGiven) {
  // A move takes 8 beats: 2.53 s at 190 bpm, 3 s at 160.
  std::set<int> lengths;
  for (const PairedTake& take : generate_salsa({.minutes = 3}))
    for (const LabelInterval& move : take.labels) {
      EXPECT_GE(move.end - move.start, 151);
      EXPECT_LE(move.end - move.start, 181);
      lengths.insert((move.end - move.start) / 4);
    }
  EXPECT_GT(lengths.size(), 3U);
  for (const PairedTake& take : generate_salsa({.minutes = 0.5, .tempo_bpm = 180}))
    EXPECT_NEAR(take.labels.front().end, 160, 1);
}

/// Mean horizontal distance of the toe-bases from one another.
double stride(const PairedTake& take) {
  double sum = 0;
  for (const Pose& pose : take.a.poses) {
    const Vec3 d = joint(pose, left_toe_base) - joint(pose, right_toe_base);
    sum += std::hypot(d.x(), d.z());
  }
  return sum / static_cast<double>(take.a.poses.size());
}

TEST(Salsa, ABeginnerTakesSmallerSteps) {
  const PerformerOptions beginner{.height_m = 1.80, .performance = performance_of_skill(0)};
  const auto expert = generate_salsa({.minutes = 0.3}),
             novice = generate_salsa({.minutes = 0.3, .a = beginner});
  EXPECT_LT(stride(novice[0]), 0.95 * stride(expert[0]));
}

TEST(Salsa, ABeginnersFeetStayPlantedAndBonesRigid) {
  const PerformerOptions beginner{.height_m = 1.80, .performance = performance_of_skill(0)};
  for (const PairedTake& take : generate_salsa({.minutes = 1, .a = beginner})) {
    const Body first = body_of(take.a.poses.front());
    const double rest = body_of(take.a.poses).toe_rest_height;
    for (std::size_t f = 1; f < take.a.poses.size(); ++f) {
      const Pose &before = take.a.poses[f - 1], &now = take.a.poses[f];
      ASSERT_LT(largest_length_difference(body_of(now), first), 1e-9);
      for (const int toe_base : {left_toe_base, right_toe_base}) {
        if (std::max(before(toe_base, 1), now(toe_base, 1)) > rest + 1e-4) continue;
        ASSERT_LT(apart(before, toe_base, now, toe_base), 0.001);
      }
    }
  }
}

TEST(Salsa, StaysAPairForOtherRatesAndSizes) {
  for (const ChoreographyOptions& options :
       {ChoreographyOptions{.minutes = 0.5, .fps = 120},
        ChoreographyOptions{.minutes = 0.5, .fps = 30, .tempo_bpm = 150},
        ChoreographyOptions{.minutes = 0.5, .a = {.height_m = 1.95}, .b = {.height_m = 1.52}},
        ChoreographyOptions{
            .minutes = 0.5, .a = {.height_m = 1.75, .arm_scale = 1.2}, .b = {.height_m = 1.70}},
        ChoreographyOptions{
            .minutes = 0.5, .a = {.height_m = 1.6, .leg_scale = 0.9}, .b = {.leg_scale = 1.1}}})
    for (const PairedTake& take : generate_salsa(options))
      for (std::size_t f = 0; f < take.a.poses.size(); ++f) {
        ASSERT_TRUE(take.a.poses[f].allFinite() && take.b.poses[f].allFinite());
        ASSERT_LT(apart(take.a.poses[f], Root, take.b.poses[f], Root), 1.3);
      }
}

TEST(Salsa, GenerationStopsBetweenTakesWhenAskedTo) {
  int asked = 0;
  const auto takes = generate_salsa({.minutes = 0.5, .take_seconds = 6},
                                    [&](double, std::string_view) { return ++asked < 3; });
  EXPECT_EQ(takes.size(), 2u);
}

TEST(Salsa, RefusesOptionsThatMakeNoDance) {
  EXPECT_THROW(generate_salsa({.minutes = 0}), std::invalid_argument);
  EXPECT_THROW(generate_salsa({.fps = -60}), std::invalid_argument);
  EXPECT_THROW(generate_salsa({.tempo_bpm = -1}), std::invalid_argument);
  EXPECT_THROW(generate_salsa({.take_seconds = std::nan("")}), std::invalid_argument);
  EXPECT_THROW(generate_salsa({.a = {.height_m = 0.3}}), std::invalid_argument);
}

}  // namespace
}  // namespace abrazo::salsa_test
