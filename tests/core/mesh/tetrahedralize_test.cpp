#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <random>
#include <set>

#include "core/mesh/interaction_mesh.hpp"
#include "core/motion/joint_set.hpp"
#include "tests/support/bodies.hpp"

namespace abrazo {
namespace {

/// Centre and radius of the sphere through four points.
std::pair<Vec3, double> circumsphere(const PairPose& pair, const MeshTetrahedron& t) {
  const Vec3 a = pair.row(t[0]);
  Eigen::Matrix3d rows;
  Vec3 right;
  for (int i = 0; i < 3; ++i) {
    const Vec3 edge = Vec3(pair.row(t[static_cast<std::size_t>(i + 1)])) - a;
    rows.row(i) = 2.0 * edge.transpose();
    right(i) = edge.squaredNorm();
  }
  const Vec3 offset = rows.fullPivLu().solve(right);
  return {a + offset, offset.norm()};
}

PairPose shaken_pair(unsigned seed, double distance_m = 0.7) {
  std::mt19937 random(seed);
  PairPose pair = test::facing_pair(distance_m);
  pair.topRows<joint_count>() = test::shaken(pair.topRows<joint_count>(), 0.05, random);
  pair.bottomRows<joint_count>() = test::shaken(pair.bottomRows<joint_count>(), 0.05, random);
  return pair;
}

void expect_bones_among_edges(const InteractionMesh& mesh) {
  for (int b = 0; b < bone_count; ++b)
    for (const int first : {0, joint_count}) {
      const auto [from, to] = bone(b);
      const MeshEdge edge = {static_cast<std::uint8_t>(from + first), static_cast<std::uint8_t>(to + first)};
      EXPECT_TRUE(std::binary_search(mesh.edges.begin(), mesh.edges.end(), edge))
          << "bone of joint " << joint_names[static_cast<std::size_t>(to)];
    }
}

TEST(Tetrahedralize, NoJointLiesInsideTheCircumsphereOfATetrahedron) {
  for (unsigned seed = 0; seed < 20; ++seed) {
    const PairPose pair = shaken_pair(seed);
    const InteractionMesh mesh = tetrahedralize(pair);
    ASSERT_EQ(mesh.quality, InteractionMesh::Quality::Exact);
    for (const MeshTetrahedron& t : mesh.tetrahedra) {
      const auto [centre, radius] = circumsphere(pair, t);
      for (int v = 0; v < pair_vertex_count; ++v)
        EXPECT_GT((Vec3(pair.row(v)) - centre).norm(), radius * (1 - 1e-7))
            << "vertex " << v << " seed " << seed;
    }
  }
}

TEST(Tetrahedralize, TetrahedraFillTheConvexHullWithoutOverlap) {
  const PairPose pair = shaken_pair(3);
  const InteractionMesh mesh = tetrahedralize(pair);
  std::mt19937 random(1);
  std::uniform_int_distribution<int> vertex(0, pair_vertex_count - 1);
  std::exponential_distribution<double> share(1.0);
  for (int sample = 0; sample < 500; ++sample) {
    // A random point inside the hull: a positive mixture of joints.
    Vec3 point = Vec3::Zero();
    double total = 0;
    for (int k = 0; k < 6; ++k) {
      const double weight = share(random);
      point += weight * Vec3(pair.row(vertex(random)));
      total += weight;
    }
    point /= total;
    int containing = 0;
    for (const MeshTetrahedron& t : mesh.tetrahedra) {
      Eigen::Matrix3d edges;
      for (int i = 0; i < 3; ++i)
        edges.col(i) = (pair.row(t[static_cast<std::size_t>(i + 1)]) - pair.row(t[0])).transpose();
      const Vec3 local = edges.fullPivLu().solve(point - Vec3(pair.row(t[0])));
      containing += local.minCoeff() > 1e-9 && local.sum() < 1 - 1e-9;
    }
    EXPECT_EQ(containing, 1);
  }
}

TEST(Tetrahedralize, EveryBoneIsAnEdgeAndEveryJointHasANeighbour) {
  const InteractionMesh mesh = tetrahedralize(shaken_pair(7));
  expect_bones_among_edges(mesh);
  EXPECT_TRUE(std::is_sorted(mesh.edges.begin(), mesh.edges.end()));
  EXPECT_EQ(std::adjacent_find(mesh.edges.begin(), mesh.edges.end()), mesh.edges.end());
  EXPECT_TRUE(std::any_of(mesh.edges.begin(), mesh.edges.end(), is_inter_body));
}

TEST(Tetrahedralize, GivesTheSameMeshAThousandMetresFromTheOrigin) {
  const PairPose near_origin = shaken_pair(11);
  PairPose far = near_origin;
  far.rowwise() += Eigen::RowVector3d(1000, 0, 1000);
  EXPECT_EQ(tetrahedralize(near_origin).edges, tetrahedralize(far).edges);
}

TEST(Tetrahedralize, TwoBodiesInTheSamePlaceAreJitteredApart) {
  PairPose pair;
  pair.topRows<joint_count>() = test::standing_pose();
  pair.bottomRows<joint_count>() = test::standing_pose();
  const InteractionMesh mesh = tetrahedralize(pair);
  EXPECT_EQ(mesh.quality, InteractionMesh::Quality::Jittered);
  expect_bones_among_edges(mesh);
  EXPECT_FALSE(mesh.tetrahedra.empty());
  EXPECT_EQ(mesh.edges, tetrahedralize(pair).edges) << "the jitter must not be random";
}

TEST(Tetrahedralize, AFlatPairStillConnectsBothBodies) {
  PairPose pair = shaken_pair(5);
  pair.col(2).setZero();
  const InteractionMesh mesh = tetrahedralize(pair);
  EXPECT_NE(mesh.quality, InteractionMesh::Quality::Exact);
  expect_bones_among_edges(mesh);
  EXPECT_TRUE(std::any_of(mesh.edges.begin(), mesh.edges.end(), is_inter_body));
}

TEST(Tetrahedralize, AllJointsInOnePointStillGiveAMesh) {
  const InteractionMesh mesh = tetrahedralize(PairPose::Zero());
  expect_bones_among_edges(mesh);
}

TEST(Tetrahedralize, AMirroredTPoseIsHandled) {
  // Many joints share planes and spheres here: what a T-pose calibration frame looks like.
  PairPose pair = test::facing_pair(1.0);
  for (int v = 0; v < pair_vertex_count; ++v) pair(v, 2) = v < joint_count ? 0.0 : 1.0;
  const InteractionMesh mesh = tetrahedralize(pair);
  expect_bones_among_edges(mesh);
  EXPECT_GT(mesh.edges.size(), 100U);
}

}  // namespace
}  // namespace abrazo
