#include "core/evaluation/takes/take_synthesis.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "evaluation_takes.hpp"
#include "tests/support/libraries.hpp"

namespace abrazo::take_synthesis_test {
namespace {

using namespace test;
using testing::HasSubstr;

TakeSynthesisOptions paper_options() {
  TakeSynthesisOptions options;
  options.settings = *preset("paper");
  return options;
}

TEST(UserOf, IsThePerformerWhoseRoleTheUserTakes) {
  PairedTake take = swinging_take("take", 30, 1);
  EXPECT_EQ(*user_of(take, UserRole::Active, false), ActivePerformer::A);
  EXPECT_EQ(*user_of(take, UserRole::Passive, false), ActivePerformer::B);
  take.roles = {{0, 30, ActivePerformer::B}};
  EXPECT_EQ(*user_of(take, UserRole::Active, false), ActivePerformer::B);
  take.roles.clear();
  EXPECT_EQ(*user_of(take, UserRole::Active, false), ActivePerformer::A);
}

TEST(UserOf, WherePerformersChangeRolesSaysHowToEvaluate) {
  PairedTake take = swinging_take("sparring", 30, 1);
  take.roles = {{0, 10, ActivePerformer::A}, {10, 30, ActivePerformer::B}};
  const auto user = user_of(take, UserRole::Active, false);
  ASSERT_FALSE(user);
  EXPECT_THAT(user.error().text(), HasSubstr("sparring"));
  EXPECT_EQ(user.error().hint, Hint::EvaluateBothRoles);
  EXPECT_EQ(*user_of(take, UserRole::Active, true), ActivePerformer::A);
}

TEST(TakeSynthesis, NeverSelectsFromTheTakeThatIsLeftOut) {
  const EvaluationData data = three_takes();
  const auto run = synthesise_take(data.library, data.takes[1], paper_options());
  ASSERT_TRUE(run);
  for (const int pair : run->pairs) EXPECT_NE(data.library->take_of(pair).name, "second");
}

TEST(TakeSynthesis, OfTheWholeLibraryFindsItsOwnTake) {
  const EvaluationData data = three_takes();
  TakeSynthesisOptions options = paper_options();
  options.leave_out = false;
  const auto run = synthesise_take(data.library, data.takes[1], options);
  ASSERT_TRUE(run);
  for (const int pair : run->pairs) EXPECT_EQ(data.library->take_of(pair).name, "second");
}

TEST(TakeSynthesis, StepsAtTheSettingsRateAndKnowsTheFrameOfEachStep) {
  const EvaluationData data = three_takes();
  const auto run = synthesise_take(data.library, data.takes[0], paper_options());
  ASSERT_TRUE(run);
  EXPECT_EQ(run->rate_hz, 15);
  ASSERT_EQ(run->size(), 38u);  // 150 frames at 60 Hz
  EXPECT_EQ(run->frames[0], 0);
  EXPECT_EQ(run->frames[10], 40);
  EXPECT_EQ(run->true_partner(10), data.takes[0].b.poses[40]);
  EXPECT_EQ(run->follows[0], 0);
  EXPECT_EQ(run->follows[1], 1);
}

TEST(TakeSynthesis, KnowsWhenEveryStepWasAndWhereItComesFrom) {
  const EvaluationData data = three_takes();
  const auto run = synthesise_take(data.library, data.takes[0], paper_options());
  ASSERT_TRUE(run);
  int locked = 0;
  for (std::size_t step = 0; step < run->size(); ++step) {
    const PartnerStep partner = run->partner_step(step);
    const PairSource& source = data.library->source(run->pairs[step]);
    EXPECT_EQ(partner.partner, run->partner(step));
    EXPECT_NEAR(partner.time_s, run->frames[step] / 60.0, 1e-12);
    EXPECT_EQ(partner.source.take, static_cast<int>(source.take));
    EXPECT_NEAR(partner.source.time_s, source.frame / 60.0, 1e-12);
    EXPECT_EQ(partner.source_changed, run->source_changed[step] != 0);
    locked += partner.locked[0] || partner.locked[1];
    EXPECT_EQ(run->true_pair(step).topRows<joint_count>(), run->true_user(step));
    EXPECT_EQ(run->true_pair(step).bottomRows<joint_count>(), run->true_partner(step));
  }
  EXPECT_GT(locked, 0) << "they stand";
}

TEST(TakeSynthesis, ThePartnerOfAPassiveUserIsTheActiveBody) {
  const EvaluationData data = three_takes();
  TakeSynthesisOptions options = paper_options();
  options.settings.user_role = UserRole::Passive;
  const auto run = synthesise_take(data.library, data.takes[0], options);
  ASSERT_TRUE(run);
  EXPECT_EQ(run->user, ActivePerformer::B);
  EXPECT_EQ(run->true_partner(10), data.takes[0].a.poses[40]);
  EXPECT_EQ(run->partner(10), Pose(run->results[10].topRows<joint_count>()));
  // The user's own body follows the user.
  EXPECT_LT((run->user_body(10) - run->true_user(10)).rowwise().norm().mean(), 0.1);
}

}  // namespace
}  // namespace abrazo::take_synthesis_test
