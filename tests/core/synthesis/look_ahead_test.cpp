#include "core/synthesis/step/look_ahead.hpp"

#include <gtest/gtest.h>

#include "core/library/build/motion_library_builder.hpp"
#include "core/session/frames/take_frames.hpp"
#include "core/synthesis/step/partner_synthesizer.hpp"
#include "tests/support/bodies.hpp"
#include "tests/support/libraries.hpp"

namespace abrazo::look_ahead_test {
namespace {

// Positions of a metre or two, turned there and back: far above rounding, far below what is seen.
constexpr double same_m = 1e-9;

double apart(const Pose& a, const Pose& b) {
  return (a - b).rowwise().norm().maxCoeff();
}

Pose recorded(const MotionLibrary& library, int pair, bool active) {
  const PairPose& pose = library.pose(pair);
  return to_world(active ? Pose(pose.topRows<joint_count>()) : Pose(pose.bottomRows<joint_count>()),
                  library.root(pair));
}

/// A user who stands and moves as somebody recorded, answered by that pair unedited.
FrameResult as_recorded(const MotionLibrary& library, int pair, UserRole role) {
  FrameResult frame;
  frame.query_world = recorded(library, pair, role == UserRole::Active);
  frame.query_root = role == UserRole::Active ? library.root(pair) : root_frame(frame.query_world);
  frame.selected_pair = library.pair_in_world(pair, frame.query_root, role == UserRole::Passive);
  frame.result = frame.selected_pair;
  frame.candidates.emplace_back().pair = pair;
  frame.selected = 0;
  frame.status = StepStatus::Ok;
  return frame;
}

/// The same with the user somewhere else, turned.
void move_user(FrameResult& frame, const MotionLibrary& library, UserRole role, double yaw_rad,
               const Vec3& offset) {
  frame.query_world = test::moved(frame.query_world, yaw_rad, offset);
  frame.query_root = root_frame(frame.query_world);
  frame.selected_pair =
      library.pair_in_world(frame.candidates[0].pair, frame.query_root, role == UserRole::Passive);
  frame.result = frame.selected_pair;
}

class LookAhead : public testing::TestWithParam<UserRole> {
 protected:
  std::shared_ptr<const MotionLibrary> library = test::small_library();
  int pair = library->find_pair("first", 40, false);
  bool partner_is_active() const { return GetParam() == UserRole::Passive; }
  FrameResult frame = as_recorded(*library, pair, GetParam());
  std::vector<Pose> ahead() const { return look_ahead(frame, *library, GetParam()); }
};

TEST_P(LookAhead, OfTheRecordedUserIsTheRecordedPartner) {
  const auto poses = ahead();
  ASSERT_EQ(poses.size(), 11U) << "a second, each tenth of it";
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const int later = library->later_pair(pair, 6 * static_cast<int>(i));  // 60 pairs a second
    EXPECT_LT(apart(poses[i], recorded(*library, later, partner_is_active())), same_m) << i;
  }
}

TEST_P(LookAhead, TurnsAndGoesWithTheUser) {
  const auto before = ahead();
  const double yaw_rad = 1.1;
  const Vec3 offset(0.7, 0, -0.4);
  move_user(frame, *library, GetParam(), yaw_rad, offset);
  const auto poses = ahead();
  ASSERT_EQ(poses.size(), before.size());
  for (std::size_t i = 0; i < poses.size(); ++i)
    EXPECT_LT(apart(poses[i], test::moved(before[i], yaw_rad, offset)), same_m) << i;
}

TEST_P(LookAhead, KeepsRecordedHeightsWhereverTheUsersRootIs) {
  const auto before = ahead();
  frame.query_root.position.y() += 0.2;
  const auto poses = ahead();
  for (std::size_t i = 0; i < poses.size(); ++i) EXPECT_LT(apart(poses[i], before[i]), same_m) << i;
}

TEST_P(LookAhead, BeginsAtThePartnerThatIsSeenAndGoesOverToTheRecording) {
  const auto unedited = ahead();
  const Vec3 edit(0.05, -0.02, 0.08);
  const int first = partner_is_active() ? 0 : joint_count;
  frame.result.middleRows<joint_count>(first).rowwise() += edit.transpose();
  const auto poses = ahead();
  EXPECT_EQ(poses[0], Pose(frame.result.middleRows<joint_count>(first)));
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const double left = std::max(0.0, 1 - static_cast<double>(i) / 4);  // gone after 0.4 s
    EXPECT_NEAR(apart(poses[i], unedited[i]), left * edit.norm(), same_m) << i;
  }
}

TEST_P(LookAhead, EndsWithTheTake) {
  frame = as_recorded(*library, library->find_pair("first", 179 - 25, false), GetParam());
  EXPECT_EQ(ahead().size(), 5U) << "now and 6, 12, 18, 24 of the 25 frames that are left";
  frame = as_recorded(*library, library->find_pair("first", 179, false), GetParam());
  EXPECT_EQ(ahead().size(), 1U);
}

TEST_P(LookAhead, IsNoneWhereThereIsNothingToGoOnFrom) {
  frame.status = StepStatus::Failed;
  EXPECT_TRUE(ahead().empty());
  frame.status = StepStatus::Relaxed;
  EXPECT_FALSE(ahead().empty());
  frame.candidates[0].pair = library->pair_count();  // of another library
  EXPECT_TRUE(ahead().empty());
  frame.selected = -1;
  EXPECT_TRUE(ahead().empty());
}

TEST_P(LookAhead, HasTheLengthAndTheStepsThatAreAskedFor) {
  EXPECT_EQ(look_ahead(frame, *library, GetParam(), 0.5, 0.05).size(), 11U);
  EXPECT_EQ(look_ahead(frame, *library, GetParam(), 0, 0.1).size(), 1U);
  EXPECT_TRUE(look_ahead(frame, *library, GetParam(), 1, 0).empty());
}

TEST_P(LookAhead, OfASolvedFrameBeginsAtItsPartner) {
  Settings settings = *preset("paper");
  settings.user_role = GetParam();
  auto synthesizer = std::move(*PartnerSynthesizer::create(library, settings));
  const PairedTake take = test::swinging_take("user", 60, 5);
  const Clip& user = partner_is_active() ? take.b : take.a;
  for (std::size_t i = 0; i < user.poses.size(); i += 4) {
    const FrameResult& solved = synthesizer->step(user.poses[i], Duration(1.0 / 15));
    ASSERT_NE(solved.status, StepStatus::Failed) << solved.message;
    const auto poses = look_ahead(solved, *library, GetParam());
    ASSERT_FALSE(poses.empty());
    EXPECT_EQ(poses[0], partner_is_active() ? Pose(solved.active()) : Pose(solved.passive()));
  }
}

INSTANTIATE_TEST_SUITE_P(Roles, LookAhead, testing::Values(UserRole::Active, UserRole::Passive),
                         [](const auto& role) {
                           return role.param == UserRole::Active ? "ActiveUser" : "PassiveUser";
                         });

TEST(LookAheadOfATake, IsThatOfTheOneBehindWhoeverLeads) {
  for (const ActivePerformer leads : {ActivePerformer::A, ActivePerformer::B}) {
    std::vector<PairedTake> takes = {test::swinging_take("only", 180, 1)};
    takes[0].roles = {{0, 180, leads}};
    const auto library =
        std::make_shared<const MotionLibrary>(std::move(*build_library("small", std::move(takes), {}, {})));
    const auto take = std::move(*TakeFrames::create(library, "only"));
    const FrameSnapshotPtr frame = take->at(1.0);
    EXPECT_EQ(partner_row(frame->result), joint_count);
    const auto poses = look_ahead(frame->result, *library, frame->settings.user_role);
    ASSERT_EQ(poses.size(), 11U);
    EXPECT_LT(apart(poses[5], take->at(1.5)->result.passive()), same_m);
  }
}

}  // namespace
}  // namespace abrazo::look_ahead_test
