#include "core/synthesis/frames/trace.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <nlohmann/json.hpp>

#include "core/synthesis/step/partner_synthesizer.hpp"
#include "tests/support/libraries.hpp"

namespace abrazo::trace_test {
namespace {

using nlohmann::json;

Pose pose_of(const json& rows) {
  Pose pose;
  for (int r = 0; r < joint_count; ++r)
    for (int c = 0; c < 3; ++c)
      pose(r, c) = rows.at(static_cast<std::size_t>(r)).at(static_cast<std::size_t>(c)).get<double>();
  return pose;
}

TEST(Trace, TheHeaderSaysWhatItWasMadeFrom) {
  const json header = json::parse(trace_header_line({"lib.h5", "user.bvh", 15, *preset("paper")}));
  EXPECT_EQ(header["abrazo_trace"], 1);
  EXPECT_EQ(header["library"], "lib.h5");
  EXPECT_EQ(header["settings"]["alpha"], 0.5);
  EXPECT_EQ(header["joints"].size(), 25U);
  EXPECT_EQ(header["joints"][20], "lhand");
  EXPECT_EQ(header["units"], "m");
}

TEST(Trace, AFrameHasEveryFieldAndItsNumbersReadBackExactly) {
  const auto library = test::small_library();
  auto synthesizer = std::move(*PartnerSynthesizer::create(library, *preset("paper")));
  const Clip user = test::swinging_take("user", 30, 3).a;
  synthesizer->step(user.poses[0], Duration(0));
  const FrameResult& result = synthesizer->step(user.poses[4], Duration(4.0 / 60));
  const json frame = json::parse(trace_frame_line(result, *library, 4, 4.0 / 60));
  EXPECT_EQ(frame["frame"], 4);
  EXPECT_EQ(pose_of(frame["query"]["world"]), result.query_world);
  EXPECT_EQ(pose_of(frame["query"]["normalized"]), result.query_normalized);
  EXPECT_EQ(frame["query"]["features"].size(), 15U);
  EXPECT_EQ(pose_of(frame["active"]), result.active());
  EXPECT_EQ(pose_of(frame["passive"]), result.passive());
  EXPECT_EQ(pose_of(frame["selected_pair"]["passive"]), result.selected_pair.bottomRows<joint_count>());
  EXPECT_EQ(frame["mesh"]["edges"].size(), result.edges.size());
  EXPECT_EQ(frame["mesh"]["tetrahedra"].size(), result.tetrahedra.size());
  for (const char* key : {"deformation", "velocity", "constraint"})
    EXPECT_TRUE(frame["energy"][key].is_number());
  for (const char* key :
       {"bone_length_max", "foot_lock_max_m", "penetration_max_m", "excess_penetration_max_m", "morph_rms_m"})
    EXPECT_TRUE(frame["residual"][key].is_number());
  for (const char* key : {"retarget", "select", "mesh", "solve", "total"})
    EXPECT_TRUE(frame["timing_us"][key].is_number());
  EXPECT_EQ(frame["status"], "ok");
  EXPECT_TRUE(frame["foot_locks"].is_array());
  EXPECT_TRUE(frame["collisions"].is_array());
}

TEST(Trace, CostsAddUpAndTheSelectedOneIsCheapest) {
  const auto library = test::small_library();
  const Settings settings = *preset("responsive");
  auto synthesizer = std::move(*PartnerSynthesizer::create(library, settings));
  const Clip user = test::swinging_take("user", 30, 3).a;
  synthesizer->step(user.poses[0], Duration(0));
  const json frame = json::parse(
      trace_frame_line(synthesizer->step(user.poses[1], Duration(1.0 / 60)), *library, 1, 1.0 / 60));
  const auto selected = frame["selected"].get<std::size_t>();
  double distance = 0;
  for (const json& candidate : frame["candidates"]) {
    const json& cost = candidate["cost"];
    EXPECT_NEAR(cost["total"].get<double>(),
                cost["pose"].get<double>() + settings.alpha * (cost["temporal_active"].get<double>() +
                                                               cost["temporal_passive"].get<double>()),
                1e-12);
    EXPECT_GE(cost["total"], frame["candidates"][selected]["cost"]["total"]);
    EXPECT_GE(candidate["feature_distance"], distance);
    distance = candidate["feature_distance"].get<double>();
  }
}

/// Eq. 3-7 from what a trace says, joint by joint, and the library's normalised poses.
TEST(Trace, EveryCostIsEquation7RecomputedFromTheTrace) {
  const auto library = test::small_library();
  const Settings settings = *preset("responsive");
  auto synthesizer = std::move(*PartnerSynthesizer::create(library, settings));
  const Clip user = test::swinging_take("user", 40, 3).a;
  std::vector<json> frames;
  for (int frame = 0; frame < 40; ++frame)
    frames.push_back(json::parse(trace_frame_line(
        synthesizer->step(user.poses[static_cast<std::size_t>(frame)], Duration(frame == 0 ? 0 : 1.0 / 60)),
        *library, frame, frame / 60.0)));
  for (std::size_t i = 2; i < frames.size(); ++i) {
    const auto predicted = [&](const char* body) -> Pose {
      const Pose before = pose_of(frames[i - 1][body]);
      return before + (before - pose_of(frames[i - 2][body]));
    };
    const Pose world = pose_of(frames[i]["query"]["world"]);
    const Pose normalized = pose_of(frames[i]["query"]["normalized"]);
    const double heading = root_frame(world).heading_rad;
    for (const json& candidate : frames[i]["candidates"]) {
      const int pair = library->find_pair(candidate["take"].get<std::string>(), candidate["frame"].get<int>(),
                                          candidate["swapped"].get<bool>());
      double cost = 0;
      for (int l = 0; l < joint_count; ++l) {
        const Eigen::Matrix3d turn = Eigen::AngleAxisd(heading, Vec3::UnitY()).toRotationMatrix();
        const Vec3 place(world(0, 0), library->root(pair).position.y(), world(0, 2));
        const Vec3 active = library->pose(pair).row(l);
        const Vec3 passive = library->pose(pair).row(l + joint_count);
        cost += (Vec3(normalized.row(l)) - active).squaredNorm();
        cost += settings.alpha * (Vec3(predicted("active").row(l)) - (turn * active + place)).squaredNorm();
        cost += settings.alpha * (Vec3(predicted("passive").row(l)) - (turn * passive + place)).squaredNorm();
      }
      EXPECT_NEAR(candidate["cost"]["total"].get<double>(), cost, 1e-9);
    }
  }
}

TEST(Trace, AStatusSaysInWordsWhatWasLetGo) {
  FrameResult result;
  result.status = StepStatus::Relaxed;
  result.message = "all foot locks were let go";
  EXPECT_EQ(result.status_text(), "relaxed: all foot locks were let go");
  EXPECT_EQ(FrameResult().status_text(), "failed: not solved yet");
}

}  // namespace
}  // namespace abrazo::trace_test
