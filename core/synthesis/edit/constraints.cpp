#include "core/synthesis/edit/constraints.hpp"

#include <algorithm>
#include <cmath>

#include "core/motion/body/joint_set.hpp"

namespace abrazo {

double ConstraintRow::value(const PairPose& positions) const {
  Vec3 sum = Vec3::Zero();
  for (int i = 0; i < count; ++i) {
    const auto at = static_cast<std::size_t>(i);
    sum += weights[at] * positions.row(vertices[at]).transpose();
  }
  return direction.dot(sum);
}

RigidDistances rigid_distances(const PairPose& pose) {
  RigidDistances distances;
  std::size_t n = 0;
  const auto add = [&](std::pair<int, int> ends, int first_vertex) {
    const int a = ends.second + first_vertex;
    const int b = ends.first + first_vertex;
    distances[n++] = {a, b, (pose.row(a) - pose.row(b)).norm()};
  };
  for (const int first_vertex : {0, joint_count}) {
    for (int b = 0; b < bone_count; ++b) add(bone(b), first_vertex);
    for (const auto& ends : pseudo_bones) add(ends, first_vertex);
  }
  return distances;
}

void add_bone_rows(const PairPose& iterate, const PairPose& reference, const RigidDistances& lengths,
                   std::vector<ConstraintRow>& rows) {
  for (const RigidDistance& rigid : lengths) {
    Vec3 along = iterate.row(rigid.a) - iterate.row(rigid.b);
    double length = along.norm();
    if (length < 1e-6) {
      along = reference.row(rigid.a) - reference.row(rigid.b);
      length = along.norm();
    }
    ConstraintRow row;
    row.kind = RowKind::Bone;
    row.count = 2;
    row.vertices = {rigid.a, rigid.b, 0, 0};
    row.weights = {1, -1, 0, 0};
    if (length >= 1e-6) {  // a bone of no length constrains nothing: an empty row keeps the order
      row.direction = along / length;
      row.target = rigid.length_m;
    }
    rows.push_back(row);
  }
}

double bone_length_error(const PairPose& positions, const RigidDistances& lengths) {
  constexpr int per_body = rigid_distance_count / 2;
  double largest = 0;
  for (int n = 0; n < rigid_distance_count; ++n) {
    if (n % per_body >= bone_count) continue;
    const RigidDistance& rigid = lengths[static_cast<std::size_t>(n)];
    if (rigid.length_m < 1e-6) continue;
    const double length = (positions.row(rigid.a) - positions.row(rigid.b)).norm();
    largest = std::max(largest, std::abs(length - rigid.length_m) / rigid.length_m);
  }
  return largest;
}

void add_floor_rows(const PairPose& reference, double lowest_m, std::vector<ConstraintRow>& rows) {
  using namespace joints;
  for (const int first_vertex : {0, joint_count})
    for (const int joint : {LeftTibia, LeftFoot, LeftToes, RightTibia, RightFoot, RightToes}) {
      ConstraintRow row;
      row.kind = RowKind::Floor;
      row.inequality = true;
      row.count = 1;
      row.vertices[0] = joint + first_vertex;
      row.weights[0] = 1;
      row.direction = Vec3::UnitY();
      row.target = std::min(lowest_m, reference(joint + first_vertex, 1));
      rows.push_back(row);
    }
}

namespace {

void add_axis_row(int vertex, int axis, double target, std::vector<ConstraintRow>& rows) {
  ConstraintRow row;
  row.kind = RowKind::FootLock;
  row.count = 1;
  row.vertices[0] = vertex;
  row.weights[0] = 1;
  row.direction = Vec3::Unit(axis);
  row.target = target;
  rows.push_back(row);
}

}  // namespace

void add_position_rows(int vertex, const Vec3& position, std::vector<ConstraintRow>& rows) {
  for (const int axis : {0, 1, 2}) add_axis_row(vertex, axis, position(axis), rows);
}

void add_place_rows(int vertex, const Vec3& position, std::vector<ConstraintRow>& rows) {
  for (const int axis : {0, 2}) add_axis_row(vertex, axis, position(axis), rows);
}

}  // namespace abrazo
