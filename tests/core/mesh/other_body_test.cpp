#include "core/mesh/other_body.hpp"

#include <gtest/gtest.h>

namespace abrazo::other_body_test {
namespace {

TEST(OtherBody, HasTheSameJointAsItsVertex) {
  EXPECT_EQ(vertex_of_other_body(3), 3 + joint_count);
  EXPECT_EQ(vertex_of_other_body(3 + joint_count), 3);
}

TEST(OtherBody, AnEdgeBetweenTheBodiesKeepsItsLowerVertexFirst) {
  EXPECT_EQ(edge_of_other_body({2, joint_count + 7}), (MeshEdge{7, joint_count + 2}));
  EXPECT_EQ(edge_of_other_body({2, 7}), (MeshEdge{joint_count + 2, joint_count + 7}));
}

TEST(OtherBody, ATetrahedronKeepsTheOrderOfItsVertices) {
  const MeshTetrahedron cell = {1, 4, joint_count + 2, joint_count + 9};
  EXPECT_EQ(tetrahedron_of_other_body(cell), (MeshTetrahedron{joint_count + 1, joint_count + 4, 2, 9}));
  EXPECT_EQ(tetrahedron_of_other_body(tetrahedron_of_other_body(cell)), cell);
}

}  // namespace
}  // namespace abrazo::other_body_test
