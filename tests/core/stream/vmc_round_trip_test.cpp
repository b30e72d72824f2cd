#include <gtest/gtest.h>

#include <algorithm>

#include "core/motion/files/import_clip.hpp"
#include "core/stream/vmc/vmc_encoder.hpp"
#include "tests/core/stream/vmc_packets.hpp"
#include "tests/support/bodies.hpp"
#include "tests/support/captured_data.hpp"

namespace abrazo::vmc_round_trip_test {
namespace {

using test::Receiver;

/// Sends a clip to a receiver. @return the largest distance of each joint from where it was sent [m]
std::array<double, joint_count> round_trip(const Clip& clip, const std::string& framing) {
  const auto uri = parse_stream_uri("vmc://127.0.0.1:39539?framing=" + framing);
  auto encoder = make_vmc_encoder(*uri, body_of(clip.poses));
  EXPECT_TRUE(encoder);
  Receiver receiver;
  std::array<double, joint_count> largest{};
  for (std::size_t f = 0; f < clip.poses.size(); ++f) {
    const double time = static_cast<double>(f) / clip.fps;
    receiver.out.frames.clear();
    for (const auto& packet : (*encoder)->packets({clip.poses[f], time, true})) {
      EXPECT_LE(packet.size(), framing.starts_with("split") ? 1500u : 65000u);
      receiver.take(packet, time);
    }
    EXPECT_EQ(receiver.out.frames.size(), 1u) << framing << " frame " << f;
    if (receiver.out.frames.empty()) return largest;
    EXPECT_NEAR(receiver.out.frames[0].sender_time_s.value_or(-1), time, 1e-5);
    const Pose back = receiver.joints();
    for (int j = 0; j < joint_count; ++j) {
      auto& worst = largest[static_cast<std::size_t>(j)];
      worst = std::max(worst, (back.row(j) - clip.poses[f].row(j)).norm());
    }
  }
  EXPECT_TRUE(receiver.out.issues.empty()) << receiver.out.issues[0].text;
  return largest;
}

void expect_all_joints_back(const Clip& clip) {
  for (const char* framing : {"t-last", "t-first", "split", "split&root=origin"}) {
    const auto largest = round_trip(clip, framing);
    for (std::size_t j = 0; j < joint_count; ++j)
      EXPECT_LT(largest[j], 1e-4) << joint_names[j] << " " << framing;
    testing::Test::RecordProperty(clip.name + "_" + framing + "_largest_error_m",
                                  std::to_string(*std::max_element(largest.begin(), largest.end())));
  }
}

TEST(VmcRoundTrip, GivesAStandingPoseBack) {
  Clip clip{"standing", 60, {}};
  for (int f = 0; f < 60; ++f)
    clip.poses.push_back(test::moved(test::standing_pose(), 0.1 * f, Vec3(0.01 * f, 0, 1)));
  expect_all_joints_back(clip);
}

TEST(VmcRoundTrip, GivesCapturedClipsBack) {
  ABRAZO_REQUIRE_CAPTURED_DATA(data);
  for (const char* name : {"60_01.amc", "61_01.amc"}) {
    ImportOptions options;
    options.fps = 60;
    SCOPED_TRACE(name);
    expect_all_joints_back(
        load_motion((data / "cmu_salsa" / name).string(), "", options).value().front().clip);
  }
}

}  // namespace
}  // namespace abrazo::vmc_round_trip_test
