#include "core/session/run/session_engine.hpp"

#include <gtest/gtest.h>

#include <numeric>
#include <thread>

#include "core/session/run/history_keeper.hpp"
#include "core/stream/receive/clip_source.hpp"
#include "tests/core/session/fakes.hpp"
#include "tests/support/settings.hpp"

namespace abrazo::session_engine_test {
namespace {

using test::FakeDevice;
using test::FakeSink;

/// Returns once it holds; the engine runs in real time.
bool eventually(const std::function<bool()>& holds) {
  const auto until = std::chrono::steady_clock::now() + std::chrono::seconds(20);
  while (!holds()) {
    if (std::chrono::steady_clock::now() > until) return false;
    std::this_thread::yield();
  }
  return true;
}

IntendedMove meant(std::optional<std::string> label, std::optional<std::string> take) {
  IntendedMove move;
  move.label = std::move(label);
  move.take = std::move(take);
  return move;
}

class FakeReceiver : public StreamReceiver {
 public:
  FakeReceiver(StreamUri uri, std::shared_ptr<FakeDevice> device)
      : uri_(std::move(uri)), device_(std::move(device)) {}
  const StreamUri& uri() const override { return uri_; }
  StreamHealth health() const override { return {}; }
  std::vector<std::string> performers() const override { return {"Ana", "Ben"}; }
  std::unique_ptr<PoseSource> source(const std::string& performer) override {
    followed = performer;
    return std::make_unique<test::SharedDevice>(device_);
  }
  int listen(std::function<void(const ReceivedPose&)> listener) override {
    listeners.push_back(std::move(listener));
    return static_cast<int>(listeners.size());
  }
  void unlisten(int number) override { listeners[static_cast<std::size_t>(number - 1)] = nullptr; }
  void set_delay(double) override {}
  void calibrate(const std::string&, double) override {}
  std::optional<Body> measured_body(const std::string&) const override { return std::nullopt; }

  std::string followed;
  std::vector<std::function<void(const ReceivedPose&)>> listeners;

 private:
  StreamUri uri_;
  std::shared_ptr<FakeDevice> device_;
};

class FakeRecorder : public Recorder {
 public:
  void frame_solved(const FrameSnapshotPtr& frame) override { frames.frame_solved(frame); }
  void pose_received(const ReceivedPose& pose) override { poses.push_back(pose); }
  void begin_take(const std::string&) override {}
  void end_take() override {}
  void set_markers(const Markers&) override {}
  void save_project(std::shared_ptr<const Project>) override {}
  void edit_takes(const TakeEdits&) override {}
  void set_library_path(const std::shared_ptr<const MotionLibrary>&, const std::string&) override {}
  State state() const override {
    State state;
    state.path = "S.abrazo";
    return state;
  }
  std::shared_ptr<const FrameStore> store() const override { return nullptr; }
  Status flush() override { return Done{}; }
  Status finish() override {
    finished = true;
    return finish_with;
  }

  test::FakeListener frames;
  std::vector<ReceivedPose> poses;
  Status finish_with = Done{};
  bool finished = false;
};

class FakeKeeper : public HistoryKeeper {
 public:
  void frame_solved(const FrameSnapshotPtr& frame) override { frames.frame_solved(frame); }
  void rest(std::shared_ptr<const FrameStore>) override { rests = true; }
  Status go_on() override {
    rests = false;
    return Done{};
  }
  void tend() override {}
  void set_bound(std::uint64_t) override {}
  State state() const override { return {}; }
  double kept_after_s(double) const override { return 0; }
  double performed_after_s(double) const override { return 0; }
  std::shared_ptr<const FrameStore> store() const override { return nullptr; }
  void remove() override {}

  test::FakeListener frames;
  bool rests = false;
};

class Engine : public testing::Test {
 protected:
  static std::unique_ptr<PartnerSynthesizer> synthesizer() {
    return std::move(*PartnerSynthesizer::create(test::small_library(), test::responsive_by_pose()));
  }
  SessionOpeners openers() {
    SessionOpeners fakes;
    fakes.receiver = [this](const StreamUri& uri, const SessionClock&,
                            const StreamReceiverOptions& options) -> Result<std::shared_ptr<StreamReceiver>> {
      if (uri.port == 1) return Error{"the port is taken", uri.text};
      receiver = std::make_shared<FakeReceiver>(uri, device);
      if (options.prepare) options.prepare(*receiver);
      if (while_opening) while_opening();
      return std::shared_ptr<StreamReceiver>(receiver);
    };
    fakes.sink = [this](const StreamUri& uri, const Body& body,
                        const std::string& character) -> Result<std::unique_ptr<PoseSink>> {
      if (uri.port == 1) return Error{"no such host", uri.text};
      opened_character = character;
      sink_body = body;
      auto made = std::make_unique<FakeSink>();
      sink = made.get();
      return std::unique_ptr<PoseSink>(std::move(made));
    };
    fakes.recorder = [this](const std::string&, const RecordingFacts& facts) {
      recorded_facts = facts;
      return Result<std::shared_ptr<Recorder>>(recorder);
    };
    return fakes;
  }
  static StreamUri uri(std::uint16_t port) {
    StreamUri made;
    made.port = port;
    made.text = "vmc://127.0.0.1:" + std::to_string(port);
    return made;
  }
  bool runs_on_the_clip() {
    return eventually([&] {
      const FrameSnapshotPtr newest = engine.latest().newest();
      return newest && newest->input_frame >= 0;
    });
  }
  void a_pose_arrives() {
    SourcePose pose;
    pose.pose = test::swinging_take("user", 2, 4).a.poses[0];
    pose.time_s = pose.arrived_s = pose.assembled_s = engine.clock().now_s();
    device->arrive(pose);
  }
  bool runs_on_the_device() {
    return eventually([&] {
      a_pose_arrives();
      const FrameSnapshotPtr newest = engine.latest().newest();
      return newest && newest->times.arrived_s >= 0;
    });
  }

  std::shared_ptr<FakeDevice> device = std::make_shared<FakeDevice>();
  std::shared_ptr<FakeReceiver> receiver;
  std::function<void()> while_opening;  ///< between who listens and who plays
  std::shared_ptr<FakeRecorder> recorder = std::make_shared<FakeRecorder>();
  FakeSink* sink = nullptr;
  std::string opened_character;
  Body sink_body;
  RecordingFacts recorded_facts;
  SessionEngine engine{synthesizer(), std::make_shared<ClipSource>(test::swinging_take("user", 120, 4).a),
                       SessionClock(), openers()};
};

TEST_F(Engine, RunsOnItsOwnSourceFromTheStart) {
  EXPECT_TRUE(runs_on_the_clip());
  EXPECT_EQ(engine.receiver(), nullptr);
  EXPECT_EQ(engine.recorder(), nullptr);
}

TEST_F(Engine, ThatForgetsItsHistoryKeepsTheNewestFrame) {
  ASSERT_TRUE(eventually([&] { return engine.history().span().frames > 5; }));
  engine.forget_history();
  EXPECT_TRUE(eventually([&] { return engine.history().span().frames == 1; }));
  EXPECT_TRUE(eventually([&] { return engine.latest().newest()->index > 10; })) << "it goes on";
}

TEST_F(Engine, AStreamTakesOverAndGivesBackTheSourceThereWas) {
  ASSERT_TRUE(runs_on_the_clip());
  ASSERT_TRUE(engine.receive(uri(39539), "Ana"));
  EXPECT_EQ(receiver->followed, "Ana");
  EXPECT_EQ(engine.receiver(), receiver);
  EXPECT_TRUE(runs_on_the_device());
  engine.follow_performer("Ben");
  EXPECT_EQ(receiver->followed, "Ben");
  EXPECT_TRUE(runs_on_the_device());
  engine.stop_receiving();
  EXPECT_EQ(engine.receiver(), nullptr);
  EXPECT_TRUE(runs_on_the_clip());
}

TEST_F(Engine, AStreamThatCannotBeOpenedChangesNothing) {
  ASSERT_TRUE(engine.receive(uri(39539)));
  const Status refused = engine.receive(uri(1));
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().text(), "vmc://127.0.0.1:1: the port is taken");
  EXPECT_EQ(engine.receiver(), receiver);
  EXPECT_TRUE(runs_on_the_device());
}

TEST_F(Engine, WhenAStreamIsClosedNobodyHoldsItsSourceAnyMore) {
  ASSERT_TRUE(engine.receive(uri(39539)));
  ASSERT_TRUE(runs_on_the_device());
  const std::weak_ptr<StreamReceiver> closed = engine.receiver();
  receiver.reset();
  engine.stop_receiving();
  EXPECT_TRUE(closed.expired());
  EXPECT_EQ(device.use_count(), 1);
}

TEST_F(Engine, ACharacterIsSentWithTheBodyOfItsRole) {
  const auto library = test::small_library();
  ASSERT_TRUE(engine.send(uri(39540), Character::Partner));
  EXPECT_EQ(opened_character, "partner");
  EXPECT_EQ(sink_body.bone_lengths, library->usual_passive_body().body.bone_lengths);
  EXPECT_TRUE(eventually([&] { return engine.sinks().front().frames > 3; }));
  EXPECT_FALSE(engine.send(uri(39540), Character::User));
  EXPECT_FALSE(engine.send(uri(1), Character::User));
  engine.stop_sending("vmc://127.0.0.1:39540");
  EXPECT_TRUE(engine.sinks().empty());
}

TEST_F(Engine, ARecordingHasEveryFrameAndPoseBetweenItsBeginningAndItsEnd) {
  ASSERT_TRUE(engine.receive(uri(39539)));
  ASSERT_TRUE(engine.record("S.abrazo", {}));
  EXPECT_NE(recorded_facts.library, nullptr);
  EXPECT_FALSE(engine.record("T.abrazo", {}));
  ASSERT_TRUE(runs_on_the_device());
  receiver->listeners.front()(ReceivedPose{});
  ASSERT_TRUE(eventually([&] {
    a_pose_arrives();  // frames follow poses, and the first few may be solved as one
    return recorder->frames.frames().size() > 2;
  }));
  recorder->finish_with = Error{"the disk is full", "S.abrazo"};
  EXPECT_FALSE(engine.stop_recording());
  EXPECT_TRUE(recorder->finished);
  EXPECT_EQ(recorder->poses.size(), 1U);
  EXPECT_EQ(receiver->listeners.front(), nullptr);
  const auto frames = recorder->frames.frames();
  ASSERT_TRUE(runs_on_the_device());
  EXPECT_EQ(recorder->frames.frames().size(), frames.size());
  EXPECT_TRUE(frames.front()->before);
  for (std::size_t i = 1; i < frames.size(); ++i) EXPECT_EQ(frames[i]->index, frames[i - 1]->index + 1);
}

/// Its files are made by a worker, and meanwhile a recording may have begun.
/// A slow disk takes seconds to finish; who must not wait takes the recorder along.
TEST_F(Engine, AReleasedRecorderGetsNothingMoreAndIsNotFinished) {
  ASSERT_TRUE(runs_on_the_clip());
  EXPECT_EQ(engine.release_recorder(), nullptr);
  ASSERT_TRUE(engine.record("S.abrazo", {}));
  ASSERT_TRUE(eventually([&] { return recorder->frames.frames().size() > 2; }));
  EXPECT_EQ(engine.release_recorder(), recorder);
  EXPECT_FALSE(recorder->finished);
  EXPECT_EQ(engine.recorder(), nullptr);
  const std::size_t frames = recorder->frames.frames().size();
  const std::uint64_t index = engine.latest().newest()->index;
  ASSERT_TRUE(eventually([&] { return engine.latest().newest()->index > index + 3; }));
  EXPECT_EQ(recorder->frames.frames().size(), frames);
}

TEST_F(Engine, AHistoryKeptFromLaterOnHasTheEarlierFramesAndRestsDuringARecording) {
  ASSERT_TRUE(runs_on_the_clip());
  ASSERT_TRUE(engine.record("S.abrazo", {}));
  const auto keeper = std::make_shared<FakeKeeper>();
  engine.keep_history(keeper);
  EXPECT_TRUE(keeper->rests);
  ASSERT_TRUE(eventually([&] { return keeper->frames.frames().size() > 2; }));
  EXPECT_EQ(keeper->frames.frames().front()->index, 0U);
  ASSERT_TRUE(engine.stop_recording());
  EXPECT_FALSE(keeper->rests);
}

TEST_F(Engine, ALaterStreamIsRecordedToo) {
  ASSERT_TRUE(engine.record("S.abrazo", {}));
  ASSERT_TRUE(engine.receive(uri(39539)));
  ASSERT_EQ(receiver->listeners.size(), 1U);
  receiver->listeners.front()(ReceivedPose{});
  EXPECT_EQ(recorder->poses.size(), 1U);
  EXPECT_TRUE(engine.stop_recording());
}

TEST_F(Engine, EveryFrameKnowsTheInputItCameFromAlsoWhileAStreamIsOpened) {
  RecordingFacts facts;
  facts.input = "clip:own";
  ASSERT_TRUE(engine.record("S.abrazo", facts));
  EXPECT_EQ(recorded_facts.input, "clip:own");
  const auto recorded = [&] { return recorder->frames.frames().size(); };
  while_opening = [&] {
    const std::size_t before = recorded();
    EXPECT_TRUE(eventually([&] { return recorded() > before + 3; }));
  };
  ASSERT_TRUE(engine.receive(uri(39539)));
  ASSERT_TRUE(runs_on_the_device());
  engine.stop_receiving();
  ASSERT_TRUE(runs_on_the_clip());
  ASSERT_TRUE(engine.stop_recording());
  std::size_t of_clip = 0, of_stream = 0;
  for (const FrameSnapshotPtr& frame : recorder->frames.frames()) {
    if (frame->elapsed_s < 0) continue;  // no pose came in time; what it shows is from before
    const bool is_of_clip = frame->input_frame >= 0;
    ++(is_of_clip ? of_clip : of_stream);
    EXPECT_EQ(frame->input ? *frame->input : "", is_of_clip ? "" : "vmc://127.0.0.1:39539");
  }
  EXPECT_GT(of_clip, 3U);
  EXPECT_GT(of_stream, 0U);
}

TEST_F(Engine, ARecordingThatBeginsWithAStreamDoesNotTakeItsNameForTheClips) {
  ASSERT_TRUE(engine.receive(uri(39539)));
  RecordingFacts facts;
  facts.input = "vmc://127.0.0.1:39539";
  ASSERT_TRUE(engine.record("S.abrazo", facts));
  EXPECT_EQ(recorded_facts.input, "") << "frames without a name are the clip's, which nobody has named";
}

TEST_F(Engine, ItsRecordingsShareTheFingerprintsOfLibraries) {
  ASSERT_TRUE(engine.record("S.abrazo", {}));
  const auto shared = recorded_facts.fingerprints;
  ASSERT_TRUE(engine.stop_recording());
  ASSERT_TRUE(engine.record("S.abrazo", {}));
  EXPECT_NE(shared, nullptr);
  EXPECT_EQ(recorded_facts.fingerprints, shared);
}

TEST_F(Engine, AMoveThatIsNotThereIsRefusedWithThoseThatAre) {
  const Status refused = engine.intend(meant("somersault", std::nullopt));
  ASSERT_FALSE(refused);
  EXPECT_NE(refused.error().text().find("\"turn\" (165 pairs)"), std::string::npos) << refused.error().text();
  EXPECT_TRUE(engine.intend(meant(std::nullopt, "second")));
  EXPECT_TRUE(eventually([&] {
    const FrameSnapshotPtr newest = engine.latest().newest();
    return newest && newest->decisions && newest->decisions->meant;
  }));
  EXPECT_FALSE(engine.meant_choices().empty());
}

TEST(MeantChoices, BeforeAPairIsSelectedEveryMoveIsThereWithoutADistance) {
  const auto library = test::small_library();
  std::vector<int> pairs(static_cast<std::size_t>(library->pair_count()));
  std::iota(pairs.begin(), pairs.end(), 0);
  const RoleViews views(library, pairs);
  const FrameResult failed;  // nothing is selected
  for (const FrameResult* frame : {static_cast<const FrameResult*>(nullptr), &failed}) {
    const auto choices = meant_choices(views, UserRole::Active, frame);
    ASSERT_EQ(choices.size(), 2U);
    EXPECT_EQ(choices[0].label, "open_hold");
    EXPECT_EQ(choices[1].label, "turn");
    for (const MeantChoice& choice : choices) {
      EXPECT_EQ(choice.pairs, 165);
      EXPECT_EQ(choice.nearest, -1);
      EXPECT_EQ(choice.pose_distance, -1);
    }
  }
  for (const int pair : {pairs.front(), pairs.back()}) {
    FrameResult solved;
    solved.selected = 0;
    solved.features = library->features(pair);
    solved.query_normalized = library->pose(pair).topRows<joint_count>();
    const auto choices = meant_choices(views, UserRole::Active, &solved);
    EXPECT_EQ(choices.at(0).label, library->label(pair)) << "the nearest first";
    EXPECT_EQ(choices.at(0).nearest, pair);
    EXPECT_EQ(choices.at(0).feature_distance, 0);
    EXPECT_EQ(choices.at(0).pose_distance, 0);
    EXPECT_GT(choices.at(1).pose_distance, 0);
  }
}

}  // namespace
}  // namespace abrazo::session_engine_test
