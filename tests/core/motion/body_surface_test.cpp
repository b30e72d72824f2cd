#include "core/motion/body/body_surface.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "core/motion/body/joint_set.hpp"
#include "tests/support/bodies.hpp"

namespace abrazo::body_surface_test {
namespace {

class BodySurfaceTest : public testing::Test {
 protected:
  BodySurfaceTest() : tree(Clip{"dancer", 60, {test::standing_pose()}}) {
    for (const auto& node : tree.nodes())
      places.push_back(node.parent < 0 ? Vec3(0, 1, 0)
                                       : Vec3(places[static_cast<std::size_t>(node.parent)] + node.offset));
    surface = body_surface(tree.nodes(), places);
  }
  const BodySurface::Vertex& corner(std::size_t i) const { return surface.vertices[surface.corners[i]]; }

  JointTree tree;
  std::vector<Vec3> places;
  BodySurface surface;
};

TEST_F(BodySurfaceTest, EveryEdgeBelongsToTwoTrianglesThatRunItOppositeWays) {
  std::map<std::pair<int, int>, int> edges;
  ASSERT_EQ(surface.corners.size() % 3, 0U);
  for (std::size_t i = 0; i < surface.corners.size(); i += 3)
    for (std::size_t k = 0; k < 3; ++k) ++edges[{surface.corners[i + k], surface.corners[i + (k + 1) % 3]}];
  for (const auto& [edge, count] : edges) {
    EXPECT_EQ(count, 1);
    EXPECT_TRUE(edges.contains({edge.second, edge.first}));
  }
}

TEST_F(BodySurfaceTest, TrianglesFaceTheWayOfTheirNormals) {
  for (std::size_t i = 0; i < surface.corners.size(); i += 3) {
    const Vec3 facing = (corner(i + 1).place - corner(i).place).cross(corner(i + 2).place - corner(i).place);
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_GT(facing.dot(corner(i + k).normal), 0);
      EXPECT_NEAR(corner(i + k).normal.norm(), 1, 1e-12);
    }
  }
}

TEST_F(BodySurfaceTest, ALimbGoesWithTheNodeThatTurnsItsBone) {
  std::set<int> moving;
  for (const auto& vertex : surface.vertices) moving.insert(vertex.node);
  for (std::size_t n = 1; n < tree.nodes().size(); ++n) {
    if (tree.nodes()[n].offset.norm() <= 1e-6) continue;
    EXPECT_TRUE(moving.contains(tree.nodes()[n].parent));
  }
}

TEST_F(BodySurfaceTest, ItIsAsWideAsAPerson) {
  double left = 0, back = 0, waist = 0;
  for (const auto& vertex : surface.vertices) {
    left = std::max(left, vertex.place.x());
    if (std::abs(vertex.place.x()) < 0.2 && std::abs(vertex.place.y() - 1.05) < 0.03) {
      waist = std::max(waist, vertex.place.x());
      back = std::max(back, -vertex.place.z());
    }
  }
  EXPECT_GT(left, 0.6);
  EXPECT_NEAR(waist, 0.12, 0.03);
  EXPECT_LT(back, waist) << "flatter than wide";
}

}  // namespace
}  // namespace abrazo::body_surface_test
