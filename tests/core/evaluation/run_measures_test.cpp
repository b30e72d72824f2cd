#include "core/evaluation/tables/run_measures.hpp"

#include <gtest/gtest.h>

#include "core/metrics/foot_slide.hpp"
#include "core/motion/body/joint_set.hpp"
#include "evaluation_takes.hpp"

namespace abrazo::run_measures_test {
namespace {

using namespace test;

/// The first take answered by itself, the partner moved aside.
struct OwnTake {
  EvaluationData data = three_takes();
  std::vector<SynthesisedTake> takes;
  explicit OwnTake(const Vec3& partner_offset = Vec3::Zero()) {
    takes.push_back(answered(data.takes[0], own_pairs(*data.library, data.takes[0]), partner_offset));
  }
};

TEST(RunMeasures, TheCaptureItselfHasNoErrorNoLagAndTheSameZmp) {
  const OwnTake run;
  const PartnerTable partner = measure_partner(run.takes);
  EXPECT_EQ(partner.mean_joint_error_m, 0);
  EXPECT_NEAR(partner.lag_s, 0, 1e-9);
  EXPECT_NEAR(partner.lag_correlation, 1, 1e-9);
  EXPECT_EQ(partner.continuity.displacement_mean_m, partner.original_continuity.displacement_mean_m);
  const ZmpTable zmp = measure_zmp(run.takes, {});
  EXPECT_GT(zmp.frames, 0);
  EXPECT_EQ(zmp.original_m, zmp.synthesised_m);
  EXPECT_EQ(zmp.original_partner_m, zmp.synthesised_partner_m);
  const ContactTable contact = measure_contact(run.takes, *run.data.library);
  EXPECT_EQ(contact.holds.change_mean_m, 0);
  EXPECT_EQ(contact.penetration.excess_max_m, 0);
  EXPECT_NEAR(contact.penetration.max_m, contact.original_penetration.max_m, 1e-12);
  EXPECT_EQ(contact.foot_slide_m_s, contact.original_foot_slide_m_s);
}

TEST(RunMeasures, APartnerThirtyCentimetresAsideIsThirtyCentimetresWrongAndOfItsPair) {
  const OwnTake run({0.18, 0, 0.24});
  const PartnerTable partner = measure_partner(run.takes);
  EXPECT_NEAR(partner.mean_joint_error_m, 0.30, 1e-12);
  EXPECT_NEAR(partner.median_joint_error_m, 0.30, 1e-12);
  EXPECT_NEAR(partner.p95_joint_error_m, 0.30, 1e-12);
  EXPECT_NEAR(partner.behind_selected_mean_m, 0.30, 1e-12);
  EXPECT_NEAR(partner.lag_s, 0, 1e-9);
}

TEST(RunMeasures, ALatePartnerLags) {
  OwnTake run;
  SynthesisedTake& take = run.takes.front();
  const std::vector<PairPose> results = take.results;
  for (std::size_t step = 6; step < results.size(); ++step)
    take.results[step].bottomRows<joint_count>() = results[step - 6].bottomRows<joint_count>();
  EXPECT_NEAR(measure_partner(run.takes).lag_s, 0.1, 1.0 / 60);
}

TEST(RunMeasures, BetweenChangesOfSourceTheZmpKnowsNothingOfTheJumps) {
  OwnTake run;
  SynthesisedTake& take = run.takes.front();
  for (std::size_t step = 75; step < take.results.size(); ++step)
    take.results[step].bottomRows<joint_count>().rowwise() += Vec3(0.2, 0, 0).transpose();
  take.source_changed[75] = 1;
  const ZmpTable zmp = measure_zmp(run.takes, {});
  EXPECT_GT(zmp.synthesised_partner_m, 2 * zmp.original_partner_m);
  EXPECT_NEAR(zmp.partner_between_changes_m, zmp.original_between_changes_m, 1e-9);
  EXPECT_GT(zmp.between_changes_share, 0.8);
}

TEST(RunMeasures, FramesInWhichThePartnerIsThrownCountForNeitherMotionWhenTheTwoAreCompared) {
  OwnTake run;
  const ZmpTable as_captured = measure_zmp(run.takes, {});
  EXPECT_EQ(as_captured.common_partner.frames, as_captured.partner_frames);
  EXPECT_EQ(as_captured.common_partner.first_m, as_captured.original_partner_m);
  EXPECT_EQ(as_captured.common.second_m, as_captured.synthesised_m);
  EXPECT_EQ(as_captured.partner_free_fall, 0);
  SynthesisedTake& take = run.takes.front();
  for (int step = 60; step < 90; ++step) {  // falls twice as fast as anybody can
    const double t = (step - 60) / 60.0;
    take.results[static_cast<std::size_t>(step)].bottomRows<joint_count>().col(1).array() -= 9.81 * t * t;
  }
  const ZmpTable zmp = measure_zmp(run.takes, {});
  EXPECT_GT(zmp.partner_free_fall, 10);
  EXPECT_EQ(zmp.original_partner_free_fall, 0);
  EXPECT_EQ(zmp.common_partner.frames, zmp.partner_frames) << "all of the capture count";
  EXPECT_LT(zmp.common_partner.frames, zmp.original_partner_frames);
}

TEST(RunMeasures, ResultAndCaptureArePenetratedByTheSameRadii) {
  OwnTake run;
  auto columns = run.data.library->columns();
  for (LibraryBody& body : columns.bodies) body.capsule_radii.fill(0.3);
  const MotionLibrary library(std::move(columns));
  const ContactTable contact = measure_contact(run.takes, library);
  EXPECT_GT(contact.penetration.max_m, 0);
  EXPECT_EQ(contact.penetration.max_m, contact.original_penetration.max_m);
  EXPECT_EQ(contact.penetration.deep_share, contact.original_penetration.deep_share);
}

TEST(RunMeasures, AnInterruptionIsNoJump) {
  OwnTake run;
  SynthesisedTake& take = run.takes.front();
  const double longest = measure_partner(run.takes).continuity.displacement_max_m;
  for (std::size_t step = 70; step < take.results.size(); ++step)
    take.results[step].bottomRows<joint_count>().rowwise() += Vec3(1, 0, 0).transpose();
  EXPECT_GT(measure_partner(run.takes).continuity.displacement_max_m, 0.9);
  take.follows[70] = 0;
  EXPECT_LE(measure_partner(run.takes).continuity.displacement_max_m, longest);
}

TEST(RunMeasures, AFailedStepIsNoSlideAndNoAcceleration) {
  OwnTake run;
  SynthesisedTake& take = run.takes.front();
  const ZmpTable zmp_before = measure_zmp(run.takes, {});
  const ContactTable before = measure_contact(run.takes, *run.data.library);
  for (std::size_t step = 70; step < take.results.size(); ++step)
    take.results[step].rowwise() += Vec3(1, 0, 0).transpose();
  EXPECT_GT(measure_contact(run.takes, *run.data.library).foot_slide_m_s, before.foot_slide_m_s + 0.1);
  take.follows[70] = 0;
  const ContactTable contact = measure_contact(run.takes, *run.data.library);
  EXPECT_NEAR(contact.foot_slide_m_s, before.foot_slide_m_s, 0.01);
  EXPECT_NEAR(contact.foot_slide_m_s, contact.original_foot_slide_m_s, 1e-9);
  const ZmpTable zmp = measure_zmp(run.takes, {});
  EXPECT_NEAR(zmp.synthesised_m, zmp.original_m, 1e-9);
  EXPECT_EQ(zmp.frames + zmp.skipped_frames, zmp_before.frames + zmp_before.skipped_frames);
  EXPECT_GT(zmp.skipped_frames, zmp_before.skipped_frames) << "the two ends at the failed step";
}

TEST(RunMeasures, CapturedPenetrationDoesNotDependOnWhichPerformerOfOtherPeopleIsNamedFirst) {
  OwnTake run;
  auto columns = run.data.library->columns();
  for (LibraryBody& body : columns.bodies) body.capsule_radii.fill(0.05);
  columns.bodies[columns.takes[0].body_b].capsule_radii[joints::Head - 1] = 0.5;  // the passive one's
  const MotionLibrary library(std::move(columns));
  SynthesisedTake& take = run.takes.front();
  take.of_library = false;
  const double deepest_m = measure_contact(run.takes, library).original_penetration.max_m;
  EXPECT_GT(deepest_m, 0);
  PairedTake renamed = *take.take;
  std::swap(renamed.a, renamed.b);
  take.take = &renamed;
  take.user = ActivePerformer::B;
  EXPECT_NEAR(measure_contact(run.takes, library).original_penetration.max_m, deepest_m, 1e-12);
}

TEST(RunMeasures, StepTimesAreThoseOfAllSteps) {
  OwnTake run;
  run.takes.front().step_us.back() = 900;
  run.takes.front().failed = 1;
  const SolveTimes times = measure_solve_times(run.takes);
  EXPECT_EQ(times.p50_us, 100);
  EXPECT_EQ(times.steps, 150);
  EXPECT_EQ(times.failed, 1);
}

}  // namespace
}  // namespace abrazo::run_measures_test
