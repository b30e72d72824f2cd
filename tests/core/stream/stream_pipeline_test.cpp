#include "core/stream/receive/stream_pipeline.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/stream/receive/pose_reader.hpp"
#include "tests/core/stream/plain_stream.hpp"
#include "tests/support/bodies.hpp"

namespace abrazo::stream_pipeline_test {
namespace {

using test::performer_frame, test::plain_packet, test::PlainDecoder, test::PlainFrame;
using testing::Contains, testing::ElementsAre, testing::Field, testing::HasSubstr, testing::IsEmpty,
    testing::Not;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

// ---- frame assembly -------------------------------------------------------------------------------------

FrameAssembly::Assembled assemble(FrameAssembly& assembly, const Pose& pose, double at_s = 0) {
  return assembly.assemble(performer_frame({"Ana", {}, {}, pose}, at_s));
}

Pose without(Pose pose, const std::vector<int>& joint_list) {
  for (const int joint : joint_list) pose.row(joint).setConstant(nan);
  return pose;
}

TEST(FrameAssembly, FindsTheJointMapByItself) {
  FrameAssembly assembly({});
  const Pose pose = test::standing_pose();
  EXPECT_EQ(*assemble(assembly, pose).pose, pose);
  EXPECT_FALSE(assemble(assembly, pose).issue) << "nothing is held";
  EXPECT_EQ(assembly.joint_map(), "cmu");
}

TEST(FrameAssembly, SaysWhichPointsAJointMapLacks) {
  FrameAssembly assembly({});
  PerformerFrame frame;
  frame.points = std::make_shared<const std::vector<std::string>>(std::vector<std::string>{"Hips", "Head"});
  frame.positions = Positions::Zero(2, 3);
  const auto assembled = assembly.assemble(frame);
  EXPECT_FALSE(assembled.pose);
  ASSERT_TRUE(assembled.issue);
  EXPECT_EQ(assembled.issue->kind, "no-joint-map");
  EXPECT_THAT(assembled.issue->text, HasSubstr("lacks"));
  const std::string names = assembled.issue->text.substr(assembled.issue->text.find("lacks"));
  EXPECT_EQ(std::count(names.begin(), names.begin() + static_cast<std::ptrdiff_t>(names.find(" and ")), ','),
            4)
      << "five of them: " << names;
}

TEST(FrameAssembly, HoldsAJointRelativeToItsParent) {
  FrameAssembly assembly({});
  const Pose pose = test::standing_pose();
  assemble(assembly, pose, 0);
  const Pose later = test::moved(pose, 0, Vec3(0.1, 0, 0.2));
  const auto assembled = assemble(assembly, without(later, {joints::left_wrist, joints::left_hand}), 0.01);
  ASSERT_TRUE(assembled.pose);
  EXPECT_TRUE(assembled.pose->isApprox(later, 1e-12)) << "wrist and hand went along with the elbow";
  EXPECT_EQ(assembled.held, 2);
  EXPECT_THAT(assembled.issue->text, HasSubstr("lwrist, lhand"));
}

TEST(FrameAssembly, HoldsNoLongerThanAllowed) {
  FrameAssemblyOptions options;
  options.longest_hold_s = 0.2;
  FrameAssembly assembly(options);
  const Pose pose = test::standing_pose();
  assemble(assembly, pose, 0);
  const Pose cut = without(pose, {joints::left_hand});
  EXPECT_TRUE(assemble(assembly, cut, 0.1).pose);
  EXPECT_TRUE(assemble(assembly, cut, 0.2).pose);
  const auto late = assemble(assembly, cut, 0.3);
  EXPECT_FALSE(late.pose);
  EXPECT_THAT(late.issue->text, HasSubstr("lhand has not been tracked for longer than the 0.2 s"));
  EXPECT_TRUE(assemble(assembly, pose, 0.4).pose);
}

TEST(FrameAssembly, GivesNoPoseWithoutTheRootOrWithTooFewJoints) {
  FrameAssembly assembly({});
  const Pose pose = test::standing_pose();
  assemble(assembly, pose);
  EXPECT_EQ(assemble(assembly, without(pose, {joints::Root})).issue->kind, "root-missing");
  EXPECT_TRUE(assemble(assembly, without(pose, {2, 3, 4, 5, 7, 8, 9, 10})).pose) << "eight can be held";
  EXPECT_EQ(assemble(assembly, without(pose, {2, 3, 4, 5, 7, 8, 9, 10, 16})).issue->kind, "joints-missing");
}

TEST(FrameAssembly, TakesWhatIsNotFiniteOrOutOfTheWorldForNotTracked) {
  FrameAssembly assembly({});
  const Pose pose = test::standing_pose();
  assemble(assembly, pose);
  for (const double bad : {nan, std::numeric_limits<double>::infinity(), 1e300, -2e4}) {
    Pose broken = pose;
    broken(joints::Head, 1) = bad;
    const auto assembled = assemble(assembly, broken);
    ASSERT_TRUE(assembled.pose);
    EXPECT_TRUE(assembled.pose->isApprox(pose));
    EXPECT_EQ(assembled.held, 1);
  }
}

TEST(FrameAssembly, AFrameWithoutAPositionPerPointIsRefused) {
  FrameAssembly assembly({});
  PerformerFrame frame = performer_frame({}, 0);
  frame.positions.conservativeResize(3, 3);
  EXPECT_EQ(assembly.assemble(frame).issue->kind, "malformed-frame");
}

TEST(StreamCorrection, ScalesThenTurnsThenLowers) {
  const StreamCorrection correction{0.01, true, 0.12};
  EXPECT_TRUE(correction.apply(Vec3(100, 200, 300)).isApprox(Vec3(1, 2.88, -2), 1e-12));
  EXPECT_EQ(correction.text(), "unit 0.01 m, Z up, floor -0.120 m");
  EXPECT_EQ(StreamCorrection{}.text(), "");
}

// ---- calibration ----------------------------------------------------------------------------------------

/// Upright with straight arms held out sideways.
Pose t_pose() {
  using namespace joints;
  Pose pose = test::standing_pose();
  for (const bool left : {true, false}) {
    const double side = pose(left ? left_shoulder : right_shoulder, 0) > 0 ? 1 : -1;
    const int shoulder = left ? left_shoulder : right_shoulder;
    const std::array<int, 3> arm = {shoulder + 1, shoulder + 2, shoulder + 3};
    const std::array<double, 3> lengths = {0.28, 0.26, 0.09};
    for (std::size_t i = 0; i < 3; ++i)
      pose.row(arm[i]) = pose.row(arm[i] - 1) + Eigen::RowVector3d(side * lengths[i], 0, 0);
  }
  return pose;
}

TEST(StreamCalibration, MeasuresABodyInTheTPoseWithoutDoubts) {
  const std::vector<Pose> poses(100, t_pose());
  const StreamCalibration calibration = calibration_of(poses);
  EXPECT_THAT(calibration.doubts, IsEmpty());
  EXPECT_NEAR(calibration.body.bone_lengths[joints::left_elbow - 1], 0.28, 1e-9);
}

TEST(StreamCalibration, OneBadFrameDoesNotChangeTheMeasures) {
  std::vector<Pose> poses(99, t_pose());
  poses.push_back(10 * t_pose());
  const StreamCalibration calibration = calibration_of(poses);
  EXPECT_NEAR(calibration.body.bone_lengths[joints::left_elbow - 1], 0.28, 1e-9);
  EXPECT_THAT(calibration.doubts, Contains(HasSubstr("stand still")));
}

TEST(StreamCalibration, SaysWhatIsNoTPose) {
  Pose hanging = t_pose();
  for (const int joint : {joints::left_elbow, joints::left_wrist, joints::left_hand})
    hanging.row(joint) =
        hanging.row(joints::left_shoulder) - Eigen::RowVector3d(0, 0.28 * (joint - joints::left_shoulder), 0);
  EXPECT_THAT(calibration_of(std::vector<Pose>{hanging}).doubts,
              testing::ElementsAre(HasSubstr("the left arm points 90 degrees down; lift it")));
  Pose forwards = t_pose();
  for (const int joint : {joints::right_elbow, joints::right_wrist, joints::right_hand})
    forwards.row(joint) = forwards.row(joints::right_shoulder) +
                          Eigen::RowVector3d(0, 0, 0.28 * (joint - joints::right_shoulder));
  EXPECT_THAT(calibration_of(std::vector<Pose>{forwards}).doubts,
              testing::ElementsAre(HasSubstr("the right arm points 90 degrees away from sideways")));
  for (const double scale : {100.0, 0.01})
    EXPECT_THAT(calibration_of(std::vector<Pose>{scale * t_pose()}).doubts,
                Contains(HasSubstr("set the unit")))
        << scale;
}

TEST(StreamCalibration, FindsTheFloorUnderTheFeet) {
  const double usual = calibration_of(std::vector<Pose>{t_pose()}).floor_y_m;
  const Pose higher = test::moved(t_pose(), 0, Vec3(0, 0.3, 0));
  EXPECT_NEAR(calibration_of(std::vector<Pose>{higher}).floor_y_m, usual + 0.3, 1e-9);
}

// ---- pipeline and reader --------------------------------------------------------------------------------

/// A pipeline that plain packets go into, on a clock of the test's own.
class PlainLine {
 public:
  explicit PlainLine(const std::string& uri = "vmc://0.0.0.0", const StreamReceiverOptions& options = {})
      : pipeline(std::make_unique<PlainDecoder>(), *parse_stream_uri(uri),
                 *performer_options(*parse_stream_uri(uri), options), 0) {}

  void send(const PlainFrame& frame, std::uint16_t port = 5000) {
    const auto bytes = plain_packet(frame);
    pipeline.take({{0x0A000001, port}, now_s, bytes}, now_s, output);
  }
  /// A second of standing there, 100 frames.
  void stand(const Pose& pose, const std::string& performer = "Ana", double seconds = 1) {
    for (int i = 0; i < std::lround(100 * seconds); ++i) {
      now_s += 0.01;
      Pose alive = pose;
      alive(joints::Head, 0) += 1e-4 * (i % 2);
      send({performer, ++counter, now_s, alive});
      pipeline.pass_time(now_s, output);
    }
  }
  std::vector<std::string> kinds() const {
    std::vector<std::string> all;
    for (const StreamDiagnosis& diagnosis : pipeline.health(now_s).diagnoses) all.push_back(diagnosis.kind);
    return all;
  }
  std::string advice(const std::string& kind) const {
    for (const StreamDiagnosis& diagnosis : pipeline.health(now_s).diagnoses)
      if (diagnosis.kind == kind) return diagnosis.text;
    return "no " + kind;
  }
  PerformerHealth performer() const { return pipeline.health(now_s).performers.at(0); }

  double now_s = 0;
  std::int64_t counter = 0;
  StreamPipeline::Output output;
  StreamPipeline pipeline;
};

TEST(StreamPipeline, GivesTheNewestPoseAndCountsWhatItReplaced) {
  PlainLine line;
  PoseReader reader("");
  line.stand(test::standing_pose(), "Ana", 0.01);
  EXPECT_TRUE(reader.poll(line.pipeline, line.now_s)->discontinuous);
  line.stand(test::standing_pose(), "Ana", 0.05);
  const auto pose = reader.poll(line.pipeline, line.now_s);
  ASSERT_TRUE(pose);
  EXPECT_EQ(pose->dropped, 4U);
  EXPECT_FALSE(pose->discontinuous);
  EXPECT_NEAR(pose->time_s, line.now_s, 1e-9);
  EXPECT_FALSE(reader.poll(line.pipeline, line.now_s));
}

TEST(StreamPipeline, ADelayMakesThePaceEven) {
  PlainLine line("vmc://0.0.0.0?delay=40");
  PoseReader reader("");
  std::vector<double> times;
  double sent_s = 5000;
  for (int i = 0; i < 400; ++i) {
    // Sent every 10 ms on another clock; the network adds 0 to 30 ms.
    sent_s += 0.01;
    const double arrives_s = 0.01 * i + 0.001 * ((i * 7) % 31);
    while (line.now_s < arrives_s) {
      line.now_s = std::min(line.now_s + 0.001, arrives_s);
      if (const auto pose = reader.poll(line.pipeline, line.now_s)) times.push_back(pose->time_s);
    }
    line.send({"Ana", i, sent_s, test::standing_pose()});
  }
  ASSERT_GT(times.size(), 300U);
  for (std::size_t i = times.size() / 2; i + 1 < times.size(); ++i) {
    const double step = times[i + 1] - times[i];
    EXPECT_NEAR(step, 0.01 * std::round(step / 0.01), 1e-6) << "on the sender's beat";
  }
}

// T = 0 in every packet.
TEST(StreamPipeline, WithoutAUsableSenderTimeArrivalIsTheTime) {
  PlainLine line;
  PoseReader reader("");
  std::vector<double> times;
  for (int i = 0; i < 240; ++i) {
    line.now_s = i / 60.0;
    Pose pose = test::standing_pose();
    pose.col(0).array() += 1e-4 * i;
    line.send({"Ana", {}, 0.0, pose});
    if (const auto got = reader.poll(line.pipeline, line.now_s)) times.push_back(got->time_s);
  }
  ASSERT_EQ(times.size(), 240U);
  for (std::size_t i = 1; i < times.size(); ++i) EXPECT_NEAR(times[i] - times[i - 1], 1 / 60.0, 1e-9) << i;
  const PerformerHealth performer = line.pipeline.health(line.now_s).performers.front();
  EXPECT_FALSE(performer.uses_sender_time);
  EXPECT_EQ(performer.clock_jumps, 0U);
}

TEST(StreamPipeline, ThinsEvenly) {
  PlainLine line;
  PoseReader reader("");
  reader.set_max_rate(25);
  std::vector<double> times;
  for (int i = 0; i < 300; ++i) {
    line.stand(test::standing_pose(), "Ana", 0.01);
    if (const auto pose = reader.poll(line.pipeline, line.now_s)) times.push_back(pose->time_s);
  }
  for (std::size_t i = times.size() - 40; i + 1 < times.size(); ++i)
    EXPECT_NEAR(times[i + 1] - times[i], 0.04, 1e-6);
  EXPECT_NEAR(reader.rate_hz(line.pipeline), 25, 1e-6);
}

TEST(StreamPipeline, ThinsToTheSameRateWhenItIsReadSeldom) {
  PlainLine line;
  PoseReader reader("");
  reader.set_max_rate(25);
  line.stand(test::standing_pose());
  reader.poll(line.pipeline, line.now_s);
  int poses = 0;
  for (int i = 0; i < 100; ++i) {  // three frames of 10 ms at a time; every fourth is wanted
    line.stand(test::standing_pose(), "Ana", 0.03);
    if (reader.poll(line.pipeline, line.now_s)) ++poses;
  }
  EXPECT_NEAR(poses, 75, 1) << "also when the wanted one is not the last of the three";
}

TEST(StreamPipeline, TwoSendersUnderOneNameBreakTheMotionOnceNotInEveryFrame) {
  PlainLine line;
  PoseReader reader("");
  line.stand(test::standing_pose());
  reader.poll(line.pipeline, line.now_s);
  int breaks = 0;
  for (int i = 0; i < 100; ++i) {
    line.stand(test::moved(test::standing_pose(), 0, Vec3(i % 2 == 0 ? 2 : 0, 0, 0)), "Ana", 0.01);
    if (const auto pose = reader.poll(line.pipeline, line.now_s); pose && pose->discontinuous) ++breaks;
  }
  EXPECT_EQ(breaks, 1);
}

TEST(StreamPipeline, SaysWhenTrackingWasLostAndComesBackDiscontinuously) {
  PlainLine line;
  PoseReader reader("");
  line.stand(test::standing_pose());
  EXPECT_TRUE(reader.poll(line.pipeline, line.now_s));
  line.stand(without(test::standing_pose(), {joints::Root}), "Ana", 0.5);
  EXPECT_FALSE(reader.poll(line.pipeline, line.now_s));
  EXPECT_FALSE(line.performer().tracked);
  EXPECT_THAT(line.advice("tracking-lost"), HasSubstr("the root (hips) is not tracked"));
  line.stand(test::standing_pose(), "Ana", 0.02);
  EXPECT_TRUE(reader.poll(line.pipeline, line.now_s)->discontinuous);
  EXPECT_EQ(line.performer().interruptions, 1U);
  EXPECT_EQ(line.performer().unusable, 50U);
  EXPECT_THAT(line.kinds(), Not(Contains("tracking-lost")));
}

TEST(StreamPipeline, AReaderOfAnyoneFollowsARestartedSenderButNotThePartner) {
  PlainLine line;
  PoseReader reader("");
  line.stand(test::standing_pose(), "10.0.0.1:5000");
  reader.poll(line.pipeline, line.now_s);
  EXPECT_EQ(reader.performer(), "10.0.0.1:5000");
  line.stand(test::standing_pose(), "10.0.0.1:5001", 3);
  const auto pose = reader.poll(line.pipeline, line.now_s);
  EXPECT_EQ(reader.performer(), "10.0.0.1:5001") << "came after the first had fallen silent";
  EXPECT_EQ(line.pipeline.health(line.now_s).followed, "10.0.0.1:5001") << "and is told";
  ASSERT_TRUE(pose);
  EXPECT_TRUE(pose->discontinuous);

  PlainLine two;
  PoseReader other("");
  for (int i = 0; i < 100; ++i) {
    two.stand(test::standing_pose(), "user", 0.01);
    two.stand(test::standing_pose(), "partner", 0.01);
    other.poll(two.pipeline, two.now_s);
  }
  two.stand(test::standing_pose(), "partner", 3);
  EXPECT_FALSE(other.poll(two.pipeline, two.now_s)) << "was there all the time: is somebody else";
  EXPECT_EQ(other.performer(), "user");
}

// A stranger's poses at a tenth of the rate, begun together with the real ones.
TEST(StreamPipeline, OfTwoThatBeginTogetherTheOneWithClearlyMorePosesIsFollowedAndThatIsSaid) {
  for (const bool is_stranger_first : {true, false}) {
    PlainLine line;
    PoseReader reader("");
    int of_stranger = 0, all = 0;
    for (int i = 0; i < 300; ++i) {
      const auto send_stranger = [&] {
        if (i % 10 == 0) line.send({"stranger", {}, {}, test::standing_pose()}, 6000);
      };
      if (is_stranger_first) send_stranger();
      line.stand(test::standing_pose(), "user", 0.01);
      if (!is_stranger_first) send_stranger();
      if (!reader.poll(line.pipeline, line.now_s)) continue;
      ++all;
      of_stranger += reader.performer() == "stranger" ? 1 : 0;
    }
    EXPECT_EQ(reader.performer(), "user");
    EXPECT_LE(of_stranger, 7) << "of half a second";
    EXPECT_GT(all, 240) << "the rate of the user";
    EXPECT_EQ(
        line.advice("sender-changed").find("user is followed now, since it sends more poses than stranger") ==
            0,
        is_stranger_first);
    EXPECT_THAT(line.advice("two-senders"), HasSubstr("choose who plays the user (now user)"));
  }
}

TEST(StreamPipeline, OfSendersThatBeginTogetherItAsksWhoIsTheUserUntilOneIsNamed) {
  const auto undecided = [](const PlainLine& line) { return line.pipeline.health(line.now_s).undecided; };
  PlainLine line;
  PoseReader anyone("");
  line.stand(test::standing_pose(), "10.0.0.1:5000", 0.1);
  anyone.poll(line.pipeline, line.now_s);
  EXPECT_THAT(undecided(line), IsEmpty()) << "of one nothing has to be asked";
  line.stand(test::standing_pose(), "10.0.0.2:6000", 0.1);
  anyone.poll(line.pipeline, line.now_s);
  EXPECT_THAT(undecided(line), ElementsAre("10.0.0.1:5000", "10.0.0.2:6000"));
  EXPECT_THAT(line.advice("which-user"), HasSubstr("10.0.0.1:5000 is followed now"));
  PoseReader chosen("10.0.0.2:6000");
  chosen.poll(line.pipeline, line.now_s);
  EXPECT_THAT(undecided(line), IsEmpty());
  EXPECT_EQ(line.advice("which-user"), "no which-user");

  PlainLine later;
  PoseReader first("");
  later.stand(test::standing_pose(), "10.0.0.1:5000", 2);
  first.poll(later.pipeline, later.now_s);
  later.stand(test::standing_pose(), "10.0.0.2:6000", 0.1);
  first.poll(later.pipeline, later.now_s);
  EXPECT_THAT(undecided(later), IsEmpty()) << "who comes later does not change who the user is";
}

TEST(StreamPipeline, APerformerWhoComesBackAfterOthersTookThePlaceIsFollowedAtOnce) {
  for (const std::string wanted : {"", "Ana"}) {
    PlainLine line;
    PoseReader reader(wanted);
    line.stand(test::standing_pose());
    ASSERT_TRUE(reader.poll(line.pipeline, line.now_s));
    line.now_s += 2.5;
    // As many as there is room for.
    for (int other = 0; other < 16; ++other)
      line.send({"other " + std::to_string(other), {}, {}, without(test::standing_pose(), {joints::Root})});
    ASSERT_FALSE(line.pipeline.find("Ana"));
    EXPECT_FALSE(reader.poll(line.pipeline, line.now_s));
    line.now_s += 2.5;
    line.stand(test::standing_pose(), "Ana", 0.02);
    const auto pose = reader.poll(line.pipeline, line.now_s);
    EXPECT_EQ(reader.performer(), "Ana");
    ASSERT_TRUE(pose) << "the hundred poses from before are not waited for";
    EXPECT_TRUE(pose->discontinuous);
  }
}

TEST(StreamPipeline, CalibrationMeasuresTheBodyAndPutsTheFeetOnTheFloor) {
  PlainLine line;
  const Pose raised = test::moved(t_pose(), 0, Vec3(0, 0.5, 0));
  line.stand(raised);
  EXPECT_THAT(line.advice("floor"), HasSubstr("the feet are at"));
  EXPECT_THAT(line.kinds(), Contains("not-calibrated"));
  line.pipeline.calibrate("", 1, line.now_s);
  EXPECT_THAT(line.kinds(), Not(Contains("not-calibrated")));
  line.stand(raised, "Ana", 1.5);
  ASSERT_TRUE(line.pipeline.find("Ana")->body());
  EXPECT_NEAR(line.pipeline.find("Ana")->body()->bone_lengths[joints::left_elbow - 1], 0.28, 1e-6);
  EXPECT_TRUE(line.performer().calibrated);
  EXPECT_THAT(line.performer().correction, HasSubstr("floor -0.5"));
  PoseReader reader("");
  EXPECT_NEAR(reader.poll(line.pipeline, line.now_s)->pose(joints::left_toe_base, 1), 0.04, 1e-6);
  line.stand(raised, "Ana", 4);
  EXPECT_THAT(line.kinds(), IsEmpty());
}

TEST(StreamPipeline, ACalibrationTakesOnlyWhatArrivedWithinItsTime) {
  PlainLine line;
  line.stand(t_pose());
  line.pipeline.calibrate("Ana", 0.5, line.now_s);
  line.stand(t_pose(), "Ana", 0.4);
  line.now_s += 0.2;
  for (int i = 0; i < 100; ++i)  // arrived later, read in the same turn
    line.send({"Ana", ++line.counter, line.now_s + 1e-4 * i, 1.2 * t_pose()});
  line.pipeline.pass_time(line.now_s, line.output);
  ASSERT_TRUE(line.pipeline.find("Ana")->body());
  EXPECT_NEAR(line.pipeline.find("Ana")->body()->bone_lengths[joints::left_elbow - 1], 0.28, 1e-6);
}

TEST(StreamPipeline, SaysWhatWasWrongWithTheTPose) {
  PlainLine line;
  line.stand(test::standing_pose());
  line.pipeline.calibrate("Ana", 0.5, line.now_s);
  Pose hanging = t_pose();
  for (const int joint : {joints::left_elbow, joints::left_wrist, joints::left_hand})
    hanging.row(joint) =
        hanging.row(joints::left_shoulder) - Eigen::RowVector3d(0, 0.28 * (joint - joints::left_shoulder), 0);
  line.stand(hanging);
  EXPECT_THAT(line.advice("calibration"), HasSubstr("the left arm points 90 degrees down"));
  PlainLine silent;
  silent.stand(t_pose(), "Ana", 0.1);
  silent.pipeline.calibrate("Ana", 0.5, silent.now_s);
  silent.now_s += 1;
  silent.pipeline.pass_time(silent.now_s, silent.output);
  EXPECT_FALSE(silent.performer().calibrated);
}

TEST(StreamPipeline, TurnsTheAxesOfVmcOnly) {
  const auto is_turned = [](const char* uri) {
    return performer_options(*parse_stream_uri(uri), {})->assembly.correction.z_up;
  };
  EXPECT_TRUE(is_turned("vmc://h?up=z"));
  EXPECT_FALSE(is_turned("vmc://h?up=y"));
  EXPECT_FALSE(is_turned("natnet://h?up=z")) << "its decoder does";
}

TEST(StreamPipeline, RefusesOptionsThatDoNotFit) {
  const auto error = [](const std::string& uri) {
    const auto options = performer_options(*parse_stream_uri(uri), {});
    return options ? std::string("none") : options.error().text();
  };
  for (const std::string unit : {"feet", "0", "-1", "inf"})
    EXPECT_THAT(error("vmc://h?unit=" + unit), HasSubstr("m, cm, mm or metres per unit"));
  EXPECT_THAT(error("vmc://h?up=x"), HasSubstr("y or z"));
  EXPECT_THAT(error("vmc://h?floor=low"), HasSubstr("metres or auto"));
  EXPECT_THAT(error("vmc://h?map=nobody"), HasSubstr("cmu, cmu-bvh, mixamo"));
  EXPECT_THAT(error("vmc://h?delay=900"), HasSubstr("0 to 500"));
  EXPECT_THAT(error("vmc://h?framing=t-last"), HasSubstr("for sending"));
  EXPECT_EQ(error("vmc://h?unit=cm&up=z&floor=0.1&map=unity&delay=20&hold=100"), "none");
}

TEST(StreamPipeline, PerformersAndIssuesOfAHostileSenderAreBounded) {
  PlainLine line;
  for (int i = 0; i < 1000; ++i)
    line.send({"p" + std::to_string(i), 1, {}, test::standing_pose()}, static_cast<std::uint16_t>(1000 + i));
  const StreamHealth health = line.pipeline.health(0);
  EXPECT_EQ(health.performers.size(), 16U);
  EXPECT_LE(health.senders.size(), 32U);
  EXPECT_THAT(health.issues, Contains(Field(&IssueCount::kind, "too-many-performers")));
}

}  // namespace
}  // namespace abrazo::stream_pipeline_test
