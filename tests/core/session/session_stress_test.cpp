// Everything that may go on at once in a running session, for ThreadSanitizer: bounded by counts, not by
// time.
#include <gtest/gtest.h>

#include <atomic>
#include <stop_token>
#include <thread>

#include "core/session/export/exporting.hpp"
#include "core/session/export/session_export.hpp"
#include "core/session/file/session_file.hpp"
#include "core/session/run/session_engine.hpp"
#include "core/stream/net/udp_socket.hpp"
#include "core/stream/receive/clip_source.hpp"
#include "core/stream/receive/silent_source.hpp"
#include "core/stream/vmc/vmc_encoder.hpp"
#include "tests/core/session/recorded_session.hpp"
#include "tests/support/settings.hpp"

namespace abrazo::session_stress_test {
namespace {

constexpr int packets_of_a_sender = 240;
constexpr int rounds = 10;

/// Sends a moving body to a port at some 400 Hz, from a thread of its own.
class Sender {
 public:
  Sender(std::uint16_t port, unsigned seed)
      : thread_([this, port, seed] {
          auto sink = PoseSink::open(*parse_stream_uri("vmc://127.0.0.1:" + std::to_string(port)),
                                     test::session_library()->usual_active_body().body, "user");
          if (!sink) return;
          const Clip clip = test::swinging_take("user", packets_of_a_sender, seed).a;
          for (int i = 0; i < packets_of_a_sender; ++i) {
            OutgoingPose pose;
            pose.pose = clip.poses[static_cast<std::size_t>(i)];
            pose.time_s = i / 400.0;
            (*sink)->send(pose);
            (void)(*sink)->health();
            std::this_thread::sleep_for(std::chrono::microseconds(2500));
          }
          done_ = true;
        }) {}
  bool done() const { return done_; }

 private:
  std::atomic<bool> done_ = false;
  std::jthread thread_;
};

/// Looks at whatever a window looks at, as often as it can.
class Onlooker {
 public:
  explicit Onlooker(const SessionEngine& engine)
      : thread_([this, &history = engine.history(), &latest = engine.latest()](const std::stop_token& stop) {
          double sum = 0;
          while (!stop.stop_requested()) {
            if (const FrameSnapshotPtr newest = latest.newest()) sum += newest->result.energy.deformation;
            const auto span = history.span();
            for (const FrameSnapshotPtr& frame : history.range(span.last_s - 0.5, span.last_s, 32)) {
              sum += frame->time_s;
              ++looked_;
            }
            if (const FrameSnapshotPtr frame = history.at(span.first_s)) sum += frame->time_s;
          }
          EXPECT_EQ(sum, sum);
        }) {}
  std::uint64_t looked() const { return looked_; }

 private:
  std::atomic<std::uint64_t> looked_ = 0;
  std::jthread thread_;
};

Status export_what_there_is(const SessionEngine& engine, const std::string& output) {
  RunningExport running;
  running.name = "session";
  running.frames = engine.history().stretch(-1, 1e9);
  if (running.frames.size() < 2) return Done{};  // a single one has no rate
  running.library = test::session_library();
  running.library_name = "small";
  running.input = "user";
  const auto source = export_of_history(std::move(running));
  if (!source) return source.error();
  ExportWish wish;
  wish.content = ExportContent::Motion;
  wish.bodies = {SessionBody::Active, SessionBody::Passive};
  wish.output = output;
  const auto written = export_session(**source, wish, {});
  return written ? Status(Done{}) : Status(written.error());
}

std::uint16_t port_of(const StreamReceiver& receiver) {
  const std::string at = receiver.health().listening;
  return static_cast<std::uint16_t>(std::stoi(at.substr(at.find(':') + 1)));
}

std::unique_ptr<PartnerSynthesizer> another_synthesizer(int round) {
  Settings settings = test::responsive_by_pose();
  settings.neighbours = 2 + round;
  return std::move(*PartnerSynthesizer::create(test::session_library(), settings));
}

TEST(SessionUnderLoad, EverythingAtOnceLeavesAWholeRecordingAndALiveSession) {
  const test::TemporaryFolder folder;
  SessionEngine engine(another_synthesizer(0), std::make_shared<SilentSource>());
  const Onlooker window(engine), plots(engine);
  std::vector<std::string> recordings;
  for (int round = 0; round < rounds; ++round) {
    ASSERT_TRUE(engine.receive(*parse_stream_uri("vmc://127.0.0.1:0")));
    const Sender ana(port_of(*engine.receiver()), 4), ben(port_of(*engine.receiver()), 5);
    recordings.push_back(folder.file("s" + std::to_string(round) + ".abrazo"));
    RecordingFacts facts = test::session_facts();
    facts.input = "vmc://127.0.0.1";
    ASSERT_TRUE(engine.record(recordings.back(), facts));
    ASSERT_TRUE(engine.send(*parse_stream_uri("vmc://127.0.0.1:9"), Character::Partner));
    engine.recorder()->begin_take("take " + std::to_string(round));
    std::jthread exporting([&engine, output = folder.file("motion.bvh")] {
      for (int i = 0; i < 3; ++i) {
        const Status exported = export_what_there_is(engine, output);
        EXPECT_TRUE(exported) << exported.error().text();
      }
    });
    for (int i = 0; !ana.done() || !ben.done(); ++i) {
      Settings settings = *preset(i % 2 ? "responsive" : "paper");
      settings.alpha = 0.1 * (i % 10);
      settings.neighbours = 1 + i % 20;
      settings.user_role = i / 7 % 2 ? UserRole::Passive : UserRole::Active;
      engine.push(SetSettings{settings});
      engine.push(SetVetoes{{{i % 5}, {}, {}}});
      if (i % 11 == 3) engine.push(PinPair{i % 30});
      if (i % 11 == 8) engine.push(PinPair{std::nullopt});
      if (i % 40 == 20) engine.push(ReplaceSynthesizer{another_synthesizer(i % 7)});
      const auto health = engine.receiver()->health();
      for (const PerformerHealth& performer : health.performers)
        if (i % 30 == 10) engine.follow_performer(performer.performer);
      (void)engine.sinks();
      (void)engine.recorder()->state();
      if (const auto store = engine.recorder()->store()) (void)store->at(engine.clock().now_s() - 0.2);
      if (i % 50 == 30) engine.recorder()->begin_take("again");
      std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
    exporting.join();
    engine.stop_sending("vmc://127.0.0.1:9");
    EXPECT_TRUE(engine.stop_recording());
    engine.stop_receiving();
  }
  const FrameSnapshotPtr newest = engine.latest().newest();
  ASSERT_TRUE(newest);
  EXPECT_GT(window.looked() + plots.looked(), 0U);
  std::uint64_t frames = 0;
  for (const std::string& path : recordings) {
    const auto file = SessionFile::open(path);
    ASSERT_TRUE(file) << file.error().text();
    const auto pass = (*file)->each_frame(-1e9, 1e9, [&](const FrameSnapshot&) -> Status {
      ++frames;
      return Done{};
    });
    ASSERT_TRUE(pass);
    EXPECT_EQ(pass->damaged, 0U) << pass->damage;
    EXPECT_TRUE((*file)->contents().runs.back().finished);
  }
  EXPECT_GT(frames, static_cast<std::uint64_t>(rounds));
}

}  // namespace
}  // namespace abrazo::session_stress_test
