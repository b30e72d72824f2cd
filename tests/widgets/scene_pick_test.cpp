// Where things lie in the picture, what the pointer is on, and what is told about it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "tests/widgets/plain_camera.hpp"
#include "tests/widgets/synthetic_frames.hpp"
#include "widgets/scene/pick/pick_facts.hpp"
#include "widgets/scene/pick/scene_pick.hpp"
#include "widgets/scene/values/pointer_moves.hpp"

namespace abrazo::widgets::scene_pick_test {
namespace {

using test::plain_camera;

constexpr double width = 800, height = 600;

PicturePoint at(const OrbitCamera& camera, const Vec3& point) {
  return PictureProjection(camera, width, height).project(point).value();
}

TEST(PictureProjection, PutsTheTargetIntoTheMiddleAndUpUpwards) {
  const OrbitCamera camera = plain_camera();
  EXPECT_NEAR(at(camera, Vec3::Zero()).x, 400, 1e-9);
  EXPECT_NEAR(at(camera, Vec3(0, 1, 0)).y, 0, 1e-9);
  EXPECT_NEAR(at(camera, Vec3(1, 0, 0)).x, 700, 1e-9);
  EXPECT_NEAR(at(camera, Vec3(0, 0, -5)).depth_m, 10, 1e-9);
  EXPECT_NEAR(at(camera, Vec3(1, 0, -5)).x, 550, 1e-9) << "twice as far, half as large";
}

TEST(PictureProjection, InParallelKeepsSizesAtEveryDepth) {
  OrbitCamera camera = plain_camera();
  camera.is_parallel = true;
  EXPECT_NEAR(at(camera, Vec3(1, 0, 0)).x, 700, 1e-9);
  EXPECT_NEAR(at(camera, Vec3(1, 0, -5)).x, 700, 1e-9);
}

TEST(PictureProjection, LeavesOutWhatTheCuttingPlaneTakesAway) {
  OrbitCamera camera = plain_camera();
  camera.cuts = true;
  camera.cut_m = 0.2;
  const PictureProjection projection(camera, width, height);
  EXPECT_FALSE(projection.project(Vec3(0, 0, 0.3)));
  EXPECT_TRUE(projection.project(Vec3(0, 0, 0.1)));
  EXPECT_FALSE(projection.project(Vec3(0, 0, 6))) << "behind the eye";
}

TEST(DistanceToSegment, IsMeasuredToTheLineOrToTheNearerEnd) {
  const PicturePoint a{10, 10, 1}, b{110, 10, 1};
  EXPECT_DOUBLE_EQ(distance_to_segment(50, 17, a, b), 7);
  EXPECT_DOUBLE_EQ(distance_to_segment(113, 14, a, b), 5);
  EXPECT_DOUBLE_EQ(distance_to_segment(13, 14, a, a), 5);
}

TEST(DepthInside, IsThatOfThePlaneAndNegativeOutside) {
  const std::array<PicturePoint, 3> triangle = {{{0, 0, 3}, {90, 0, 6}, {0, 90, 9}}};
  EXPECT_NEAR(depth_inside(30, 30, triangle), 6, 1e-12);
  EXPECT_NEAR(depth_inside(45, 0, triangle), 4.5, 1e-12);
  EXPECT_LT(depth_inside(60, 60, triangle), 0);
}

/// All joints out of the way but 0, 1, 2 and 30 around the middle of the picture.
struct Corner {
  PairPose pair = PairPose::Constant(50);
  std::vector<MeshEdge> edges = {{0, 1}, {0, 2}, {2, 30}};
  std::vector<MeshTetrahedron> cells = {{0, 1, 2, 30}};
  std::vector<double> corners;
  std::vector<Ghost> ghosts;
  Corner() {
    pair.row(0) << 0, 0, 0;
    pair.row(1) << 0.5, 0, 0;
    pair.row(2) << 0, 0.5, 0;
    pair.row(30) << 0, 0, 0.5;
    for (const int v : {0, 1, 2, 30})
      for (int axis = 0; axis < 3; ++axis) corners.push_back(pair(v, axis));
  }
  Selection operator()(double x, double y, std::array<bool, 2> bodies = {true, true}) const {
    return pick(x, y, PictureProjection(plain_camera(), width, height),
                {pair, bodies, edges, cells, corners, ghosts});
  }
};

TEST(Pick, TakesTheJointThenTheEdgeThenTheCell) {
  const Corner corner;  // joints at x 400 and 550, the edge 0-1 between them, the cell above it
  EXPECT_EQ(corner(552, 303), Selection::joint(1));
  EXPECT_EQ(corner(475, 303), Selection::edge({0, 1}));
  EXPECT_EQ(corner(440, 260), Selection::tetrahedron({30, 2, 1, 0}));
  EXPECT_EQ(corner(100, 100), Selection());
}

TEST(Pick, ReachesAsFarAsItSays) {
  const Corner corner;
  EXPECT_EQ(corner(550 + joint_reach_px - 0.5, 300), Selection::joint(1));
  EXPECT_EQ(corner(550 + joint_reach_px + 0.5, 300), Selection());
}

TEST(Pick, OfTwoJointsBehindOneAnotherTakesTheOneInFront) {
  EXPECT_EQ(Corner()(400, 300), Selection::joint(30));
  EXPECT_EQ(Corner()(400, 300, {true, false}), Selection::joint(0)) << "the other body is hidden";
}

TEST(Pick, TakesAGhostWhereItsBonesAre) {
  Corner corner;
  PairPose ghost = PairPose::Constant(50);
  ghost.row(3) << -0.5, -0.8, 0;  // bone 3-4 lies below everything else
  ghost.row(4) << 0.5, -0.8, 0;
  corner.ghosts.push_back({7, ghost});
  EXPECT_EQ(corner(420, 300 + 0.8 * 300), Selection::candidate(7));
  EXPECT_EQ(corner(420, 300 + 0.8 * 300 + edge_reach_px + 1), Selection());
  ghost.row(3) << -0.5, 0, -1;
  ghost.row(4) << 0.5, 0, -1;
  corner.ghosts = {{7, ghost}};
  EXPECT_EQ(corner(475, 300), Selection::candidate(7)) << "drawn over the edge 0-1 that lies as near";
  EXPECT_EQ(corner(552, 303), Selection::joint(1)) << "joints come first";
}

TEST(Pick, PassesOverWhatIsCutAway) {
  Corner corner;
  OrbitCamera camera = plain_camera();
  camera.plane = CutPlane{Vec3(0.2, 0, 0), Vec3::UnitX()};
  const PictureProjection projection(camera, width, height);
  const Pickable all{corner.pair, {true, true}, corner.edges, corner.cells, corner.corners, {}};
  EXPECT_EQ(pick(552, 303, projection, all), Selection()) << "the joint at 0.5 m lies beyond the plane";
  EXPECT_EQ(pick(400, 152, projection, all), Selection::joint(2));
}

/// Whether a card there hides a point.
bool hides(const CardPlace& card, int width_px, int height_px, double x, double y) {
  return x >= card.x && x <= card.x + width_px && y >= card.y && y <= card.y + height_px;
}

TEST(PlaceCard, StandsBesideThePointerWithinTheRoom) {
  for (const auto& [x, y] : {std::pair{5, 5}, {795, 5}, {5, 595}, {795, 595}, {400, 300}}) {
    const CardPlace card = place_card(x, y, 200, 80, 800, 600, {});
    EXPECT_FALSE(hides(card, 200, 80, x, y)) << x << ", " << y;
    EXPECT_GE(card.x, 0);
    EXPECT_LE(card.x + 200, 800);
    EXPECT_GE(card.y, 0);
    EXPECT_LE(card.y + 80, 600);
  }
}

TEST(PlaceCard, LeavesFreeWhatItIsAbout) {
  const std::array<std::array<PicturePoint, 2>, 1> falling = {{{{{100, 100, 1}, {700, 500, 1}}}}};
  const CardPlace card = place_card(400, 300, 200, 80, 800, 600, falling);
  for (int s = 0; s <= 100; ++s)
    EXPECT_FALSE(hides(card, 200, 80, 100 + 6 * s, 100 + 4 * s))
        << "below it to the right would hide the edge";
}

/// In a low picture the legend was under the card wherever the pointer was near it.
TEST(PlaceCard, KeepsOffTheLegendWhereverThereIsOtherRoom) {
  constexpr PictureBox legend{430, 8, 200, 60};
  const std::array<PictureBox, 1> taken{legend};
  const auto is_off_legend = [&](const CardPlace& card, int width_px, int height_px) {
    return card.x + width_px <= legend.x || card.x >= legend.x + legend.width ||
           card.y + height_px <= legend.y || card.y >= legend.y + legend.height;
  };
  for (int x = 0; x <= 640; x += 20)
    for (int y = 0; y <= 140; y += 20) {
      const CardPlace high = place_card(x, y, 300, 126, 640, 140, {}, taken);
      EXPECT_TRUE(is_off_legend(high, 300, 126)) << x << ", " << y << ": at the left";
      const CardPlace wide = place_card(x, y, 600, 60, 640, 140, {}, taken);
      EXPECT_TRUE(is_off_legend(wide, 600, 60)) << x << ", " << y << ": below";
      for (const CardPlace& card : {high, wide}) EXPECT_TRUE(card.x >= 0 && card.y >= 0);
      EXPECT_TRUE(high.x + 300 <= 640 && high.y + 126 <= 140 && wide.x + 600 <= 640 && wide.y + 60 <= 140);
    }
}

TEST(SegmentsOf, AreTheLinesOfAnItemThatTheCameraShows) {
  const Corner corner;
  const PictureProjection projection(plain_camera(), width, height);
  EXPECT_EQ(segments_of(Selection::edge({0, 1}), projection, corner.pair).size(), 1U);
  EXPECT_EQ(segments_of(Selection::tetrahedron({0, 1, 2, 30}), projection, corner.pair).size(), 6U);
  EXPECT_EQ(segments_of(Selection::joint(1), projection, corner.pair).size(), 1U);
  EXPECT_EQ(segments_of(Selection::edge({0, 5}), projection, corner.pair).size(), 0U)
      << "5 is behind the eye";
}

TEST(Selection, IsTheSameHoweverItsVerticesAreOrdered) {
  EXPECT_EQ(Selection::tetrahedron({3, 40, 1, 2}), Selection::tetrahedron({1, 2, 3, 40}));
  EXPECT_EQ(Selection::edge({40, 3}), Selection::edge({3, 40}));
  EXPECT_NE(Selection::edge({3, 40}), Selection::edge({3, 41}));
}

TEST(JointFacts, MeasureTheWayToTheUserOnlyForTheUsersCharacter) {
  FrameSnapshot frame = *test::synthetic_frame(0, 0);
  EXPECT_NEAR(joint_facts(frame, 20).to_user_m.value(), 0.25, 1e-12) << "the user stands 25 cm beside";
  EXPECT_FALSE(joint_facts(frame, 45).to_user_m);
  frame.settings.user_role = UserRole::Passive;
  EXPECT_FALSE(joint_facts(frame, 20).to_user_m);
  EXPECT_TRUE(joint_facts(frame, 45).to_user_m);
}

TEST(JointFacts, FindTheNearestJointOfTheOtherBody) {
  const auto frame = test::synthetic_frame(0, 0);
  const PairPose& pair = frame->result.result;
  for (const int vertex : {20, 45}) {
    const JointFacts facts = joint_facts(*frame, vertex);
    EXPECT_NE(facts.nearest_partner / joint_count, vertex / joint_count);
    EXPECT_NEAR((pair.row(vertex) - pair.row(facts.nearest_partner)).norm(), facts.to_partner_m, 1e-12);
    for (int v = vertex < joint_count ? joint_count : 0, n = v + joint_count; v < n; ++v)
      EXPECT_GE((pair.row(vertex) - pair.row(v)).norm(), facts.to_partner_m - 1e-12);
  }
}

TEST(EdgeFacts, AreThoseOfTheEdgeAndNothingForOneThatTheMeshDoesNotHave) {
  const auto frame = test::synthetic_frame(0, 0);
  const MeshEdge& edge = frame->result.edges[5];
  const EdgeFacts facts = edge_facts(*frame, edge).value();
  EXPECT_NEAR(facts.length_m, (frame->result.result.row(edge[0]) - frame->result.result.row(edge[1])).norm(),
              1e-12);
  EXPECT_DOUBLE_EQ(facts.weight, 0.1);
  EXPECT_DOUBLE_EQ(facts.residual_m, 0.005);
  EXPECT_FALSE(edge_facts(*frame, {edge[1], edge[0]}));
}

TEST(Describe, NamesBodiesAndJointsAndSaysWhatTheFrameDoesNotHave) {
  const auto frame = test::synthetic_frame(0, 0);
  EXPECT_EQ(vertex_name(20), "leader lhand");
  EXPECT_EQ(vertex_name(49), "follower rhand");
  EXPECT_EQ(describe(*frame, Selection::joint(16)).title, "leader head");
  FrameSnapshot without = *frame;
  without.result.edges.clear();
  EXPECT_THAT(describe(without, Selection::edge({20, 49})).lines,
              ::testing::ElementsAre("not in the mesh of this frame"));
  const auto of_the_pair = ::testing::Contains(::testing::HasSubstr("from the selected pair's"));
  EXPECT_THAT(describe(*frame, Selection::joint(16)).lines, of_the_pair);
  without.result.selected = -1;
  EXPECT_THAT(describe(without, Selection::joint(16)).lines, ::testing::Not(of_the_pair));
  EXPECT_FALSE(has_item(without, Selection::edge({20, 49})));
  EXPECT_TRUE(has_item(without, Selection::joint(20)));
}

TEST(Describe, TellsRankAndCostOfACandidateAndWhenItIsNone) {
  const auto frame = test::synthetic_frame(0, 0);
  const auto library = test::two_take_library();
  const PickText winner = describe(*frame, Selection::candidate(0), library.get());
  EXPECT_EQ(winner.title, "salsa_01 · 0");
  EXPECT_THAT(winner.lines, ::testing::Contains("rank 1 of 5, selected"));
  EXPECT_THAT(winner.lines, ::testing::Contains("cost 0.130 m² = pose 0.100 + 0.50 (0.020 + 0.040)"));
  EXPECT_THAT(describe(*frame, Selection::candidate(7), library.get()).lines,
              ::testing::Contains("not among the candidates of this frame"));
}

TEST(Describe, TellsWhatTheFilterExpectsOfACandidate) {
  const auto frame = test::frame_by_intent(0, 0);
  const auto library = test::two_take_library();
  EXPECT_THAT(describe(*frame, Selection::candidate(0), library.get()).lines,
              ::testing::ElementsAre("turn", "rank 1 of 5, selected, continues",
                                     "cost 0.190 m = partner 0.100 + leader 0.060", "+ move 0.030"));
  EXPECT_THAT(describe(*frame, Selection::candidate(1), library.get()).lines,
              ::testing::ElementsAre("turn", "rank 2 of 5", "cost 0.200 m = partner 0.090 + leader 0.050",
                                     "+ move 0.030 + change 0.030"));
}

TEST(Describe, TellsHowDeepALimbOverlaps) {
  const auto frame = test::synthetic_frame(0, 0);
  EXPECT_THAT(describe(*frame, Selection::joint(20)).lines,
              ::testing::Contains("limb overlaps follower lhand's by 4 mm (recorded 10)"));
}

TEST(PointerMove, FollowsTheHabitsOfEachProgram) {
  using N = NavigationStyle;
  const PointerButtons left{true}, middle{false, true}, right{false, false, true};
  const auto with = [](PointerButtons buttons, bool shift, bool control, bool alt) {
    buttons.shift = shift, buttons.control = control, buttons.alt = alt;
    return buttons;
  };
  EXPECT_EQ(pointer_move(N::Abrazo, left), PointerMove::Turn);
  EXPECT_EQ(pointer_move(N::Abrazo, right), PointerMove::Shift);
  EXPECT_EQ(pointer_move(N::Abrazo, with(middle, true, false, false)), PointerMove::Shift);
  EXPECT_EQ(pointer_move(N::Blender, left), PointerMove::None);
  EXPECT_EQ(pointer_move(N::Blender, middle), PointerMove::Turn);
  EXPECT_EQ(pointer_move(N::Blender, with(middle, true, false, false)), PointerMove::Shift);
  EXPECT_EQ(pointer_move(N::Blender, with(middle, false, true, false)), PointerMove::Zoom);
  EXPECT_EQ(pointer_move(N::Maya, left), PointerMove::None);
  EXPECT_EQ(pointer_move(N::Maya, with(left, false, false, true)), PointerMove::Turn);
  EXPECT_EQ(pointer_move(N::Maya, with(middle, false, false, true)), PointerMove::Shift);
  EXPECT_EQ(pointer_move(N::Maya, with(right, false, false, true)), PointerMove::Zoom);
  EXPECT_EQ(pointer_move(N::Vtk, left), PointerMove::Turn);
  EXPECT_EQ(pointer_move(N::Vtk, middle), PointerMove::Shift);
  EXPECT_EQ(pointer_move(N::Vtk, right), PointerMove::Zoom);
}

}  // namespace
}  // namespace abrazo::widgets::scene_pick_test
