#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <tuple>

#include "core/motion/body/body.hpp"
#include "core/motion/files/import_clip.hpp"
#include "core/motion/joints/marker_model.hpp"
#include "tests/core/motion/marker_body.hpp"
#include "tests/core/motion/motion_fixtures.hpp"
#include "tests/support/captured_data.hpp"

namespace abrazo::marker_sets_test {
namespace {

using test::has_warning;
using test::the_warning;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using ::testing::StartsWith;

/// What a laboratory calls the markers of `marked_body`, and which of its joints the set finds worse.
struct NamedSet {
  const char* model;
  std::vector<std::pair<const char*, const char*>> names;  ///< Plug-in Gait's, the set's; % is the side
  std::string inferred;                                    ///< in the warning
};

const std::vector<NamedSet>& sets() {
  static const std::vector<NamedSet> all = {
      {"plug-in-gait",
       {{"%ASI", "Anna:%asis"},
        {"%PSI", "Anna:%psis"},
        {"C7", "Anna:c7"},
        {"CLAV", "Anna:clav"},
        {"%SHO", "Anna:%sho"},
        {"%ELB", "Anna:%elb"},
        {"%WRA", "Anna:%wrth"},
        {"%WRB", "Anna:%wrpi"},
        {"%KNE", "Anna:%kne"},
        {"%ANK", "Anna:%ank"},
        {"%TOE", "Anna:%toe"},
        {"%HEE", "Anna:%heel"},
        {"%FIN", "Anna:%fin"},
        {"%FHD", "Anna:%fhd"},
        {"%BHD", "Anna:%bhd"},
        {"%THI", "Anna:%thi"},
        {"%TIB", "Anna:%tib"},
        {"%UPA", "Anna:%upa"}},
       ""},
      {"cmu-markers",
       {{"%ASI", "%FWT"},
        {"%PSI", "%BWT"},
        {"C7", "C7"},
        {"CLAV", "CLAV"},
        {"%SHO", "%SHO"},
        {"%ELB", "%ELB"},
        {"%WRA", "%WRA"},
        {"%WRB", "%WRB"},
        {"%KNE", "%KNE"},
        {"%ANK", "%ANK"},
        {"%TOE", "%TOE"},
        {"%HEE", "%HEE"},
        {"%FIN", "%FIN"},
        {"%FHD", "%FHD"},
        {"%BHD", "%BHD"},
        {"%THI", "%THI"},
        {"%TIB", "%SHN"},
        {"%UPA", "%UPA"}},
       ""},
      {"ior-cast",
       {{"%ASI", "%_IAS"},
        {"%PSI", "%_IPS"},
        {"C7", "CV7"},
        {"CLAV", "SNJ_"},
        {"STRN", "SXS"},
        {"T10", "TV8"},
        {"%SHO", "%_SAJ"},
        {"%ELB", "%_HLE"},
        {"%WRA", "%_RSP"},
        {"%WRB", "%_UHE"},
        {"%KNE", "%_FLE"},
        {"%ANK", "%_FAL"},
        {"%TOE", "%_FM2"},
        {"%HEE", "%_FCC"},
        {"%FHD", "%_HDF"},
        {"%BHD", "%_HDB"}},
       "2 of the 25 joints have no marker and were inferred from those beside them: lhand, rhand"},
      {"rajagopal",
       {{"%ASI", "%.ASIS"},
        {"%PSI", "%.PSIS"},
        {"%SHO", "%.Shoulder"},
        {"%ELB", "%.Elbow"},
        {"%WRA", "%.Wrist"},
        {"%KNE", "%.Knee"},
        {"%ANK", "%.Ankle"},
        {"%TOE", "%.MT5"},
        {"%HEE", "%.Heel"},
        {"%THI", "%.TH1"}},
       "5 of the 25 joints have no marker and were inferred from those beside them: lowerneck, upperneck, "
       "head, lhand, "
       "rhand"},
      {"helen-hayes",
       {{"%ASI", "% asis"},
        {"LPSI", "sacrum"},
        {"C7", "c7"},
        {"%SHO", "% should"},
        {"%ELB", "% elbow"},
        {"%WRA", "% wrist"},
        {"%KNE", "% knee 1"},
        {"%ANK", "% mall"},
        {"%TOE", "% met"},
        {"%HEE", "% heel"},
        {"%THI", "% bar 1"},
        {"%TIB", "% bar 2"}},
       "5 of the 25 joints have no marker and were inferred from those beside them: lowerneck, upperneck, "
       "head, lhand, "
       "rhand"},
      {"optitrack-baseline",
       {{"%ASI", "Waist%Front"},
        {"%PSI", "Waist%Back"},
        {"C7", "BackTop"},
        {"CLAV", "Chest"},
        {"%SHO", "%ShoulderTop"},
        {"%ELB", "%ElbowOut"},
        {"%WRA", "%WristIn"},
        {"%WRB", "%WristOut"},
        {"%KNE", "%KneeOut"},
        {"%ANK", "%AnkleOut"},
        {"%TOE", "%ToeOut"},
        {"%HEE", "%Heel"},
        {"%FIN", "%HandOut"},
        {"%THI", "%Thigh"},
        {"%TIB", "%Shin"},
        {"%UPA", "%UArmHigh"},
        {"LFHD", "HeadTop"}},
       ""},
      {"xsens-points",
       {{"%ASI", "p@ASI"},
        {"%PSI", "p@PSI"},
        {"C7", "pC7SpinalProcess"},
        {"CLAV", "pIJ"},
        {"%SHO", "p@Acromion"},
        {"%ELB", "p@ArmLatEpicondyle"},
        {"%WRA", "p@RadialStyloid"},
        {"%WRB", "p@UlnarStyloid"},
        {"%KNE", "p@KneeLatEpicondyle"},
        {"%ANK", "p@LatMalleolus"},
        {"%TOE", "p@FirstMetatarsal"},
        {"%HEE", "p@HeelFoot"},
        {"%FHD", "p@Auricularis"}},
       "2 of the 25 joints have no marker and were inferred from those beside them: lhand, rhand"}};
  return all;
}

std::string with_side(std::string name, char side) {
  if (const auto mark = name.find('%'); mark != std::string::npos) name[mark] = side;
  if (const auto mark = name.find('@'); mark != std::string::npos)
    name.replace(mark, 1, side == 'L' ? "Left" : "Right");
  return name;
}

/// The markers of the body that the set has, under its names.
NamedMotion renamed(const NamedMotion& body, const NamedSet& set) {
  NamedMotion motion = body;
  motion.points.clear(), motion.parents.clear(), motion.frames.clear();
  std::vector<Eigen::Index> rows;
  for (const auto& [from, to] : set.names)
    for (const char side : {'L', 'R'}) {
      const std::string name = with_side(from, side);
      const auto found = std::find(body.points.begin(), body.points.end(), name);
      if (found == body.points.end() || with_side(to, side) == "SNJ_") continue;
      if (!motion.points.empty() && motion.points.back() == with_side(to, side)) continue;
      motion.points.push_back(with_side(to, side)), motion.parents.push_back(-1);
      rows.push_back(found - body.points.begin());
    }
  for (const Positions& frame : body.frames) {
    Positions& chosen = motion.frames.emplace_back(static_cast<Eigen::Index>(rows.size()), 3);
    for (std::size_t r = 0; r < rows.size(); ++r)
      chosen.row(static_cast<Eigen::Index>(r)) = frame.row(rows[r]);
  }
  return motion;
}

NamedMotion without(const NamedMotion& motion, const std::vector<std::string>& words) {
  NamedMotion less = motion;
  for (std::string& point : less.points)
    for (const std::string& word : words) {
      if (point.find(word) != std::string::npos)
        point = "extra" + std::to_string(&point - less.points.data());
    }
  return less;
}

TEST(MarkerSets, OfLaboratoriesAreFoundByTheirNames) {
  const test::MarkedBody body = test::marked_body(30, 0.3);
  for (const NamedSet& set : sets()) {
    SCOPED_TRACE(set.model);
    const auto clip = import_clip(renamed(body.markers, set), {});
    ASSERT_TRUE(clip) << clip.error().text();
    EXPECT_EQ(clip->report.joint_map, set.model);
    // What every set marks; a sacrum in place of two at the back is off to its side here.
    const bool whole_pelvis = std::string(set.model) != "helen-hayes";
    for (const int joint : {joints::left_knee, joints::right_knee, joints::left_ankle, joints::right_elbow})
      EXPECT_LT((clip->clip.poses[9].row(joint) - body.poses[9].row(joint)).norm(),
                whole_pelvis ? 0.015 : 0.03)
          << joint_names[static_cast<std::size_t>(joint)];
    EXPECT_LT((clip->clip.poses[9].row(joints::Head) - body.poses[9].row(joints::Head)).norm(), 0.13);
    EXPECT_EQ(has_warning(clip->report.warnings, "inferred-joints"), !set.inferred.empty());
    if (!set.inferred.empty()) {
      EXPECT_EQ(the_warning(clip->report.warnings, "inferred-joints").detail, set.inferred);
      EXPECT_EQ(clip->report.inferred_joints.size(), static_cast<std::size_t>(set.inferred[0] - '0'));
    } else {
      EXPECT_THAT(clip->report.inferred_joints, IsEmpty());
    }
    EXPECT_FALSE(has_warning(clip->report.warnings, "not-a-person"));
  }
}

TEST(MarkerSets, WithoutArmsAreSaidToBeOfTheLowerBody) {
  const test::MarkedBody body = test::marked_body(10, 0.3);
  const NamedMotion gait = renamed(body.markers, sets()[4]);
  const auto clip = import_clip(without(gait, {"elbow", "wrist"}), {});
  ASSERT_FALSE(clip);
  EXPECT_THAT(clip.error().message, HasSubstr("arms are not marked, and cannot be inferred"));
  EXPECT_THAT(clip.error().message, Not(HasSubstr("lower body"))) << "shoulders and head are marked";
  const auto legs = import_clip(without(gait, {"elbow", "wrist", "should"}), {});
  ASSERT_FALSE(legs);
  EXPECT_THAT(legs.error().message, HasSubstr("the markers are of the lower body; arms are not marked"));
  EXPECT_THAT(clip.error().message, HasSubstr("'helen-hayes'"));
  EXPECT_THAT(clip.error().message, HasSubstr("L elbow, L wrist, R elbow, R wrist"));
  EXPECT_THAT(clip.error().message, HasSubstr("A partner answers the head, the hands and the feet"));
}

TEST(MarkerSets, APersonWhoNamesMarkersIsToldWhatTheFileCannotBeUsedWithout) {
  const test::MarkedBody body = test::marked_body(10, 0.3);
  const auto said_without = [&](const std::vector<std::string>& words) {
    return why_not_enough(nearest_marker_model(without(body.markers, words).points));
  };
  EXPECT_EQ(said_without({}), "");
  EXPECT_THAT(
      said_without({"SHO", "ELB", "WRA", "WRB"}),
      StartsWith("No marker tells where the shoulders, elbows, wrists and hands are. The file cannot be "
                 "used without "));
  EXPECT_THAT(said_without({"SHO", "ELB", "WRA", "WRB"}),
              HasSubstr("or export the recording with markers there"));
  EXPECT_THAT(said_without({"LPSI"}), StartsWith("The file cannot be used without "))
      << "every joint can be found";
}

TEST(MarkerSets, WithoutLegsOrWithUnknownNamesAreRefusedWithTheNearestSet) {
  const test::MarkedBody body = test::marked_body(10, 0.3);
  const auto arms = import_clip(without(body.markers, {"KNE", "ANK", "TOE", "THI", "TIB", "HEE"}), {});
  ASSERT_FALSE(arms);
  EXPECT_THAT(arms.error().message, HasSubstr("of the upper body; legs are not marked"));
  EXPECT_THAT(arms.error().message, HasSubstr("LKNE"));
  const auto one = import_clip(without(body.markers, {"LKNE"}), {});
  ASSERT_FALSE(one);
  EXPECT_THAT(one.error().message, HasSubstr("'plug-in-gait'"));
  EXPECT_THAT(one.error().message, HasSubstr("also has LKNE."));
  NamedMotion numbered = body.markers;
  for (std::size_t p = 0; p < numbered.points.size(); ++p) numbered.points[p] = "M" + std::to_string(p);
  const auto unknown = import_clip(numbered, {});
  ASSERT_FALSE(unknown);
  EXPECT_THAT(unknown.error().message, HasSubstr("have unknown names"));
  EXPECT_THAT(unknown.error().message, Not(HasSubstr("--")));
}

TEST(MarkerModelFiles, AreReadBackAsTheyWereWritten) {
  const auto model = parse_marker_model(
      R"({"name": "ours", "markers": {"neck": "N", "left shoulder": ["A", "B"], "sacrum": "S"}})",
      "ours.json");
  ASSERT_TRUE(model) << model.error().text();
  EXPECT_EQ(model->name, "ours");
  EXPECT_THAT(model->names[static_cast<std::size_t>(MarkerPlace::Shoulder)][0], ElementsAre("A", "B"));
  EXPECT_THAT(model->names[static_cast<std::size_t>(MarkerPlace::Shoulder)][1], IsEmpty());
  const auto again = parse_marker_model(marker_model_json(*model), "again.json");
  ASSERT_TRUE(again);
  EXPECT_EQ(again->names, model->names);
}

TEST(MarkerModelFiles, SayWhatIsWrong) {
  const auto said = [](const char* text) {
    const auto model = parse_marker_model(text, "ours.json");
    return model ? std::string("read") : model.error().text();
  };
  EXPECT_THAT(said("[1, 2]"), HasSubstr(R"(expected {"name": "...", "markers")"));
  EXPECT_THAT(said(R"({"markers": {"left ear lobe": "E"}})"),
              HasSubstr("no place 'left ear lobe' for a marker"));
  EXPECT_THAT(said(R"({"markers": {"left ear lobe": "E"}})"), HasSubstr("left shoulder"));
  EXPECT_THAT(said(R"({"markers": {"neck": []}})"), HasSubstr("markers.neck: expected the name of a marker"));
  EXPECT_THAT(said(R"({"markers": {"neck": 7}})"), HasSubstr("expected the name of a marker"));
}

TEST(JointCentres, AreFoundByTheNamesOfXsensVisual3DAndKeyPoints) {
  using namespace joints;
  const Pose pose = test::standing_pose();
  const auto of = [&](const std::vector<std::pair<std::string, int>>& points) {
    NamedMotion motion;
    motion.name = "anna", motion.fps = 60, motion.metres_per_unit = 1.0;
    Positions frame(static_cast<Eigen::Index>(points.size()), 3);
    for (const auto& [name, joint] : points) {
      frame.row(static_cast<Eigen::Index>(motion.points.size())) = pose.row(joint);
      motion.points.push_back(name), motion.parents.push_back(-1);
    }
    motion.frames.assign(5, frame);
    return import_clip(motion, {});
  };
  const std::vector<std::pair<std::string, int>> visual3d = {
      {"LHJC", left_hip},      {"LKJC", left_knee},   {"LAJC", left_ankle},     {"LMTP", left_toe_base},
      {"LSJC", left_shoulder}, {"LEJC", left_elbow},  {"LWJC", left_wrist},     {"RHJC", right_hip},
      {"RKJC", right_knee},    {"RAJC", right_ankle}, {"RMTP", right_toe_base}, {"RSJC", right_shoulder},
      {"REJC", right_elbow},   {"RWJC", right_wrist}};
  const std::vector<std::pair<std::string, int>> xsens = {{"jLeftHip", left_hip},
                                                          {"jLeftKnee", left_knee},
                                                          {"jLeftAnkle", left_ankle},
                                                          {"jLeftBallFoot", left_toe_base},
                                                          {"jLeftShoulder", left_shoulder},
                                                          {"jLeftElbow", left_elbow},
                                                          {"jLeftWrist", left_wrist},
                                                          {"jRightHip", right_hip},
                                                          {"jRightKnee", right_knee},
                                                          {"jRightAnkle", right_ankle},
                                                          {"jRightBallFoot", right_toe_base},
                                                          {"jRightShoulder", right_shoulder},
                                                          {"jRightElbow", right_elbow},
                                                          {"jRightWrist", right_wrist},
                                                          {"jL4L3", LowerBack},
                                                          {"jL1T12", UpperBack},
                                                          {"jT9T8", Thorax},
                                                          {"jT1C7", LowerNeck},
                                                          {"jC1Head", UpperNeck}};
  const std::vector<std::pair<std::string, int>> key_points = {{"Hip", Root},
                                                               {"LHip", left_hip},
                                                               {"LKnee", left_knee},
                                                               {"LAnkle", left_ankle},
                                                               {"LBigToe", left_toe_tip},
                                                               {"LShoulder", left_shoulder},
                                                               {"LElbow", left_elbow},
                                                               {"LWrist", left_wrist},
                                                               {"RHip", right_hip},
                                                               {"RKnee", right_knee},
                                                               {"RAnkle", right_ankle},
                                                               {"RBigToe", right_toe_tip},
                                                               {"RShoulder", right_shoulder},
                                                               {"RElbow", right_elbow},
                                                               {"RWrist", right_wrist},
                                                               {"Neck", LowerNeck},
                                                               {"Head", Head}};
  for (const auto& points : {visual3d, xsens, key_points}) {
    SCOPED_TRACE(points.front().first);
    const auto clip = of(points);
    ASSERT_TRUE(clip) << clip.error().text();
    EXPECT_EQ(clip->report.joint_map, "joint-centres");
    EXPECT_FALSE(has_warning(clip->report.warnings, "not-a-person"));
    for (const int joint : {left_hip, right_knee, left_ankle, right_elbow, left_wrist, right_shoulder})
      EXPECT_LT((clip->clip.poses[2].row(joint) - pose.row(joint)).norm(), 1e-9);
    EXPECT_LT((clip->clip.poses[2].row(Head) - pose.row(Head)).norm(), 0.15);
  }
}

/// Real exports, which are not part of the project: where the folder of captured data has them.
class ForeignMarkers : public testing::Test {
 protected:
  static std::string file(const std::string& name) {
    const auto folder = test::captured_data();
    const auto path = folder ? *folder / "foreign" / name : std::filesystem::path();
    return folder && std::filesystem::exists(path) ? path.string() : std::string();
  }
  static void expect_a_person(const Clip& clip, double least_m, double most_m) {
    const Body body = body_of(clip.poses);
    EXPECT_GT(body.height(), least_m);
    EXPECT_LT(body.height(), most_m);
    const auto length = [&](int from, int to) {
      double sum = 0;
      for (const Pose& pose : clip.poses) sum += (pose.row(from) - pose.row(to)).norm();
      return sum / static_cast<double>(clip.poses.size());
    };
    using namespace joints;
    for (const auto& [from, to, least, most] :
         {std::tuple(left_hip, left_knee, 0.33, 0.52), std::tuple(left_knee, left_ankle, 0.32, 0.50),
          std::tuple(left_shoulder, left_elbow, 0.22, 0.37), std::tuple(left_elbow, left_wrist, 0.19, 0.32),
          std::tuple(left_hip, right_hip, 0.12, 0.24),
          std::tuple(left_shoulder, right_shoulder, 0.26, 0.45)}) {
      EXPECT_GT(length(from, to), least) << joint_names[static_cast<std::size_t>(to)];
      EXPECT_LT(length(from, to), most) << joint_names[static_cast<std::size_t>(to)];
      EXPECT_NEAR(length(from, to), length(mirrored_joint(from), mirrored_joint(to)), 0.03);
    }
  }
};

TEST_F(ForeignMarkers, OfQualisysAreAPerson) {
  if (file("qualisys.c3d").empty()) GTEST_SKIP() << "no captured data";
  const auto clips = load_motion(file("qualisys.c3d"), "", {});
  ASSERT_TRUE(clips) << clips.error().text();
  EXPECT_EQ(clips->front().report.joint_map, "ior-cast");
  EXPECT_EQ(clips->front().clip.fps, 200);
  EXPECT_EQ(clips->front().clip.poses.size(), 340U);
  expect_a_person(clips->front().clip, 1.35, 1.80);
}

TEST_F(ForeignMarkers, OfOpenSimAreAPerson) {
  if (file("opensim_walk.trc").empty()) GTEST_SKIP() << "no captured data";
  const auto clips = load_motion(file("opensim_walk.trc"), "", {});
  ASSERT_TRUE(clips) << clips.error().text();
  EXPECT_EQ(clips->front().report.joint_map, "rajagopal");
  EXPECT_EQ(clips->front().clip.poses.size(), 238U);
  expect_a_person(clips->front().clip, 1.35, 1.80);
}

TEST_F(ForeignMarkers, WithoutArmsOrLegsAreRefusedWithTheReason) {
  if (file("bts.c3d").empty() || file("comma.trc").empty()) GTEST_SKIP() << "no captured data";
  const auto gait = load_motion(file("bts.c3d"), "", {});
  ASSERT_FALSE(gait);
  EXPECT_THAT(gait.error().message, HasSubstr("arms are not marked"));
  EXPECT_THAT(gait.error().message, HasSubstr("'helen-hayes'"));
  const auto shoulder = load_motion(file("comma.trc"), "", {});
  ASSERT_FALSE(shoulder);
  EXPECT_THAT(shoulder.error().message, HasSubstr("of a part of a body, or have unknown names"));
}

}  // namespace
}  // namespace abrazo::marker_sets_test
