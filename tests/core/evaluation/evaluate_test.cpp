#include "core/evaluation/run/evaluate.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/evaluation/report/report_json.hpp"
#include "core/library/build/motion_library_builder.hpp"
#include "evaluation_takes.hpp"
#include "tests/support/libraries.hpp"

namespace abrazo::evaluate_test {
namespace {

using namespace test;
using testing::ElementsAre;
using testing::HasSubstr;

EvaluationOptions of_parts(std::set<EvaluationPart> parts) {
  EvaluationOptions options;
  options.parts = std::move(parts);
  options.settings = *preset("paper");
  options.variants = false;
  return options;
}

TEST(Evaluate, AnswersEveryTakeByTheOthers) {
  const auto evaluation = evaluate(three_takes(), of_parts({EvaluationPart::Moves}), {});
  ASSERT_TRUE(evaluation);
  EXPECT_THAT(evaluation->takes, ElementsAre("first", "second", "third"));
  ASSERT_TRUE(evaluation->result);
  EXPECT_EQ(evaluation->result->moves.all.total, 6);
  EXPECT_EQ(evaluation->step_rate_hz, 15);
  EXPECT_EQ(evaluation->library_pairs, 360);
  EXPECT_TRUE(evaluation->has_moves);
  EXPECT_FALSE(evaluation->has_zmp);
}

TEST(Evaluate, OnlyTheTakesAskedFor) {
  EvaluationOptions options = of_parts({EvaluationPart::Contact});
  options.hold_out = {"third", "first", "third"};
  const auto evaluation = evaluate(three_takes(), options, {});
  ASSERT_TRUE(evaluation);
  EXPECT_THAT(evaluation->takes, ElementsAre("third", "first"));
}

TEST(Evaluate, ATakeThatDoesNotExistIsRefusedWithTheNamesThereAre) {
  EvaluationOptions options = of_parts({EvaluationPart::Moves});
  options.hold_out = {"fourth"};
  const auto evaluation = evaluate(three_takes(), options, {});
  ASSERT_FALSE(evaluation);
  EXPECT_THAT(evaluation.error().text(), HasSubstr("fourth"));
  EXPECT_THAT(evaluation.error().text(), HasSubstr("first, second, third"));
}

TEST(Evaluate, ASingleTakeCannotBeLeftOut) {
  EvaluationData data = three_takes();
  data.takes.resize(1);
  const auto evaluation = evaluate(data, of_parts({EvaluationPart::Moves}), {});
  ASSERT_FALSE(evaluation);
  EXPECT_EQ(evaluation.error().hint, Hint::NameUsers);
}

TEST(Evaluate, OtherPeoplesTakesAreAnsweredByTheWholeLibrary) {
  EvaluationData data = three_takes();
  data.users_name = "novices";
  data.users = {data.takes[1]};  // of the same name as a take of the library, which is not left out
  const auto evaluation = evaluate(data, of_parts({EvaluationPart::Contact}), {});
  ASSERT_TRUE(evaluation);
  EXPECT_EQ(evaluation->users, "novices");
  EXPECT_THAT(evaluation->takes, ElementsAre("second"));
  EXPECT_LT(evaluation->result->partner.median_joint_error_m, 0.2);  // it finds itself
}

TEST(Evaluate, UsersOfOtherBuildsAndDisturbedInputComeWithMovesAndContact) {
  EvaluationOptions options = of_parts({EvaluationPart::Moves, EvaluationPart::Contact});
  options.variants = true;
  const auto evaluation = evaluate(three_takes(), options, {});
  ASSERT_TRUE(evaluation);
  EXPECT_EQ(evaluation->builds.size(), other_builds().size());
  EXPECT_EQ(evaluation->disturbed.size(), disturbances().size());
  EXPECT_EQ(evaluation->builds.front().user, other_builds().front().name);
  EXPECT_EQ(evaluation->builds.front().moves.all.total, 6);
}

/// A report without what depends on the clock.
std::string without_times(Evaluation evaluation) {
  evaluation.seconds = 0;
  evaluation.result->solve = {};
  for (SelectionTable& table : evaluation.selection)
    for (SelectionRow& row : table.rows) row.query_us = 0;
  return report_json(evaluation);
}

TEST(Evaluate, TheFiguresOfTheLiteratureAreOfTheTakesAsTheyAre) {
  EvaluationOptions options = of_parts({EvaluationPart::Contact, EvaluationPart::Published});
  const auto evaluation = evaluate(three_takes(), options, {});
  ASSERT_TRUE(evaluation) << evaluation.error().text();
  ASSERT_TRUE(evaluation->result->published);
  EXPECT_NEAR(evaluation->result->published->captured.mpjpe_m, 0, 1e-12);
  EXPECT_GT(evaluation->result->published->made.mpjpe_m, 0);
  for (const UserResult& user : evaluation->disturbed) EXPECT_FALSE(user.published) << user.user;
  const auto without = evaluate(three_takes(), of_parts({EvaluationPart::Moves}), {});
  ASSERT_TRUE(without);
  EXPECT_FALSE(without->result->published);
}

TEST(Evaluate, TwiceTheSameGivesTheSameFigures) {
  const EvaluationData data = three_takes();
  const EvaluationOptions options =
      of_parts({EvaluationPart::Selection, EvaluationPart::Moves, EvaluationPart::Zmp,
                EvaluationPart::Contact, EvaluationPart::Published});
  const auto first = evaluate(data, options, {}), second = evaluate(data, options, {});
  ASSERT_TRUE(first && second);
  EXPECT_EQ(without_times(*first), without_times(*second));
}

TEST(Evaluate, TakesWithoutMovesAreNamed) {
  EvaluationData data = three_takes();
  data.takes[2].labels.clear();
  const auto evaluation = evaluate(data, of_parts({EvaluationPart::Moves}), {});
  ASSERT_TRUE(evaluation);
  EXPECT_THAT(evaluation->remarks, ElementsAre(HasSubstr("take third has no labelled moves")));
}

TEST(Evaluate, StepsThatAreUnevenlyApartAreNamed) {
  EvaluationOptions options = of_parts({EvaluationPart::Zmp});
  options.hold_out = {"third"};
  const auto remarks_at = [&](double step_rate_hz) {
    options.settings.step_rate_hz = step_rate_hz;
    return evaluate(three_takes(), options, {})->remarks;
  };
  EXPECT_THAT(remarks_at(20), testing::IsEmpty());
  EXPECT_THAT(remarks_at(25), ElementsAre(HasSubstr("take third has 60 frames a second, which 25 steps")));
}

TEST(Evaluate, StopsWhenAskedTo) {
  const auto evaluation = evaluate(three_takes(), of_parts({EvaluationPart::Moves}),
                                   [](double, std::string_view) { return false; });
  ASSERT_FALSE(evaluation);
  EXPECT_THAT(evaluation.error().text(), HasSubstr("cancelled"));
}

TEST(Evaluate, RoleChangesNeedBothRoles) {
  std::vector<PairedTake> takes = three_takes().takes;
  for (PairedTake& take : takes) take.roles = {{0, 40, ActivePerformer::A}, {40, 1000, ActivePerformer::B}};
  for (PairedTake& take : takes) take.roles.back().end = static_cast<int>(take.a.poses.size());
  EvaluationData data;
  data.name = "sparring";
  data.takes = takes;
  const auto with = [&](bool both_roles) {
    data.both_roles = both_roles;
    data.library = std::make_shared<const MotionLibrary>(*build_library(
        "sparring", takes, {.excluded_takes = {}, .rate_hz = {}, .both_roles = both_roles}, {}));
    return evaluate(data, of_parts({EvaluationPart::Moves}), {});
  };
  const auto refused = with(false);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().hint, Hint::EvaluateBothRoles);
  const auto evaluation = with(true);
  ASSERT_TRUE(evaluation);
  EXPECT_EQ(evaluation->library_pairs, 720);
  EXPECT_TRUE(evaluation->both_roles);
}

}  // namespace
}  // namespace abrazo::evaluate_test
