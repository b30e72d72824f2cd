// Contacts, morph steps, the way of the camera, the rows of the tree and what is remembered of the scene.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "core/mesh/capsules.hpp"
#include "core/mesh/laplacian.hpp"
#include "core/motion/body/joint_set.hpp"
#include "tests/widgets/synthetic_frames.hpp"
#include "widgets/scene/values/camera_move.hpp"
#include "widgets/scene/values/contact_shapes.hpp"
#include "widgets/scene/values/morph_step.hpp"
#include "widgets/scene/values/scene_memory.hpp"
#include "widgets/scene/values/scene_tree_rows.hpp"

namespace abrazo::widgets::scene_shapes_test {
namespace {

using test::synthetic_frame;

TEST(ContactLines, JoinTheNearestPointsOfTheTwoAxes) {
  FrameResult frame;
  frame.result.row(1) << 0, 1, 0;  // bone 1-2 of the leader stands, bone 26-27 of the follower lies beside it
  frame.result.row(2) << 0, 2, 0;
  frame.result.row(26) << 0.1, 1.5, -1;
  frame.result.row(27) << 0.1, 1.5, 1;
  frame.collisions = {{{1, 2}, {26, 27}, 0.012, 0.003}};
  const auto lines = contact_lines(frame);
  ASSERT_EQ(lines.size(), 1U);
  EXPECT_LT((lines[0].on_leader - Vec3(0, 1.5, 0)).norm(), 1e-12);
  EXPECT_LT((lines[0].on_follower - Vec3(0.1, 1.5, 0)).norm(), 1e-12);
  EXPECT_TRUE(lines[0].is_excess()) << "9 mm deeper than recorded";
  const auto bones = colliding_bones(frame);
  EXPECT_THAT(bones[0], ::testing::ElementsAre(1)) << "bone 1 ends at joint 2";
  EXPECT_THAT(bones[1], ::testing::ElementsAre(1));
}

TEST(HeldHands, AreThoseThatAreNearInTheSelectedPair) {
  FrameResult frame;
  frame.selected_pair.setRandom();
  frame.selected_pair *= 100;
  EXPECT_TRUE(held_hands(frame).empty());
  frame.selected_pair.row(joint_count + joints::right_hand) =
      frame.selected_pair.row(joints::left_hand) + Eigen::RowVector3d(0.9 * hold_distance_m, 0, 0);
  EXPECT_THAT(held_hands(frame), ::testing::ElementsAre(std::array<int, 2>{
                                     joints::left_hand, joint_count + joints::right_hand}));
}

TEST(FloorContacts, AreToesThatAreLow) {
  PairPose pair = PairPose::Constant(1);
  pair(joints::left_toe_tip, 1) = floor_contact_m / 2;
  pair(joint_count + joints::right_toe_base, 1) = floor_contact_m / 2;
  pair(joints::left_hand, 1) = 0;
  EXPECT_THAT(floor_contacts(pair),
              ::testing::ElementsAre(joints::left_toe_tip, joint_count + joints::right_toe_base));
}

TEST(CapsuleOutline, KeepsToTheRadiusFromTheAxisInThePlaneOfThePicture) {
  const Vec3 a(0, 0, 0), b(0.4, 0.3, 0.2), direction = Vec3(0.2, -0.1, -1).normalized();
  for (const Vec3& point : capsule_outline(a, b, 0.07, direction)) {
    const double to_a = (point - a).dot(direction), to_b = (point - b).dot(direction);
    EXPECT_TRUE(std::abs(to_a) < 1e-12 || std::abs(to_b) < 1e-12) << "as far as one of its ends";
    const Vec3& end = std::abs(to_a) < 1e-12 ? a : b;
    EXPECT_NEAR((point - end).norm(), 0.07, 1e-12);
  }
}

TEST(CapsuleOutline, SurroundsBothEnds) {
  const auto outline = capsule_outline(Vec3(0, 0, 0), Vec3(1, 0, 0), 0.1, -Vec3::UnitZ());
  double left = 0, right = 0, up = 0, down = 0;
  for (const Vec3& point : outline) {
    left = std::min(left, point.x()), right = std::max(right, point.x());
    down = std::min(down, point.y()), up = std::max(up, point.y());
  }
  EXPECT_NEAR(left, -0.1, 1e-12);
  EXPECT_NEAR(right, 1.1, 1e-12);
  EXPECT_NEAR(up, 0.1, 1e-12);
  EXPECT_NEAR(down, -0.1, 1e-12);
}

TEST(DepthText, SaysWhatTheRecordedPairHas) {
  EXPECT_EQ(depth_text(0.012, 0), "12 mm");
  EXPECT_EQ(depth_text(0.012, 0.009), "12 mm (recorded 9)");
}

TEST(MorphStep, ShowsThePoseOfTheStepWithItsOwnResiduals) {
  auto frame = std::make_shared<FrameSnapshot>(*synthetic_frame(3, 0.05));
  frame->settings.morph_steps = 1;
  frame->settings.projection_steps = 1;
  ASSERT_EQ(step_count(*frame), 2);
  const FrameSnapshotPtr before = at_step(frame, 0), first = at_step(frame, 1);
  EXPECT_EQ(before->result.result, frame->result.selected_pair);
  for (const double residual : before->result.edge_residuals_m) EXPECT_NEAR(residual, 0, 1e-12);
  EXPECT_EQ(first->result.result, frame->result.morph_steps[0]);
  EXPECT_TRUE(first->result.collisions.empty()) << "measured at the result only";
  EXPECT_EQ(at_step(frame, 2), frame);
  EXPECT_EQ(at_step(frame, 9), frame);
}

TEST(MorphStep, MeasuresResidualsAsTheFrameDoes) {
  auto frame = std::make_shared<FrameSnapshot>(*synthetic_frame(3, 0.05));
  frame->result.morph_steps = {frame->result.result, frame->result.result};
  Laplacian laplacian;
  laplacian.build(frame->result.edges, frame->result.selected_pair, frame->settings.edge_weights);
  const PairPose bent = laplacian.apply(frame->result.selected_pair) - laplacian.apply(frame->result.result);
  const FrameSnapshotPtr shown = at_step(frame, 1);
  const MeshEdge& edge = frame->result.edges[40];
  EXPECT_NEAR(shown->result.edge_residuals_m[40], 0.5 * (bent.row(edge[0]).norm() + bent.row(edge[1]).norm()),
              1e-12);
}

TEST(MorphStep, IsNamedByMorphsThenProjections) {
  auto frame = std::make_shared<FrameSnapshot>(*synthetic_frame(0, 0));
  frame->settings.morph_steps = 5;
  frame->settings.projection_steps = 2;
  frame->result.morph_steps.assign(7, frame->result.result);
  EXPECT_EQ(step_text(*frame, 0), "0 / 5 + 2");
  EXPECT_EQ(step_text(*frame, 3), "3 / 5 + 2");
  EXPECT_EQ(step_text(*frame, 6), "5 + 1 / 5 + 2");
  EXPECT_EQ(step_text(*frame, 7), "5 + 2 / 5 + 2");
  frame->result.morph_steps.push_back(frame->result.result);
  EXPECT_EQ(step_text(*frame, 8), "5 + 3 / 5 + 3");
}

TEST(CameraMove, ArrivesExactlyAndGoesTheShorterWayAround) {
  CameraMove move;
  move.from.azimuth_rad = 3;
  move.to.azimuth_rad = -3;
  move.to.target = Vec3(1, 2, 3);
  move.to.distance_m = 2.5;
  OrbitCamera camera = move.from;
  camera.is_parallel = true;
  move.apply(camera, CameraMove::duration_s / 2);
  EXPECT_GT(std::abs(camera.azimuth_rad), 3) << "through half a turn, not through the front";
  move.apply(camera, CameraMove::duration_s);
  EXPECT_EQ(camera.azimuth_rad, -3);
  EXPECT_EQ(camera.target, move.to.target);
  EXPECT_EQ(camera.distance_m, 2.5);
  EXPECT_TRUE(camera.is_parallel) << "what is not a view stays";
}

OrbitCamera seen_from(double azimuth_rad) {
  OrbitCamera camera;
  camera.azimuth_rad = azimuth_rad;
  return camera;
}

TEST(CameraHistory, GoesBackAndForthBetweenTheViewsThatWereLeft) {
  CameraHistory views;
  EXPECT_FALSE(views.back(seen_from(0)));
  views.leave(seen_from(0));
  views.leave(seen_from(1));
  EXPECT_EQ(views.back(seen_from(2))->azimuth_rad, 1);
  EXPECT_EQ(views.back(seen_from(1))->azimuth_rad, 0);
  EXPECT_FALSE(views.back(seen_from(0)));
  EXPECT_EQ(views.forth(seen_from(0))->azimuth_rad, 1);
  EXPECT_EQ(views.forth(seen_from(1))->azimuth_rad, 2);
  views.leave(seen_from(2));
  EXPECT_FALSE(views.forth(seen_from(5))) << "a new way was taken";
}

TEST(OrbitCamera, ShiftsThePictureWithoutTurningIt) {
  OrbitCamera camera = seen_from(0);
  const Vec3 before = camera.position();
  camera.shift_m = 0.7;
  EXPECT_LT((camera.position() - before - Vec3(0.7, 0, 0)).norm(), 1e-12);
  EXPECT_LT((camera.focus() - camera.target - Vec3(0.7, 0, 0)).norm(), 1e-12);
}

TEST(TreeRows, AreCalmUntilACharacterIsOpened) {
  EXPECT_EQ(tree_rows({}, "").size(), part_rows().size());
  const auto open = tree_rows({false, true}, "");
  ASSERT_EQ(open.size(), part_rows().size() + joint_count);
  EXPECT_EQ(open[3].name, "Follower");
  EXPECT_EQ(open[4].name, "root");
  EXPECT_EQ(open[4].vertex, joint_count);
  EXPECT_EQ(open[4].depth, 2);
}

std::vector<std::string> names(const std::vector<TreeRow>& rows) {
  std::vector<std::string> all;
  for (const TreeRow& row : rows) all.push_back(row.name);
  return all;
}

TEST(TreeRows, AreFoundByPartsOfTheirNamesWhateverTheCase) {
  EXPECT_THAT(names(tree_rows({}, "LHAND")), ::testing::ElementsAre("leader lhand", "follower lhand"));
  EXPECT_THAT(names(tree_rows({}, "follower rha")), ::testing::ElementsAre("follower rhand"));
  EXPECT_THAT(names(tree_rows({}, "tetra")), ::testing::ElementsAre("tetrahedra"));
  EXPECT_THAT(names(tree_rows({}, "ahead")), ::testing::ElementsAre("Look-ahead"));
  EXPECT_THAT(names(tree_rows({}, "nothing like it")), ::testing::IsEmpty());
}

TEST(TreeRows, OfTheFirstNineEachSwitchesItsOwnParts) {
  ASSERT_GE(part_rows().size(), rows_with_keys);
  const TreeRow& result = part_rows()[1];
  EXPECT_EQ(result.name, "Result");
  PartVisibility visible = toggled(result, default_visibility);
  EXPECT_FALSE(visible[static_cast<std::size_t>(ScenePart::Leader)]);
  EXPECT_FALSE(visible[static_cast<std::size_t>(ScenePart::Follower)]);
  EXPECT_TRUE(visible[static_cast<std::size_t>(ScenePart::User)]);
  EXPECT_EQ(toggled(result, visible), default_visibility);
}

TEST(TreeRows, SayWhatTheyAre) {
  for (const TreeRow& row : part_rows()) EXPECT_FALSE(row.tip.empty()) << row.name;
}

TEST(SceneMemory, ReadsBackWhatItWrote) {
  SceneMemory memory;
  memory.visibility[static_cast<std::size_t>(ScenePart::Trails)] = true;
  memory.visibility[static_cast<std::size_t>(ScenePart::LookAhead)] = false;
  memory.scalar = MeshScalar::LengthChange;
  memory.options.longest_m = 0.8;
  memory.options.trail_s = 4;
  memory.options.map = ColourMap::Cividis;
  memory.options.is_logarithmic = true;
  memory.options.navigation = NavigationStyle::Maya;
  memory.options.apart = 0.5;
  memory.options.character_files = {"", "/figures/ana &co.vrm"};
  memory.ranges[static_cast<std::size_t>(MeshScalar::LengthChange)] = {0.0, 0.25};
  const SceneMemory again = scene_memory_of(text_of(memory));
  EXPECT_EQ(again.visibility, memory.visibility);
  EXPECT_EQ(again.scalar, memory.scalar);
  EXPECT_EQ(again.options, memory.options);
  EXPECT_EQ(again.ranges, memory.ranges);
}

TEST(SceneMemory, StartsUncutAndUnfilteredByASelection) {
  SceneMemory memory;
  memory.options.cuts = memory.options.isolates = memory.options.cut_in_world = true;
  EXPECT_EQ(scene_memory_of(text_of(memory)).options, SceneOptions());
}

TEST(SceneMemory, KeepsForAnotherSessionHowTheSceneIsDrawnAndNotWhatOfItIsShown) {
  SceneMemory memory;
  memory.visibility[static_cast<std::size_t>(ScenePart::Follower)] = false;
  memory.scalar = MeshScalar::EnergyShare;
  memory.options.map = ColourMap::Cividis;
  memory.options.longest_m = 0.8;
  SceneMemory drawn = memory;
  drawn.visibility = default_visibility;
  memory.options.character_files = {"ana.vrm", ""};
  memory.options.cuts = memory.options.cut_in_world = memory.options.isolates = true;
  memory.options.cut_m = 0.2;
  memory.ranges[0] = {0.0, 0.25};
  const SceneMemory next = without_session(memory);
  EXPECT_EQ(next.visibility, drawn.visibility);
  EXPECT_EQ(next.scalar, drawn.scalar);
  EXPECT_EQ(next.options, drawn.options);
  EXPECT_EQ(next.ranges, drawn.ranges);
}

TEST(SceneMemory, IsAsUsualForWhatItDoesNotKnow) {
  for (const char* text : {"", "[]", "not json", R"({"map": "jet", "trail_s": 9000, "mouse": 3, "shown": 1})",
                           R"({"ranges": {"residual": [3, 1], "weight": 2, "energy": ["0", "1"]}})"}) {
    const SceneMemory memory = scene_memory_of(text);
    EXPECT_EQ(memory.options, SceneOptions()) << text;
    EXPECT_EQ(memory.visibility, default_visibility) << text;
    EXPECT_EQ(memory.ranges, SceneMemory().ranges) << text;
  }
}

}  // namespace
}  // namespace abrazo::widgets::scene_shapes_test
