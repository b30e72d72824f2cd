// Volumes, energies and filters of the interaction mesh as the scene shows it.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numeric>

#include "tests/widgets/synthetic_frames.hpp"
#include "widgets/scene/actors/ahead_lines.hpp"
#include "widgets/scene/actors/joint_trails.hpp"
#include "widgets/scene/values/mesh_cells.hpp"
#include "widgets/scene/values/mesh_filter.hpp"
#include "widgets/scene/values/mesh_scalar.hpp"

namespace abrazo::widgets::scene_mesh_test {
namespace {

constexpr MeshTetrahedron corner_cell = {0, 1, 2, 30};

/// Vertices 0, 1, 2 and 30 at the origin and on the axes, `height` up: volume height / 6.
PairPose corner_pair(double height) {
  PairPose pair = PairPose::Zero();
  pair.row(1) << 1, 0, 0;
  pair.row(2) << 0, 0, 1;
  pair.row(30) << 0, height, 0;
  return pair;
}

TEST(CellVolume, IsASixthOfTheBoxAndItsRatioThatOfTheHeights) {
  const CellVolume cell = cell_volume(corner_pair(0.3), corner_pair(0.6), corner_cell);
  EXPECT_NEAR(cell.volume_m3, 0.05, 1e-12);
  EXPECT_NEAR(cell.reference_m3, 0.1, 1e-12);
  EXPECT_NEAR(cell.ratio, 0.5, 1e-12);
  EXPECT_FALSE(cell.is_inverted);
  EXPECT_FALSE(cell.is_flat);
}

TEST(CellVolume, IsInvertedOnceACornerWentThroughTheOppositeFace) {
  const CellVolume cell = cell_volume(corner_pair(-0.3), corner_pair(0.6), corner_cell);
  EXPECT_TRUE(cell.is_inverted);
  EXPECT_NEAR(cell.ratio, -0.5, 1e-12);
  EXPECT_NEAR(cell.volume_m3, 0.05, 1e-12);
}

TEST(CellVolume, DoesNotJudgeACellThatWasThinnerThanAMillimetre) {
  const CellVolume thin = cell_volume(corner_pair(-0.3), corner_pair(0.0008), corner_cell);
  EXPECT_TRUE(thin.is_flat);
  EXPECT_FALSE(thin.is_inverted);
  EXPECT_FALSE(cell_volume(corner_pair(-0.3), corner_pair(0.0012), corner_cell).is_flat);
}

TEST(CellVolume, TypicalChangeIsInDoublingsAndLeavesInvertedOut) {
  std::vector<CellVolume> cells(11);
  for (std::size_t c = 0; c < cells.size(); ++c)
    cells[c].ratio = std::pow(2.0, -0.1 * static_cast<double>(c));
  EXPECT_NEAR(typical_doublings(cells), 0.9, 1e-12);
  cells.push_back({1, 1, -5, false, true});
  EXPECT_NEAR(typical_doublings(cells), 0.9, 1e-12);
  EXPECT_EQ(inverted_count(cells), 1);
}

TEST(CellVolume, TellsWhetherACellJoinsTheBodies) {
  EXPECT_TRUE(joins_bodies(corner_cell));
  EXPECT_FALSE(joins_bodies(MeshTetrahedron{0, 1, 2, 24}));
  EXPECT_FALSE(joins_bodies(MeshTetrahedron{25, 30, 40, 49}));
}

Vec3 corner_of(const std::vector<double>& corners, std::size_t i) {
  return Vec3(corners.data() + 3 * i);
}

TEST(SpreadCells, MovesACellAwayFromTheMiddleWithoutTurningIt) {
  const PairPose pair = corner_pair(1);
  const std::vector<MeshTetrahedron> cells = {corner_cell};
  const auto plain = spread_cells(pair, cells, 0, 0), apart = spread_cells(pair, cells, 1.5, 0);
  const Vec3 centre(0.25, 0.25, 0.25), middle(0.02, 0, 0.02);  // of 4, of 50 points, on the floor
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_NEAR((corner_of(plain, i) - pair.row(corner_cell[i]).transpose()).norm(), 0, 1e-12);
    EXPECT_NEAR((corner_of(apart, i) - corner_of(plain, i) - 1.5 * (centre - middle)).norm(), 0, 1e-12);
  }
}

TEST(SpreadCells, ShrinksACellTowardsItsOwnCentre) {
  const auto small = spread_cells(corner_pair(1), std::vector<MeshTetrahedron>{corner_cell}, 0, 0.2);
  EXPECT_NEAR((corner_of(small, 0) - corner_of(small, 1)).norm(), 0.8, 1e-12);
  const Vec3 centre =
      0.25 * (corner_of(small, 0) + corner_of(small, 1) + corner_of(small, 2) + corner_of(small, 3));
  EXPECT_NEAR((centre - Vec3(0.25, 0.25, 0.25)).norm(), 0, 1e-12);
}

TEST(FacesBackToFront, BeginWithTheFaceFarthestFromTheEye) {
  const auto corners = spread_cells(corner_pair(1), std::vector<MeshTetrahedron>{corner_cell}, 0, 0);
  const auto order = faces_back_to_front(corners, Vec3(0, 5, 0), Vec3(0, -1, 0));
  ASSERT_EQ(order.size(), 4U);
  EXPECT_EQ(order.front(), 0) << "corners 0, 1, 2 lie on the floor, the eye is above";
  EXPECT_EQ(faces_back_to_front(corners, Vec3(0, -5, 0), Vec3(0, 1, 0)).back(), 0);
}

TEST(EdgeEnergies, AddUpToTheDeformationEnergyOfTheFrame) {
  const auto frame = test::synthetic_frame(7, 0.1);
  // Independently: w_jl = (1/d_jl) / sum, vertex by vertex.
  const FrameResult& result = frame->result;
  double energy = 0;
  for (int j = 0; j < pair_vertex_count; ++j) {
    Vec3 sum = Vec3::Zero();
    double weights = 0;
    for (const MeshEdge& edge : result.edges) {
      if (edge[0] != j && edge[1] != j) continue;
      const int other = edge[0] == j ? edge[1] : edge[0];
      const double w = 1 / (result.selected_pair.row(j) - result.selected_pair.row(other)).norm();
      const PairPose& after = result.result;
      const PairPose& before = result.selected_pair;
      sum += w * ((after.row(j) - before.row(j)) - (after.row(other) - before.row(other))).transpose();
      weights += w;
    }
    energy += 0.5 * (sum / weights).squaredNorm();
  }
  ASSERT_GT(energy, 1e-4);
  const auto energies = edge_energies(*frame);
  EXPECT_NEAR(std::accumulate(energies.begin(), energies.end(), 0.0), energy, 1e-12);
}

TEST(EdgeEnergies, SharesAddUpToAHundredPercentWhateverTheWeights) {
  for (const EdgeWeights weights : {EdgeWeights::Inverse, EdgeWeights::InverseMean, EdgeWeights::Uniform}) {
    FrameSnapshot frame = *test::synthetic_frame(7, 0.1);
    frame.settings.edge_weights = weights;
    const auto shares = edge_scalars(frame, MeshScalar::EnergyShare);
    EXPECT_NEAR(std::accumulate(shares.begin(), shares.end(), 0.0), 100, 1e-9);
    EXPECT_GE(*std::min_element(shares.begin(), shares.end()), 0);
  }
}

TEST(EdgeEnergies, AreNothingWhereNothingIsBent) {
  FrameSnapshot frame = *test::synthetic_frame(7, 0.1);
  frame.result.result = frame.result.selected_pair;
  for (const double share : edge_scalars(frame, MeshScalar::EnergyShare)) EXPECT_EQ(share, 0);
}

TEST(MeshFilter, LetsEverythingThroughAtFirst) {
  EXPECT_TRUE(MeshFilter().is_open());
  EXPECT_TRUE(MeshFilter().passes(corner_pair(1), MeshEdge{0, 1}));
}

MeshFilter lengths(double shortest_m, double longest_m) {
  MeshFilter filter;
  filter.shortest_m = shortest_m;
  filter.longest_m = longest_m;
  return filter;
}

MeshFilter isolating(const Selection& selection) {
  MeshFilter filter;
  filter.isolated = selection;
  return filter;
}

TEST(MeshFilter, KeepsToARangeOfLengthsWithItsEnds) {
  const PairPose pair = corner_pair(2);
  EXPECT_TRUE(lengths(1, 2).passes(pair, MeshEdge{0, 1}));
  EXPECT_TRUE(lengths(1, 2).passes(pair, MeshEdge{0, 30}));
  EXPECT_FALSE(lengths(1.01, 2).passes(pair, MeshEdge{0, 1}));
  EXPECT_FALSE(lengths(0, 1.99).passes(pair, MeshEdge{0, 30}));
  EXPECT_FALSE(lengths(0, 1.99).passes(pair, corner_cell)) << "one edge of the cell is too long";
}

TEST(MeshFilter, KeepsToARangeOfTheColouredValueWithoutItsSign) {
  MeshFilter filter;
  EXPECT_TRUE(filter.passes_value(std::nan(""))) << "nothing is asked of it";
  filter.least_value = 0.5;
  EXPECT_TRUE(filter.passes_value(0.5));
  EXPECT_TRUE(filter.passes_value(-0.7));
  EXPECT_TRUE(filter.passes_value(3));
  EXPECT_FALSE(filter.passes_value(0.49));
  EXPECT_FALSE(filter.passes_value(std::nan("")));
  filter.most_value = 0.8;
  EXPECT_FALSE(filter.passes_value(0.81));
  EXPECT_FALSE(filter.is_open());
}

TEST(MeshFilter, KeepsToWhatMeetsAtAJoint) {
  const MeshFilter filter = isolating(Selection::joint(30));
  EXPECT_TRUE(filter.passes(corner_pair(1), MeshEdge{0, 30}));
  EXPECT_FALSE(filter.passes(corner_pair(1), MeshEdge{0, 1}));
  EXPECT_TRUE(filter.passes(corner_pair(1), corner_cell));
  EXPECT_FALSE(filter.passes(corner_pair(1), MeshTetrahedron{0, 1, 2, 31}));
}

TEST(MeshFilter, KeepsToWhatMeetsAtAnyOfSeveralJoints) {
  Selection two = Selection::joint(30);
  two.vertices.push_back(1);
  EXPECT_TRUE(isolating(two).passes(corner_pair(1), MeshEdge{0, 1}));
  EXPECT_FALSE(isolating(two).passes(corner_pair(1), MeshEdge{0, 2}));
}

TEST(MeshFilter, KeepsToAnEdgeOrACellAndWhatItIsPartOfOrConsistsOf) {
  const PairPose pair = corner_pair(1);
  const MeshFilter edge = isolating(Selection::edge({0, 30}));
  EXPECT_TRUE(edge.passes(pair, MeshEdge{0, 30}));
  EXPECT_FALSE(edge.passes(pair, MeshEdge{0, 1}));
  EXPECT_TRUE(edge.passes(pair, corner_cell));
  EXPECT_FALSE(edge.passes(pair, MeshTetrahedron{0, 1, 2, 31}));
  const MeshFilter cell = isolating(Selection::tetrahedron(corner_cell));
  EXPECT_TRUE(cell.passes(pair, MeshEdge{0, 30}));
  EXPECT_FALSE(cell.passes(pair, MeshEdge{0, 31}));
  EXPECT_TRUE(cell.passes(pair, corner_cell));
}

TEST(MeshFilter, HidesAnEdgeWithItsCellsACellAloneAndAJointWithAllThatMeetsThere) {
  const PairPose pair = corner_pair(1);
  MeshFilter filter;
  filter.hidden = {Selection::tetrahedron(corner_cell)};
  EXPECT_FALSE(filter.passes(pair, corner_cell));
  EXPECT_TRUE(filter.passes(pair, MeshEdge{0, 30})) << "its edges belong to others, too";
  filter.hidden = {Selection::edge({0, 30})};
  EXPECT_FALSE(filter.passes(pair, MeshEdge{0, 30}));
  EXPECT_FALSE(filter.passes(pair, corner_cell));
  filter.hidden = {Selection::joint(30), Selection::edge({1, 2})};
  EXPECT_FALSE(filter.passes(pair, MeshEdge{2, 30}));
  EXPECT_FALSE(filter.passes(pair, MeshEdge{1, 2}));
  EXPECT_TRUE(filter.passes(pair, MeshEdge{0, 1}));
}

TEST(MeshFilter, IsolatesNothingForACandidate) {
  EXPECT_TRUE(isolating(Selection::candidate(3)).passes(corner_pair(1), MeshEdge{0, 1}));
}

TEST(JointTrails, KeepTheLastMomentsOnly) {
  JointTrails trails;
  for (int i = 0; i < 300; ++i) trails.add(i / 60.0, corner_pair(i / 60.0));
  const auto trail = trails.lines_of({30});
  const std::size_t kept = static_cast<std::size_t>(std::lround(trails.length_s() * 60)) + 1;
  EXPECT_NEAR(static_cast<double>(trails.size()), static_cast<double>(kept), 1);
  EXPECT_EQ(trail.lines.size(), trails.size() - 1);
  EXPECT_DOUBLE_EQ(trail.xyz[trail.xyz.size() - 2], 299 / 60.0) << "the newest comes last";
  EXPECT_DOUBLE_EQ(trail.age.back(), 0);
  EXPECT_NEAR(trail.age.front(), 1, 0.03);
}

TEST(JointTrails, StayBoundedHoweverFastTheFramesCome) {
  JointTrails trails;
  for (int i = 0; i < 8000; ++i) trails.add(i / 2000.0, corner_pair(1));
  EXPECT_LE(trails.size(), JointTrails::most_samples);
  EXPECT_GT(trails.size(), JointTrails::most_samples / 2);
  EXPECT_NEAR(trails.last_s() - trails.known_since_s(), trails.length_s(), 0.01) << "thinned, not cut short";
}

TEST(JointTrails, HaveTheLengthTheyAreGiven) {
  JointTrails trails;
  trails.set_length(4);
  for (int i = 0; i < 600; ++i) trails.add(i / 60.0, corner_pair(1));
  EXPECT_NEAR(trails.last_s() - trails.known_since_s(), 4, 0.05);
  trails.set_length(1);
  trails.add(10, corner_pair(1));
  EXPECT_NEAR(trails.last_s() - trails.known_since_s(), 1, 0.05);
}

TEST(JointTrails, BeginAnewWhenTheCursorWasMoved) {
  JointTrails trails;
  for (int i = 0; i < 10; ++i) trails.add(5 + i / 60.0, corner_pair(1));
  trails.add(5, corner_pair(1));
  EXPECT_EQ(trails.size(), 1U) << "back";
  trails.add(5.02, corner_pair(1));
  trails.add(5.02, corner_pair(1));
  EXPECT_EQ(trails.size(), 2U) << "the same frame shown again";
  trails.add(9, corner_pair(1));
  EXPECT_EQ(trails.size(), 1U) << "far on";
}

TEST(AheadLines, FadeTowardsTheEndOfTheirSecond) {
  std::vector<Pose> poses;
  for (int i = 0; i <= 20; ++i) poses.push_back(Pose::Constant(0.01 * i));
  const auto ahead = ahead_lines(poses, joint_count);
  ASSERT_EQ(ahead.lines.size(), 6U * 20) << "root, head, hands and feet";
  EXPECT_EQ(ahead.xyz.size(), 6U * 21 * 3);
  EXPECT_EQ(ahead.lines.front(), (std::array<int, 2>{0, 1})) << "it begins at the body";
  EXPECT_EQ(ahead.age.front(), 0);
  EXPECT_NEAR(ahead.age.back(), 0.95, 1e-12) << "its last step is hardly seen";
  EXPECT_EQ(ahead.vertex.front(), joint_count + joints::Root);
  EXPECT_EQ(ahead.vertex.back(), joint_count + joints::right_toe_base);
}

TEST(AheadLines, OfATakeThatEndsAreShortAndOfNoneNone) {
  const std::vector<Pose> poses(3, Pose::Zero());
  EXPECT_EQ(ahead_lines(poses, 0).lines.size(), 6U * 2);
  EXPECT_NEAR(ahead_lines(poses, 0).age.back(), ahead_step_s, 1e-12) << "they stop where they are bright";
  EXPECT_TRUE(ahead_lines(std::span(poses).first(1), 0).lines.empty());
  EXPECT_TRUE(ahead_lines({}, 0).lines.empty());
}

}  // namespace
}  // namespace abrazo::widgets::scene_mesh_test
