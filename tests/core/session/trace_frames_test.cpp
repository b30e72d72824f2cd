// Traces read back: what was written comes out again, and each broken line is named.
#include "core/session/frames/trace_frames.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "tests/support/bodies.hpp"
#include "tests/support/libraries.hpp"

namespace abrazo::test::trace_frames_test {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

FrameResult example(double distance_m) {
  FrameResult result;
  result.result = facing_pair(distance_m);
  result.selected_pair = facing_pair(distance_m + 0.1);
  result.query_world = result.result.topRows<joint_count>();
  result.edges = {{0, 1}, {0, 25}, {16, 41}};
  result.tetrahedra = {{0, 1, 25, 26}};
  result.candidates.resize(3);
  for (Candidate& candidate : result.candidates) candidate.pair = 0;
  result.selected = 1;
  result.foot_locks = {{true, false}, {true, true}, {false, true}, {false, false}};
  result.collisions = {{{1, 2}, {26, 27}, 0.02, 0.01}};
  result.status = StepStatus::Relaxed;
  result.message = "feet were let go";
  return result;
}

std::string trace_of(const std::vector<double>& times_s) {
  TraceHeader header{"lib.h5", "walk.bvh", 15, {}};
  std::string text = trace_header_line(header) + "\n";
  const auto library = small_library();
  for (std::size_t i = 0; i < times_s.size(); ++i)
    text += trace_frame_line(example(0.6 + 0.01 * static_cast<double>(i)), *library,
                             static_cast<long long>(i), times_s[i]) +
            "\n";
  return text;
}

class TraceFile : public testing::Test {
 protected:
  Result<TraceFrames> opened(const std::string& text, const Progress& progress = {}) {
    std::ofstream(file_, std::ios::binary) << text;
    return TraceFrames::open(file_, progress);
  }
  std::string refusal(const std::string& text) {
    const auto trace = opened(text);
    return trace ? "was read" : trace.error().text();
  }
  void TearDown() override { std::filesystem::remove(file_); }

 private:
  std::filesystem::path file_ =
      std::filesystem::path(testing::TempDir()) / ("trace" + std::to_string(::getpid()) + ".jsonl");
};

TEST_F(TraceFile, GivesTheFramesAsTheyWereSolved) {
  auto trace = opened(trace_of({0, 0.1, 0.2}));
  ASSERT_TRUE(trace) << trace.error().text();
  EXPECT_EQ(trace->header().input, "walk.bvh");
  EXPECT_EQ(trace->header().fps, 15);
  EXPECT_THAT(trace->times_s(), ElementsAre(0, 0.1, 0.2));
  const auto frame = trace->at(0.15);
  ASSERT_TRUE(frame) << frame.error().text();
  const FrameResult &result = (*frame)->result, wanted = example(0.61);
  EXPECT_EQ((*frame)->time_s, 0.1);
  EXPECT_EQ((*frame)->input_frame, 1);
  EXPECT_EQ(result.result, wanted.result) << "to the bit";
  EXPECT_EQ(result.selected_pair, wanted.selected_pair);
  EXPECT_EQ(result.edges, wanted.edges);
  EXPECT_EQ(result.tetrahedra, wanted.tetrahedra);
  EXPECT_EQ(result.edge_residuals_m.size(), 3u);
  EXPECT_EQ(result.candidates.size(), 3u) << "how many there were is known";
  EXPECT_EQ(result.selected, 1);
  EXPECT_EQ(result.foot_locks, wanted.foot_locks);
  EXPECT_EQ(result.collisions.size(), 1u);
  EXPECT_EQ(result.collisions[0].allowed_depth_m, 0.01);
  EXPECT_EQ(result.status_text(), wanted.status_text());
}

TEST_F(TraceFile, ShowsTheFirstFrameBeforeItAndTheLastAfter) {
  auto trace = opened(trace_of({1, 2}));
  ASSERT_TRUE(trace);
  EXPECT_EQ((*trace->at(-5))->time_s, 1);
  EXPECT_EQ((*trace->at(99))->time_s, 2);
  EXPECT_EQ((*trace->at(1))->time_s, 1) << "also backwards";
}

TEST_F(TraceFile, ThatIsBrokenIsRefusedWithItsLine) {
  const std::string good = trace_of({0, 0.1});
  const std::string header = good.substr(0, good.find('\n') + 1);
  const auto frame = [&](const std::string& from, const std::string& to) {
    std::string line = good.substr(header.size(), good.find('\n', header.size()) - header.size());
    const std::size_t at = line.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    return header + line.replace(at, from.size(), to) + "\n";
  };
  EXPECT_THAT(refusal(""), HasSubstr(":1: is empty"));
  EXPECT_THAT(refusal("take,start_frame\n"), HasSubstr(":1: is no trace"));
  EXPECT_THAT(refusal("{\"abrazo_trace\":2}\n"), HasSubstr("newer version"));
  EXPECT_THAT(refusal("{\"abrazo_trace\":1,\"units\":\"cm\"}\n"), HasSubstr("\"units\" is not \"m\""));
  EXPECT_THAT(refusal(header), HasSubstr("has a header and no frame"));
  EXPECT_THAT(refusal(good.substr(0, good.size() - 40)), HasSubstr(":3: is no JSON object"));
  EXPECT_THAT(refusal(frame("\"time\":0", "\"time\":\"now\"")), HasSubstr(":2: \"time\" has to be a number"));
  EXPECT_THAT(refusal(frame("]]},\"active\":[[", "]]},\"activ\":[[")),
              HasSubstr(":2: \"active\" is missing"));
  EXPECT_THAT(refusal(frame("\"edges\":[[0,1]", "\"edges\":[[0,77]")), HasSubstr("rows of 2 vertices 0..49"));
  EXPECT_THAT(refusal(frame("\"edges\":[[0,1]", "\"edges\":[[4,4]")), HasSubstr("from a vertex to itself"));
  EXPECT_THAT(refusal(frame("\"edges\":[[0,1],[0,25]", "\"edges\":[[0,1],[1,0]")),
              HasSubstr(":2: \"edges\" has the edge between 0 and 1 twice"));
  std::string same = "\"edges\":[[48,49]";
  for (int i = 0; i < 2400; ++i) same += ",[48,49]";
  EXPECT_THAT(refusal(frame("\"edges\":[[0,1]", same)), HasSubstr("has the edge between 48 and 49 twice"));
  EXPECT_THAT(refusal(frame("\"selected\":1", "\"selected\":3")), HasSubstr("no index into \"candidates\""));
  EXPECT_THAT(refusal(frame("active.right", "active.tail")), HasSubstr("\"foot_locks\" has to be names"));
  EXPECT_THAT(refusal(header + std::string((16u << 20) + 1, ' ')), HasSubstr(":2: is too long a line"));
  EXPECT_THAT(refusal(trace_of({1, 0.5})),
              HasSubstr(":3: its time 0.5 is before that of the line before, 1"));
}

TEST_F(TraceFile, StopsWhenItIsToldTo) {
  const auto trace = opened(trace_of({0, 1, 2}), [](double, std::string_view) { return false; });
  ASSERT_FALSE(trace);
  EXPECT_THAT(trace.error().text(), HasSubstr("cancelled"));
}

}  // namespace
}  // namespace abrazo::test::trace_frames_test
