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

#include "core/motion/body.hpp"
#include "core/motion/joint_set.hpp"

namespace abrazo {
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
  EXPECT_EQ(moves, (std::set<std::string>{"open_hold", "closed_hold", "turn", "cross_body_lead"}));
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

TEST(Salsa, OpenHoldJoinsBothHands) {
  const Spread lead =
      spread("open_hold", [](auto& a, auto& b) { return apart(a, left_hand, b, right_hand); });
  const Spread other =
      spread("open_hold", [](auto& a, auto& b) { return apart(a, right_hand, b, left_hand); });
  EXPECT_LT(lead.most, 0.08);
  EXPECT_LT(lead.mean, 0.05);
  EXPECT_LT(other.most, 0.08);
  EXPECT_LT(other.mean, 0.05);
}

TEST(Salsa, ClosedHoldPutsHisHandOnHerBackAndHersOnHisShoulder) {
  const Spread side =
      spread("closed_hold", [](auto& a, auto& b) { return apart(a, left_hand, b, right_hand); });
  const Spread shoulder =
      spread("closed_hold", [](auto& a, auto& b) { return apart(a, right_shoulder, b, left_hand); });
  const Spread back = spread("closed_hold", [](auto& a, auto& b) {
    return std::min(apart(a, right_hand, b, Thorax), apart(a, right_hand, b, UpperBack));
  });
  EXPECT_LT(side.most, 0.08);
  EXPECT_LT(side.mean, 0.05);
  EXPECT_LT(shoulder.most, 0.12);
  EXPECT_LT(back.most, 0.16);
}

TEST(Salsa, HeTurnsHerOnceToHerRightUnderTheRaisedHold) {
  int turns = 0;
  for (const PairedTake& take : takes())
    for (const LabelInterval& move : take.labels) {
      if (move.label != "turn") continue;
      double turned = 0, highest = 0, widest = 0;
      for (int f = move.start + 1; f < move.end; ++f) {
        const Pose &before = take.b.poses[static_cast<std::size_t>(f) - 1],
                   &now = take.b.poses[static_cast<std::size_t>(f)];
        const Vec3 was = joint(before, left_shoulder) - joint(before, right_shoulder);
        const Vec3 is = joint(now, left_shoulder) - joint(now, right_shoulder);
        turned += std::atan2(was.z() * is.x() - was.x() * is.z(), was.x() * is.x() + was.z() * is.z());
        highest = std::max(highest, now(right_hand, 1) - now(Head, 1));
        widest =
            std::max(widest, apart(take.a.poses[static_cast<std::size_t>(f)], left_hand, now, right_hand));
      }
      ++turns;
      EXPECT_NEAR(turned, -2 * std::numbers::pi, 1.3)
          << take.name << " at " << move.start;  // the couple may turn too
      EXPECT_GT(highest, 0.15);
      EXPECT_LT(widest, 0.085);
    }
  EXPECT_GT(turns, 10);
}

TEST(Salsa, InACrossBodyLeadTheyExchangePlacesHoldingOneHand) {
  const Spread lead =
      spread("cross_body_lead", [](auto& a, auto& b) { return apart(a, left_hand, b, right_hand); });
  EXPECT_LT(lead.most, 0.08);
  EXPECT_LT(lead.mean, 0.05);
  int leads = 0;
  for (const PairedTake& take : takes())
    for (const LabelInterval& move : take.labels) {
      if (move.label != "cross_body_lead") continue;
      const auto direction = [&](int frame) -> Vec3 {
        const auto f = static_cast<std::size_t>(frame);
        return (joint(take.b.poses[f], Root) - joint(take.a.poses[f], Root)).normalized();
      };
      EXPECT_LT(direction(move.start).dot(direction(move.end - 1)), -0.7)
          << take.name << " at " << move.start;
      ++leads;
    }
  EXPECT_GT(leads, 5);
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
  for (const PairedTake& take : takes())
    for (std::size_t f = 0; f < take.a.poses.size(); ++f) {
      const Pose &a = take.a.poses[f], &b = take.b.poses[f];
      ASSERT_GT(apart(a, Root, b, Root), 0.35);
      ASSERT_GT(apart(a, Head, b, Head), 0.25);
      for (const auto& [elbow, wrist] :
           {std::pair(left_elbow, left_wrist), std::pair(right_elbow, right_wrist)}) {
        ASSERT_GT(from_spine(joint(a, elbow), joint(a, wrist), b), 0.08) << take.name << " frame " << f;
        ASSERT_GT(from_spine(joint(b, elbow), joint(b, wrist), a), 0.08) << take.name << " frame " << f;
      }
    }
}

TEST(Salsa, AcceleratesNoMoreThanCapturedDancersDo) {
  // 99.9th percentile of |second difference| x 60^2 [m/s^2] of each joint over all eleven captured salsa
  // takes at 60 fps: CMU subject 60 (leads), subject 61 (follows).
  constexpr std::array<double, joint_count> leader = {66,  144, 114, 135, 189, 220, 165, 96, 108,
                                                      172, 194, 90,  110, 50,  63,  76,  77, 180,
                                                      198, 196, 202, 274, 280, 269, 268};
  constexpr std::array<double, joint_count> follower = {29, 40, 49, 54, 67, 111, 38, 80,  55, 67, 103, 26, 29,
                                                        27, 35, 36, 34, 66, 73,  81, 134, 58, 71, 76,  299};
  for_each_performer([&](const PairedTake& take, const Clip& clip) {
    const auto& limit = &clip == &take.a ? leader : follower;
    for (std::size_t f = 2; f < clip.poses.size(); ++f) {
      const Pose change = (clip.poses[f] - 2 * clip.poses[f - 1] + clip.poses[f - 2]) * clip.fps * clip.fps;
      for (int j = 0; j < joint_count; ++j)
        ASSERT_LT(change.row(j).norm(), 1.5 * limit[static_cast<std::size_t>(j)])
            << take.name << " frame " << f << " " << joint_names[static_cast<std::size_t>(j)];
    }
  });
}

TEST(Salsa, StaysAPairForOtherRatesAndSizes) {
  for (const ChoreographyOptions& options :
       {ChoreographyOptions{.minutes = 0.5, .fps = 120},
        ChoreographyOptions{.minutes = 0.5, .fps = 30, .tempo_bpm = 150},
        ChoreographyOptions{.minutes = 0.5, .leader_height_m = 1.95, .follower_height_m = 1.52},
        ChoreographyOptions{.minutes = 0.5, .leader_height_m = 1.75, .follower_height_m = 1.70}})
    for (const PairedTake& take : generate_salsa(options))
      for (std::size_t f = 0; f < take.a.poses.size(); ++f) {
        ASSERT_TRUE(take.a.poses[f].allFinite() && take.b.poses[f].allFinite());
        ASSERT_LT(apart(take.a.poses[f], left_hand, take.b.poses[f], right_hand),
                  0.12);  // a raised hold may be out of reach
      }
}

TEST(Salsa, RefusesOptionsThatMakeNoDance) {
  EXPECT_THROW(generate_salsa({.minutes = 0}), std::invalid_argument);
  EXPECT_THROW(generate_salsa({.fps = -60}), std::invalid_argument);
  EXPECT_THROW(generate_salsa({.tempo_bpm = 0}), std::invalid_argument);
  EXPECT_THROW(generate_salsa({.take_seconds = std::nan("")}), std::invalid_argument);
  EXPECT_THROW(generate_salsa({.leader_height_m = 0.3}), std::invalid_argument);
}

}  // namespace
}  // namespace abrazo
