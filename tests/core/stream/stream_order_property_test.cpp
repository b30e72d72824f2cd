#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cmath>

#include "core/stream/receive/pose_reader.hpp"
#include "core/stream/receive/stream_pipeline.hpp"
#include "tests/core/stream/plain_stream.hpp"
#include "tests/support/bodies.hpp"

namespace abrazo::stream_order_property_test {
namespace {

/// One way of a frame through the network.
struct Copy {
  std::int64_t counter;
  double arrives_s;
};

/// 200 frames at 100 Hz, some lost, some twice, some up to 120 ms late, in this order.
std::vector<Copy> network(std::int64_t frames) {
  std::vector<Copy> copies;
  for (std::int64_t counter = 0; counter < frames; ++counter) {
    const bool is_end = counter == 0 || counter == frames - 1;  // what nobody knows of cannot be counted
    const int times = is_end ? 1 : *rc::gen::weightedElement<int>({{2, 0}, {12, 1}, {3, 2}});
    for (int i = 0; i < times; ++i) {
      const int late_ms = is_end ? (counter == 0 ? 0 : 130) : *rc::gen::inRange(0, 120);
      copies.push_back({counter, 0.01 * static_cast<double>(counter) + 0.001 * late_ms});
    }
  }
  std::stable_sort(copies.begin(), copies.end(),
                   [](const Copy& a, const Copy& b) { return a.arrives_s < b.arrives_s; });
  return copies;
}

void keeps_order_and_counts(bool with_counter, bool with_time) {
  constexpr std::int64_t frames = 200;
  const std::vector<Copy> copies = network(frames);
  StreamReceiverOptions given_options;
  given_options.delay_s = *rc::gen::element(0.0, 0.03, 0.2);
  const StreamUri uri = *parse_stream_uri("vmc://0.0.0.0");
  StreamPipeline pipeline(std::make_unique<test::PlainDecoder>(), uri, *performer_options(uri, given_options),
                          0);
  PoseReader reader("");
  StreamPipeline::Output output;
  const int polls_left_out = *rc::gen::inRange(0, 4);

  std::uint64_t given = 0;
  double last_time_s = -1, last_number = -1;
  const auto read = [&](double now_s) {
    const auto pose = reader.poll(pipeline, now_s);
    if (!pose) return;
    ++given;
    RC_ASSERT(pose->pose.allFinite());
    RC_ASSERT(pose->time_s > last_time_s);
    const double number = std::round(1e4 * pose->pose(joints::Root, 0));  // which frame it is
    RC_ASSERT(number > last_number);
    last_time_s = pose->time_s;
    last_number = number;
  };
  int turn = 0;
  for (const Copy& copy : copies) {
    test::PlainFrame frame;
    if (with_counter) frame.counter = copy.counter;
    if (with_time) frame.time_s = 77 + 0.01 * static_cast<double>(copy.counter);
    frame.pose = test::moved(test::standing_pose(), 0, Vec3(1e-4 * static_cast<double>(copy.counter), 0, 0));
    pipeline.take({{1, 1}, copy.arrives_s, test::plain_packet(frame)}, copy.arrives_s, output);
    if (turn++ % (polls_left_out + 1) == 0) read(copy.arrives_s);
  }
  read(100);
  const PerformerHealth health = pipeline.health(100).performers.at(0);
  const std::uint64_t came = copies.size();
  RC_ASSERT(given + health.dropped + health.late + health.repeated == came);
  if (with_counter)
    RC_ASSERT(given + health.dropped + health.late + health.lost == static_cast<std::uint64_t>(frames));
  RC_ASSERT(health.restarts == 0U);
  RC_ASSERT(health.unusable == 0U);
}

TEST(StreamOrder, NoNetworkMakesACountedStreamGoBackOrMiscount) {
  EXPECT_TRUE(rc::check([] { keeps_order_and_counts(true, false); }));
}

TEST(StreamOrder, NorOneWithCounterAndTime) {
  EXPECT_TRUE(rc::check([] { keeps_order_and_counts(true, true); }));
}

TEST(StreamOrder, NorOneWithTimeAlone) {
  EXPECT_TRUE(rc::check([] { keeps_order_and_counts(false, true); }));
}

}  // namespace
}  // namespace abrazo::stream_order_property_test
