#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <fstream>
#include <iterator>
#include <limits>
#include <random>
#include <sstream>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "core/mesh/interaction_mesh.hpp"
#include "core/motion/joint_set.hpp"
#include "tests/support/bodies.hpp"

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

/// Four joints of each, as letters: a-z for vertices 0 to 25, A-X for the rest.
std::vector<std::string> in_letters(const InteractionMesh& mesh) {
  std::vector<std::string> words;
  for (MeshTetrahedron tetrahedron : mesh.tetrahedra) {
    std::sort(tetrahedron.begin(), tetrahedron.end());
    std::string word;
    for (const int v : tetrahedron) word += static_cast<char>(v < 26 ? 'a' + v : 'A' + v - 26);
    words.push_back(word);
  }
  std::sort(words.begin(), words.end(), [](const std::string& a, const std::string& b) {
    return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end(), [](char x, char y) {
      return (x < 'a' ? x + 256 : x) < (y < 'a' ? y + 256 : y);
    });
  });
  return words;
}

TEST(Tetrahedralize, FindsTheTetrahedraThatTetGenFinds) {
  // Points in general position have one Delaunay tetrahedralisation. One line per seed, written by a program
  // that calls TetGen 1.5 on the same points about their mean.
  std::ifstream file(ABRAZO_FIXTURES "/mesh/tetgen_of_shaken_pairs.txt");
  unsigned seed = 0;
  for (std::string line; std::getline(file, line); ++seed) {
    std::istringstream words(line);
    const std::vector<std::string> wanted{std::istream_iterator<std::string>(words), {}};
    EXPECT_EQ(in_letters(tetrahedralize(shaken_pair(seed))), wanted) << "seed " << seed;
  }
  EXPECT_EQ(seed, 12U);
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
  constexpr int pairs = 40;
  std::vector<InteractionMesh> alone(pairs), together(pairs);
  for (int i = 0; i < pairs; ++i) alone[static_cast<std::size_t>(i)] = tetrahedralize(shaken_pair(100U + i));
  {
    std::vector<std::jthread> threads;
    for (int first = 0; first < 4; ++first)
      threads.emplace_back([&together, first] {
        for (int i = first; i < pairs; i += 4)
          together[static_cast<std::size_t>(i)] = tetrahedralize(shaken_pair(100U + i));
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
