#include "core/synthesis/motion/partner_motion.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>
#include <limits>
#include <random>

#include "core/library/build/motion_library_builder.hpp"
#include "core/motion/body/body_segments.hpp"
#include "core/motion/body/joint_set.hpp"
#include "core/synthesis/step/partner_synthesizer.hpp"
#include "core/synthesis/step/synthesizer_state.hpp"
#include "tests/support/bodies.hpp"
#include "tests/support/libraries.hpp"
#include "tests/support/settings.hpp"

namespace abrazo::partner_motion_test {
namespace {

constexpr double step_s = 1.0 / 60;

std::unique_ptr<PartnerSynthesizer> synthesizer_with(const Settings& settings) {
  auto synthesizer = std::move(*PartnerSynthesizer::create(test::small_library(), settings));
  synthesizer->set_user_body(synthesizer->library().usual_active_body().body);
  return synthesizer;
}

const Clip& user() {
  static const Clip clip = test::swinging_take("user", 600, 4).a;
  return clip;
}

/// The partner's frames, one after the other.
class Shown {
 public:
  void add(const FrameResult& frame) {
    before_previous_ = previous_;
    previous_ = partner_;
    partner_ = frame.passive();
    ++count_;
  }
  /// How much farther its joints moved on average than their speed explains [m].
  double kink() const {
    return count_ < 3 ? 0 : (partner_ - 2 * previous_ + before_previous_).rowwise().norm().mean();
  }
  double jump() const { return count_ < 2 ? 0 : (partner_ - previous_).rowwise().norm().maxCoeff(); }

 private:
  Pose partner_, previous_, before_previous_;
  int count_ = 0;
};

TEST(PartnerMotion, TheResultIsContinuousAtAChangeOfSource) {
  auto synthesizer = synthesizer_with(test::responsive_by_pose());
  const auto& library = synthesizer->library();
  Shown shown;
  int changes = 0;
  for (int step = 0; step < 300; ++step) {
    // A pin and its end change the source for certain.
    if (step % 60 == 20)
      synthesizer->pin_pair(library.find_pair(step % 120 < 60 ? "second" : "first", 40 + step / 4, false));
    if (step % 60 == 50) synthesizer->pin_pair(std::nullopt);
    const FrameResult& frame =
        synthesizer->step(user().poses[static_cast<std::size_t>(step)], Duration(step == 0 ? 0 : step_s));
    ASSERT_NE(frame.status, StepStatus::Failed) << frame.message;
    shown.add(frame);
    if (!frame.source_changed) continue;
    ++changes;
    EXPECT_LT(shown.kink(), 0.01) << step;
  }
  EXPECT_GT(changes, 4);
}

/// Pair 0 is a pair like any other, and not the sign of a partner without a source.
TEST(PartnerMotion, TheFirstPairOfALibraryIsLeftAtStepsShorterThanItsFrames) {
  const auto library = test::small_library();
  const Settings settings = test::responsive_by_pose();
  const Pose& pose = user().poses.front();
  PartnerMotion motion;
  for (const double pairs : {0.0, 0.5, 1.0, 1.5}) {
    const MotionStep step{.library = *library,
                          .settings = settings,
                          .user = pose,
                          .user_root = root_frame(pose),
                          .elapsed_s = 0.5 * step_s,
                          .chosen = 0,
                          .shown = std::nullopt};
    PartnerMover(motion, step).move();
    EXPECT_NEAR(motion.playhead.pair + motion.playhead.fraction, pairs, 1e-9);
  }
}

TEST(PartnerMotion, AChangeOfSourceLeavesTheCentreOfMassOnItsWay) {
  // Without what the user's hands and the floor ask for: how a body whose shape fades is carried.
  Settings settings = test::responsive_by_pose();
  settings.foot_locks = settings.collisions = false;
  settings.hold_weight = 0;
  settings.place_rate = 0.5;
  auto synthesizer = synthesizer_with(settings);
  const auto& library = synthesizer->library();
  const auto segments = body_segments(SegmentTable::Mean);
  std::vector<Vec3> centres, roots;
  int changed_at = 0;
  for (int step = 0; step < 120; ++step) {
    if (step == 60) synthesizer->pin_pair(library.find_pair("second", 50, false));
    const FrameResult& frame =
        synthesizer->step(user().poses[static_cast<std::size_t>(step)], Duration(step == 0 ? 0 : step_s));
    if (frame.source_changed && step >= 60) changed_at = step;
    centres.push_back(centre_of_mass(segments, frame.passive()));
    roots.emplace_back(frame.passive().row(0));
  }
  ASSERT_GE(changed_at, 60);
  // Greatest horizontal acceleration while the change fades [m/s2].
  const auto greatest = [&](const std::vector<Vec3>& path) {
    double most = 0;
    for (auto i = static_cast<std::size_t>(changed_at); i < 85; ++i) {
      Vec3 change = path[i + 1] - 2 * path[i] + path[i - 1];
      change.y() = 0;
      most = std::max(most, change.norm() / (step_s * step_s));
    }
    return most;
  };
  EXPECT_LT(greatest(centres), 0.7 * greatest(roots)) << greatest(centres) << " " << greatest(roots);
}

/// A recorded partner who stands for a second and then walks off at 0.6 m/s.
TEST(PartnerMotion, TheRecordingCarriesByItsMeanSpeedOfTheHalfSecondToCome) {
  PairedTake take = test::swinging_take("walks", 120, 1);
  for (std::size_t frame = 0; frame < take.a.poses.size(); ++frame) {
    const double walked_m = 0.6 * std::max(0.0, static_cast<double>(frame) * step_s - 1);
    take.a.poses[frame] = test::standing_pose();
    take.b.poses[frame] = test::moved(test::standing_pose(), 3.1, Vec3(0, 0, 0.9 + walked_m));
  }
  std::vector<PairedTake> takes;
  takes.push_back(std::move(take));
  const MotionLibrary library = std::move(*build_library("walks", std::move(takes), {}, {}));
  const Settings settings = test::responsive_by_pose();
  const Pose user = test::standing_pose();
  PartnerMotion motion;
  const auto advance = [&](int frame, bool stands) {
    const MotionStep step{.library = library,
                          .settings = settings,
                          .user = user,
                          .user_root = root_frame(user),
                          .elapsed_s = frame == 0 ? 0 : step_s,
                          .chosen = 0,
                          .stands = stands,
                          .shown = std::nullopt};
    PartnerMover(motion, step).move();
    return motion.place.recorded_speed().norm();
  };
  double filtered = 0;  // v' = (c - v) / 0.3 s
  for (int frame = 0; frame < 118; ++frame) {
    const double to_come = 0.6 * std::clamp((frame * step_s + 0.5 - 1) / 0.5, 0.0, 1.0);
    if (frame > 0) filtered = to_come + (filtered - to_come) * std::exp(-step_s / 0.3);
    ASSERT_NEAR(advance(frame, false), filtered, 1e-6) << frame;
  }
  EXPECT_GT(filtered, 0.5) << "also where less than half a second is left";
  const double before = filtered;
  EXPECT_NEAR(advance(118, true), before * std::exp(-step_s / 0.3), 1e-6)
      << "a source that is held carries no more";
}

/// A partner who stands on both feet throughout.
MotionLibrary library_of_a_stand() {
  PairedTake take = test::swinging_take("stands", 120, 1);
  for (Pose& pose : take.b.poses) pose = test::moved(test::standing_pose(), 3.1, Vec3(0, 0, 0.7));
  for (Pose& pose : take.a.poses) pose = test::standing_pose();
  std::vector<PairedTake> takes;
  takes.push_back(std::move(take));
  return std::move(*build_library("stands", std::move(takes), {}, {}));
}

TEST(PartnerMotion, AStandingPartnerLeansAfterTheUserOnFeetThatStayWhereTheyAre) {
  const MotionLibrary library = library_of_a_stand();
  const Settings settings = test::responsive_by_pose();
  PartnerMotion motion;
  Pose first, last;
  for (int frame = 0; frame < 60; ++frame) {
    const Pose user = test::moved(test::standing_pose(), 0, Vec3(0.001 * frame, 0, 0));
    const MotionStep step{.library = library,
                          .settings = settings,
                          .user = user,
                          .user_root = root_frame(user),
                          .elapsed_s = frame == 0 ? 0 : step_s,
                          .chosen = frame,
                          .shown = std::nullopt};
    PartnerMover mover(motion, step);
    last = mover.adapt(mover.move().bottomRows<joint_count>());
    if (frame == 0) first = last;
    for (const FootPlants::Foot& foot : motion.plants.feet()) EXPECT_FALSE(foot.steps) << frame;
  }
  EXPECT_GT((last.row(0) - first.row(0)).norm(), 0.02);
  for (const int toe_base : {joints::left_toe_base, joints::right_toe_base})
    EXPECT_LT((last.row(toe_base) - first.row(toe_base)).norm(), 0.002);
}

TEST(PartnerMotion, NothingOfATransitionIsLeftWhenAPartnerBeginsAnew) {
  auto used = synthesizer_with(test::responsive_by_pose());
  auto fresh = synthesizer_with(test::responsive_by_pose());
  const auto& library = used->library();
  used->pin_pair(library.find_pair("first", 40, false));
  for (std::size_t step = 0; step < 30; ++step) {
    if (step == 28) used->pin_pair(library.find_pair("second", 90, false));
    used->step(user().poses[step], Duration(step == 0 ? 0 : step_s));
  }
  used->reset();
  fresh->pin_pair(library.find_pair("second", 90, false));
  EXPECT_EQ(used->step(user().poses[30], Duration(0)).result,
            fresh->step(user().poses[30], Duration(0)).result);
}

TEST(PartnerMotion, GoesOnFromWhereItIsAfterTrackingWasLost) {
  auto synthesizer = synthesizer_with(test::responsive_by_pose());
  Shown shown;
  for (int step = 0; step < 120; ++step) {
    const double elapsed_s = step == 0 ? 0 : step == 60 ? 1.0 : step_s;
    shown.add(synthesizer->step(user().poses[static_cast<std::size_t>(step < 60 ? step : 3 * step)],
                                Duration(elapsed_s)));
    EXPECT_LT(shown.jump(), 0.08) << step;
  }
}

TEST(PartnerMotion, GoesOnFromWhereItIsWhenTheUserIsMeasuredAnew) {
  auto synthesizer = synthesizer_with(test::responsive_by_pose());
  Shown shown;
  for (int step = 0; step < 120; ++step) {
    if (step == 60) {
      Body tall = synthesizer->library().usual_active_body().body;
      for (double& length : tall.bone_lengths) length *= 0.85;
      synthesizer->set_user_body(tall);
    }
    shown.add(
        synthesizer->step(user().poses[static_cast<std::size_t>(step)], Duration(step == 0 ? 0 : step_s)));
    EXPECT_LT(shown.jump(), 0.15) << step;
  }
}

TEST(PartnerMotion, AFailedStepLeavesNothingBehind) {
  auto with = synthesizer_with(test::responsive_by_pose()),
       without = synthesizer_with(test::responsive_by_pose());
  Pose nowhere = user().poses[0];
  nowhere(7, 1) = std::numeric_limits<double>::quiet_NaN();
  Pose far = user().poses[0] * 1e160;
  for (int step = 0; step < 60; ++step) {
    const Pose& pose = user().poses[static_cast<std::size_t>(step)];
    if (step == 30) {
      EXPECT_EQ(with->step(nowhere, Duration(0.5 * step_s)).status, StepStatus::Failed);
      EXPECT_EQ(with->step(far, Duration(0.25 * step_s)).status, StepStatus::Failed);
    }
    const PairPose one = with->step(pose, Duration(step == 0    ? 0
                                                   : step == 30 ? 0.25 * step_s
                                                                : step_s))
                             .result;
    const PairPose other = without->step(pose, Duration(step == 0 ? 0 : step_s)).result;
    ASSERT_LT((one - other).cwiseAbs().maxCoeff(), 1e-9) << step;
  }
}

/// Two people who hold hands throughout.
MotionLibrary library_of_a_hold() {
  PairedTake take = test::swinging_take("hold", 240, 5, 0.62);
  for (std::size_t frame = 0; frame < take.a.poses.size(); ++frame)
    take.b.poses[frame].row(joints::right_hand) =
        take.a.poses[frame].row(joints::left_hand) + Eigen::RowVector3d(0.01, 0.02, 0.03);
  std::vector<PairedTake> takes;
  takes.push_back(std::move(take));
  return std::move(*build_library("hold", std::move(takes), {}, {}));
}

TEST(PartnerMotion, AHoldIsHeld) {
  const auto library = std::make_shared<const MotionLibrary>(library_of_a_hold());
  auto synthesizer = std::move(*PartnerSynthesizer::create(library, test::responsive_by_pose()));
  const Clip holding = test::swinging_take("hold", 240, 5).a;
  int held = 0;
  for (int step = 0; step < 120; ++step) {
    const FrameResult& frame =
        synthesizer->step(holding.poses[static_cast<std::size_t>(step)], Duration(step == 0 ? 0 : step_s));
    for (const HandHold& hold : frame.holds) {
      if (hold.strength < 0.999) continue;
      const int active = hold.active_left ? joints::left_hand : joints::right_hand;
      const int passive = hold.passive_left ? joints::left_hand : joints::right_hand;
      const Eigen::RowVector3d apart = frame.passive().row(passive) - frame.active().row(active);
      if (apart.norm() < hold_ends_m) ++held;
    }
  }
  EXPECT_GT(held, 60);
}

/// Two people who stand still and hold hands, the user's left and the partner's right; the partner is 0.9 m
/// away.
MotionLibrary library_of_a_standing_hold() {
  PairedTake take = test::swinging_take("stands", 120, 1);
  for (std::size_t frame = 0; frame < take.a.poses.size(); ++frame) {
    Pose &a = take.a.poses[frame], &b = take.b.poses[frame];
    a = test::standing_pose();
    b = test::moved(test::standing_pose(), 3.1, Vec3(0, 0, 0.9));
    b.row(joints::right_hand) = a.row(joints::left_hand) + Eigen::RowVector3d(0, 0, 0.12);
  }
  std::vector<PairedTake> takes;
  takes.push_back(std::move(take));
  return std::move(*build_library("stands", std::move(takes), {}, {}));
}

/// Where the partner's root comes to rest while the user's left hand is drawn off by so much.
Vec3 rests_at(const MotionLibrary& library, const Vec3& hand_moves, double hold_weight) {
  Settings settings = test::responsive_by_pose();
  settings.hold_weight = hold_weight;
  settings.foot_locks = false;
  PartnerMotion motion;
  Pose partner;
  for (int frame = 0; frame < 110; ++frame) {
    Pose user = test::standing_pose();
    user.row(joints::left_hand) += (std::min(1.0, frame / 30.0) * hand_moves).transpose();
    const MotionStep step{.library = library,
                          .settings = settings,
                          .user = user,
                          .user_root = root_frame(user),
                          .elapsed_s = frame == 0 ? 0 : step_s,
                          .chosen = frame,
                          .shown = std::nullopt};
    PartnerMover mover(motion, step);
    partner = mover.adapt(mover.move().bottomRows<joint_count>());
  }
  return partner.row(0);
}

TEST(PartnerMotion, AHeldHandDrawsThePartnerAlongButNotIntoTheUser) {
  const MotionLibrary library = library_of_a_standing_hold();
  // Beside the user: there the partner goes along, also where this is nearer, up to a tenth of a metre nearer
  // than recorded.
  const Vec3 beside(0.8, 0, 0);
  const Vec3 without = rests_at(library, beside, 0), drawn = rests_at(library, beside, 50);
  const double without_m = std::hypot(without.x(), without.z()), drawn_m = std::hypot(drawn.x(), drawn.z());
  EXPECT_GT(drawn.x(), without.x() + 0.05);
  EXPECT_GT(drawn_m, 0.9 - 0.1);
  EXPECT_LT(drawn_m, without_m - 0.02);
  // Behind the user: what the partner is nearer is of the place that follows the hand, and not of the pull.
  for (const double behind_m : {0.7, 0.8, 0.9}) {
    const Vec3 behind(0, 0, -behind_m);
    const double unheld_m = rests_at(library, behind, 0).z(), held_m = rests_at(library, behind, 50).z();
    ASSERT_LT(unheld_m, 0.9 - 0.1) << "a tenth of a metre nearer than recorded";
    EXPECT_GT(held_m, unheld_m - 0.01) << behind_m;
  }
}

TEST(PartnerMotion, FeetThatWereLetGoAreNotSaidToBeLocked) {
  // Hands pulled hard, and a user who is somewhere else a few times a second.
  const auto library = std::make_shared<const MotionLibrary>(library_of_a_hold());
  const Clip dance = test::swinging_take("hold", 240, 5).a;
  int let_go = 0;
  for (const auto& [hold_weight, morph_weight, stays] : {std::tuple(300.0, 10.0, 5),
                                                         {50.0, 50.0, 30},
                                                         {300.0, 500.0, 5},
                                                         {1000.0, 50.0, 5},
                                                         {1000.0, 50.0, 30}}) {
    Settings settings = test::responsive_by_pose();
    settings.hold_weight = hold_weight;
    settings.morph_weight = morph_weight;
    auto synthesizer = std::move(*PartnerSynthesizer::create(library, settings));
    std::mt19937 random(3);
    std::normal_distribution<double> turn(0, 1), away(0, 0.5);
    double yaw = 0;
    Vec3 place = Vec3::Zero();
    for (int frame = 0; frame < 400; ++frame) {
      if (frame % stays == stays - 1) yaw = turn(random), place.x() = away(random), place.z() = away(random);
      const Pose& pose = dance.poses[static_cast<std::size_t>(frame % 200)];
      const FrameResult& result = synthesizer->step(test::moved(pose, yaw, place), Duration(step_s));
      if (result.status != StepStatus::Relaxed) continue;
      ++let_go;
      for (const FootLock& lock : result.foot_locks) {
        EXPECT_TRUE(lock.active_body) << result.message;
        EXPECT_EQ(result.message, "the partner's foot locks were let go");
      }
    }
  }
  EXPECT_GT(let_go, 0) << "feet must be let go to test anything";
}

TEST(PartnerMotion, AHoldIsTakenUpSlowlyAgainAfterTheUserWasLost) {
  const auto library = std::make_shared<const MotionLibrary>(library_of_a_hold());
  auto synthesizer = std::move(*PartnerSynthesizer::create(library, test::responsive_by_pose()));
  const Clip holding = test::swinging_take("hold", 240, 5).a;
  const auto strongest = [&](int step) {
    const FrameResult& frame =
        synthesizer->step(holding.poses[static_cast<std::size_t>(step)], Duration(step == 0 ? 0 : step_s));
    double strength = 0;
    for (const HandHold& hold : frame.holds) strength = std::max(strength, hold.strength);
    return strength;
  };
  int step = 0;
  while (step < 120 && strongest(step) < 0.999) ++step;
  ASSERT_LT(step, 120) << "never held";
  synthesizer->reset();
  EXPECT_LT(strongest(step + 1), 0.5);
}

TEST(PartnerMotion, NeverTeleportsWhateverIsChanged) {
  EXPECT_TRUE(rc::check("changes of everything", [] {
    auto synthesizer = synthesizer_with(test::responsive_by_pose());
    Settings settings = synthesizer->settings();
    Shown shown;
    for (int step = 0; step < 90; ++step) {
      if (*rc::gen::inRange(0, 12) == 0) {
        switch (*rc::gen::inRange(0, 6)) {
          case 0:
            settings.foot_locks = !settings.foot_locks;
            break;
          case 1:
            settings.hold_weight = settings.hold_weight > 0 ? 0 : 50;
            break;
          case 2:
            settings.collisions = !settings.collisions;
            break;
          case 3:
            settings.place_rate = *rc::gen::element(2.0, 5.0, 7.0);
            break;
          case 4:
            synthesizer->pin_pair(*rc::gen::inRange(0, synthesizer->library().pair_count()));
            break;
          default:
            synthesizer->pin_pair(std::nullopt);
        }
        synthesizer->set_settings(settings);
      }
      const double elapsed_s = step == 0 ? 0 : *rc::gen::weightedElement<double>({{20, step_s}, {1, 0.5}});
      const FrameResult& frame =
          synthesizer->step(user().poses[static_cast<std::size_t>(step)], Duration(elapsed_s));
      RC_ASSERT(frame.status != StepStatus::Failed);
      shown.add(frame);
      RC_ASSERT(shown.jump() < 0.25);
    }
  }));
}

}  // namespace
}  // namespace abrazo::partner_motion_test
