#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <random>
#include <stdexcept>
#include <thread>
#include <vector>

#include "core/mesh/interaction_mesh.hpp"
#include "core/motion/body/joint_set.hpp"
#include "tests/support/bodies.hpp"
#include "tests/support/cgal_mesh.hpp"

namespace abrazo::tetrahedralize_test {
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

TEST(Tetrahedralize, FindsTheTetrahedraThatCgalFinds) {
  // Points in general position have one Delaunay tetrahedralisation.
  for (unsigned seed = 0; seed < 300; ++seed) {
    const PairPose pair = shaken_pair(seed, 0.2 + 0.005 * seed);
    const InteractionMesh mesh = tetrahedralize(pair);
    ASSERT_EQ(mesh.quality, InteractionMesh::Quality::Exact);
    ASSERT_EQ(test::in_ascending_order(mesh.tetrahedra), test::cgal_tetrahedra(pair)) << "seed " << seed;
  }
}

PairPose on_a_grid(PairPose pair, double step_m) {
  pair = (pair.array() / step_m).round() * step_m;
  for (int v = 0; v < pair_vertex_count; ++v) pair(v, 0) += 4 * step_m * (v % 25 / 5);  // nobody in one place
  for (int v = 0; v < pair_vertex_count; ++v) pair(v, 2) += 4 * step_m * (v % 5);
  return pair;
}

TEST(Tetrahedralize, WhereManyJointsLieOnOneSphereTheTetrahedraAreDelaunayToo) {
  int compared = 0;
  for (unsigned seed = 0; seed < 60; ++seed) {
    PairPose sphere = shaken_pair(seed);
    sphere.rowwise().normalize();
    PairPose mirrored = shaken_pair(seed);
    mirrored.bottomRows<joint_count>() = mirrored.topRows<joint_count>();
    mirrored.col(2).tail<joint_count>() *= -1;
    mirrored.col(2).tail<joint_count>().array() -= 1;
    for (const PairPose& pair : {sphere, mirrored, on_a_grid(shaken_pair(seed), 0.125)}) {
      const InteractionMesh mesh = tetrahedralize(pair);
      if (mesh.quality != InteractionMesh::Quality::Exact) continue;
      ++compared;
      ASSERT_TRUE(test::is_delaunay(pair, mesh.tetrahedra)) << "seed " << seed;
    }
  }
  EXPECT_GT(compared, 120);
}

TEST(Tetrahedralize, PairsWithHardlyAnyVolumeHaveAMeshToo) {
  // TetGen itself ends the process where it takes all points for one plane or line.
  for (int power = 0; power < 18; ++power)
    for (int other_power : {0, 3, power}) {
      PairPose pair = shaken_pair(static_cast<unsigned>(power));
      pair.col(2) *= std::pow(10.0, -power);
      pair.col(1) *= std::pow(10.0, -other_power);
      for (const double apart_m : {0.0, 1e3, 1e6, 1e9, 1e15}) {
        PairPose moved = pair;
        moved.col(0).tail<joint_count>().array() += apart_m;
        expect_bones_among_edges(tetrahedralize(moved));
      }
    }
}

TEST(Tetrahedralize, LeavesTheProcesssRandomNumbersAlone) {
  std::srand(5);
  const int wanted = std::rand();
  std::srand(5);
  tetrahedralize(shaken_pair(1));
  EXPECT_EQ(std::rand(), wanted);
}

TEST(Tetrahedralize, EveryTetrahedronHasVolumeAndTheSameTurn) {
  const PairPose pair = shaken_pair(13);
  const InteractionMesh mesh = tetrahedralize(pair);
  const double sign = six_volumes(pair, mesh.tetrahedra.front()) > 0 ? 1 : -1;
  for (const MeshTetrahedron& t : mesh.tetrahedra) EXPECT_GT(sign * six_volumes(pair, t), 0);
  EXPECT_TRUE(std::is_sorted(mesh.tetrahedra.begin(), mesh.tetrahedra.end()))
      << "the order must not depend on how they were found";
}

TEST(Tetrahedralize, ThreadsDoNotDisturbOneAnother) {
  // Of sizes from a centimetre to kilometres and with ties, so that one's filters would be wrong for another.
  constexpr int pairs = 200, threads_at_once = 4;
  const auto pair = [](int i) {
    PairPose one = shaken_pair(100U + static_cast<unsigned>(i));
    if (i % 3 == 0) one.rowwise().normalize();
    return PairPose(std::pow(10.0, i % 5 - 1) * one);
  };
  std::vector<InteractionMesh> alone(pairs), together(pairs);
  for (int i = 0; i < pairs; ++i) alone[static_cast<std::size_t>(i)] = tetrahedralize(pair(i));
  {
    std::vector<std::jthread> threads;
    for (int first = 0; first < threads_at_once; ++first)
      threads.emplace_back([&together, &pair, first] {
        for (int i = first; i < pairs; i += threads_at_once)
          together[static_cast<std::size_t>(i)] = tetrahedralize(pair(i));
      });
  }
  for (std::size_t i = 0; i < alone.size(); ++i) {
    EXPECT_EQ(together[i].tetrahedra, alone[i].tetrahedra);
    EXPECT_EQ(together[i].edges, alone[i].edges);
  }
}

TEST(Tetrahedralize, RefusesAJointThatIsNowhere) {
  PairPose pair = shaken_pair(1);
  pair(17, 1) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(tetrahedralize(pair), std::invalid_argument);
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
}  // namespace abrazo::tetrahedralize_test
