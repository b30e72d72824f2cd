#include <gtest/gtest.h>

#include "core/motion/body/body.hpp"
#include "core/stream/xsens/xsens_encoder.hpp"
#include "tests/core/stream/mocap_stream.hpp"
#include "tests/support/bodies.hpp"

namespace abrazo::xsens_hostile_test {
namespace {

TEST(XsensHostile, MutatedPacketsAreIssuesOrFramesButNeverFatal) {
  const Pose pose = test::standing_pose();
  auto sender = make_xsens_encoder(*parse_stream_uri("xsens://h:9763"), body_of(pose));
  ASSERT_TRUE(sender);
  std::vector<std::vector<std::uint8_t>> good;
  for (int f = 0; f < 4; ++f)
    for (auto& packet : (*sender)->packets({pose, f / 60.0, true})) good.push_back(std::move(packet));
  test::Listener listener("xsens://0.0.0.0:9763");
  EXPECT_GT(test::feed_mutations(listener, good, 100'000, 11), 10'000u);
}

}  // namespace
}  // namespace abrazo::xsens_hostile_test
