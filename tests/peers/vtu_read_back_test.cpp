// What VTK's own reader finds in an interaction mesh that was written.
#include <gtest/gtest.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLUnstructuredGridReader.h>
#include <Eigen/Geometry>

#include <cmath>

#include "core/mesh/vtu_writer.hpp"
#include "tests/support/libraries.hpp"

namespace abrazo::vtu_read_back_test {
namespace {

/// A pair of the library with its mesh, somewhat moved.
class VtuReadBack : public testing::Test {
 protected:
  VtuReadBack() {
    const auto library = test::small_library();
    reference = library->pair_in_world(40, library->root(40));
    positions = reference;
    for (int i = 0; i < positions.rows(); ++i)
      positions.row(i) += Eigen::RowVector3d(0.01 * std::sin(i), 0.002 * i, -0.01 * std::cos(i));
    edges.assign(library->edges(40).begin(), library->edges(40).end());
    tetrahedra.assign(library->tetrahedra(40).begin(), library->tetrahedra(40).end());
    for (std::size_t e = 0; e < edges.size(); ++e) {
      weights.push_back(1 / (1.0 + static_cast<double>(e)));
      residuals.push_back(1e-3 * static_cast<double>(e) / 3);
    }
    reader->ReadFromInputStringOn();
    reader->SetInputString(write_vtu({1.5, positions, reference, edges, tetrahedra, weights, residuals}));
    reader->Update();
  }
  vtkUnstructuredGrid& grid() { return *reader->GetOutput(); }
  double point_value(const char* name, vtkIdType i, int component = 0) {
    return grid().GetPointData()->GetArray(name)->GetComponent(i, component);
  }
  double cell_value(const char* name, vtkIdType i) {
    return grid().GetCellData()->GetArray(name)->GetComponent(i, 0);
  }

  PairPose positions, reference;
  std::vector<MeshEdge> edges;
  std::vector<MeshTetrahedron> tetrahedra;
  std::vector<double> weights, residuals;
  vtkNew<vtkXMLUnstructuredGridReader> reader;
};

TEST_F(VtuReadBack, EveryJointStandsWhereItStood) {
  ASSERT_EQ(reader->GetErrorCode(), 0U);
  ASSERT_EQ(grid().GetNumberOfPoints(), positions.rows());
  for (vtkIdType i = 0; i < positions.rows(); ++i) {
    double place[3];
    grid().GetPoint(i, place);
    for (int axis = 0; axis < 3; ++axis) {
      EXPECT_EQ(place[axis], positions(i, axis));
      EXPECT_EQ(point_value("displacement", i, axis), positions(i, axis) - reference(i, axis));
    }
    EXPECT_EQ(point_value("body", i), i < 25 ? 0 : 1);
    EXPECT_EQ(point_value("joint", i), static_cast<double>(i % 25));
  }
}

TEST_F(VtuReadBack, TheCellsAreTheMeshs) {
  const auto of_tetrahedra = static_cast<vtkIdType>(tetrahedra.size());
  ASSERT_GT(of_tetrahedra, 50);
  ASSERT_EQ(grid().GetNumberOfCells(), of_tetrahedra + static_cast<vtkIdType>(edges.size()));
  for (vtkIdType c = 0; c < grid().GetNumberOfCells(); ++c) {
    vtkIdType count = 0;
    const vtkIdType* corners = nullptr;
    grid().GetCellPoints(c, count, corners);
    const bool is_edge = c >= of_tetrahedra;
    ASSERT_EQ(count, is_edge ? 2 : 4);
    EXPECT_EQ(cell_value("kind", c), is_edge ? 1 : 0);
    for (vtkIdType k = 0; k < count; ++k)
      EXPECT_EQ(corners[k],
                is_edge ? edges[static_cast<std::size_t>(c - of_tetrahedra)][static_cast<std::size_t>(k)]
                        : tetrahedra[static_cast<std::size_t>(c)][static_cast<std::size_t>(k)]);
  }
}

TEST_F(VtuReadBack, ValuesOfEdgesAndTetrahedraComeBack) {
  const auto of_tetrahedra = static_cast<vtkIdType>(tetrahedra.size());
  for (std::size_t e = 0; e < edges.size(); ++e) {
    const vtkIdType c = of_tetrahedra + static_cast<vtkIdType>(e);
    EXPECT_EQ(cell_value("weight", c), weights[e]);
    EXPECT_EQ(cell_value("residual", c), residuals[e]);
    EXPECT_EQ(cell_value("length", c), (positions.row(edges[e][0]) - positions.row(edges[e][1])).norm());
    EXPECT_TRUE(std::isnan(cell_value("volume", c)));
  }
  EXPECT_TRUE(std::isnan(cell_value("weight", 0)));
  const auto& first = tetrahedra.front();
  const Vec3 a = positions.row(first[0]), b = positions.row(first[1]), c = positions.row(first[2]),
             d = positions.row(first[3]);
  EXPECT_NEAR(std::abs(cell_value("volume", 0)), std::abs((b - a).dot((c - a).cross(d - a))) / 6, 1e-12);
}

}  // namespace
}  // namespace abrazo::vtu_read_back_test
