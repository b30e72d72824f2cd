#include "widgets/plots/plot_series.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "core/metrics/continuity.hpp"
#include "core/metrics/holds.hpp"
#include "core/motion/body/joint_set.hpp"
#include "tests/support/bodies.hpp"
#include "tests/widgets/synthetic_frames.hpp"

namespace abrazo::widgets::plot_series_test {
namespace {

using test::facing_pair;
using test::synthetic_frame;

double of(const SeriesValues& values, Series series) {
  return values[static_cast<std::size_t>(series)];
}

FrameSnapshot frame_at(std::uint64_t index, double time_s) {
  return *synthetic_frame(index, time_s);
}

TEST(PlotSeries, StandInTheCatalogueInTheirOwnPlaceWithKeysOfTheirOwn) {
  std::set<std::string_view> keys;
  for (std::size_t s = 0; s < series_count; ++s) {
    const SeriesInfo& info = all_series()[s];
    EXPECT_EQ(static_cast<std::size_t>(info.series), s) << info.key;
    EXPECT_TRUE(keys.insert(info.key).second) << info.key;
    EXPECT_EQ(find_series(info.key), info.series);
    EXPECT_FALSE(info.unit.empty() || info.name.empty() || info.meaning.empty()) << info.key;
  }
  EXPECT_FALSE(find_series("energy.unheard_of"));
}

TEST(PlotSeries, ReadEnergiesWithTheVelocityTermWeightedForTheTimeBetweenSteps) {
  SeriesReader reader;
  FrameSnapshot frame = frame_at(0, 1.0);
  frame.result.energy = {0.01, 0, 0.002};
  EXPECT_EQ(of(reader.read(frame), Series::VelocityEnergy), 0) << "no step before";
  frame.index = 1;
  frame.time_s = 1.0 + 1.0 / 30;
  frame.settings.velocity_weight = 0.2;  // at 15 Hz, so 0.4 at 30 Hz
  frame.result.energy = {0.01, 0.004, 0.002};
  const SeriesValues values = reader.read(frame);
  EXPECT_DOUBLE_EQ(of(values, Series::DeformationEnergy), 0.01);
  EXPECT_DOUBLE_EQ(of(values, Series::ConstraintEnergy), 0.002);
  EXPECT_NEAR(of(values, Series::VelocityEnergy), 0.4 * 0.004, 1e-12);
}

TEST(PlotSeries, HaveNoVelocityEnergyWhereTheTimeSinceTheLastStepIsUnknown) {
  SeriesReader reader;
  EXPECT_TRUE(std::isnan(of(reader.read(frame_at(7, 1.0)), Series::VelocityEnergy)));
}

TEST(PlotSeries, ReadResidualsInPercentAndMillimetres) {
  FrameSnapshot frame = frame_at(0, 0);
  frame.result.residual = {0.0004, 0.0002, 0.010, 0.003, 0.020};
  const SeriesValues values = SeriesReader().read(frame);
  EXPECT_DOUBLE_EQ(of(values, Series::BoneLength), 0.04);
  EXPECT_DOUBLE_EQ(of(values, Series::FootLock), 0.2);
  EXPECT_DOUBLE_EQ(of(values, Series::Penetration), 10);
  EXPECT_DOUBLE_EQ(of(values, Series::ExcessPenetration), 3);
  EXPECT_DOUBLE_EQ(of(values, Series::MorphRms), 20);
}

TEST(PlotSeries, ReadTheWinnersCostAndItsMarginToTheCheapestOther) {
  FrameSnapshot frame = frame_at(0, 0);
  frame.settings.alpha = 0.5;
  frame.result.candidates = {{0, 0.1, false, {0.3, 0, 0, 0.30}, {}},
                             {1, 0.2, false, {0.10, 0.04, 0.06, 0.15}, {}},
                             {2, 0.3, false, {0.2, 0, 0, 0.21}, {}}};
  frame.result.selected = 1;
  const SeriesValues values = SeriesReader().read(frame);
  EXPECT_DOUBLE_EQ(of(values, Series::PoseCost), 0.10);
  EXPECT_DOUBLE_EQ(of(values, Series::LeaderCost), 0.02);
  EXPECT_DOUBLE_EQ(of(values, Series::FollowerCost), 0.03);
  EXPECT_DOUBLE_EQ(of(values, Series::TotalCost), 0.15);
  EXPECT_NEAR(of(values, Series::CostMargin), 0.06, 1e-12);
  frame.result.selected = 2;
  EXPECT_NEAR(of(SeriesReader().read(frame), Series::CostMargin), -0.06, 1e-12);
  frame.result.candidates.resize(1);
  frame.result.selected = 0;
  EXPECT_TRUE(std::isnan(of(SeriesReader().read(frame), Series::CostMargin))) << "no runner-up";
}

TEST(PlotSeries, ReadTheTermsOfIntentBesideEquation7) {
  const SeriesValues values = SeriesReader().read(*test::frame_by_intent(0, 0));
  EXPECT_DOUBLE_EQ(of(values, Series::ExpectedPartner), 0.10);
  EXPECT_DOUBLE_EQ(of(values, Series::LeaderMotion), 0.06);
  EXPECT_DOUBLE_EQ(of(values, Series::UnlikelyMove), 0.03);
  EXPECT_DOUBLE_EQ(of(values, Series::NotMeant), 0);
  EXPECT_DOUBLE_EQ(of(values, Series::ChangeOfSource), 0);
  EXPECT_DOUBLE_EQ(of(values, Series::IntentTotal), 0.19);
  EXPECT_NEAR(of(values, Series::IntentMargin), 0.01, 1e-12);
  EXPECT_DOUBLE_EQ(of(values, Series::PoseCost), 0.1) << "of the same winner";
}

TEST(PlotSeries, HaveNoTermsOfIntentWhereEquation7Decided) {
  const SeriesValues values = SeriesReader().read(frame_at(0, 0));
  for (const Series series :
       {Series::ExpectedPartner, Series::LeaderMotion, Series::UnlikelyMove, Series::NotMeant,
        Series::ChangeOfSource, Series::IntentTotal, Series::IntentMargin})
    EXPECT_TRUE(std::isnan(of(values, series))) << info_of(series).key;
}

TEST(PlotSeries, ReadTimingsInMillisecondsAlsoOfAFailedStep) {
  FrameSnapshot frame = frame_at(0, 0);
  frame.result.timing = {10, 50, 20, 300, 400};
  frame.result.status = StepStatus::Failed;
  const SeriesValues values = SeriesReader().read(frame);
  EXPECT_DOUBLE_EQ(of(values, Series::RetargetTime), 0.01);
  EXPECT_DOUBLE_EQ(of(values, Series::SelectTime), 0.05);
  EXPECT_DOUBLE_EQ(of(values, Series::MeshTime), 0.02);
  EXPECT_DOUBLE_EQ(of(values, Series::SolveTime), 0.3);
  EXPECT_DOUBLE_EQ(of(values, Series::TotalTime), 0.4);
  EXPECT_TRUE(std::isnan(of(values, Series::DeformationEnergy)));
  EXPECT_TRUE(std::isnan(of(values, Series::TotalCost)));
}

TEST(PlotSeries, HoldChangeIsThatOfTheMetric) {
  FrameSnapshot frame = frame_at(0, 0);
  PairPose selected = facing_pair(5);
  selected.row(joints::left_hand) = Vec3(0, 1, 0);
  selected.row(joint_count + joints::right_hand) = Vec3(0.05, 1, 0);
  PairPose result = selected;
  result.row(joint_count + joints::right_hand) = Vec3(0.08, 1, 0);
  frame.result.selected_pair = selected;
  frame.result.result = result;
  HoldMetric metric;
  metric.add(result, selected);
  ASSERT_EQ(metric.figures().holds, 1);
  const double change_mm = of(SeriesReader().read(frame), Series::HoldChange);
  EXPECT_NEAR(change_mm, 30, 1e-9);
  EXPECT_NEAR(change_mm, 1000 * metric.figures().change_mean_m, 1e-9);
}

TEST(PlotSeries, HoldChangeIsNoneWithoutAHold) {
  FrameSnapshot frame = frame_at(0, 0);
  frame.result.selected_pair = frame.result.result = facing_pair(5);
  EXPECT_TRUE(std::isnan(of(SeriesReader().read(frame), Series::HoldChange)));
}

/// A frame whose partner stands this far to the side of the selected pair's.
FrameSnapshot aside(std::uint64_t index, double aside_m) {
  FrameSnapshot frame = frame_at(index, static_cast<double>(index) / 30);
  frame.result.result = frame.result.selected_pair;
  frame.result.result.bottomRows<joint_count>().col(0).array() += aside_m;
  return frame;
}

TEST(PlotSeries, PartnerStepAndDistanceBehindAreMeansOverJoints) {
  SeriesReader reader;
  const SeriesValues first = reader.read(aside(0, 0.10));
  EXPECT_TRUE(std::isnan(of(first, Series::PartnerStep)));
  EXPECT_NEAR(of(first, Series::BehindSelected), 100, 1e-9);
  const SeriesValues second = reader.read(aside(1, 0.04));
  EXPECT_NEAR(of(second, Series::PartnerStep), 60, 1e-9);
  EXPECT_NEAR(of(second, Series::BehindSelected), 40, 1e-9);
}

TEST(PlotSeries, AFailedOrMissingStepInterruptsThePartnersSteps) {
  SeriesReader reader;
  reader.read(aside(0, 0));
  FrameSnapshot failed = aside(1, 0.5);
  failed.result.status = StepStatus::Failed;
  reader.read(failed);
  EXPECT_TRUE(std::isnan(of(reader.read(aside(2, 0)), Series::PartnerStep)));
  EXPECT_NEAR(of(reader.read(aside(3, 0.01)), Series::PartnerStep), 10, 1e-9);
  EXPECT_TRUE(std::isnan(of(reader.read(aside(5, 0)), Series::PartnerStep)));
}

TEST(PlotSeries, SpeedAccelerationAndSlidingAreThoseOfThePartner) {
  SeriesReader reader;
  const auto read = [&](std::uint64_t index, double aside_m) { return reader.read(aside(index, aside_m)); };
  EXPECT_TRUE(std::isnan(of(read(0, 0), Series::PartnerSpeed)));
  const SeriesValues second = read(1, 0.01);  // at 30 Hz
  EXPECT_NEAR(of(second, Series::PartnerSpeed), 0.3, 1e-9);
  EXPECT_NEAR(of(second, Series::FootSlide), 0.3, 1e-9);
  EXPECT_TRUE(std::isnan(of(second, Series::PartnerAcceleration)));
  const SeriesValues third = read(2, 0.03);
  EXPECT_NEAR(of(third, Series::PartnerSpeed), 0.6, 1e-9);
  EXPECT_NEAR(of(third, Series::PartnerAcceleration), 0.3 * 30, 1e-9);
  FrameSnapshot failed = aside(3, 0.5);
  failed.result.status = StepStatus::Failed;
  reader.read(failed);
  EXPECT_TRUE(std::isnan(of(read(4, 0), Series::PartnerSpeed))) << "a failed step interrupts";
}

/// Poses that come late in one go are solved within a few milliseconds, far less than lies between them.
TEST(PlotSeries, FramesOfABacklogMoveAsFastAsTheirPoses) {
  SeriesReader reader;
  FrameSnapshot frame = frame_at(0, 1.0);
  frame.elapsed_s = 0;
  reader.read(frame);
  frame.index = 1;
  frame.time_s = 1.0 + 1e-6;
  frame.elapsed_s = 0.02;
  frame.result.result.col(0).array() += 0.03;
  EXPECT_NEAR(of(reader.read(frame), Series::PartnerSpeed), 1.5, 1e-9);
}

TEST(PlotSeries, ThePartnerOfAPassiveUserIsTheActiveBodyThatMoves) {
  SeriesReader reader;
  for (std::uint64_t index = 0; index < 2; ++index) {
    FrameSnapshot frame = aside(index, 0.1 * static_cast<double>(index));
    frame.settings.user_role = UserRole::Passive;
    const SeriesValues values = reader.read(frame);
    if (index == 1) {
      EXPECT_EQ(of(values, Series::PartnerSpeed), 0);
    }
  }
}

TEST(PlotSeries, BesideThemStandsTheRecordedPartnerInItsTake) {
  FrameSnapshot frame = frame_at(0, 1);
  const auto library = test::two_take_library();
  frame.library = library;
  frame.result.candidates = {{1, 0.1, false, {}, {}}};
  frame.result.selected = 0;
  // The follower of these takes goes back by 5 cm a frame, at 60 frames a second.
  const SeriesValues values = SeriesReader().read(frame);
  EXPECT_NEAR(of(values, Series::RecordedSpeed), 3, 1e-9);
  EXPECT_NEAR(of(values, Series::RecordedAcceleration), 0, 1e-9);
  frame.result.candidates[0].pair = library->pair_count();
  EXPECT_TRUE(std::isnan(of(SeriesReader().read(frame), Series::RecordedSpeed))) << "of another library";
}

TEST(PlotSeries, SourceChangesAreThoseOfTheLastHundredSteps) {
  SeriesReader reader;
  ContinuityMetric metric;
  double last = 0;
  for (std::uint64_t i = 0; i < 200; ++i) {
    FrameSnapshot frame = aside(i, 0);
    frame.result.source_changed = i == 0 || i % 50 == 0;  // 0, 50, 100, 150
    last = of(reader.read(frame), Series::SourceChanges);
    metric.add(frame.result.passive(), frame.result.source_changed);
    if (i == 0) {
      EXPECT_DOUBLE_EQ(last, 100);
    }
    if (i == 9) {
      EXPECT_DOUBLE_EQ(last, 10);
    }
    if (i == 99) {
      EXPECT_DOUBLE_EQ(last, metric.figures().source_changes_per_100);
    }
  }
  EXPECT_DOUBLE_EQ(last, 2);
}

}  // namespace
}  // namespace abrazo::widgets::plot_series_test
