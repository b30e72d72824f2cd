#include <gtest/gtest.h>

#include "core/motion/body/body.hpp"
#include "core/motion/files/import_clip.hpp"
#include "core/stream/xsens/xsens_encoder.hpp"
#include "tests/core/stream/mocap_stream.hpp"
#include "tests/support/captured_data.hpp"

namespace abrazo::xsens_round_trip_test {
namespace {

using namespace joints;

/// Segments' origins are joints, so those come back exactly. The ends of head, hands and toes come from the
/// sender's scaling data: exact for a body whose bones keep their lengths.
void expect_joints_back(const Clip& clip, double ends_m) {
  auto sender = make_xsens_encoder(*parse_stream_uri("xsens://h:9763?performer=Ana"), body_of(clip.poses));
  ASSERT_TRUE(sender);
  test::Listener listener("xsens://0.0.0.0:9763");
  const test::RoundTrip trip = test::round_trip(clip, listener, **sender, false);
  EXPECT_EQ(trip.joint_map, "xsens");
  EXPECT_EQ(listener.out.frames.back().performer, "Ana");
  for (std::size_t j = 0; j < joint_count; ++j) {
    bool is_end = false;
    for (const int end : {+Head, +LeftHand, +RightHand, +LeftToes, +RightToes})
      is_end = is_end || j == static_cast<std::size_t>(end);
    EXPECT_LT(trip.largest[j], is_end ? ends_m : 1e-5) << joint_names[j];
  }
}

TEST(XsensRoundTrip, WhoListensLaterIsToldTheBodyWithinASecond) {
  const Clip clip = test::demo_clip();
  auto sender = make_xsens_encoder(*parse_stream_uri("xsens://h:9763?performer=Ana"), body_of(clip.poses));
  ASSERT_TRUE(sender);
  const auto packets_at = [&](double time_s) {
    return (*sender)->packets({.pose = clip.poses.front(), .time_s = time_s}).size();
  };
  const std::size_t with_body = packets_at(0), poses = packets_at(0.5);
  EXPECT_GT(with_body, poses);
  EXPECT_EQ(packets_at(1), with_body);
  EXPECT_EQ(packets_at(1.5), poses);
  EXPECT_EQ(packets_at(0.1), with_body) << "its clock began anew";
}

TEST(XsensRoundTrip, GivesAGeneratedDanceBack) {
  expect_joints_back(test::demo_clip(), 1e-4);
}

TEST(XsensRoundTrip, GivesACapturedDanceBack) {
  ABRAZO_REQUIRE_CAPTURED_DATA(data);
  ImportOptions options;
  options.fps = 60;
  const auto loaded = load_motion((data / "cmu_salsa" / "60_01.amc").string(), "", options);
  ASSERT_TRUE(loaded);
  expect_joints_back(loaded->front().clip, 1e-4);
}

}  // namespace
}  // namespace abrazo::xsens_round_trip_test
