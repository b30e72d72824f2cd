#include "widgets/plots/selection_series.hpp"

#include <algorithm>
#include <array>
#include <limits>

#include "core/base/units.hpp"

namespace abrazo::widgets {
namespace {

double length(const PairPose& pair, const Selection& edge) {
  return (pair.row(edge.vertices[0]) - pair.row(edge.vertices[1])).norm();
}

void read_edge(const FrameSnapshot& frame, const Selection& edge, SeriesValues& values) {
  const FrameResult& result = frame.result;
  const auto found = std::ranges::find(result.edges, MeshEdge{edge.vertices[0], edge.vertices[1]});
  if (found == result.edges.end()) return;
  const auto place = static_cast<std::size_t>(found - result.edges.begin());
  at(values, Series::EdgeLength) = mm_per_m * length(result.result, edge);
  at(values, Series::EdgeReference) = mm_per_m * length(result.selected_pair, edge);
  if (place < result.edge_weights.size()) at(values, Series::EdgeWeight) = result.edge_weights[place];
  if (place < result.edge_residuals_m.size())
    at(values, Series::EdgeResidual) = mm_per_m * result.edge_residuals_m[place];
}

void read_cell(const FrameSnapshot& frame, const Selection& cell, SeriesValues& values) {
  for (const MeshTetrahedron& tetrahedron : frame.result.tetrahedra) {
    if (Selection::tetrahedron(tetrahedron) != cell) continue;
    const double reference = six_volumes(frame.result.selected_pair, tetrahedron);
    if (reference != 0)
      at(values, Series::CellRatio) = six_volumes(frame.result.result, tetrahedron) / reference;
  }
}

}  // namespace

const PaneSeries& selection_series() {
  using enum Series;
  static const PaneSeries all = {JointResidual, JointFromUser, JointFromSelected, JointSpeed, EdgeLength,
                                 EdgeReference, EdgeResidual,  EdgeWeight,        CellRatio};
  return all;
}

PaneSeries series_of(const Selection& selection) {
  using enum Series;
  switch (selection.kind) {
    case SelectionKind::Joints:
      return {JointResidual, JointFromUser, JointFromSelected};
    case SelectionKind::Edge:
      return {EdgeLength, EdgeReference, EdgeResidual};
    case SelectionKind::Tetrahedron:
      return {CellRatio};
    case SelectionKind::Candidate:
    case SelectionKind::None:
      break;
  }
  return {};
}

double vertex_residual_m(const FrameSnapshot& frame, int vertex) {
  constexpr double least_distance_m = 0.001;  // touching joints do not take all the weight
  const FrameResult& result = frame.result;
  const EdgeWeights kind = frame.settings.edge_weights;
  const PairPose &pair = result.result, &reference = result.selected_pair;
  Vec3 bent = Vec3::Zero();
  double sum = 0;
  int count = 0;
  for (const MeshEdge& edge : result.edges) {
    if (edge[0] != vertex && edge[1] != vertex) continue;
    const int other = edge[0] == vertex ? edge[1] : edge[0];
    const Vec3 was = (reference.row(vertex) - reference.row(other)).transpose();
    const Vec3 is = (pair.row(vertex) - pair.row(other)).transpose();
    const double weight = kind == EdgeWeights::Uniform ? 1 : 1 / std::max(was.norm(), least_distance_m);
    bent += weight * (was - is);
    sum += weight;
    ++count;
  }
  if (count == 0) return 0;
  return bent.norm() / (kind == EdgeWeights::InverseMean ? count : sum);
}

void SelectionReader::read_joint(const FrameSnapshot& frame, SeriesValues& values) {
  const int vertex = selection_.last_joint();
  const FrameResult& result = frame.result;
  const Vec3 position = result.result.row(vertex).transpose();
  at(values, Series::JointResidual) = mm_per_m * vertex_residual_m(frame, vertex);
  at(values, Series::JointFromSelected) =
      mm_per_m * (result.selected_pair.row(vertex) - result.result.row(vertex)).norm();
  const bool second = vertex >= joint_count;
  if (second == (frame.settings.user_role == UserRole::Passive))
    at(values, Series::JointFromUser) =
        mm_per_m * (frame.user.row(vertex % joint_count) - result.result.row(vertex)).norm();
  // On the session's clock the frames of a backlog are much closer together than the poses in them.
  const double elapsed_s =
      frame.elapsed_s > 0 || !previous_ ? frame.elapsed_s : frame.time_s - previous_->time_s;
  if (previous_ && frame.index == previous_->index + 1 && elapsed_s > 0)
    at(values, Series::JointSpeed) = (position - previous_->position).norm() / elapsed_s;
  previous_ = Previous{frame.index, frame.time_s, position};
}

void SelectionReader::read(const FrameSnapshot& frame, SeriesValues& values) {
  for (const Series series : selection_series())
    at(values, series) = std::numeric_limits<double>::quiet_NaN();
  if (frame.result.status == StepStatus::Failed) return previous_.reset();
  if (selection_.kind == SelectionKind::Joints) read_joint(frame, values);
  if (selection_.kind == SelectionKind::Edge) read_edge(frame, selection_, values);
  if (selection_.kind == SelectionKind::Tetrahedron) read_cell(frame, selection_, values);
}

}  // namespace abrazo::widgets
