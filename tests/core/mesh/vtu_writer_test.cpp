#include "core/mesh/vtu_writer.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <pugixml.hpp>
#include <sstream>
#include <stdexcept>

#include "core/base/text.hpp"
#include "tests/support/bodies.hpp"

namespace abrazo::vtu_writer_test {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::SizeIs;

std::vector<double> numbers(const std::string& text) {
  std::vector<double> values;
  for (std::istringstream in(text); in.good();) {
    std::string word;
    if (in >> word) values.push_back(parse_number(word).value());
  }
  return values;
}

/// What a reader of the XML finds, by the name of its array.
struct Grid {
  int points = 0, cells = 0;
  std::map<std::string, std::vector<double>> arrays;
};

Grid parsed(const std::string& vtu) {
  pugi::xml_document document;
  const auto outcome = document.load_string(vtu.c_str());
  EXPECT_TRUE(outcome) << outcome.description();
  const auto grid = document.child("VTKFile").child("UnstructuredGrid");
  const auto piece = grid.child("Piece");
  Grid found{piece.attribute("NumberOfPoints").as_int(), piece.attribute("NumberOfCells").as_int(), {}};
  for (const auto& array : document.select_nodes("//DataArray"))
    found.arrays[array.node().attribute("Name").value()] = numbers(array.node().child_value());
  return found;
}

/// Two people and a mesh of one tetrahedron between them with three of its edges.
struct Example {
  PairPose reference = test::facing_pair(0.7);
  PairPose positions = reference;
  std::vector<MeshTetrahedron> tetrahedra = {{0, 6, 24, 49}};
  std::vector<MeshEdge> edges = {{0, 6}, {24, 49}, {30, 49}};
  std::vector<double> weights = {0.1, 1.0 / 3, 2};
  std::vector<double> residuals_m = {1e-3, 0, 0.04};

  MeshFrame frame() const { return {12.5, positions, reference, edges, tetrahedra, weights, residuals_m}; }
};

TEST(VtuWriter, HoldsThePointsToTheLastBit) {
  Example example;
  example.positions.array() += 1.0 / 7;
  const Grid grid = parsed(write_vtu(example.frame()));
  ASSERT_EQ(grid.points, 50);
  const std::vector<double>& points = grid.arrays.at("Points");
  ASSERT_THAT(points, SizeIs(150));
  for (int v = 0; v < 50; ++v)
    for (int axis = 0; axis < 3; ++axis)
      ASSERT_EQ(points[static_cast<std::size_t>(3 * v + axis)], example.positions(v, axis));
}

TEST(VtuWriter, CellsAreTetrahedraThenEdges) {
  const Grid grid = parsed(write_vtu(Example().frame()));
  EXPECT_EQ(grid.cells, 4);
  EXPECT_THAT(grid.arrays.at("types"), ElementsAre(10, 3, 3, 3));
  EXPECT_THAT(grid.arrays.at("offsets"), ElementsAre(4, 6, 8, 10));
  EXPECT_THAT(grid.arrays.at("connectivity"), ElementsAre(0, 6, 24, 49, 0, 6, 24, 49, 30, 49));
  EXPECT_THAT(grid.arrays.at("kind"), ElementsAre(0, 1, 1, 1));
  EXPECT_THAT(grid.arrays.at("inter_body"), ElementsAre(1, 0, 1, 0));
}

TEST(VtuWriter, EdgesHaveWeightResidualAndLength) {
  Example example;
  example.positions.row(6) = example.positions.row(0) + Eigen::RowVector3d(0.3, 0, 0.4);
  const Grid grid = parsed(write_vtu(example.frame()));
  EXPECT_EQ(grid.arrays.at("weight")[2], 1.0 / 3);
  EXPECT_EQ(grid.arrays.at("residual")[3], 0.04);
  EXPECT_NEAR(grid.arrays.at("length")[1], 0.5, 1e-12);
  const double before = (example.reference.row(0) - example.reference.row(6)).norm();
  EXPECT_NEAR(grid.arrays.at("length_change")[1], 0.5 - before, 1e-12);
  EXPECT_EQ(grid.arrays.at("length_change")[2], 0);
  EXPECT_TRUE(std::isnan(grid.arrays.at("weight")[0]));
}

TEST(VtuWriter, ATetrahedronTurnedInsideOutHasANegativeRatio) {
  Example example;
  example.reference.row(0) = Eigen::RowVector3d(0, 0, 0);
  example.reference.row(6) = Eigen::RowVector3d(1, 0, 0);
  example.reference.row(24) = Eigen::RowVector3d(0, 1, 0);
  example.reference.row(49) = Eigen::RowVector3d(0, 0, 1);
  example.positions = example.reference;
  example.positions(49, 2) = -2;
  const Grid grid = parsed(write_vtu(example.frame()));
  EXPECT_NEAR(std::abs(grid.arrays.at("volume")[0]), 2.0 / 6, 1e-12);
  EXPECT_NEAR(grid.arrays.at("volume_ratio")[0], -2, 1e-12);
  EXPECT_TRUE(std::isnan(grid.arrays.at("volume")[1]));
}

TEST(VtuWriter, PointsSayWhoseJointTheyAreAndHowFarTheyMoved) {
  Example example;
  example.positions(26, 1) += 0.25;
  const Grid grid = parsed(write_vtu(example.frame()));
  EXPECT_EQ(grid.arrays.at("body")[24], 0);
  EXPECT_EQ(grid.arrays.at("body")[25], 1);
  EXPECT_EQ(grid.arrays.at("joint")[26], 1);
  EXPECT_EQ(grid.arrays.at("displacement")[3 * 26 + 1], example.positions(26, 1) - example.reference(26, 1));
  EXPECT_THAT(grid.arrays.at("TimeValue"), ElementsAre(12.5));
}

TEST(VtuWriter, AWeightIsMissing) {
  Example example;
  example.weights.pop_back();
  EXPECT_THROW(write_vtu(example.frame()), std::invalid_argument);
}

TEST(PvdWriter, ListsTheFilesWithTheirTimes) {
  const std::vector<SeriesFile> files = {{0.5, "a_0001.vtu"}, {0.75, "you & me_0002.vtu"}};
  pugi::xml_document document;
  ASSERT_TRUE(document.load_string(write_pvd(files).c_str()));
  const auto collection = document.child("VTKFile").child("Collection");
  const auto second = collection.first_child().next_sibling();
  EXPECT_EQ(collection.first_child().attribute("timestep").as_double(), 0.5);
  EXPECT_STREQ(second.attribute("file").value(), "you & me_0002.vtu");
}

}  // namespace
}  // namespace abrazo::vtu_writer_test
