#include <cmath>

#include "core/selection/recorded_motion.hpp"

#include <gtest/gtest.h>

#include "core/library/build/motion_library_builder.hpp"
#include "tests/core/selection/user_motions.hpp"
#include "tests/support/libraries.hpp"

namespace abrazo::recorded_motion_test {
namespace {

/// B leads in the frames 60 to 119, so what A leads has a gap there.
PairedTake take_with_a_gap() {
  PairedTake take = test::swinging_take("only", 200, 3);
  take.roles = {{0, 60, ActivePerformer::A}, {60, 120, ActivePerformer::B}, {120, 200, ActivePerformer::A}};
  return take;
}

MotionLibrary library_of(const PairedTake& take, double rate_hz) {
  std::vector<PairedTake> takes;
  takes.push_back(take);
  LibraryBuildOptions options;
  options.rate_hz = rate_hz;
  return std::move(*build_library("recorded", std::move(takes), options, {}));
}

/// The performer's poses from one frame to another, as if somebody had done that before the user.
HistoryKernel::Raw as_a_users(const Clip& performer, int first, int last, int step) {
  MotionHistory history;
  for (int frame = first; frame <= last; frame += step) {
    const Pose& pose = performer.poses[static_cast<std::size_t>(frame)];
    history.add(pose, root_frame(pose), step / performer.fps);
  }
  HistoryKernel::Raw raw;
  HistoryKernel::sample(history, raw);
  return raw;
}

double largest_difference(const HistoryKernel::Raw& a, const HistoryKernel::Raw& b) {
  double largest = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
    largest = std::max(largest, std::abs(static_cast<double>(a[i]) - static_cast<double>(b[i])));
  return largest;
}

TEST(RecordedMotion, IsWhatAHistoryOfTheRecordedLeaderHolds) {
  const PairedTake take = take_with_a_gap();
  // At 30 Hz both have the same poses to be between; at 60 Hz the history keeps every other one, between
  // which 4 m/s^2 bend the way by half a millimetre.
  for (const auto& [rate_hz, step, tolerance_m] : {std::tuple{30.0, 2, 1e-5}, std::tuple{60.0, 1, 1e-3}}) {
    const MotionLibrary library = library_of(take, rate_hz);
    const RecordedMotion recorded(library);
    HistoryKernel::Raw raw;
    for (const auto& [first, last, swapped] :
         {std::tuple{0, 58, false}, std::tuple{60, 118, true}, std::tuple{120, 198, false}})
      for (int frame = first; frame <= last; frame += 2) {
        const int pair = library.find_pair("only", frame, swapped);
        ASSERT_GE(pair, 0);
        recorded.sample(pair, raw);
        // The history of a stretch begins where the stretch does.
        EXPECT_LT(largest_difference(raw, as_a_users(swapped ? take.b : take.a, first, frame, step)),
                  tolerance_m)
            << "frame " << frame << " at " << rate_hz << " Hz";
      }
  }
}

/// The partner of one frame seen by the leader of another; heights above the floor.
Pose seen_partner(const Clip& leader, int at, const Clip& partner, int frame) {
  RootFrame root = root_frame(leader.poses[static_cast<std::size_t>(at)]);
  root.position.y() = 0;
  return to_normalized(partner.poses[static_cast<std::size_t>(frame)], root);
}

TEST(RecordedMotion, ThePartnerOfLaterIsSeenFromTheLeaderOfNow) {
  const PairedTake take = take_with_a_gap();
  for (const double rate_hz : {30.0, 60.0}) {
    const MotionLibrary library = library_of(take, rate_hz);
    const RecordedMotion recorded(library);
    for (const auto& [frame, later_s, expected] : {std::tuple{20, 0.0, 20}, std::tuple{20, 1.0 / 30, 22},
                                                   std::tuple{20, 0.5, 50}, std::tuple{150, 0.1, 156}}) {
      const Pose partner = recorded.partner_after(library.find_pair("only", frame, false), later_s);
      EXPECT_LT((partner - seen_partner(take.a, frame, take.b, expected)).cwiseAbs().maxCoeff(), 1e-9)
          << later_s << " s after " << frame;
    }
    const Pose of_b = recorded.partner_after(library.find_pair("only", 80, true), 0.1);
    EXPECT_LT((of_b - seen_partner(take.b, 80, take.a, 86)).cwiseAbs().maxCoeff(), 1e-9) << "B leads";
  }
}

TEST(RecordedMotion, WhereARecordingEndsThePartnerIsTheLastThereIs) {
  const PairedTake take = take_with_a_gap();
  const MotionLibrary library = library_of(take, 60);
  const RecordedMotion recorded(library);
  for (const auto& [frame, last] : {std::pair{199, 199}, std::pair{198, 199}, std::pair{190, 199},
                                    std::pair{59, 59}, std::pair{50, 59}}) {
    const Pose partner = recorded.partner_after(library.find_pair("only", frame, false), 1);
    EXPECT_LT((partner - seen_partner(take.a, frame, take.b, last)).cwiseAbs().maxCoeff(), 1e-9) << frame;
  }
}

}  // namespace
}  // namespace abrazo::recorded_motion_test
