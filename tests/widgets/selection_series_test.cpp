// The figures of what is selected, over time.
#include "widgets/plots/selection_series.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/mesh/laplacian.hpp"
#include "tests/widgets/synthetic_frames.hpp"
#include "widgets/plots/sample_table.hpp"

namespace abrazo::widgets::selection_series_test {
namespace {

using test::synthetic_frame;

double of(const SeriesValues& values, Series series) {
  return values[static_cast<std::size_t>(series)];
}

SeriesValues read(const Selection& selection, const FrameSnapshot& frame) {
  SeriesValues values{};
  SelectionReader(selection).read(frame, values);
  return values;
}

TEST(VertexResidual, IsThatOfTheLaplacianForEachKindOfWeights) {
  FrameSnapshot frame = *synthetic_frame(3, 0.05);
  for (const EdgeWeights weights : {EdgeWeights::Inverse, EdgeWeights::InverseMean, EdgeWeights::Uniform}) {
    frame.settings.edge_weights = weights;
    Laplacian laplacian;
    laplacian.build(frame.result.edges, frame.result.selected_pair, weights);
    const PairPose bent = laplacian.apply(frame.result.selected_pair) - laplacian.apply(frame.result.result);
    for (const int vertex : {0, 20, 45})
      EXPECT_NEAR(vertex_residual_m(frame, vertex), bent.row(vertex).norm(), 1e-12) << vertex;
  }
}

TEST(SelectionReader, ReadsAJoint) {
  const auto frame = synthetic_frame(3, 0.05);
  const SeriesValues values = read(Selection::joint(45), *frame);
  const double moved = (frame->result.result.row(45) - frame->result.selected_pair.row(45)).norm();
  EXPECT_NEAR(of(values, Series::JointFromSelected), 1000 * moved, 1e-9);
  EXPECT_TRUE(std::isnan(of(values, Series::JointFromUser))) << "the user is the leader";
  EXPECT_NEAR(of(read(Selection::joint(20), *frame), Series::JointFromUser), 250, 1e-9);
  EXPECT_TRUE(std::isnan(of(values, Series::JointSpeed))) << "no frame before";
  EXPECT_TRUE(std::isnan(of(values, Series::EdgeLength)));
}

TEST(SelectionReader, MeasuresTheSpeedBetweenFramesThatFollowOneAnother) {
  FrameSnapshot first = *synthetic_frame(3, 1.0), second = *synthetic_frame(3, 1.1), later = first;
  second.index = 4;
  later.index = 9;
  later.time_s = 2;
  second.result.result.row(45) += Eigen::RowVector3d(0, 0.05, 0);
  SelectionReader reader(Selection::joint(45));
  SeriesValues values{};
  reader.read(first, values);
  reader.read(second, values);
  EXPECT_NEAR(of(values, Series::JointSpeed), 0.5, 1e-9);
  reader.read(later, values);
  EXPECT_TRUE(std::isnan(of(values, Series::JointSpeed))) << "frames between are missing";
}

TEST(SelectionReader, ReadsAnEdgeAndNothingWhereTheMeshDoesNotHaveIt) {
  FrameSnapshot frame = *synthetic_frame(3, 0.05);
  const MeshEdge edge = frame.result.edges[7];
  const SeriesValues values = read(Selection::edge(edge), frame);
  const auto length = [&edge](const PairPose& pair) {
    return (pair.row(edge[0]) - pair.row(edge[1])).norm();
  };
  EXPECT_NEAR(of(values, Series::EdgeLength), 1000 * length(frame.result.result), 1e-9);
  EXPECT_NEAR(of(values, Series::EdgeReference), 1000 * length(frame.result.selected_pair), 1e-9);
  EXPECT_DOUBLE_EQ(of(values, Series::EdgeWeight), 0.1);
  EXPECT_NEAR(of(values, Series::EdgeResidual), 7, 1e-9);
  frame.result.edges.erase(frame.result.edges.begin() + 7);
  EXPECT_TRUE(std::isnan(of(read(Selection::edge(edge), frame), Series::EdgeLength)));
}

TEST(SelectionReader, ReadsTheVolumeRatioOfATetrahedron) {
  FrameSnapshot frame = *synthetic_frame(3, 0.05);
  frame.result.result = 2 * frame.result.selected_pair;
  EXPECT_NEAR(of(read(Selection::tetrahedron(frame.result.tetrahedra[5]), frame), Series::CellRatio), 8,
              1e-9);
}

TEST(SelectionReader, ReadsNothingOfAFailedStep) {
  FrameSnapshot frame = *synthetic_frame(3, 0.05);
  frame.result.status = StepStatus::Failed;
  for (const Series series : selection_series())
    EXPECT_TRUE(std::isnan(of(read(Selection::joint(3), frame), series)));
}

TEST(SeriesOf, ShareAUnitSoThatOnePaneTakesThem) {
  for (const Selection& selection :
       {Selection::joint(3), Selection::edge({3, 40}), Selection::tetrahedron({1, 2, 3, 40})}) {
    const PaneSeries pane = series_of(selection);
    ASSERT_FALSE(pane.empty());
    for (const Series series : pane) EXPECT_TRUE(can_join(pane, series));
  }
  EXPECT_TRUE(series_of(Selection::candidate(3)).empty());
}

TEST(SampleTable, RewritesSeriesOfRowsAndTheirExtremes) {
  SampleTable table;
  constexpr int rows = 4 * SampleTable::block_rows;
  for (int r = 0; r < rows; ++r) {
    SampleTable::Row row{r / 100.0, static_cast<std::uint64_t>(r), {}};
    row.values[0] = 1;
    table.append(row);
  }
  SeriesValues values{};
  values[0] = 50;
  values[1] = 60;
  table.rewrite(100, {static_cast<Series>(0)}, values);
  table.rewrite(99999, {static_cast<Series>(0)}, values);  // of a frame that is not kept
  EXPECT_EQ(table.rows()[100].values[0], 50);
  EXPECT_EQ(table.rows()[100].values[1], 0) << "only what was asked for";
  table.refresh_extremes(100, 100);
  const auto line = table.line(static_cast<Series>(0), 0, rows / 100.0, 1);
  double largest = 0;
  for (const auto& point : line) largest = std::max(largest, point.value);
  EXPECT_EQ(largest, 50) << "also where whole blocks are drawn";
}

}  // namespace
}  // namespace abrazo::widgets::selection_series_test
