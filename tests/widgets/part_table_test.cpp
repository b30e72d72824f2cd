// Figures of what is selected: which rows there are, what they say, and the table that shows them.
#include "widgets/scene/pick/part_table.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/widgets/synthetic_frames.hpp"
#include "widgets/scene/pick/pick_facts.hpp"

namespace abrazo::widgets::part_table_test {
namespace {

using testing::HasSubstr;
using testing::SizeIs;

PartTable table(TableOf of, const Selection& selection = {}) {
  const auto frame = test::synthetic_frame(3, 0.05), before = test::synthetic_frame(2, 0.04);
  return part_table(*frame, before.get(), of, selection);
}

double value(const PartTable& table, std::size_t row, const std::string& column) {
  const auto at = std::ranges::find(table.columns, column) - table.columns.begin();
  return table.rows.at(row).values.at(static_cast<std::size_t>(at));
}

TEST(PartTable, HasAllPartsWithoutASelectionAndThoseOfItWithOne) {
  const auto frame = test::synthetic_frame(3, 0.05);
  EXPECT_THAT(table(TableOf::Joints).rows, SizeIs(50));
  EXPECT_THAT(table(TableOf::Edges).rows, SizeIs(frame->result.edges.size()));
  EXPECT_THAT(table(TableOf::Tetrahedra).rows, SizeIs(frame->result.tetrahedra.size()));
  const MeshEdge edge = frame->result.edges.front();
  EXPECT_THAT(table(TableOf::Edges, Selection::edge(edge)).rows, SizeIs(1));
  EXPECT_THAT(table(TableOf::Joints, Selection::edge(edge)).rows, SizeIs(2));
  const PartTable at_joint = table(TableOf::Edges, Selection::joint(edge[0]));
  EXPECT_GT(at_joint.rows.size(), 1u);
  for (const PartTable::Row& row : at_joint.rows) EXPECT_TRUE(row.item.has(edge[0])) << row.name;
}

TEST(PartTable, SaysWhatTheCardsSay) {
  const auto frame = test::synthetic_frame(3, 0.05);
  const MeshEdge edge = frame->result.edges.front();
  const PartTable edges = table(TableOf::Edges, Selection::edge(edge));
  const EdgeFacts facts = *edge_facts(*frame, edge);
  EXPECT_DOUBLE_EQ(value(edges, 0, "length [m]"), facts.length_m);
  EXPECT_NEAR(value(edges, 0, "change [mm]"), 1000 * (facts.length_m - facts.reference_m), 1e-9);
  EXPECT_NEAR(value(edges, 0, "residual [mm]"), 1000 * facts.residual_m, 1e-9);
  EXPECT_NEAR(value(edges, 0, "energy [%]"), facts.energy_share, 1e-9);
}

TEST(PartTable, GivesVelocitiesAndTheDistanceOfTwoJoints) {
  const auto frame = test::synthetic_frame(3, 0.05), before = test::synthetic_frame(2, 0.04);
  Selection two = Selection::joint(3);
  two.vertices.push_back(28);
  const PartTable joints = table(TableOf::Joints, two);
  ASSERT_THAT(joints.rows, SizeIs(2));
  const Vec3 moved = (frame->result.result.row(28) - before->result.result.row(28)).transpose();
  EXPECT_NEAR(value(joints, 1, "speed [m/s]"), moved.norm() / 0.01, 1e-6);
  const double apart = (frame->result.result.row(3) - frame->result.result.row(28)).norm();
  EXPECT_NEAR(value(joints, 0, "to " + vertex_name(28) + " [m]"), apart, 1e-12);
  const PartTable alone = part_table(*frame, nullptr, TableOf::Joints, two);
  EXPECT_TRUE(std::isnan(value(alone, 0, "speed [m/s]"))) << "nothing is known of before";
}

TEST(PartTable, IsWrittenAsCsvWithUnitsAndEmptyFieldsForWhatIsNone) {
  const auto frame = test::synthetic_frame(3, 0.05);
  const std::string csv = csv_of(part_table(*frame, nullptr, TableOf::Joints, Selection::joint(0)));
  EXPECT_THAT(csv, HasSubstr("part,x [m],y [m],z [m],vx [m/s]"));
  EXPECT_THAT(csv, HasSubstr(",,,,")) << "velocities";
  EXPECT_EQ(std::ranges::count(csv, '\n'), 2);
}

}  // namespace
}  // namespace abrazo::widgets::part_table_test
