#include <gtest/gtest.h>

#include "core/motion/body/body.hpp"
#include "core/motion/files/import_clip.hpp"
#include "core/stream/natnet/natnet_encoder.hpp"
#include "tests/core/stream/mocap_stream.hpp"
#include "tests/support/captured_data.hpp"

namespace abrazo::natnet_round_trip_test {
namespace {

using namespace joints;

test::RoundTrip by_natnet(const Clip& clip, const std::string& version) {
  auto server = make_natnet_encoder(*parse_stream_uri("natnet://h?performer=Ana&version=" + version),
                                    body_of(clip.poses));
  if (!server) throw std::invalid_argument(server.error().text());
  test::Listener listener("natnet://h");
  const test::RoundTrip trip = test::round_trip(clip, listener, **server, true);
  EXPECT_TRUE(listener.has_fact("NatNet " + version)) << "the server speaks what it was asked to";
  return trip;
}

/// Of Motive's skeleton the thorax is only estimated, and limbs end where the last bone begins: how far head,
/// hands and toes go on is an average. All else is a bone's origin.
bool is_estimated(std::size_t joint) {
  for (const int estimated : {+Thorax, +Head, +LeftHand, +RightHand, +LeftToes, +RightToes})
    if (joint == static_cast<std::size_t>(estimated)) return true;
  return false;
}

void expect_joints_back(const test::RoundTrip& trip) {
  EXPECT_EQ(trip.joint_map, "motive");
  for (std::size_t j = 0; j < joint_count; ++j) {
    EXPECT_LT(trip.largest[j], is_estimated(j) ? 0.045 : 1e-5) << joint_names[j];
  }
}

TEST(NatNetRoundTrip, GivesAGeneratedDanceBackInEveryVersion) {
  const Clip clip = test::demo_clip();
  for (const char* version : {"3.0", "3.1", "4.0", "4.1"}) expect_joints_back(by_natnet(clip, version));
}

TEST(NatNetRoundTrip, GivesACapturedDanceBack) {
  ABRAZO_REQUIRE_CAPTURED_DATA(data);
  ImportOptions options;
  options.fps = 60;
  const auto loaded = load_motion((data / "cmu_salsa" / "60_01.amc").string(), "", options);
  ASSERT_TRUE(loaded);
  expect_joints_back(by_natnet(loaded->front().clip, "4.1"));
}

TEST(NatNetRoundTrip, ARestartedServerCountsFromNought) {
  const Clip clip = test::demo_clip();
  auto server = make_natnet_encoder(*parse_stream_uri("natnet://h"), body_of(clip.poses));
  test::Listener listener("natnet://h");
  test::converse(listener, **server, 0);
  for (int f = 0; f < 3; ++f)
    listener.take((*server)->packets({clip.poses[0], f / 60.0, true}).at(0), f / 60.0);
  EXPECT_EQ(listener.out.frames.back().counter, 2);
  (*server)->restart();
  listener.take((*server)->packets({clip.poses[0], 0, true}).at(0), 0.1);
  EXPECT_EQ(listener.out.frames.back().counter, 0);
}

TEST(NatNetRoundTrip, AHeldPoseIsSentAsNotTracked) {
  const Clip clip = test::demo_clip();
  auto server = make_natnet_encoder(*parse_stream_uri("natnet://h"), body_of(clip.poses));
  test::Listener listener("natnet://h");
  test::converse(listener, **server, 0);
  listener.take((*server)->packets({clip.poses[0], 0, true}).at(0));
  EXPECT_EQ(listener.out.frames.size(), 1u);
  listener.take((*server)->packets({clip.poses[0], 0.1, false}).at(0));
  EXPECT_EQ(listener.out.frames.size(), 1u);
}

}  // namespace
}  // namespace abrazo::natnet_round_trip_test
